// Texts of scenarios that the program writes: the first one of `armature new`, and the one of `armature live --robot`.
#pragma once

#include <filesystem>
#include <string>

#include "cosim/robot/robot_spec.hpp"

namespace armature::cosim {

// A scenario file with comments: one joint move of all axes of this robot, and expectations that the run meets. A line
// that begins with # and no blank is an example; it can be used without its #. `robot_key`: the value of the key
// `robot`. `schema`: path of the JSON Schema, relative to the file.
[[nodiscard]] std::string new_scenario(const std::string& name, const std::string& robot_key, const RobotSpec& robot,
                                       const std::string& schema);

// A scenario in which the robot stands and waits for a pendant.
[[nodiscard]] std::string bare_scenario(const std::string& robot_key);

// The value of the key `robot` in a scenario in `folder`, for what the user calls the robot. Throws InputError for a
// path with characters that the key cannot have.
[[nodiscard]] std::string robot_key(const std::string& robot, const std::filesystem::path& folder);

}  // namespace armature::cosim
