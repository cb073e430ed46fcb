// What core 1 must know to plan, beside the robot.
#pragma once

#include "controller/command/frames.hpp"
#include "controller/kinematics/transform.hpp"
#include "controller/trajectory/profile/synchronise.hpp"

namespace armature {

struct PlanningConfig {
  SyncRule sync = SyncRule::kFig9;
  Transform flange_T_tool{};  // the tool centre point and its axes
  UserFrames base_T_user{};   // frames that a command may name
  double max_stretch = 20.0;  // >= 1: by how much a Cartesian move may be slowed down for the joints
};

}  // namespace armature
