#include "controller/trajectory/profile/synchronise.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "controller/base/rounding.hpp"
#include "controller/base/timebase.hpp"

namespace armature {
namespace {

constexpr double kForgivenTicks = 1e-6;

TrapezoidProfile stretch(double distance, const TrapezoidProfile& nominal, double duration_s, SyncRule rule) {
  if (rule == SyncRule::kTimeScale) return scale_in_time(nominal, duration_s);
  if (rule == SyncRule::kFig9 && nominal.shape == ProfileShape::kTriangle) return plan_triangle(distance, duration_s);
  return plan_with_accel(distance, nominal.accel, duration_s);
}

}  // namespace

Ticks whole_ticks(double duration_s) noexcept {
  if (duration_s == 0.0) return Ticks{0};
  const double ticks = rounded_up(duration_s / kTickSeconds - kForgivenTicks);
  // Written so that a NaN saturates too: the conversion of a value outside int64 would be undefined.
  if (!(ticks < 0x1p63)) return Ticks{std::numeric_limits<std::int64_t>::max()};
  return Ticks{std::max<std::int64_t>(1, static_cast<std::int64_t>(ticks))};
}

SynchronisedProfiles synchronise(const PerAxis<double>& distance, const PerAxis<ProfileLimits>& limits,
                                 SyncRule rule) noexcept {
  SynchronisedProfiles result;
  double longest_s = 0.0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    result.axes[axis] = plan_profile(distance[axis], limits[axis]);
    longest_s = std::max(longest_s, result.axes[axis].duration_s);
  }
  result.duration = whole_ticks(longest_s);
  const double duration_s = seconds(result.duration);
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    result.axes[axis] = stretch(distance[axis], result.axes[axis], duration_s, rule);
  }
  return result;
}

}  // namespace armature
