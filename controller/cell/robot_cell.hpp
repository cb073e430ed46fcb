// The robot with its tool and the frames around it: what a program needs to know.
#pragma once

#include "controller/cell/frames.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/kinematics/transform.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature {

// The references must outlive whatever keeps a copy.
struct RobotCell {
  const RobotModel& robot;
  const Arm& arm;
  Transform flange_T_tool{};  // the tool centre point and its axes
  UserFrames base_T_user{};   // element i is FrameId{i + 1}, which the robot language calls USER i + 1
};

}  // namespace armature
