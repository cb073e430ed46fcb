// The plane in which a tool draws, for a picture that looks at it at a right angle.
#pragma once

#include <Eigen/Core>
#include <string>

#include "cosim/plot/planned_path.hpp"
#include "cosim/plot/svg.hpp"
#include "cosim/recording/recorded_frame.hpp"
#include "cosim/recording/run_record.hpp"

namespace armature::cosim {

// A direction of the picture. If it is an axis of the base or of the frame of a program, `zero` is at the origin of
// that frame and the picture has the coordinate of that axis. Otherwise `zero` is at the middle of the points.
struct PlaneDirection {
  Eigen::Vector3d along = Eigen::Vector3d::UnitX();  // unit vector
  double zero = 0;
  std::string label;  // with the unit
};

struct DrawingPlane {
  PlaneDirection right, up;
  double tilt_deg = 0;  // against the floor, 0 to 90
  std::string frame{};  // along whose z it is seen: "the base", or "the frame plate"; empty: none

  [[nodiscard]] PlotPoint of(const Eigen::Vector3d& point) const {
    return {right.along.dot(point) - right.zero, up.along.dot(point) - up.zero};
  }
};

// The plane through points that are about in one plane. At least one point.
[[nodiscard]] DrawingPlane drawing_plane(const SpacePoints& points);

// x and y of this frame.
[[nodiscard]] DrawingPlane plane_of_frame(const RecordedFrame& frame);

// Whether the points are about in one plane that is parallel to x and y of this frame, so that a view along its z shows
// what is drawn.
[[nodiscard]] bool is_level_in(const RecordedFrame& frame, const SpacePoints& points);

// That of the frame of the program if the drawn points are level in it, or else the one through them.
[[nodiscard]] DrawingPlane plane_of_run(const RunRecord& run, const SpacePoints& drawn);

}  // namespace armature::cosim
