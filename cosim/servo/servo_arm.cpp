#include "cosim/servo/servo_arm.hpp"

#include <stdexcept>

#include "cosim/logic/axis_bits.hpp"

namespace armature::cosim {
namespace {

// A load that is slower, and accelerates less, rests: its oscillation is some 1e-8 rad wide.
constexpr double kRestSpeed = 1e-6;  // [rad/s]
constexpr double kRestAccel = 1e-3;  // [rad/s^2]
// The speed of a shaft that stands, while other parts of its axis do not [counts/step].
constexpr double kStillMoves = 0x1.0p-100;
constexpr double kMaxStiffness = 0.5 * 0.5;  // (wn h)^2

Pair within(Pair value, Pair limit) {
  return smaller(larger(value, -limit), limit);
}

WholePair negative(Pair value) {
  return value < both(0.0);
}

}  // namespace

ServoArm::ServoArm(const ServoNumbers& numbers, const ArmModel& model, int renewal)
    : numbers_{numbers}, arm_{model}, renewal_{renewal} {
  state_.braking = numbers_.holding;
  const LoadSide::State load = arm_.at({}, {});
  for (std::size_t i = 0; i < kAxes; ++i) {
    const double h = numbers_.step_s;
    const double mobility = load.inverse[i][i] * h + numbers_.speed_per_torque[i];
    if (!(numbers_.stiffness[i] * h * mobility < kMaxStiffness) || !(numbers_.damping[i] * mobility < 0.5)) {
      throw std::invalid_argument{"servo: the gear is too stiff for the integration step"};
    }
  }
}

void ServoArm::step(std::uint8_t controlled, const AxisNumbers& reference, AxisNumbers& error, AxisNumbers& speed) {
  if (!state_.begun) begin(reference, error);
  if (controlled != state_.controlled) switch_drives(controlled, reference);
  wait_for_brakes();
  if (state_.until_renewal == 0) renew(reference, error);
  --state_.until_renewal;

  std::array<Pair, kAxisPairs> gears;
  for (std::size_t i = 0; i < kAxisPairs; ++i) {
    const WholePair lanes = controlled_lanes(i);
    control(i, lanes, reference.pair(i), error.pair(i));
    gears[i] = gear_torque(i);
    turn_motor(i, lanes, gears[i]);
  }
  for_each_bit(blocked_, [&](std::size_t axis) { state_.speed[axis] = 0.0; });
  const bool loads_move = turn_loads(gears);
  warm_drives(controlled);
  const Pair h = both(numbers_.step_s);
  for (std::size_t i = 0; i < kAxisPairs; ++i) {
    const Pair turned = h * state_.speed.pair(i);
    state_.twist.set_pair(i, state_.twist.pair(i) + (turned - h * state_.load_speed.pair(i)));
    const Pair counts = turned / numbers_.rad_per_count.pair(i);
    error.set_pair(i, error.pair(i) + counts);
    const WholePair rests = rest_lanes(i, loads_move) & (counts == both(0.0));
    speed.set_pair(i, only(~rests, counts == both(0.0) ? both(kStillMoves) : counts));
  }
}

// Held by the brakes, the motors stand where they are, and the gears carry the weight of the arm.
void ServoArm::begin(const AxisNumbers& reference, const AxisNumbers& error) {
  state_.begun = true;
  state_.reference = reference;
  PerAxis<double> motors{}, loads{};
  for (std::size_t i = 0; i < kAxes; ++i) {
    loads[i] = motors[i] = (reference[i] + error[i]) * numbers_.rad_per_count[i];
  }
  constexpr int kTimes = 20;  // a gear gives way by little, so each time gains some digits
  for (int k = 0; k < kTimes; ++k) {
    const PerAxis<double> weight = arm_.gravity(loads);
    for (std::size_t i = 0; i < kAxes; ++i) {
      const double play = weight[i] > 0.0 ? numbers_.half_play[i] : weight[i] < 0.0 ? -numbers_.half_play[i] : 0.0;
      state_.twist[i] = weight[i] / numbers_.stiffness[i] + play;
      loads[i] = motors[i] - state_.twist[i];
    }
  }
}

void ServoArm::renew(const AxisNumbers& reference, const AxisNumbers& error) {
  state_.until_renewal = renewal_;
  AxisNumbers loads;
  for (std::size_t i = 0; i < kAxisPairs; ++i) {
    loads.set_pair(i, (reference.pair(i) + error.pair(i)) * numbers_.rad_per_count.pair(i) - state_.twist.pair(i));
  }
  state_.load = arm_.at(loads, state_.load_speed);
}

void ServoArm::switch_drives(std::uint8_t controlled, const AxisNumbers& reference) {
  for_each_bit(static_cast<std::uint8_t>(controlled ^ state_.controlled), [&](std::size_t axis) {
    state_.reference[axis] = reference[axis];
    state_.lag[axis] = state_.integral[axis] = 0.0;
    const bool on = has_bit(controlled, axis);
    const bool engaged = state_.braking[axis] != 0.0;
    const std::int32_t delay = on ? numbers_.release_steps[axis] : numbers_.engage_steps[axis];
    state_.brake_in[axis] = on == engaged ? delay + 1 : 0;
  });
  state_.controlled = controlled;
}

void ServoArm::wait_for_brakes() {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (state_.brake_in[axis] == 0 || --state_.brake_in[axis] > 0) continue;
    state_.braking[axis] = has_bit(state_.controlled, axis) ? 0.0 : numbers_.holding[axis] * brake_share_[axis];
  }
}

