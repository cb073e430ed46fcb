// A message of the page: a JSON object whose `do` names what it wants. Every field is checked before it is used.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "cosim/scenario/toml/config_value.hpp"

namespace armature::cosim {

// What is wrong with a message, for the page.
class MessageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The functions throw MessageError.
class PageMessage {
 public:
  static constexpr int kMaxDepth = 4;  // of arrays and objects within each other

  explicit PageMessage(std::string_view text);

  [[nodiscard]] const std::string& what() const { return what_; }
  [[nodiscard]] bool has(const char* key) const { return json_.contains(key); }

  [[nodiscard]] std::int64_t integer(const char* key, std::int64_t min, std::int64_t max) const;
  [[nodiscard]] double number(const char* key, double min, double max) const;
  [[nodiscard]] bool flag(const char* key) const;
  [[nodiscard]] std::string text(const char* key, std::size_t longest) const;
  // An object of numbers, flags and short texts, as a table of a scenario.
  [[nodiscard]] ConfigValue table(const char* key) const;
  // Exactly so many numbers from -largest to largest.
  [[nodiscard]] std::vector<double> numbers(const char* key, std::size_t count, double largest) const;

 private:
  [[nodiscard]] const nlohmann::json& field(const char* key) const;

  nlohmann::json json_;
  std::string what_;
};

}  // namespace armature::cosim
