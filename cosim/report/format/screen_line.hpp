// A line of the summary: a label, and a text or numbers in columns after it.
#pragma once

#include <fmt/format.h>

#include <iterator>
#include <string>
#include <string_view>
#include <type_traits>

namespace armature::cosim {

inline void add_line(std::string& out, std::string_view label, std::string_view text) {
  fmt::format_to(std::back_inserter(out), "  {:<22}{}\n", label, text);
}

// `digits` after the point of numbers that have a fraction.
template <class Values>
std::string columns(const Values& values, int digits) {
  std::string text;
  for (const auto& value : values) {
    if constexpr (std::is_floating_point_v<std::remove_cvref_t<decltype(value)>>) {
      fmt::format_to(std::back_inserter(text), "{:>12.{}f}", value, digits);
    } else {
      fmt::format_to(std::back_inserter(text), "{:>12}", value);
    }
  }
  return text;
}

}  // namespace armature::cosim
