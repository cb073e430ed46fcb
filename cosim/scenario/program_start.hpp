// When the program of a scenario may begin.
#pragma once

#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

// Earliest start of the program [s]: program_at_s, and not before the last command of the scenario that moves the arm
// is sent. The controller then waits until the arm stands.
[[nodiscard]] double program_start_s(const Scenario& scenario);

}  // namespace armature::cosim
