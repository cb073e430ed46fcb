// The allowed values of a key. The check and its message come from the same declaration.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "cosim/scenario/toml/config_value.hpp"

namespace armature::cosim {

enum class Need { kOptional, kRequired };

struct Rule {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool above_min = false;                   // the minimum itself is not allowed
  std::string_view unit{};                  // for messages; empty: none
  std::vector<std::string_view> choices{};  // of a string; empty = any
  std::string_view otherwise{};             // advice if no choice fits, for messages
  std::size_t count = 0;                    // elements of an array; 0 = any number, or as many as the type has
  std::size_t most_rows = 0;                // arrays in an array of arrays, which has at least one
  std::vector<double> numbers{};            // of a number; empty = any in the range
  std::string when_missing{};               // the end of the message for a required key that is missing
};

[[nodiscard]] inline Rule anything() {
  return {};
}
[[nodiscard]] inline Rule between(double min, double max, std::string_view unit = {}) {
  return {.min = min, .max = max, .above_min = false, .unit = unit};
}
[[nodiscard]] inline Rule above(double min, double max, std::string_view unit = {}) {
  return {.min = min, .max = max, .above_min = true, .unit = unit};
}
[[nodiscard]] inline Rule at_least(double min, std::string_view unit = {}) {
  return {.min = min, .unit = unit};
}
// The words must outlive the rule.
template <std::ranges::range Words>
[[nodiscard]] Rule one_of(const Words& choices) {
  Rule rule;
  rule.choices.assign(choices.begin(), choices.end());
  return rule;
}
[[nodiscard]] inline Rule one_of(std::initializer_list<std::string_view> choices) {
  Rule rule;
  rule.choices = choices;
  return rule;
}

[[nodiscard]] inline Rule one_of_numbers(std::initializer_list<double> numbers) {
  Rule rule;
  rule.numbers = numbers;
  return rule;
}

// The type of a value. An integer is accepted as a number, but a number is not accepted as an integer.
enum class ValueKind { kNumber, kInteger, kBoolean, kString };

// `"joint", "line" or "stop"`.
[[nodiscard]] std::string quoted_list(const std::vector<std::string_view>& choices);
// `a number from 0 to 1 (s)`, `"joint" or "stop"`.
[[nodiscard]] std::string expected_one(ValueKind kind, const Rule& rule);
// `an array of 6 numbers (deg)`; `count` 0 = any number of them.
[[nodiscard]] std::string expected_array(ValueKind kind, const Rule& rule, std::size_t count);

// `1 to 15 arrays of 3 numbers (mm)`: an array of arrays.
[[nodiscard]] std::string expected_rows(ValueKind kind, const Rule& rule, std::size_t count);

// `move[2]`: the full key of an element of an array.
[[nodiscard]] std::string element_key(const std::string& array_key, std::size_t index);

// Each function sets `out` and returns true, or reports one problem and does not change `out`.
bool convert(const ConfigValue& value, const std::string& path, const Rule& rule, ProblemList& problems, double& out);
bool convert(const ConfigValue& value, const std::string& path, const Rule& rule, ProblemList& problems,
             std::int64_t& out);
bool convert(const ConfigValue& value, const std::string& path, const Rule& rule, ProblemList& problems, bool& out);
bool convert(const ConfigValue& value, const std::string& path, const Rule& rule, ProblemList& problems,
             std::string& out);

}  // namespace armature::cosim
