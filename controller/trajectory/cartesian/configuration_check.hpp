// Checks the requested configurations at the ends of the segments. A path cannot choose: the start of a segment
// determines the configuration at its end (configuration.hpp).
#pragma once

#include "controller/kinematics/arm.hpp"
#include "controller/trajectory/cartesian/cartesian_plan.hpp"
#include "controller/trajectory/path/path_problem.hpp"

namespace armature {

// For the joints of the plan at a tick: kOtherConfiguration with `configuration` and, for turns, `axis`, if a segment
// that ends there requests another configuration; otherwise kNone. Segments that end at tick 0 are checked there and at
// tick 1.
[[nodiscard]] PathProblem find_other_configuration(const CartesianPlan& plan, const Arm& arm, const JointAngles& joints,
                                                   Ticks tick) noexcept;

}  // namespace armature
