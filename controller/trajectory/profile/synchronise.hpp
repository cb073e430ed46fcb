// One duration for all axes of a joint move: they start and stop together.
//
// The duration is that of the slowest axis, rounded up to whole ticks. The other axes are slowed down by one of three
// rules. None of them exceeds the speed or acceleration limit of an axis, because T >= T_i >= 2 sqrt(q/a):
//   fig9        a trapezoid keeps its acceleration and cruises slower, eq. (13); a triangle stays a triangle with
//               a' = 4 q / T^2, eq. (14). Only this rule gives Figure 9 of Vo 2021: with eq. (13) for every axis, as
//               printed, its joints 4 and 5 would be trapezoids (eq. (14) could never be reached).
//   const_acc   eq. (13) for every axis
//   time_scale  every axis' own profile, slowed down
#pragma once

#include <cstdint>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/trajectory/profile/trapezoid.hpp"

namespace armature {

enum class SyncRule : std::uint8_t { kFig9, kConstAcc, kTimeScale };

struct SynchronisedProfiles {
  PerAxis<TrapezoidProfile> axes{};  // each takes exactly `duration`; empty for an axis that does not move
  Ticks duration{};
};

// Number of whole ticks that cover `duration_s`: 0 only for 0. Up to a millionth of a tick is rounded down, because a
// duration that should be whole may be slightly larger by rounding. Speeds and accelerations then exceed their limits
// by at most that share. The result saturates at the largest value of Ticks.
[[nodiscard]] Ticks whole_ticks(double duration_s) noexcept;

// Distances and limits of all axes in any unit of length. If the duration saturates, only the duration is valid.
[[nodiscard]] SynchronisedProfiles synchronise(const PerAxis<double>& distance, const PerAxis<ProfileLimits>& limits,
                                               SyncRule rule) noexcept;

}  // namespace armature
