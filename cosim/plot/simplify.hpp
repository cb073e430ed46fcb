// Leaves out points of a line that nobody would see.
#pragma once

#include <vector>

#include "cosim/plot/svg.hpp"

namespace armature::cosim {

// The points that are needed so that no point of the line is farther than `tolerance` from the simplified one. The ends
// stay (Douglas and Peucker's method).
[[nodiscard]] std::vector<PlotPoint> simplify(const std::vector<PlotPoint>& points, double tolerance);

}  // namespace armature::cosim
