#include "controller/trajectory/run/path_clock.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "controller/base/halving.hpp"
#include "controller/base/timebase.hpp"
#include "controller/robot/axis_units.hpp"
#include "controller/trajectory/joint/axis_limits.hpp"

namespace armature {
namespace {

// The tool's positions are about 1e3 mm, with 1e-13 mm of rounding: 1e-6 of the change of a step at 40 mm/s^2.
constexpr double kToolRounding = 1e-4;
// Bisection steps for the change of the rate: a resolution of 1e-9 of it.
constexpr int kHalvings = 30;

// The least y >= 0 beyond which slope y + curvature y^2 exceeds `room` >= 0.
double first_excess(double slope, double curvature, double room) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const double discriminant = slope * slope + 4.0 * curvature * room;
  if (discriminant < 0.0) return kNever;
  const double root = std::sqrt(discriminant);
  if (slope > 0.0) return 2.0 * room / (slope + root);
  return curvature > 0.0 ? (root - slope) / (2.0 * curvature) : kNever;
}

// A model of the change of the tool's step when the rate changes by x: quadratic in x, so its square is of degree 4.
class ToolBend {
 public:
  ToolBend(const Eigen::Vector3d& last, double ticks, const Eigen::Vector3d& step, double rate, bool short_step) {
    const Eigen::Vector3d mean = step / ticks;
    Eigen::Vector3d curvature = Eigen::Vector3d::Zero();
    if (!short_step) curvature = (mean * rate - last) / (rate * (ticks + rate));
    const Eigen::Vector3d slope = mean + curvature * (rate - ticks), kept = slope * rate - last;
    const Eigen::Vector3d local = slope + curvature * rate;
    square_ = {kept.squaredNorm(), 2.0 * kept.dot(local), local.squaredNorm() + 2.0 * kept.dot(curvature),
               2.0 * local.dot(curvature), curvature.squaredNorm()};
    most_ = std::max(1.0, square_[0]);
  }
  // > 0: the bend is beyond its limit, or beyond that of the present rate if this is larger.
  [[nodiscard]] double excess(double x) const {
    return square_[0] - most_ + x * (square_[1] + x * (square_[2] + x * (square_[3] + x * square_[4])));
  }

 private:
  std::array<double, 5> square_{};
  double most_;
};

}  // namespace

PathClock::PathClock(const RobotModel& robot) noexcept : axis_count_{robot.axis_count} {
  for (std::size_t axis = 0; axis < axis_count_; ++axis) {
    max_step_rad_[axis] = AxisUnits{robot.axes[axis]}.max_speed_rad_s() * kTickSeconds;
    max_bend_rad_[axis] = robot.axes[axis].max_accel_rad_s2 * kTickSeconds * kTickSeconds;
    const double jerk = robot.axes[axis].max_jerk_rad_s3;
    max_jerk_rad_[axis] = jerk > 0.0 ? jerk * kTickSeconds * kTickSeconds * kTickSeconds : kNoJerkLimit;
  }
}

void PathClock::restart(double rate, RateJerk jerk, double rate_bend, bool in_motion) noexcept {
  time_ = last_time_ = time_before_ = 0.0;
  rate_ = rate;
  rate_step_ = 0.0;
  jerk_ = jerk;
  rate_bend_ = rate_bend;
  change_scale_ = 1.0;
  peak_rad_ = {};
  if (!in_motion) step_rad_ = previous_step_rad_ = {};
}

void PathClock::move_origin(Ticks origin) noexcept {
  for (double* time : {&time_, &last_time_, &time_before_}) *time -= static_cast<double>(origin.value());
}

void PathClock::set_peak(std::size_t axis, double accel_rad_s2) noexcept {
  peak_rad_[axis] = accel_rad_s2 * kTickSeconds * kTickSeconds;
}

void PathClock::set_jerk(RateJerk jerk) noexcept {
  rate_step_ = 0.0;
  jerk_ = jerk;
}

double PathClock::shaped(double wanted) const noexcept {
  const double w = rate_bend_;
  const double direction = wanted < rate_ ? -1.0 : 1.0;
  const double change = std::fabs(wanted - rate_);
  const double u = direction * rate_step_;
  // The last step may change by up to 1.5 w, because the rate must meet `wanted` exactly.
  if (change <= w && -w <= u && u <= change + 1.5 * w) return wanted;
  // Steps of n w, (n - 1) w, .. w change the rate by n (n + 1) / 2 w.
  const double most = change <= w ? change : 0.5 * w * (std::sqrt(1.0 + 8.0 * change / w) - 1.0);
  const double next = std::max(std::min(u + w, most), u - w);
  return std::clamp(rate_ + direction * next, 0.0, 1.0);
}

