// The arms of scenarios/robots for tests below the loader of the co-simulation: geometry, gears and limits, and nothing
// else of the file. Throws (toml++) when a file or a number is missing.
#pragma once

#include <string>

#include "controller/robot/robot_model.hpp"

namespace armature::test {

// `name` without the ending.
[[nodiscard]] RobotModel robot_of_file(const std::string& name);

}  // namespace armature::test
