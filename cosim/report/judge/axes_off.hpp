// The axes whose value differs from the expected one, in words and as data.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <type_traits>

#include "cosim/report/facts/fact_where.hpp"
#include "cosim/report/facts/value_text.hpp"

namespace armature::cosim {

// `axis 6 differs: expected 12, got 9, difference -3`, or `axes 2, 6 differ, axis 6 most: ...`. Both spans have an
// element for each axis. `off(wanted, got)` returns the size of the difference of an axis, and 0 if the axis meets the
// expectation. `places`: where the values are from, or empty. The result is empty if no axis differs.
template <class T, class Off>
FactWhere axes_off(std::span<const T> wanted, std::span<const T> got, Off off,
                   std::span<const std::optional<RunPlace>> places = {}) {
  FactWhere where;
  std::string axes;
  std::size_t worst = 0;
  double largest = 0;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const double size = off(wanted[i], got[i]);
    if (size == 0) continue;
    where.axes.push_back(static_cast<std::uint8_t>(i + 1));
    axes += (axes.empty() ? "" : ", ") + std::to_string(i + 1);
    if (!(size > largest)) continue;
    largest = size;
    worst = i;
  }
  if (where.axes.empty()) return where;
  const bool several = where.axes.size() > 1;
  where.text = several ? fmt::format("axes {} differ", axes) : fmt::format("axis {} differs", axes);
  if (several) where.text += fmt::format(std::is_arithmetic_v<T> ? ", axis {} most" : ", such as axis {}", worst + 1);
  where.text += fmt::format(": expected {}, got {}", show(wanted[worst]), show(got[worst]));
  if constexpr (std::is_arithmetic_v<T>) where.text += fmt::format(", difference {}", show(got[worst] - wanted[worst]));
  if (places.empty() || !places[worst]) return where;
  where.at = places[worst];
  RunPlace place = *where.at;
  place.axis = 0;  // the text names it already
  where.text += ", " + at_place(place).text;
  return where;
}

}  // namespace armature::cosim
