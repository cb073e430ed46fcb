// The points of a polyline, in a CSV file beside the scenario.
#pragma once

#include <cstddef>
#include <vector>

#include "cosim/scenario/scenario.hpp"
#include "cosim/text/input_error.hpp"

namespace armature::cosim {

inline constexpr std::size_t kMaxPoints = 100'000;  // of a file

// Reads the files that the polylines of the scenario name, and adds them to its sources. Points at the same place as
// the one before are left out. The problems are added to `all`: no such file, a wrong header or number, no point, more
// than kMaxPoints.
void load_points(Scenario& scenario, std::vector<Problem>& all);

}  // namespace armature::cosim
