#include "controller/trajectory/path_clock.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "controller/core/timebase.hpp"
#include "controller/robot/axis_units.hpp"

namespace armature {
namespace {

// By how much rounding may make set-points exceed a limit that the plan just reaches; whole_ticks() forgives as much.
constexpr double kRounding = 1e-6;
// Below this rate the last step says nothing about the path's curvature, and the model is a line.
constexpr double kShortStep = 1e-3;

// The least y >= 0 beyond which slope y + curvature y^2 exceeds `room` >= 0.
double leaves(double slope, double curvature, double room) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const double discriminant = slope * slope + 4.0 * curvature * room;
  if (discriminant < 0.0) return kNever;
  const double root = std::sqrt(discriminant);
  if (slope > 0.0) return 2.0 * room / (slope + root);
  return curvature > 0.0 ? (root - slope) / (2.0 * curvature) : kNever;
}

}  // namespace

PathClock::PathClock(const RobotModel& robot) noexcept : axis_count_{robot.axis_count} {
  for (std::size_t axis = 0; axis < axis_count_; ++axis) {
    max_step_rad_[axis] = AxisUnits{robot.axes[axis]}.max_speed_rad_s() * kTickSeconds;
    max_bend_rad_[axis] = robot.axes[axis].max_accel_rad_s2 * kTickSeconds * kTickSeconds;
  }
}

void PathClock::restart(double rate) noexcept {
  time_ = 0.0;
  rate_ = rate;
  step_rad_ = {};
}

double PathClock::propose(double wanted, const PerAxis<Radians>& now, const PerAxis<Radians>& ahead) const noexcept {
  const double direction = wanted < rate_ ? -1.0 : 1.0;
  const double whole_way = std::fabs(wanted - rate_);
  double way = whole_way;
  for (std::size_t axis = 0; axis < axis_count_; ++axis) {
    // The joint at time_ + x is now + slope x + curvature x^2, so the set-points then bend by that minus the last step.
    const double step = step_rad_[axis];
    const double tick = (ahead[axis] - now[axis]).value();
    const double curvature = rate_ < kShortStep ? 0.0 : (tick * rate_ - step) / (rate_ * (1.0 + rate_));
    const double slope = tick - curvature;
    const double bend = (slope + curvature * rate_) * rate_ - step;  // when the rate is kept
    const double limit = std::max(max_bend_rad_[axis], std::fabs(bend));
    const double local_slope = direction * (slope + 2.0 * curvature * rate_);
    way = std::min(way, leaves(local_slope, curvature, limit - bend));
    way = std::min(way, leaves(-local_slope, -curvature, limit + bend));
  }
  return way == whole_way ? wanted : rate_ + direction * way;
}

bool PathClock::allowed(const PerAxis<Radians>& now, const PerAxis<Radians>& next) const noexcept {
  for (std::size_t axis = 0; axis < axis_count_; ++axis) {
    const double step = (next[axis] - now[axis]).value();
    // Written so that a NaN is not allowed.
    if (!(std::fabs(step) <= max_step_rad_[axis] * (1.0 + kRounding))) return false;
    if (!(std::fabs(step - step_rad_[axis]) <= max_bend_rad_[axis] * (1.0 + kRounding))) return false;
  }
  return true;
}

void PathClock::take(double rate, const PerAxis<Radians>& now, const PerAxis<Radians>& next) noexcept {
  time_ += rate;
  rate_ = rate;
  for (std::size_t axis = 0; axis < kAxes; ++axis) step_rad_[axis] = (next[axis] - now[axis]).value();
}

}  // namespace armature
