#include "controller/activity/jog/velocity_source.hpp"

#include <algorithm>
#include <cmath>

#include "controller/base/timebase.hpp"
#include "controller/trajectory/joint/axis_limits.hpp"

namespace armature {
namespace {

// Slower commands are none: an axis would need 30 years for a radian.
constexpr double kLeastSpeed = 1e-9;

// The last tick of a law may miss its end by rounding.
constexpr double kLawEndTicks = 1e-6;

}  // namespace

VelocitySource::VelocitySource(const RobotModel& robot, const Arm& arm, VelocityInput& input,
                               const VelocitySettings& settings) noexcept
    : robot_{robot},
      input_{input},
      time_out_{settings.time_out},
      tool_{robot, arm, settings.manner.tool, settings.flange_T_tool} {
  set_manner(settings.manner);
}

void VelocitySource::set_manner(const VelocityManner& manner) noexcept {
  profile_ = manner.profile;
  limits_ = make_per_axis([&](std::size_t axis) { return axis_limits(robot_.axes[axis], 1.0, manner.accel_share); });
  tool_.set_limits(manner.tool);
}

const SetPoint& VelocitySource::advance(Ticks tick) noexcept {
  set_point_.stopped = set_point_.wake = set_point_.planned = false;
  set_point_.inverses = 0;
  if (const std::optional<VelocityCommand> command = input_.latest()) accept(*command, tick);
  if (tick >= expires_ && wants_to_move()) expire();
  const bool begins = next_twist_ && !joints_move();
  if (begins) {
    tool_.begin(set_point_.position);
    tool_.follow(*next_twist_);
    next_twist_.reset();
    follows_tool_ = true;
  }
  const bool was_moving = any_moves();
  // There is no time to begin and to move in the same tick.
  if (follows_tool_ && !begins) advance_tool();
  if (!follows_tool_) advance_joints();
  const bool moves_on = any_moves(), moved = was_moving || moves_on;
  set_point_.rate = moved ? 1.0 : 0.0;
  set_point_.wake = was_moving && !moves_on;
  set_point_.state = stopping_ ? MotionState::kStopping : moved ? MotionState::kMoving : MotionState::kIdle;
  if (stopping_ && !moves_on) {
    leave_tool();
    stopping_ = false;
    set_point_.stopped = true;
  }
  return set_point_;
}

void VelocitySource::advance_tool() noexcept {
  const std::optional<PerAxis<Radians>> next = tool_.advance();
  set_point_.inverses = tool_.inverses();
  if (next) {
    set_point_.position = *next;
    return;
  }
  ++departures_;
  failed_twist_ = tool_.wanted();
  follows_tool_ = false;
  stop_joints(tool_.state());
}

void VelocitySource::advance_joints() noexcept {
  for (std::size_t i = 0; i < robot_.axis_count; ++i) {
    Axis& axis = axes_[i];
    ++axis.ticks;
    set_point_.position[i] = Radians{axis.law.at(seconds(Ticks{axis.ticks})).position};
  }
}

// No command came in time.
void VelocitySource::expire() noexcept {
  ++time_outs_;
  const std::uint8_t axis = axis_at_limit();
  if (axis != 0) ending_ = {.how = JogEnd::kLimit, .axis = axis};
  if (failed_twist_) ending_ = {.how = JogEnd::kCannotFollow};
  halt_all();
}

// The first joint with a velocity that stands at its soft limit, 1..6; 0: none.
std::uint8_t VelocitySource::axis_at_limit() const noexcept {
  if (follows_tool_) return tool_.wants_to_move() && tool_.at_rest() ? tool_.axis_at_limit() : std::uint8_t{0};
  for (std::uint8_t axis = 0; axis < robot_.axis_count; ++axis) {
    if (axes_[axis].wanted_rad_s != 0.0 && !moves(axes_[axis])) return static_cast<std::uint8_t>(axis + 1);
  }
  return 0;
}

void VelocitySource::accept(const VelocityCommand& command, Ticks tick) noexcept {
  if (command.kind == VelocityCommand::Kind::kStop) {
    stopping_ = true;
    ending_ = {.how = JogEnd::kStop};
    next_twist_.reset();
    if (follows_tool_) {
      tool_.stop();
    } else {
      stop_joints(state());
    }
    return;
  }
  if (stopping_) return;
  if (command.kind == VelocityCommand::Kind::kHalt || command.kind == VelocityCommand::Kind::kSoftStop) {
    ending_ = {.how = command.kind == VelocityCommand::Kind::kHalt ? JogEnd::kHold : JogEnd::kStop};
    return halt_all();
  }
  if (command.manner) set_manner(*command.manner);
  expires_ = tick + (command.time_out > Ticks{} ? command.time_out : time_out_);
  if (command.kind == VelocityCommand::Kind::kTool) {
    ending_ = {.how = command.tool.is_zero() ? JogEnd::kReleased : JogEnd::kDuration};
    if (follows_tool_) {
      tool_.follow(command.tool);
    } else if (command.tool != failed_twist_) {
      halt_all();
      next_twist_ = command.tool;
    }
    return;
  }
  leave_tool();
  for (std::size_t axis = 0; axis < robot_.axis_count; ++axis) {
    const double most = limits_[axis].speed, wanted = std::clamp(command.joint_rad_s[axis], -most, most);
    // Written so that a NaN is 0.
    follow(axis, std::fabs(wanted) >= kLeastSpeed ? wanted : 0.0);
  }
  ending_ = {.how = wants_to_move() ? JogEnd::kDuration : JogEnd::kReleased};
}

// From here on the joints are followed, from the present state of motion to rest.
void VelocitySource::leave_tool() noexcept {
  next_twist_.reset();
  failed_twist_.reset();
  if (!follows_tool_) return;
  begin_from(tool_.state());
}

void VelocitySource::follow(std::size_t index, double wanted_rad_s) noexcept {
  Axis& axis = axes_[index];
  if (axis.wanted_rad_s == wanted_rad_s) return;
  const AxisState now = axis.law.at(seconds(Ticks{axis.ticks}));
  set_point_.planned = true;
  if (wanted_rad_s == 0.0) {
    axis.law = plan_to_velocity(profile_, now, 0.0, limits_[index]);
  } else {
    TimeLawLimits limits = limits_[index];
    limits.speed = std::fabs(wanted_rad_s);
    const AxisModel& model = robot_.axes[index];
    axis.law = plan_to_rest(profile_, now, wanted_rad_s > 0.0 ? model.max_rad : model.min_rad, limits);
  }
  axis.ticks = 0;
  axis.wanted_rad_s = wanted_rad_s;
}

void VelocitySource::halt_all() noexcept {
  next_twist_.reset();
  failed_twist_.reset();
  if (follows_tool_) tool_.follow({});
  for (std::size_t axis = 0; axis < robot_.axis_count; ++axis) follow(axis, 0.0);
}

void VelocitySource::stop_joints(const PerAxis<AxisState>& state) noexcept {
  for (std::size_t i = 0; i < robot_.axis_count; ++i) {
    TimeLawLimits limits = limits_[i];
    limits.accel = robot_.axes[i].max_accel_rad_s2;
    axes_[i] = {.law = plan_to_velocity(ProfileKind::kTrapezoid, state[i], 0.0, limits)};
  }
}

void VelocitySource::reset_to(const PerAxis<Radians>& position) noexcept {
  for (std::size_t i = 0; i < kAxes; ++i) {
    axes_[i].law.restart({.position = position[i].value()});
    axes_[i].ticks = 0;
    axes_[i].wanted_rad_s = 0.0;
  }
  stopping_ = follows_tool_ = false;
  next_twist_.reset();
  failed_twist_.reset();
  set_point_.position = position;
  set_point_.rate = 0.0;
}

void VelocitySource::cancel(Ticks) noexcept {
  reset_to(set_point_.position);
}

void VelocitySource::begin_from(const PerAxis<AxisState>& state) noexcept {
  for (std::size_t i = 0; i < kAxes; ++i) {
    const bool moves = i < robot_.axis_count && !state[i].at_rest();
    axes_[i] = {.law = moves ? plan_to_velocity(profile_, state[i], 0.0, limits_[i]) : PhaseLaw{state[i]}};
    set_point_.position[i] = Radians{state[i].position};
  }
  follows_tool_ = false;
}

PerAxis<AxisState> VelocitySource::state() const noexcept {
  if (follows_tool_) return tool_.state();
  return make_per_axis([&](std::size_t axis) { return axes_[axis].law.at(seconds(Ticks{axes_[axis].ticks})); });
}

bool VelocitySource::wants_to_move() const noexcept {
  if (follows_tool_) return tool_.wants_to_move();
  return next_twist_ || failed_twist_ ||
         std::any_of(axes_.begin(), axes_.end(), [](const Axis& axis) { return axis.wanted_rad_s != 0.0; });
}

bool VelocitySource::moves(const Axis& axis) const noexcept {
  return axis.law.duration_s() > seconds(Ticks{axis.ticks}) + kLawEndTicks * kTickSeconds;
}

bool VelocitySource::joints_move() const noexcept {
  return std::any_of(axes_.begin(), axes_.end(), [this](const Axis& axis) { return moves(axis); });
}

bool VelocitySource::any_moves() const noexcept {
  return follows_tool_ ? !tool_.at_rest() : joints_move();
}

}  // namespace armature
