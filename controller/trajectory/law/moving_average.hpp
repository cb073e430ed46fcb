// The moving average of the motion of a table over a time tau: the same path with limited jerk.
//
//   s~(t) = integral of s over t - tau .. t, divided by tau
//   s~'   = (s(t) - s(t - tau)) / tau     s~'' = (v(t) - v(t - tau)) / tau
//
// So speed and acceleration are the means of those of the table, and the acceleration is continuous. A motion from stop
// to stop takes tau longer.
#pragma once

#include <span>

#include "controller/core/units.hpp"
#include "controller/trajectory/law/time_table.hpp"

namespace armature {

// `tau`: of each motion between two stops, in order; 0: that motion is copied. Both tables must be different ones. A
// point of `law` within a motion that is averaged becomes two; when there is no room for them, neighbouring points are
// left out.
void moving_average(const TimeTable& law, std::span<const Ticks> tau, TimeTable& result) noexcept;

}  // namespace armature
