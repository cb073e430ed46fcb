#include "controller/activity/jog/tool_velocity.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "controller/activity/joint_steps.hpp"
#include "controller/base/timebase.hpp"
#include "controller/trajectory/path/orientation_path.hpp"

namespace armature {
namespace {

// Shares of the joints' accelerations. What is left is for the change of the Jacobian along the path.
constexpr double kForCommands = 0.4;  // to follow a new command
constexpr double kForLimits = 0.4;    // to brake before a soft limit
constexpr double kAtMost = 0.8;
constexpr double kSpeedShare = 0.98;
// A joint that stands so close to its limit was stopped by it.
constexpr double kAtLimitRad = 1e-6;
constexpr double kUnlimited = std::numeric_limits<double>::infinity();

// The largest x >= 0 with x |part| <= limit.
double at_most(double limit, double part) {
  return part == 0.0 ? kUnlimited : limit / std::fabs(part);
}

}  // namespace

ToolVelocity::ToolVelocity(const RobotModel& robot, const Arm& arm, const ToolVelocityLimits& limits,
                           const Transform& flange_T_tool) noexcept
    : robot_{robot},
      arm_{arm},
      limits_{limits},
      flange_T_tool_{flange_T_tool},
      tool_T_flange_{inverse(flange_T_tool)},
      max_speed_rad_s_{speed_limits_rad_s(robot)} {}

void ToolVelocity::begin(const PerAxis<Radians>& position) noexcept {
  position_ = previous_ = before_ = position;
  posture_ = arm_.posture(position);
  base_T_tool_ = arm_.flange_at(*posture_) * flange_T_tool_;
  moving_ = {.base_R_tool = base_T_tool_.rotation};
  wanted_ = {};
  change_.keep(Vector6::Zero());
  change_frame_ = {};
  next_change_.reset();
  change_ticks_ = 0;
  stopping_ = false;
  at_rest_ = true;
}

void ToolVelocity::follow(const ToolTwist& twist) noexcept {
  if (stopping_ || twist == wanted_) return;
  if (next_change_ && is_due_) end_of_next_change();
  wanted_ = twist;
  // Where the joints slow the tool down, jerk is not limited.
  const bool smooth = limits_.jerk_mm_s3 > 0.0 || limits_.turn_jerk_rad_s3 > 0.0;
  if (!at_rest_ && smooth && moving_.whole) {
    begin_next_change();
  } else {
    change_at_once();
  }
}

VelocityChange::Limits ToolVelocity::limits_of_change() const noexcept {
  VelocityChange::Limits limits{.accel_mm_s2 = limits_.accel_mm_s2,
                                .turn_accel_rad_s2 = limits_.turn_accel_rad_s2,
                                .jerk_mm_s3 = limits_.jerk_mm_s3,
                                .turn_jerk_rad_s3 = limits_.turn_jerk_rad_s3,
                                .tick_s = kTickSeconds};
  for (std::size_t axis = 0; axis < robot_.axis_count; ++axis) {
    limits.joint_accel_rad_s2[axis] = kForCommands * robot_.axes[axis].max_accel_rad_s2;
  }
  return limits;
}

// From the present velocity, without an acceleration.
void ToolVelocity::change_at_once() noexcept {
  const Vector6 now = in_frame(moving_.twist, moving_.base_R_tool, wanted_.frame);
  // At a singularity advance() finds that the tool cannot continue.
  const bool planned =
      change_.plan(seconds(Ticks{change_ticks_}), now, {}, change_of(wanted_twist() - now), limits_of_change());
  start_change(planned);
}

// From the velocity and the acceleration that the present change has after the next tick.
void ToolVelocity::begin_next_change() noexcept {
  const double then_s = seconds(Ticks{change_ticks_ + 1});
  const Vector6 then = in_frame(in_base(change_.at(then_s), change_frame_), base_T_tool_.rotation, wanted_.frame);
  const Vector6 accel = (then - in_frame(moving_.twist, moving_.base_R_tool, wanted_.frame)) / kTickSeconds;
  next_change_ = change_;
  is_due_ = false;
  next_change_->begin(then_s, then, change_of(accel), change_of(wanted_twist() - then), limits_of_change());
}

// A tick later. It begins there, unless the joints have slowed the tool down.
void ToolVelocity::end_of_next_change() noexcept {
  if (moving_.whole) {
    const bool planned = next_change_->finish();
    change_ = *next_change_;
    start_change(planned);
  } else {
    change_at_once();
  }
  next_change_.reset();
}

void ToolVelocity::start_change(bool planned) noexcept {
  if (!planned) change_.keep(wanted_twist());
  change_frame_ = wanted_.frame;
  change_ticks_ = 0;
}

ToolVelocity::Vector6 ToolVelocity::wanted_twist() const noexcept {
  Vector6 wanted;
  wanted << wanted_.move_mm_s, wanted_.turn_rad_s;
  return wanted;
}

std::optional<PerAxis<Radians>> ToolVelocity::advance() noexcept {
  inverses_ = 0;
  if (next_change_ && is_due_) end_of_next_change();
  is_due_ = next_change_.has_value();
  ++change_ticks_;
  const Vector6 twist = stopping_ ? moving_.twist : in_base(change_.at(seconds(Ticks{change_ticks_})), change_frame_);
  moving_ = {.twist = twist, .base_R_tool = base_T_tool_.rotation};
  PerAxis<Radians> next = position_;
  if (twist != Vector6::Zero()) {
    const std::optional<double> share = share_of(rates(twist));
    if (!share) return std::nullopt;
    moving_.twist = *share * twist;
    moving_.whole = *share == 1.0;
    if (*share > 0.0) {
      move_reference(moving_.twist, kTickSeconds);
      inverses_ = 1;
      const IkTracking found = arm_.track(base_T_tool_ * tool_T_flange_, position_);
      if (!found.found || !solved(found.status)) return std::nullopt;
      next = found.joints;
    }
  }
  if (!allowed(next)) return std::nullopt;
  at_rest_ = next == position_;
  if (!at_rest_) posture_.reset();
  before_ = previous_;
  previous_ = position_;
  position_ = next;
  return next;
}

// The share of the velocity that the joints can follow in the next tick.
std::optional<double> ToolVelocity::share_of(const PerAxis<double>& rates_rad_s) const noexcept {
  double most = stopping_ ? 0.0 : 1.0, least = 0.0, largest = kUnlimited, braking = kUnlimited, room_s = kUnlimited;
  for (std::size_t axis = 0; axis < robot_.axis_count; ++axis) {
    const AxisModel& model = robot_.axes[axis];
    const double rate = rates_rad_s[axis];
    // Written so that a NaN is refused.
    if (!(std::fabs(rate) < kUnlimited)) return std::nullopt;
    const double now = (position_[axis] - previous_[axis]).value() / kTickSeconds;
    const double change = kAtMost * model.max_accel_rad_s2 * kTickSeconds;
    if (rate == 0.0) continue;
    const double one = (now - change) / rate, other = (now + change) / rate;
    least = std::max(least, std::min(one, other));
    largest = std::min(largest, std::max(one, other));
    most = std::min(most, at_most(kSpeedShare * max_speed_rad_s_[axis], rate));
    braking = std::min(braking, at_most(kForLimits * model.max_accel_rad_s2, rate));
    const double limit_rad = rate > 0.0 ? model.max_rad : model.min_rad;
    room_s = std::min(room_s, std::max((limit_rad - position_[axis].value()) / rate, 0.0));
  }
  // Whole ticks of braking: share^2 / (2 braking) + share Ts / 2 = room.
  const double tick_change = 0.5 * braking * kTickSeconds;
  const double before_limit = std::sqrt(tick_change * tick_change + 2.0 * braking * room_s) - tick_change;
  if (braking < kUnlimited) most = std::min({most, before_limit, room_s / kTickSeconds});
  if (least > largest) return std::nullopt;
  return std::clamp(most, least, std::max(least, largest));
}

// The judge of every set-point: the joints' limits, and the way that each joint alone needs to stop.
bool ToolVelocity::allowed(const PerAxis<Radians>& next) const noexcept {
  return axis_beyond_limits(robot_, max_speed_rad_s_, {.previous = previous_, .position = position_, .next = next}) ==
         0;
}

ToolVelocity::Vector6 ToolVelocity::in_frame(const Vector6& twist, const Eigen::Matrix3d& base_R_tool,
                                             ToolTwist::Frame frame) noexcept {
  if (frame == ToolTwist::Frame::kBase) return twist;
  Vector6 result;
  result << base_R_tool.transpose() * twist.head<3>(), base_R_tool.transpose() * twist.tail<3>();
  return result;
}

ToolVelocity::Vector6 ToolVelocity::in_base(const Vector6& twist, ToolTwist::Frame frame) const noexcept {
  if (frame == ToolTwist::Frame::kBase) return twist;
  Vector6 result;
  result << base_T_tool_.rotation * twist.head<3>(), base_T_tool_.rotation * twist.tail<3>();
  return result;
}

VelocityChange::Change ToolVelocity::change_of(const Vector6& in_frame) noexcept {
  return {.twist = in_frame, .joints_rad_s = rates(in_base(in_frame, wanted_.frame))};
}

PerAxis<double> ToolVelocity::rates(const Vector6& twist) noexcept {
  if (!posture_) posture_ = arm_.posture(position_);
  const Eigen::Vector3d turn = twist.tail<3>();
  const Eigen::Vector3d tool_to_flange = base_T_tool_.rotation * tool_T_flange_.position_mm;
  return arm_.joint_rates(*posture_, twist.head<3>() + turn.cross(tool_to_flange), turn);
}

void ToolVelocity::move_reference(const Vector6& twist, double duration_s) noexcept {
  base_T_tool_.position_mm += duration_s * twist.head<3>();
  const double angle = duration_s * twist.tail<3>().norm();
  if (angle == 0.0) return;
  const OrientationPath step{.axis = twist.tail<3>() * (duration_s / angle), .angle_rad = angle};
  const Eigen::Matrix3d turned_by = turned(step, 1.0) * base_T_tool_.rotation;
  // One Newton step towards the nearest rotation, so that rounding does not accumulate.
  base_T_tool_.rotation = 0.5 * turned_by * (3.0 * Eigen::Matrix3d::Identity() - turned_by.transpose() * turned_by);
}

std::uint8_t ToolVelocity::axis_at_limit() const noexcept {
  for (std::uint8_t axis = 0; axis < robot_.axis_count; ++axis) {
    const AxisModel& model = robot_.axes[axis];
    const double position = position_[axis].value();
    const double room = std::min(model.max_rad - position, position - model.min_rad);
    if (room < kAtLimitRad) return static_cast<std::uint8_t>(axis + 1);
  }
  return 0;
}

PerAxis<AxisState> ToolVelocity::state() const noexcept {
  if (at_rest_) return make_per_axis([&](std::size_t axis) { return AxisState{.position = position_[axis].value()}; });
  return make_per_axis([&](std::size_t axis) {
    return state_after(position_[axis].value(), previous_[axis].value(), before_[axis].value(), kTickSeconds);
  });
}

}  // namespace armature
