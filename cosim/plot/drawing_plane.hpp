// The plane in which a tool draws, for a picture that looks at it at a right angle.
#pragma once

#include <Eigen/Core>
#include <string>

#include "cosim/plot/planned_path.hpp"
#include "cosim/plot/svg.hpp"

namespace armature::cosim {

// A direction of the picture. If it is an axis of the base, `zero` is 0 and the picture has the coordinate of that
// axis. Otherwise `zero` is at the middle of the points.
struct PlaneDirection {
  Eigen::Vector3d along = Eigen::Vector3d::UnitX();  // unit vector
  double zero = 0;
  std::string label;  // with the unit
};

struct DrawingPlane {
  PlaneDirection right, up;
  double tilt_deg = 0;  // against the floor, 0 to 90

  [[nodiscard]] PlotPoint of(const Eigen::Vector3d& point) const {
    return {right.along.dot(point) - right.zero, up.along.dot(point) - up.zero};
  }
};

// The plane through points that are about in one plane. At least one point.
[[nodiscard]] DrawingPlane drawing_plane(const SpacePoints& points);

}  // namespace armature::cosim
