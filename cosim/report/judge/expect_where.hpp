// Where a value that is not met comes from: axis, tick and time, in words and as data.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "cosim/report/judge/expect.hpp"
#include "cosim/text/number_text.hpp"

namespace armature::cosim {

inline std::string show(double value) {
  return number_text(std::round(value * 1e6) / 1e6);
}
// What is compared with a limit: small values keep their digits.
inline std::string show_small(double value) {
  return std::fabs(value) < 1e-3 ? number_text(std::stod(fmt::format("{:.3g}", value))) : show(value);
}
inline std::string show(std::int64_t value) {
  return std::to_string(value);
}
inline std::string show(std::string_view value) {
  return std::string{value};
}

// `axis 2, tick 180, 0.009112 s`, without the axis for a place of none. Nothing for no place.
[[nodiscard]] ExpectWhere at_place(const std::optional<FactPlace>& place);
// The same with `first` in front: of something that happened several times.
[[nodiscard]] ExpectWhere first_at(const std::optional<FactPlace>& place);
// `watchdog, 0.3 s; estop, 0.5 s`: all faults of the run.
[[nodiscard]] ExpectWhere at_faults(const RunFacts& facts);
// `move[3], 0.3 s`: all moves that were refused or dropped.
[[nodiscard]] ExpectWhere at_refusals(const RunFacts& facts);

// `axis 6 is off: wanted 12, got 9, difference -3`, or `axes 2, 6 are off, axis 6 most: ...`. Both have an element for
// each axis; `off(wanted, got)` is 0 where the axis is as it should be, else by how much it is not. `places`: of the
// values, or none.
template <class T, class Off>
ExpectWhere at_axes(std::span<const T> wanted, std::span<const T> got, Off off,
                    std::span<const std::optional<FactPlace>> places = {}) {
  ExpectWhere where;
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
  where.text = several ? fmt::format("axes {} are off", axes) : fmt::format("axis {} is off", axes);
  if (several) where.text += fmt::format(std::is_arithmetic_v<T> ? ", axis {} most" : ", such as axis {}", worst + 1);
  where.text += fmt::format(": wanted {}, got {}", show(wanted[worst]), show(got[worst]));
  if constexpr (std::is_arithmetic_v<T>) where.text += fmt::format(", difference {}", show(got[worst] - wanted[worst]));
  if (places.empty() || !places[worst]) return where;
  where.at = places[worst];
  FactPlace place = *where.at;
  place.axis = 0;  // it is said already
  where.text += ", " + at_place(place).text;
  return where;
}

}  // namespace armature::cosim
