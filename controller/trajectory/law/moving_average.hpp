// The moving average of the motion of a table over a time tau: the same path with limited jerk.
//
//   s~(t) = integral of s over t - tau .. t, divided by tau
//   s~'   = (s(t) - s(t - tau)) / tau     s~'' = (v(t) - v(t - tau)) / tau
//
// So speed and acceleration are the means of those of the table, and the acceleration is continuous. A motion from stop
// to stop takes tau longer. Up to a time, the average depends only on the table up to that time.
#pragma once

#include <cstddef>
#include <span>

#include "controller/base/units.hpp"
#include "controller/trajectory/law/time_table.hpp"

namespace armature {

// The points of a table from one stop to the next, and the time for which the motion rests there. The first motion of a
// table that was kept in part may begin in motion.
struct TableRun {
  std::size_t first = 0, last = 0;
};
// The one that begins at the point `first`, which is not the last one of the table.
[[nodiscard]] TableRun run_from(const TimeTable& table, std::size_t first) noexcept;

// `tau`: of each motion between two stops, in order; 0: that motion is copied. Both tables must be different ones. A
// point of `law` within a motion that is averaged becomes two.
void moving_average(const TimeTable& law, std::span<const Ticks> tau, TimeTable& result) noexcept;

// Appends the average to what TimeTable::keep() has left of the average of an older law, which is the same as `law` up
// to that time. `law` contains what is at most `tau` > 0 before that time. All further motions have the same tau.
void continue_average(const TimeTable& law, Ticks tau, TimeTable& result) noexcept;

// The speed of the average of a motion at `t_s`.
[[nodiscard]] double average_speed(const TimeTable& law, const TableRun& run, Ticks tau, double t_s) noexcept;

}  // namespace armature
