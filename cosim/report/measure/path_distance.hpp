// The distance of a point from a path, computed independently of the controller except for the geometry of the path.
#pragma once

#include <Eigen/Core>

#include "controller/trajectory/path/position_path.hpp"

namespace armature::cosim {

// To the nearest point of the curve itself, not of the line or circle that it is a part of. Exact to rounding for
// lines, arcs and helices. For splines it is too large by at most 1e-10 mm plus 1e-7 of the distance, and never too
// small.
[[nodiscard]] double distance_mm(const PositionPath& path, const Eigen::Vector3d& point_mm);

// All points of the path are in it.
struct Ball {
  Eigen::Vector3d center_mm = Eigen::Vector3d::Zero();
  double radius_mm = 0;

  // Whether no point of the path can be as near to the point as `mm`. Rounding does not matter.
  [[nodiscard]] bool is_farther(const Eigen::Vector3d& point_mm, double mm) const {
    constexpr double kRounding_mm = 1e-9;
    const double reach_mm = mm + radius_mm + kRounding_mm;
    return (point_mm - center_mm).squaredNorm() > reach_mm * reach_mm;
  }
};
[[nodiscard]] Ball ball_around(const PositionPath& path);

}  // namespace armature::cosim
