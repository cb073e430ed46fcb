// The rigid bodies of a robot file.
#pragma once

#include "cosim/dynamics/arm_dynamics.hpp"
#include "cosim/robot/robot_spec.hpp"

namespace armature::cosim {

// The robot has [kinematics] and a link for each joint. Tool and payload belong to the last link.
[[nodiscard]] ArmModel arm_model(const RobotSpec& robot);

}  // namespace armature::cosim
