#include "cosim/plant/independent_axes.hpp"

#include <bit>
#include <cstddef>

#include "cosim/plant/counts_per_rev.hpp"

namespace armature::cosim {

IndependentAxes::IndependentAxes(const RobotSpec& robot) {
  motors_.reserve(kAxes);
  for (const AxisSpec& axis : robot.axes) {
    motors_.emplace_back(axis.drive, static_cast<double>(counts_per_rev(axis)));
  }
}

std::uint8_t IndependentAxes::step(std::uint8_t axes, const PerAxis<MotorDemand>& demands, PerAxis<Shaft>& shafts) {
  for (unsigned rest = axes; rest != 0; rest &= rest - 1) {
    const auto axis = static_cast<std::size_t>(std::countr_zero(rest));
    if (demands[axis].controlled) {
      motors_[axis].step(shafts[axis]);
    } else {
      motors_[axis].brake(shafts[axis]);
    }
  }
  return axes;
}

}  // namespace armature::cosim
