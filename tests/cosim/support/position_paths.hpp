// Paths made by hand for the tests of what is measured on paths.
#pragma once

#include <Eigen/Core>

#include "controller/trajectory/path/position_path.hpp"

namespace armature::cosim::test {

inline PositionPath line_path(const Eigen::Vector3d& start_mm, const Eigen::Vector3d& end_mm) {
  PositionPath path;
  path.start_mm = start_mm;
  path.end_mm = end_mm;
  path.length_mm = (end_mm - start_mm).norm();
  return path;
}

}  // namespace armature::cosim::test
