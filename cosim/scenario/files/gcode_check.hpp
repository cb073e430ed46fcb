// Checks the text of a G-code program before a run.
#pragma once

#include <vector>

#include "cosim/scenario/scenario.hpp"
#include "cosim/text/input_error.hpp"

namespace armature::cosim {

// Executes the program of the scenario without an arm and adds all its errors to `all`. After an error the check begins
// again without the line of it, so an error may follow from that line. The check ends where the program reads an input.
void check_gcode(const Scenario& scenario, std::vector<Problem>& all);

}  // namespace armature::cosim
