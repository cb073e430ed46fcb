// The programs that the pendant of a scenario sends.
#pragma once

#include <cstddef>
#include <vector>

#include "cosim/scenario/scenario.hpp"
#include "cosim/text/input_error.hpp"

namespace armature::cosim {

// Of a program that a pendant reads. The controller has less room, which is an error that it reports.
inline constexpr std::size_t kMaxSentBytes = std::size_t{1} << 20U;

// Reads the files that the steps `download` name, and adds them to the sources of the scenario. Their text is for the
// controller to check. The problems are added to `all`: no such file, an empty one, a character that is not ASCII.
void load_pendant_programs(Scenario& scenario, std::vector<Problem>& all);

}  // namespace armature::cosim
