// Numbers and lists as messages about facts show them.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "cosim/text/number_text.hpp"

namespace armature::cosim {

inline std::string show(double value) {
  return number_text(std::round(value * 1e6) / 1e6);
}
// A value that is compared with a limit. Small values keep three significant digits.
inline std::string show_small(double value) {
  return std::fabs(value) < 1e-3 ? number_text(std::stod(fmt::format("{:.3g}", value))) : show(value);
}
inline std::string show(std::int64_t value) {
  return std::to_string(value);
}
inline std::string show(std::string_view value) {
  return std::string{value};
}

inline std::string with_unit(std::string text, std::string_view unit) {
  if (!unit.empty()) text.append(" ").append(unit);
  return text;
}

template <class Values>
std::string show_list(const Values& values) {
  std::string text = "[";
  for (const auto& value : values) {
    if (text.size() > 1) text += ", ";
    text += show(value);
  }
  return text += "]";
}

}  // namespace armature::cosim
