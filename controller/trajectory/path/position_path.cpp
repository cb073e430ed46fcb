#include "controller/trajectory/path/position_path.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "controller/base/math.hpp"
#include "controller/kinematics/turns.hpp"

namespace armature {
namespace {

constexpr double kCollinear = 1e-10;
constexpr double kNoRadius = 1e-10;  // of the distance from the centre

// Without underflow, so that a tiny line has a direction.
double length(const Eigen::Vector3d& v) {
  return math::hypot(math::hypot(v.x(), v.y()), v.z());
}

Eigen::Vector3d point_of_arc(const PositionPath& path, double s) {
  // From the start along the chord, not from the centre: a flat arc's centre is far away, and digits would be lost.
  const math::SinCos half = math::sin_cos(0.5 * s * path.angle_rad);
  const Eigen::Vector3d in_plane =
      path.start_mm + 2.0 * path.radius_mm * half.sin * (half.cos * path.y - half.sin * path.x);
  return path.advance_mm == 0.0 ? in_plane : in_plane + s * path.advance_mm * path.x.cross(path.y);
}

}  // namespace

PositionPath line(const Eigen::Vector3d& start_mm, const Eigen::Vector3d& end_mm) noexcept {
  PositionPath path;
  path.start_mm = start_mm;
  path.end_mm = end_mm;
  path.length_mm = length(end_mm - start_mm);
  return path;
}

std::optional<PositionPath> arc(const Eigen::Vector3d& start_mm, const Eigen::Vector3d& via_mm,
                                const Eigen::Vector3d& end_mm) noexcept {
  const Eigen::Vector3d u = via_mm - start_mm;
  const Eigen::Vector3d v = end_mm - start_mm;
  const Eigen::Vector3d w = end_mm - via_mm;
  const Eigen::Vector3d normal = u.cross(v);
  const double twice_area = length(normal);
  // Written so that a NaN is refused.
  if (!(twice_area > kCollinear * std::max(u.squaredNorm(), v.squaredNorm()))) return std::nullopt;

  PositionPath path;
  path.shape = PositionPath::Shape::kArc;
  path.start_mm = start_mm;
  path.end_mm = end_mm;
  // Scaled before the multiplication: the fourth power of a length may not be representable.
  const Eigen::Vector3d unit_normal = normal / twice_area;
  const Eigen::Vector3d to_center =
      (u.squaredNorm() / twice_area * v - v.squaredNorm() / twice_area * u).cross(unit_normal) / 2.0;
  path.radius_mm = length(to_center);
  path.center_mm = start_mm + to_center;
  path.x = -to_center / path.radius_mm;
  path.y = unit_normal.cross(path.x);
  // Twice the angle by which the chord turns at `via` (inscribed angle). This has no cancellation for flat arcs, and
  // needs no test on which side of the chord the arc is.
  path.angle_rad = 2.0 * math::atan2(twice_area, u.dot(w));
  path.length_mm = path.radius_mm * path.angle_rad;
  if (!std::isfinite(path.length_mm)) return std::nullopt;
  return path;
}

std::optional<PositionPath> circle(const Eigen::Vector3d& start_mm, const Eigen::Vector3d& second_mm,
                                   const Eigen::Vector3d& third_mm) noexcept {
  auto path = arc(start_mm, second_mm, third_mm);
  if (!path) return path;
  path->end_mm = start_mm;
  path->angle_rad = kTurn_rad;
  path->length_mm = path->radius_mm * path->angle_rad;
  return path;
}

std::optional<PositionPath> arc_about(const Eigen::Vector3d& start_mm, const Eigen::Vector3d& center_mm,
                                      const Eigen::Vector3d& axis, double angle_rad, double advance_mm) noexcept {
  const double norm = length(axis);
  if (!(norm > 0.0) || !std::isfinite(norm) || angle_rad == 0.0) return std::nullopt;
  const Eigen::Vector3d normal = (angle_rad > 0.0 ? axis : -axis) / norm;
  const Eigen::Vector3d from_center = start_mm - center_mm;
  const Eigen::Vector3d radial = from_center - from_center.dot(normal) * normal;

  PositionPath path;
  path.shape = PositionPath::Shape::kArc;
  path.start_mm = start_mm;
  path.radius_mm = length(radial);
  // Written so that a NaN is refused.
  if (!(path.radius_mm > kNoRadius * length(from_center))) return std::nullopt;
  path.center_mm = start_mm - radial;
  path.x = radial / path.radius_mm;
  path.y = normal.cross(path.x);
  path.angle_rad = std::fabs(angle_rad);
  path.advance_mm = angle_rad > 0.0 ? advance_mm : -advance_mm;
  path.length_mm = math::hypot(path.radius_mm * path.angle_rad, advance_mm);
  if (!std::isfinite(path.length_mm)) return std::nullopt;
  const double turns = path.angle_rad / kTurn_rad;
  path.end_mm = start_mm;
  // Whole turns up to the rounding of an angle in degrees.
  if (advance_mm != 0.0 || std::fabs(turns - std::floor(turns + 0.5)) > 1e-12 * turns) {
    path.end_mm = point_of_arc(path, 1.0);
  }
  return path;
}

PositionPath along(const Spline& curve) noexcept {
  PositionPath path;
  path.shape = PositionPath::Shape::kSpline;
  path.start_mm = curve.points_mm().front();
  path.end_mm = curve.points_mm().back();
  path.length_mm = curve.length_mm();
  path.spline = &curve;
  return path;
}

Eigen::Vector3d point(const PositionPath& path, double s) noexcept {
  if (s <= 0.0) return path.start_mm;
  if (s >= 1.0) return path.end_mm;
  if (path.shape == PositionPath::Shape::kLine) return path.start_mm + s * (path.end_mm - path.start_mm);
  if (path.shape == PositionPath::Shape::kSpline) return path.spline->position_mm(s * path.length_mm);
  return point_of_arc(path, s);
}

double share_of(const PositionPath& path, const Eigen::Vector3d& point_mm) noexcept {
  // point() solved for its half angle, also from the start along the chord.
  const Eigen::Vector3d chord = point_mm - path.start_mm;
  return std::min(1.0, 2.0 * math::atan2(std::fabs(chord.dot(path.x)), chord.dot(path.y)) / path.angle_rad);
}

Eigen::Vector3d tangent(const PositionPath& path, double s) noexcept {
  if (path.length_mm == 0.0) return Eigen::Vector3d::Zero();
  if (path.shape == PositionPath::Shape::kLine) return (path.end_mm - path.start_mm) / path.length_mm;
  if (path.shape == PositionPath::Shape::kSpline) {
    return path.spline->at(std::clamp(s, 0.0, 1.0) * path.length_mm).tangent;
  }
  const math::SinCos phi = math::sin_cos(std::clamp(s, 0.0, 1.0) * path.angle_rad);
  Eigen::Vector3d around = phi.cos * path.y - phi.sin * path.x;
  if (path.advance_mm == 0.0) return around;
  return (path.radius_mm * path.angle_rad * around + path.advance_mm * path.x.cross(path.y)) / path.length_mm;
}

}  // namespace armature
