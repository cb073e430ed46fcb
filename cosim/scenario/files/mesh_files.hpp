// The files of [meshes], beside the robot file.
#pragma once

#include <filesystem>
#include <vector>

#include "cosim/robot/robot_spec.hpp"
#include "cosim/scenario/toml/table_reader.hpp"
#include "cosim/text/input_error.hpp"

namespace armature::cosim {

// Reads the files that `robot.meshes` names, makes paths of the names, and fills `robot.mesh_files`. `table`: [meshes],
// which gets the problems of its keys: no such file, not one link for each joint, no [kinematics]. Problems
// within a file are added to `all`. The triangles are not kept: only pictures need them.
void load_meshes(TableReader& table, const std::filesystem::path& folder, RobotSpec& robot, std::vector<Problem>& all);

}  // namespace armature::cosim
