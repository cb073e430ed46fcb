// The scenario that a Cartesian one is compared with.
#pragma once

#include "cosim/scenario/scenario.hpp"

namespace armature::bench {

// The same robot, length and commands, with every line replaced by a joint move that ends in the same joint angles and
// begins and ends in the same ticks, within a few: the same pulses in the same time, to within the bend of the path.
// All targets are joint angles and nothing is expected, so neither cores nor recorder compute any kinematics. Of joint
// moves and lines only; lines of one `at_s` that are blended are planned as a chain. Throws std::invalid_argument
// otherwise.
[[nodiscard]] cosim::Scenario joint_twin(const cosim::Scenario& scenario);

}  // namespace armature::bench
