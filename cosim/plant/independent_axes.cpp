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
    const PositionLoop::Numbers& numbers = motor.numbers();
    error_by_error_[axis] = numbers.error_by_error;
    error_by_speed_[axis] = numbers.error_by_speed;
    speed_by_error_[axis] = numbers.speed_by_error;
    speed_by_speed_[axis] = numbers.speed_by_speed;
    max_accel_[axis] = numbers.max_accel;
    max_speed_[axis] = numbers.max_speed;
    rest_speed_[axis] = numbers.rest_speed;
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
  return axes;
}

// As PositionLoop::step(), operation for operation, so the same bits.
std::uint8_t IndependentAxes::step_within_limits(Shafts& shafts) const {
  std::array<WholePair, kAxisPairs> limited;
  WholePair any_limited{};
  for (std::size_t i = 0; i < kAxisPairs; ++i) {
    const Pair error_before = shafts.error.pair(i), speed_before = shafts.speed.pair(i);
    const Pair error = error_by_error_.pair(i) * error_before + error_by_speed_.pair(i) * speed_before;
    const Pair speed = speed_by_error_.pair(i) * error_before + speed_by_speed_.pair(i) * speed_before;
    limited[i] = (magnitude(speed - speed_before) > max_accel_.pair(i)) | (magnitude(speed) > max_speed_.pair(i));
    any_limited |= limited[i];
    const WholePair rests =
        (magnitude(error) < both(PositionLoop::kRestCounts)) & (magnitude(speed) < rest_speed_.pair(i));
    shafts.error.set_pair(i, only(~rests, error));
    shafts.speed.set_pair(i, only(~rests, speed));
  }
  std::uint8_t axes = 0;
  if (any(any_limited)) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) set_bit(axes, axis, limited[axis / 2][axis % 2] != 0);
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
