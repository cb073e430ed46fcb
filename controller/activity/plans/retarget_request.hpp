// A joint move that replaces the present motion from its present state.
#pragma once

#include "controller/base/axes.hpp"
#include "controller/base/tag.hpp"
#include "controller/base/units.hpp"
#include "controller/trajectory/profile/time_law.hpp"

namespace armature {

// Core 0 plans it, because only there the state of motion is known (PlanSource).
struct RetargetRequest {
  PerAxis<Radians> target{};
  double speed = 1.0;  // these three as in plan_retarget()
  double accel = 1.0;
  ProfileKind kind = ProfileKind::kTrapezoid;
  Tag tag{};  // of the command
};

}  // namespace armature
