#include "cosim/plant/independent_axes.hpp"

#include <cmath>

#include "cosim/logic/axis_bits.hpp"
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
  for_each_bit((limited | ~demands.controlled | ~axes) & kAllAxes, [&](std::size_t axis) {
    shafts.set(axis, before[axis]);
    if (has_bit(axes, axis)) step_alone(axis, has_bit(demands.controlled, axis), shafts);
  });
  return axes;
}

// As PositionLoop::step(), operation for operation, so the same bits.
std::uint8_t IndependentAxes::step_within_limits(Shafts& shafts) const {
  PerAxis<double> excess;
  for (std::size_t i = 0; i < kAxes; ++i) {
    const double error = error_by_error_[i] * shafts.error[i] + error_by_speed_[i] * shafts.speed[i];
    const double speed = speed_by_error_[i] * shafts.error[i] + speed_by_speed_[i] * shafts.speed[i];
    const double accel_excess = std::fabs(speed - shafts.speed[i]) - max_accel_[i];
    const double speed_excess = std::fabs(speed) - max_speed_[i];
    excess[i] = accel_excess > speed_excess ? accel_excess : speed_excess;
    const bool rests = (std::fabs(error) < PositionLoop::kRestCounts) & (std::fabs(speed) < rest_speed_[i]);
    shafts.error[i] = rests ? 0.0 : error;
    shafts.speed[i] = rests ? 0.0 : speed;
  }
  std::uint8_t limited = 0;
  for (std::size_t i = 0; i < kAxes; ++i) limited |= static_cast<std::uint8_t>((excess[i] > 0.0 ? 1 : 0) << i);
  return limited;
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