WholePair ServoArm::controlled_lanes(std::size_t pair) const {
  const auto lane = [&](std::size_t axis) { return has_bit(state_.controlled, axis) ? std::int64_t{-1} : 0; };
  return WholePair{lane(2 * pair), lane(2 * pair + 1)};
}

// From the command to the torque of the motor.
void ServoArm::control(std::size_t pair, WholePair controlled, Pair reference, Pair error) {
  const ServoNumbers& n = numbers_;
  const Pair to_rad = n.rad_per_count.pair(pair);
  const Pair command = (reference - state_.reference.pair(pair)) * to_rad;
  state_.reference.set_pair(pair, reference);
  const Pair behind = state_.lag.pair(pair) + only(controlled, command);
  const Pair lag = behind * n.lag_kept.pair(pair);
  state_.lag.set_pair(pair, lag);

  const Pair off = -(error * to_rad) - lag;
  const Pair seen = off - within(off, n.unseen.pair(pair));
  const Pair demanded = n.position_gain.pair(pair) * seen + n.feed_forward.pair(pair) * (behind - lag);
  const Pair missing = within(demanded, n.max_speed.pair(pair)) - state_.speed.pair(pair);
  const Pair integral = state_.integral.pair(pair);
  const Pair wanted = n.torque_per_speed.pair(pair) * (missing + integral);
  const Pair limited = within(wanted, n.max_torque.pair(pair));
  const WholePair winds_up = (wanted != limited) & (negative(wanted) == negative(missing));
  const Pair more = n.integral_per_step.pair(pair) * missing;
  state_.integral.set_pair(pair, only(controlled, integral + only(~winds_up, more)));
  const Pair torque = state_.torque.pair(pair);
  // Shorted windings carry no current of the drive.
  state_.torque.set_pair(pair, only(controlled, torque + n.current_per_step.pair(pair) * (limited - torque)));
}

// Of the gear on the load. Teeth push and never pull.
Pair ServoArm::gear_torque(std::size_t pair) const {
  const ServoNumbers& n = numbers_;
  const Pair twist = state_.twist.pair(pair), play = n.half_play.pair(pair);
  const Pair bent = twist - within(twist, play);
  const Pair turning = state_.speed.pair(pair) - state_.load_speed.pair(pair);
  const Pair torque = n.stiffness.pair(pair) * bent + n.damping.pair(pair) * turning;
  const WholePair apart = (play > both(0.0)) & ((bent == both(0.0)) | (negative(torque) != negative(bent)));
  return only(~apart, torque);
}

void ServoArm::turn_motor(std::size_t pair, WholePair controlled, Pair load) {
  const ServoNumbers& n = numbers_;
  const Pair drag = only(controlled, n.driven_drag.pair(pair)) + only(~controlled, n.shorted_drag.pair(pair));
  const Pair pushed = state_.speed.pair(pair) + n.speed_per_torque.pair(pair) * (state_.torque.pair(pair) - load);
  const Pair free = pushed * drag;
  state_.speed.set_pair(pair, free - within(free, n.friction.pair(pair) + state_.braking.pair(pair)));
}

// Returns whether one of them moves.
bool ServoArm::turn_loads(const std::array<Pair, kAxisPairs>& gears) {
  AxisNumbers torque;
  for (std::size_t i = 0; i < kAxisPairs; ++i) {
    const Pair drag = numbers_.bearing.pair(i) * state_.load_speed.pair(i);
    torque.set_pair(i, gears[i] - state_.load.bias.pair(i) - drag + pushed_.pair(i));
  }
  WholePair moves{};
  for (std::size_t i = 0; i < kAxisPairs; ++i) {
    Pair accel{};
    for (std::size_t j = 0; j < kAxes; ++j) accel = accel + state_.load.inverse[j].pair(i) * both(torque[j]);
    const Pair speed = state_.load_speed.pair(i) + both(numbers_.step_s) * accel;
    state_.load_speed.set_pair(i, speed);
    moves |= (magnitude(speed) > both(kRestSpeed)) | (magnitude(accel) > both(kRestAccel));
  }
  return any(moves);
}

void ServoArm::warm_drives(std::uint8_t controlled) {
  state_.overloaded &= controlled;
  for (std::size_t i = 0; i < kAxisPairs; ++i) {
    const Pair torque = state_.torque.pair(i);
    const Pair rise = numbers_.heating.pair(i) * torque * torque - numbers_.cooling.pair(i);
    state_.heat.set_pair(i, larger(state_.heat.pair(i) + rise, both(0.0)));
  }
  for_each_bit(controlled, [&](std::size_t axis) {
    if (state_.heat[axis] >= 1.0) set_bit(state_.overloaded, axis, true);
  });
}

// Axes of which nothing but the shaft can move, and nothing cools down.
WholePair ServoArm::rest_lanes(std::size_t pair, bool loads_move) const {
  if (loads_move) return WholePair{};
  const WholePair currents = (state_.torque.pair(pair) != both(0.0)) | (state_.lag.pair(pair) != both(0.0)) |
                             (state_.heat.pair(pair) != both(0.0));
  const auto waits = [&](std::size_t axis) { return state_.brake_in[axis] != 0 ? std::int64_t{-1} : 0; };
  const WholePair brakes_wait{waits(2 * pair), waits(2 * pair + 1)};
  return ~(currents | brakes_wait);
}

}  // namespace armature::cosim
