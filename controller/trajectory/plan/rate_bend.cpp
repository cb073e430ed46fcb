#include "controller/trajectory/plan/rate_bend.hpp"

#include <algorithm>
#include <cmath>

#include "controller/base/timebase.hpp"
#include "controller/trajectory/joint/axis_limits.hpp"

namespace armature {

double rate_bend(double speed, double jerk, double accel) noexcept {
  constexpr double kShare = 0.4;
  double w = speed > 0.0 ? jerk / speed : kAnyBend;
  if (accel > 0.0) w = std::min(w, jerk / accel * (jerk / accel));
  return std::max(kMinBend, kShare * w * kTickSeconds * kTickSeconds);
}

double rate_bend(const RetargetPlan& plan, const RobotModel& robot) noexcept {
  if (plan.kind != ProfileKind::kSCurve) return kAnyBend;
  double least = kAnyBend;
  for (std::size_t axis = 0; axis < robot.axis_count; ++axis) {
    const double jerk = robot.axes[axis].max_jerk_rad_s3;
    least = std::min(least, rate_bend(plan.peak_speed_rad_s[axis], jerk, plan.peak_accel_rad_s2[axis]));
  }
  return least;
}

namespace {

// From the limits of the segment and of the axes: how fast the joints really move is not known here.
double bend_on_path(const CartesianSegment& segment, const RobotModel& robot) {
  if (segment.profile != ProfileKind::kSCurve) return kAnyBend;
  const PathLimits& limits = segment.limits;
  double least = std::min(rate_bend(limits.speed_mm_s, limits.jerk_mm_s3, limits.accel_mm_s2),
                          rate_bend(limits.turn_speed_rad_s, limits.turn_jerk_rad_s3, limits.turn_accel_rad_s2));
  for (std::size_t axis = 0; axis < robot.axis_count; ++axis) {
    const TimeLawLimits most = axis_limits(robot.axes[axis]);
    if (most.jerk > 0.0) least = std::min(least, rate_bend(most.speed, most.jerk, most.accel));
  }
  return least;
}

}  // namespace

double rate_bend(const Plan& plan, const RobotModel& robot) noexcept {
  double least = kAnyBend;
  for (const Piece& piece : plan.view()) {
    const std::size_t moves = piece.chain != nullptr ? piece.chain->count : 0;
    for (std::size_t i = 0; i < moves; ++i) least = std::min(least, rate_bend(piece.chain->moves[i], robot));
    const std::size_t segments = piece.path != nullptr ? piece.path->count : 0;
    for (std::size_t i = 0; i < segments; ++i) least = std::min(least, bend_on_path(piece.path->segments[i], robot));
  }
  return least;
}

}  // namespace armature
