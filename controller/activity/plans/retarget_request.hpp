// A joint move that replaces the present motion from its present state.
#pragma once

#include "controller/base/tag.hpp"
#include "controller/trajectory/joint/joint_retarget.hpp"

namespace armature {

// Core 0 plans it, because only there the state of motion is known (PlanSource).
struct RetargetRequest {
  RetargetGoal goal{};
  Tag tag{};  // of the command
};

}  // namespace armature
