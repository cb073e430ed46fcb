// The file of [conveyor.policy]: a network, as `armature train` writes it. Lines of words; # begins a comment.
//
//   full_mm 0.25       what an output of 127 means
//   input -0.03 0.03   the range of an input in training, in the order of BeltObservation; kInputs of them
//   crc 1234abcd       of the image, hexadecimal, 8 digits
//   image 0001020f     words of the image (rtl/policy_mlp/README.md, eight lanes), hexadecimal; any number in a line
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "controller/cell/belt_policy_config.hpp"
#include "cosim/scenario/scenario.hpp"
#include "cosim/text/input_error.hpp"

namespace armature::cosim {

// Throws InputError with the line of the first problem. The checksum is for the controller to check.
[[nodiscard]] BeltPolicyConfig parse_belt_policy(std::string_view text, const std::string& name);

// Reads the file that [conveyor.policy] names, and adds it to the sources of the scenario. Problems are added to `all`.
void load_belt_policy(Scenario& scenario, std::vector<Problem>& all);

}  // namespace armature::cosim
