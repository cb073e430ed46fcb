#include "cosim/plant/independent_axes.hpp"

#include <cstddef>

#include "cosim/logic/axis_bits.hpp"
#include "cosim/plant/counts_per_rev.hpp"

namespace armature::cosim {

IndependentAxes::IndependentAxes(const RobotSpec& robot) {
  motors_.reserve(kAxes);
  for (const AxisSpec& axis : robot.axes) {
    motors_.emplace_back(axis.drive, static_cast<double>(counts_per_rev(axis)));
  }
}

std::uint8_t IndependentAxes::step(std::uint8_t axes, const PerAxis<MotorDemand>& demands, PerAxis<Shaft>& shafts) {
  for_each_bit(axes, [&](std::size_t axis) {
    if (demands[axis].controlled) {
      motors_[axis].step(shafts[axis]);
    } else {
      motors_[axis].brake(shafts[axis]);
    }
  });
  return axes;
}

}  // namespace armature::cosim
