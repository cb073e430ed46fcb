// The configuration that core 1 needs for planning, beside the robot.
#pragma once

#include <optional>

#include "controller/cell/conveyor_config.hpp"
#include "controller/cell/frames.hpp"
#include "controller/kinematics/transform.hpp"
#include "controller/trajectory/profile/synchronise.hpp"

namespace armature {

struct PlanningConfig {
  SyncRule sync = SyncRule::kFig9;
  Transform flange_T_tool{};  // the tool centre point and its axes
  UserFrames base_T_user{};   // the defined user frames
  double max_stretch =
      20.0;  // >= 1: largest factor by which a Cartesian move may be slowed down to keep the joint limits
  std::optional<ConveyorConfig> conveyor{};
};

}  // namespace armature
