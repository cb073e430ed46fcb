#include "controller/trajectory/stop_move.hpp"

#include <algorithm>
#include <cmath>

#include "controller/core/timebase.hpp"

namespace armature {

StopMove::StopMove(const JointPlan& plan, const RobotModel& robot, double path_s) noexcept
    : plan_{&plan}, robot_{&robot}, path_s_{path_s}, step_s_{kTickSeconds} {}

double StopMove::least_step_s() const noexcept {
  double least_s = 0.0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const TrapezoidProfile& profile = plan_->profiles[axis];
    if (profile.shape == ProfileShape::kNone) continue;
    const double covered = std::fabs(position(profile, path_s_));
    const double last_step = covered - std::fabs(position(profile, path_s_ - step_s_));
    const double least_step = last_step - robot_->axes[axis].max_accel_rad_s2 * kTickSeconds * kTickSeconds;
    if (least_step > 0.0) least_s = std::max(least_s, time_at(profile, covered + least_step) - path_s_);
  }
  return least_s;
}

double StopMove::advance() noexcept {
  // Never faster than before: where the plan brakes as hard as it may, the least step is the last one but for rounding.
  step_s_ = std::min(step_s_, least_step_s());
  path_s_ += step_s_;
  finished_ = step_s_ <= 0.0 || path_s_ >= static_cast<double>(plan_->duration.value()) * kTickSeconds;
  return path_s_;
}

}  // namespace armature
