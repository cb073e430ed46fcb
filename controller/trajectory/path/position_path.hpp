// Straight lines, circular arcs, helices and splines in space, Vo 2021 eq. (15) and (17)-(19), corrected: (15) lacks
// the + after p_i, (18) calls the arc angle n(t) and (17), (18) mix the arc length with the normalised parameter of
// (16). Here the parameter is the share of the length, s = 0..1.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>

#include "controller/base/members.hpp"
#include "controller/trajectory/path/spline.hpp"

namespace armature {

// What an event says of a path: all but the curve of a spline.
struct PathGeometry {
  enum class Shape : std::uint8_t { kLine, kArc, kSpline };

  Shape shape = Shape::kLine;
  Eigen::Vector3d start_mm = Eigen::Vector3d::Zero();
  Eigen::Vector3d end_mm = Eigen::Vector3d::Zero();
  double length_mm = 0.0;  // 0: a point

  // kArc: centre + radius (cos(phi) x + sin(phi) y) + s advance (x cross y), phi = s * angle. x and y are orthonormal,
  // x points to the start.
  Eigen::Vector3d center_mm = Eigen::Vector3d::Zero();
  Eigen::Vector3d x = Eigen::Vector3d::UnitX();
  Eigen::Vector3d y = Eigen::Vector3d::UnitY();
  double radius_mm = 0.0;
  double angle_rad = 0.0;   // > 0; more than 2 pi: several turns
  double advance_mm = 0.0;  // of a helix, along its axis; 0: an arc or a circle
  ARMATURE_MEMBERS(PathGeometry, shape, start_mm, end_mm, length_mm, center_mm, x, y, radius_mm, angle_rad, advance_mm)
};

struct PositionPath : PathGeometry {
  const Spline* spline = nullptr;  // kSpline: the curve, which is not copied with the path
};

[[nodiscard]] PositionPath line(const Eigen::Vector3d& start_mm, const Eigen::Vector3d& end_mm) noexcept;

// From start through via to end. Nothing if the three points do not determine a circle: |u x v| <= 1e-10 max(|u|^2,
// |v|^2) with u = via - start, v = end - start, or if a coordinate is not finite.
[[nodiscard]] std::optional<PositionPath> arc(const Eigen::Vector3d& start_mm, const Eigen::Vector3d& via_mm,
                                              const Eigen::Vector3d& end_mm) noexcept;

// The full circle through three points, from the first in the direction of the second, back to the first. Nothing in
// the same cases as for arc().
[[nodiscard]] std::optional<PositionPath> circle(const Eigen::Vector3d& start_mm, const Eigen::Vector3d& second_mm,
                                                 const Eigen::Vector3d& third_mm) noexcept;

// From the start around the axis through `center_mm` by an angle, right-handed about `axis` (of any length), and at the
// same time along the axis by `advance_mm`: an arc, a circle, or a helix of any number of turns. After whole turns
// without advance it ends exactly at the start. Nothing if the axis has no direction, the start is on the axis, the
// angle is 0, or a number is not finite.
[[nodiscard]] std::optional<PositionPath> arc_about(const Eigen::Vector3d& start_mm, const Eigen::Vector3d& center_mm,
                                                    const Eigen::Vector3d& axis, double angle_rad,
                                                    double advance_mm) noexcept;

// Along a curve that must outlive the path.
[[nodiscard]] PositionPath along(const Spline& curve) noexcept;

// Exactly start_mm for s <= 0 and end_mm for s >= 1.
[[nodiscard]] Eigen::Vector3d point(const PositionPath& path, double s) noexcept;

// For an arc() or a circle(): the share s, (0, 1], of a point of the path other than its start.
[[nodiscard]] double share_of(const PositionPath& path, const Eigen::Vector3d& point_mm) noexcept;

// Unit vector in the direction of motion, also at and beyond both ends; 0 for a path without length.
[[nodiscard]] Eigen::Vector3d tangent(const PositionPath& path, double s) noexcept;

}  // namespace armature
