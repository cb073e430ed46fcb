#include "controller/motion/velocity_source.hpp"

#include <algorithm>
#include <cmath>

#include "controller/core/timebase.hpp"
#include "controller/robot/axis_units.hpp"

namespace armature {
namespace {

// Slower commands are none: an axis would need 30 years for a radian.
constexpr double kLeastSpeed = 1e-9;

// The last tick of a law may miss its end by rounding.
constexpr double kEndTicks = 1e-6;

}  // namespace

VelocitySource::VelocitySource(const RobotModel& robot, VelocityInput& input, const VelocitySettings& settings) noexcept
    : robot_{robot}, input_{input}, settings_{settings}, limits_{make_per_axis([&](std::size_t axis) {
        const AxisModel& model = robot.axes[axis];
        return TimeLawLimits{.speed = AxisUnits{model}.max_speed_rad_s(),
                             .accel = settings.accel_share * model.max_accel_rad_s2,
                             .jerk = model.max_jerk_rad_s3};
      })} {}

const SetPoint& VelocitySource::advance(Ticks tick) noexcept {
  set_point_.stopped = set_point_.wake = false;
  if (const std::optional<VelocityCommand> command = input_.latest()) accept(*command, tick);
  if (tick >= expires_ &&
      std::any_of(axes_.begin(), axes_.end(), [](const Axis& a) { return a.wanted_rad_s != 0.0; })) {
    ++time_outs_;
    halt_all();
  }
  for (std::size_t i = 0; i < robot_.axis_count; ++i) {
    Axis& axis = axes_[i];
    ++axis.ticks;
    set_point_.position[i] = Radians{axis.law.at(seconds(Ticks{axis.ticks})).position};
  }
  const bool moved = moving_ || any_moves();
  moving_ = any_moves();
  set_point_.rate = moved ? 1.0 : 0.0;
  set_point_.wake = moved && !moving_;
  set_point_.state = stopping_ ? MotionState::kStopping : moved ? MotionState::kMoving : MotionState::kIdle;
  if (stopping_ && !moving_) {
    stopping_ = false;
    set_point_.stopped = true;
  }
  return set_point_;
}

void VelocitySource::accept(const VelocityCommand& command, Ticks tick) noexcept {
  if (command.kind == VelocityCommand::Kind::kStop) {
    stop();
    return;
  }
  if (stopping_) return;
  expires_ = tick + settings_.time_out;
  for (std::size_t axis = 0; axis < robot_.axis_count; ++axis) {
    const double most = limits_[axis].speed, wanted = std::clamp(command.joint_rad_s[axis], -most, most);
    // Written so that a NaN is 0.
    follow(axis, std::fabs(wanted) >= kLeastSpeed ? wanted : 0.0);
  }
}

void VelocitySource::follow(std::size_t index, double wanted_rad_s) noexcept {
  Axis& axis = axes_[index];
  if (axis.wanted_rad_s == wanted_rad_s) return;
  const AxisState now = axis.law.at(seconds(Ticks{axis.ticks}));
  if (wanted_rad_s == 0.0) {
    axis.law = plan_to_velocity(settings_.profile, now, 0.0, limits_[index]);
  } else {
    TimeLawLimits limits = limits_[index];
    limits.speed = std::fabs(wanted_rad_s);
    const AxisModel& model = robot_.axes[index];
    axis.law = plan_to_rest(settings_.profile, now, wanted_rad_s > 0.0 ? model.max_rad : model.min_rad, limits);
  }
  axis.ticks = 0;
  axis.wanted_rad_s = wanted_rad_s;
}

void VelocitySource::halt_all() noexcept {
  for (std::size_t axis = 0; axis < robot_.axis_count; ++axis) follow(axis, 0.0);
}

void VelocitySource::stop() noexcept {
  stopping_ = true;
  for (std::size_t i = 0; i < robot_.axis_count; ++i) {
    TimeLawLimits limits = limits_[i];
    limits.accel = robot_.axes[i].max_accel_rad_s2;
    const AxisState now = axes_[i].law.at(seconds(Ticks{axes_[i].ticks}));
    axes_[i] = {.law = plan_to_velocity(ProfileKind::kTrapezoid, now, 0.0, limits)};
  }
}

void VelocitySource::reset_to(const PerAxis<Radians>& position) noexcept {
  for (std::size_t i = 0; i < kAxes; ++i) axes_[i] = {.law = PhaseLaw{{.position = position[i].value()}}};
  stopping_ = moving_ = false;
  set_point_.position = position;
  set_point_.rate = 0.0;
}

void VelocitySource::cancel(Ticks) noexcept {
  stopping_ = false;
  reset_to(set_point_.position);
}

void VelocitySource::begin_from(const PerAxis<AxisState>& state) noexcept {
  for (std::size_t i = 0; i < kAxes; ++i) {
    const bool moves = i < robot_.axis_count && !state[i].at_rest();
    axes_[i] = {.law = moves ? plan_to_velocity(settings_.profile, state[i], 0.0, limits_[i]) : PhaseLaw{state[i]}};
    set_point_.position[i] = Radians{state[i].position};
  }
  stopping_ = false;
  moving_ = any_moves();
}

PerAxis<AxisState> VelocitySource::state() const noexcept {
  return make_per_axis([&](std::size_t axis) { return axes_[axis].law.at(seconds(Ticks{axes_[axis].ticks})); });
}

Stopping VelocitySource::stopping() const noexcept {
  Stopping stopping;
  for (const Axis& axis : axes_) {
    if (!moves(axis)) continue;
    const double left = axis.law.duration_s() / kTickSeconds - static_cast<double>(axis.ticks);
    stopping.within_ticks = std::max(stopping.within_ticks, left);
  }
  return stopping;
}

bool VelocitySource::moves(const Axis& axis) const noexcept {
  return axis.law.duration_s() > seconds(Ticks{axis.ticks}) + kEndTicks * kTickSeconds;
}

bool VelocitySource::any_moves() const noexcept {
  return std::any_of(axes_.begin(), axes_.end(), [this](const Axis& axis) { return moves(axis); });
}

}  // namespace armature
