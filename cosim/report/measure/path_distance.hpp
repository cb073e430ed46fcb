// The distance of a point from a path, computed independently of the controller except for the geometry of the path.
#pragma once

#include <Eigen/Core>

#include "controller/trajectory/path/position_path.hpp"

namespace armature::cosim {

// To the nearest point of the curve itself, not of the line or circle that it is a part of. Exact to rounding for
// lines, arcs and helices. For splines it is too large by at most 1e-10 mm plus 1e-7 of the distance, and never too
// small.
[[nodiscard]] double distance_mm(const PositionPath& path, const Eigen::Vector3d& point_mm);

}  // namespace armature::cosim
