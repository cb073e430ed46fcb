#include "controller/trajectory/cartesian/configuration_check.hpp"

#include <cstddef>

namespace armature {
namespace {

// The first joint that has other turns; 0: none.
std::uint8_t axis_with_other_turns(const Configuration& wanted, const JointAngles& joints) {
  if (!wanted.turns) return 0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!has_turns(joints[axis].value(), (*wanted.turns)[axis])) return static_cast<std::uint8_t>(axis + 1);
  }
  return 0;
}

}  // namespace

PathProblem find_other_configuration(const CartesianPlan& plan, const Arm& arm, const JointAngles& joints,
                                     Ticks tick) noexcept {
  for (std::size_t i = 0; i < plan.count; ++i) {
    const CartesianSegment& segment = plan.segments[i];
    const Ticks end = end_of(segment);
    const bool ends_here = end == tick || (end == Ticks{0} && tick == Ticks{1});
    if (!ends_here || requested_parts(segment.configuration) == 0) continue;
    const std::uint8_t sides = differing_sides(segment.configuration, arm.configuration(joints));
    const std::uint8_t axis = axis_with_other_turns(segment.configuration, joints);
    if (sides == 0 && axis == 0) continue;
    return {.kind = PathProblem::Kind::kOtherConfiguration,
            .segment = static_cast<std::uint8_t>(i),
            .at = 1.0,
            .axis = axis,
            .configuration = static_cast<std::uint8_t>(sides | (axis != 0 ? kTurnsPart : 0))};
  }
  return {};
}

}  // namespace armature
