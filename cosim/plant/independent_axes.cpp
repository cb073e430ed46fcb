#include "cosim/plant/independent_axes.hpp"

#include <array>

#include "cosim/logic/axis_bits.hpp"
#include "cosim/logic/axis_pairs.hpp"
#include "cosim/plant/counts_per_rev.hpp"

namespace armature::cosim {

IndependentAxes::IndependentAxes(const RobotSpec& robot) {
  motors_.reserve(kAxes);
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const AxisSpec& spec = robot.axes[axis];
    const PositionLoop& motor = motors_.emplace_back(spec.drive, static_cast<double>(counts_per_rev(spec)));
    loops_.set(axis, motor.numbers());
  }
}

std::uint8_t IndependentAxes::step(std::uint8_t axes, const MotorDemands& demands, Shafts& shafts) {
  const Shafts before = shafts;
  const std::uint8_t limited = step_within_limits(shafts);
  const auto others = static_cast<std::uint8_t>((limited | ~demands.controlled | ~axes) & kAllAxes);
  for_each_bit(others, [&](std::size_t axis) {
    shafts.set(axis, before[axis]);
    if (has_bit(axes, axis)) step_alone(axis, has_bit(demands.controlled, axis), shafts);
  });
  for_each_bit(blocked_, [&](std::size_t axis) { shafts.set(axis, {.error = before.error[axis], .speed = 0.0}); });
  return axes;
}

std::uint8_t IndependentAxes::step_within_limits(Shafts& shafts) const {
  std::array<PositionLoops::Events, kAxisPairs> events;
  WholePair limited{};
  for (std::size_t i = 0; i < kAxisPairs; ++i) {
    Pair error = shafts.error.pair(i), speed = shafts.speed.pair(i);
    loops_.step(i, error, speed, events[i]);
    limited |= ~events[i].within;
    shafts.error.set_pair(i, error);
    shafts.speed.set_pair(i, speed);
  }
  std::uint8_t axes = 0;
  if (any(limited)) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) set_bit(axes, axis, events[axis / 2].within[axis % 2] == 0);
  }
  return axes;
}

void IndependentAxes::step_alone(std::size_t axis, bool controlled, Shafts& shafts) const {
  Shaft shaft = shafts[axis];
  if (controlled) {
    motors_[axis].step(shaft);
  } else {
    motors_[axis].brake(shaft);
  }
  shafts.set(axis, shaft);
}

}  // namespace armature::cosim