void PathClock::add_motions(RateChange& change, const PerAxis<Radians>& now, double ticks, const PerAxis<Radians>& next,
                            const ToolSteps& tool) const noexcept {
  const bool short_step = rate_ < kShortStep;
  const double kept = change.kept();
  const auto motion = [&]<class Length>(const Length& way, const Length& step, const Length& before, double max_bend,
                                        double max_change) {
    const Length mean = way / ticks;
    const Length curvature =
        short_step ? Length{0.0 * mean} : Length{(mean * rate_ - step) / (rate_ * (ticks + rate_))};
    const Length slope = mean - curvature * ticks;
    const Length kept_step = (slope + curvature * kept) * kept;
    return RateChange::Motion<Length>{.speed = slope + 2.0 * kept * curvature,
                                      .accel = 2.0 * curvature,
                                      .bend = kept_step - step,
                                      .change = kept_step - 2.0 * step + before,
                                      .max_bend = max_bend,
                                      .max_change = max_change};
  };
  for (std::size_t axis = 0; axis < axis_count_; ++axis) {
    const double step = step_rad_[axis], before = previous_step_rad_[axis];
    const double max_bend = std::max(max_bend_rad_[axis], std::fabs(step - before));
    auto joint = motion((next[axis] - now[axis]).value(), step, before, max_bend, max_jerk_rad_[axis]);
    joint.peak = peak_rad_[axis];
    change.add(joint);
  }
  const auto add = [&](const Eigen::Vector3d& way, const Eigen::Vector3d& step, const Eigen::Vector3d& before,
                       double max_change) {
    change.add(motion(way, step, before, std::max(1.0, (step - before).norm()), max_change));
  };
  add(tool.next.move, tool.last.move, tool.before.move, tool.next.move_jerk);
  add(tool.next.turn, tool.last.turn, tool.before.turn, tool.next.turn_jerk);
}

PathClock::PathModel::PathModel(const PathClock& clock, const PerAxis<Radians>& from, double to,
                                const PerAxis<Radians>& at_end) noexcept
    : ticks{to}, now{from}, next{at_end} {
  const bool short_step = clock.rate_ < kShortStep;
  const double rate = clock.rate_, per_tick = 1.0 / ticks;
  const double per_square = short_step ? 0.0 : 1.0 / (rate * (ticks + rate));
  for (std::size_t axis = 0; axis < clock.axis_count_; ++axis) {
    const double mean = (next[axis] - now[axis]).value() * per_tick;
    curvature[axis] = (mean * rate - clock.step_rad_[axis]) * per_square;
    slope[axis] = mean - curvature[axis] * ticks;
  }
}

PerAxis<Radians> PathClock::PathModel::at(double rate) const noexcept {
  if (rate == ticks) return next;
  return make_per_axis(
      [&](std::size_t axis) { return now[axis] + Radians{(slope[axis] + curvature[axis] * rate) * rate}; });
}

double PathClock::propose(double wanted, const PathModel& model, const ToolStep& last,
                          const ToolStep& tool) const noexcept {
  const bool short_step = rate_ < kShortStep;
  const double direction = wanted < rate_ ? -1.0 : 1.0, ticks = model.ticks;
  const double whole_change = std::fabs(wanted - rate_);
  double change = whole_change;
  for (std::size_t axis = 0; axis < axis_count_; ++axis) {
    // The second difference is the step to the joint on the parabola minus the last step.
    const double slope = model.slope[axis], curvature = model.curvature[axis];
    const double bend = (slope + curvature * rate_) * rate_ - step_rad_[axis];  // when the rate is kept
    const double limit = std::max(max_bend_rad_[axis], std::fabs(bend));
    const double local_slope = direction * (slope + 2.0 * curvature * rate_);
    const double end_slope = local_slope + 2.0 * curvature * change;
    const double end = bend + (local_slope + curvature * change) * change;
    if (local_slope * end_slope >= 0.0 && std::fabs(end) <= limit) continue;
    change = std::min(change, first_excess(local_slope, curvature, limit - bend));
    change = std::min(change, first_excess(-local_slope, -curvature, limit + bend));
  }
  const auto keep_limit = [&](const ToolBend& bend) {
    const auto excess = [&](double tried) { return bend.excess(direction * tried); };
    const double beyond = excess(change);
    if (beyond <= 0.0) return;
    // No change is within the limits, since the rate is kept.
    const EndValues at{.inside = std::min(excess(0.0), 0.0), .outside = beyond};
    change = halved<kHalvings>({.inside = 0.0, .outside = change}, at, excess).inside;
  };
  keep_limit({last.move, ticks, tool.move, rate_, short_step});
  keep_limit({last.turn, ticks, tool.turn, rate_, short_step});
  return change == whole_change ? wanted : rate_ + direction * change;
}

bool PathClock::allowed(const ToolStep& last, const ToolStep& next) noexcept {
  return (next.move - last.move).norm() <= 1.0 + kToolRounding && (next.turn - last.turn).norm() <= 1.0 + kToolRounding;
}

bool PathClock::keeps_limits(const ToolStep& last, double ticks, const ToolStep& next, double rate) const noexcept {
  const auto keeps = [&](const Eigen::Vector3d& last_step, const Eigen::Vector3d& next_step) {
    const ToolBend bend{last_step, ticks, next_step, rate_, rate_ < kShortStep};
    return bend.excess(rate - rate_) <= 2.0 * kToolRounding;
  };
  return keeps(last.move, next.move) && keeps(last.turn, next.turn);
}

bool PathClock::allowed(const PerAxis<Radians>& now, const PerAxis<Radians>& next) const noexcept {
  for (std::size_t axis = 0; axis < axis_count_; ++axis) {
    const double step = (next[axis] - now[axis]).value();
    // Written so that a NaN is refused.
    if (!(std::fabs(step) <= max_step_rad_[axis] * (1.0 + kLimitRounding))) return false;
    if (!(std::fabs(step - step_rad_[axis]) <= max_bend_rad_[axis] * (1.0 + kLimitRounding))) return false;
  }
  return true;
}

}  // namespace armature
