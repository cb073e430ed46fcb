// One duration for all axes of a joint move: they start and stop together.
//
// The duration is that of the slowest axis, rounded up to whole ticks. The other axes are slowed down by one of three
// rules; none of them exceeds an axis' speed or acceleration limit, because T >= T_i >= 2 sqrt(q/a):
//   fig9        a nominal trapezoid keeps its acceleration and cruises slower, eq. (13); a nominal triangle stays one
//               with a' = 4 q / T^2, eq. (14). The only rule that gives Figure 9 of Vo 2021: with eq. (13) for every
//               axis, as printed, its joints 4 and 5 would be trapezoids (eq. (14) could never be reached).
//   const_acc   eq. (13) for every axis
//   time_scale  every axis' own profile, slowed down
#pragma once

#include <cstdint>

#include "controller/core/axes.hpp"
#include "controller/core/units.hpp"
#include "controller/trajectory/profile/trapezoid.hpp"

namespace armature {

enum class SyncRule : std::uint8_t { kFig9, kConstAcc, kTimeScale };

struct SynchronisedProfiles {
  PerAxis<TrapezoidProfile> axes{};  // each takes exactly `duration`; none for an axis that does not move
  Ticks duration{};
};

// Whole ticks that cover `duration_s`: 0 only for 0. A millionth of a tick is forgiven, since a duration that is meant
// to be whole comes out of the arithmetic a little above; speeds and accelerations then exceed their limits by at most
// that share of the duration. Saturates: what is too long for Ticks is the longest that they can say.
[[nodiscard]] Ticks whole_ticks(double duration_s) noexcept;

// Distances and limits of all axes in any unit of length. Where the duration saturates, only it has a meaning.
[[nodiscard]] SynchronisedProfiles synchronise(const PerAxis<double>& distance, const PerAxis<ProfileLimits>& limits,
                                               SyncRule rule) noexcept;

}  // namespace armature
