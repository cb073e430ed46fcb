#include "cosim/scenario/toml/config_value.hpp"

#include <algorithm>
#include <cmath>

#include "cosim/text/number_text.hpp"
#include "cosim/text/printable.hpp"

namespace armature::cosim {
namespace {

struct Describer {
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(std::int64_t value) const { return std::to_string(value); }
  std::string operator()(double value) const {
    const std::string text = number_text(value);
    return text.find_first_not_of("-0123456789") == std::string::npos ? text + ".0" : text;
  }
  std::string operator()(const std::string& value) const { return "the string \"" + printable(value) + "\""; }
  std::string operator()(ConfigValue::Date) const { return "a date or time"; }
  std::string operator()(const ConfigValue::Array&) const { return "an array"; }
  std::string operator()(const ConfigValue::Table&) const { return "a table"; }
};

struct SameContent {
  bool operator()(double a, double b) const { return a == b || (std::isnan(a) && std::isnan(b)); }
  bool operator()(ConfigValue::Date, ConfigValue::Date) const { return true; }
  bool operator()(const ConfigValue::Array& a, const ConfigValue::Array& b) const {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_content);
  }
  bool operator()(const ConfigValue::Table& a, const ConfigValue::Table& b) const {
    const ConfigValue other{b, {}};
    return a.size() == b.size() && std::all_of(a.begin(), a.end(), [&](const ConfigEntry& entry) {
             const ConfigEntry* twin = other.find(entry.key);
             return twin != nullptr && same_content(entry.value, twin->value);
           });
  }
  template <class T>
  bool operator()(const T& a, const T& b) const {
    return a == b;
  }
  template <class T, class U>
  bool operator()(const T&, const U&) const {
    return false;
  }
};

}  // namespace

std::string describe(const ConfigValue& value) {
  return std::visit(Describer{}, value.data);
}

bool same_content(const ConfigValue& a, const ConfigValue& b) {
  return std::visit(SameContent{}, a.data, b.data);
}

}  // namespace armature::cosim
