// The text of a first scenario, for `armature new`.
#pragma once

#include <string>

#include "cosim/robot/robot_spec.hpp"

namespace armature::cosim {

// A scenario file with comments: one joint move of all axes of this robot, and expectations that the run meets. A line
// that begins with # and no blank is an example; it can be used without its #. `robot_key`: the value of the key
// `robot`. `schema`: path of the JSON Schema, relative to the file.
[[nodiscard]] std::string new_scenario(const std::string& name, const std::string& robot_key, const RobotSpec& robot,
                                       const std::string& schema);

}  // namespace armature::cosim
