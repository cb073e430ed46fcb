// The arm of a run as data: limits of its axes, and its links for a picture.
#pragma once

#include <vector>

#include "cosim/report/format/json/fact_json.hpp"
#include "cosim/robot/robot_spec.hpp"
#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

// `tool`: in the flange. Without kinematics in the robot file, `links` and `tool` are null.
[[nodiscard]] Json arm_json(const RobotSpec& robot, const PoseSpec& tool);

// The frames of a scenario, in the base.
[[nodiscard]] Json frames_json(const std::vector<FrameSpec>& frames);

}  // namespace armature::cosim
