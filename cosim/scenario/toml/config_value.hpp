// A parsed TOML document as plain data, each key and value with the place where it was written.
//
// The loaders work on this tree, so that only toml_document.cpp needs the TOML library and a `--set` override is an
// ordinary value with another origin.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "cosim/text/input_error.hpp"

namespace armature::cosim {

struct ConfigEntry;

struct ConfigValue {
  struct Date {};  // dates and times: no key accepts one
  using Array = std::vector<ConfigValue>;
  using Table = std::vector<ConfigEntry>;  // in the order of the file

  using Data = std::variant<bool, std::int64_t, double, std::string, Date, Array, Table>;

  Data data;
  Origin origin;

  // Defined below, where ConfigEntry is complete.
  ConfigValue();
  ConfigValue(Data content, Origin place);
  ConfigValue(const ConfigValue&);
  ConfigValue(ConfigValue&&) noexcept;
  ConfigValue& operator=(const ConfigValue&);
  ConfigValue& operator=(ConfigValue&&) noexcept;
  ~ConfigValue();

  [[nodiscard]] const Table* table() const { return std::get_if<Table>(&data); }
  [[nodiscard]] Table* table() { return std::get_if<Table>(&data); }
  [[nodiscard]] const Array* array() const { return std::get_if<Array>(&data); }
  [[nodiscard]] Array* array() { return std::get_if<Array>(&data); }

  // The entry of a table, or nullptr when there is none or this is no table.
  [[nodiscard]] const ConfigEntry* find(std::string_view key) const;
  [[nodiscard]] ConfigEntry* find(std::string_view key);
};

struct ConfigEntry {
  std::string key;
  Origin origin;  // of the key
  ConfigValue value;
};

inline ConfigValue::ConfigValue() = default;
inline ConfigValue::ConfigValue(Data content, Origin place) : data{std::move(content)}, origin{std::move(place)} {}
inline ConfigValue::ConfigValue(const ConfigValue&) = default;
inline ConfigValue::ConfigValue(ConfigValue&&) noexcept = default;
inline ConfigValue& ConfigValue::operator=(const ConfigValue&) = default;
inline ConfigValue& ConfigValue::operator=(ConfigValue&&) noexcept = default;
inline ConfigValue::~ConfigValue() = default;

inline const ConfigEntry* ConfigValue::find(std::string_view key) const {
  if (const Table* entries = table()) {
    for (const ConfigEntry& entry : *entries) {
      if (entry.key == key) return &entry;
    }
  }
  return nullptr;
}

inline ConfigEntry* ConfigValue::find(std::string_view key) {
  return const_cast<ConfigEntry*>(std::as_const(*this).find(key));
}

// The value as a message names it: `the string "abc"`, `a table`, `12`.
[[nodiscard]] std::string describe(const ConfigValue& value);

// Compares the content. Origins and the order of the keys of a table do not matter.
[[nodiscard]] bool same_content(const ConfigValue& a, const ConfigValue& b);

}  // namespace armature::cosim
