// What core 1 hands to core 0: a finished plan of either kind.
#pragma once

#include <variant>

#include "controller/trajectory/cartesian_plan.hpp"
#include "controller/trajectory/joint_move.hpp"

namespace armature {

using MotionPlan = std::variant<JointPlan, CartesianPlan>;

}  // namespace armature
