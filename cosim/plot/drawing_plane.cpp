#include "cosim/plot/drawing_plane.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "controller/base/angle_units.hpp"
#include "controller/base/math.hpp"

namespace armature::cosim {
namespace {

using Eigen::Vector3d;

constexpr double kSmallestShapeMm = 1e-3;
constexpr std::string_view kBaseName = "base";

// The point for which `size` is largest.
template <class Size>
Vector3d farthest(const SpacePoints& points, Size size) {
  return *std::ranges::max_element(points, {}, size);
}

// A unit vector at a right angle to the plane, towards a viewer who stands above it, or in front of a wall.
Vector3d plane_normal(const SpacePoints& points) {
  const Vector3d& start = points.front();
  const Vector3d far = farthest(points, [&](const Vector3d& p) { return (p - start).norm(); }) - start;
  if (far.norm() < kSmallestShapeMm) return Vector3d::UnitZ();
  const Vector3d along = far.normalized();
  const Vector3d wide = farthest(points, [&](const Vector3d& p) { return along.cross(p - start).norm(); }) - start;
  Vector3d normal = along.cross(wide);
  // A straight line: look at it from above, or from the side if it is vertical.
  if (normal.norm() < kSmallestShapeMm) normal = Vector3d::UnitZ() - along.z() * along;
  if (normal.norm() < kSmallestShapeMm) normal = Vector3d::UnitX();
  normal.normalize();
  constexpr double kLevel = 1e-6;
  const bool wall = std::fabs(normal.z()) < kLevel;
  const bool away = wall ? normal.x() + normal.y() < 0 : normal.z() < 0;
  return away ? Vector3d{-normal} : normal;
}

PlaneDirection plane_direction(Vector3d along, const SpacePoints& points, std::string_view other_label) {
  constexpr double kAligned = 1 - 1e-9;
  constexpr std::array<std::string_view, 3> kAxes3{"x", "y", "z"};
  for (int i = 0; i < 3; ++i) {
    if (std::fabs(along[i]) < kAligned) continue;
    const std::string sign = along[i] < 0 ? "\u2212" : "";
    along = (along[i] < 0 ? -1.0 : 1.0) * Vector3d::Unit(i);
    return {along, 0, sign + std::string{kAxes3[static_cast<std::size_t>(i)]} + " [mm]"};
  }
  const auto at = [&](const Vector3d& p) { return along.dot(p); };
  const double zero =
      (at(*std::ranges::min_element(points, {}, at)) + at(*std::ranges::max_element(points, {}, at))) / 2;
  return {along, zero, std::string{other_label} + " [mm]"};
}

}  // namespace

DrawingPlane drawing_plane(const SpacePoints& points) {
  constexpr double kFloor = 0.985;  // cos(10 deg): a plane that is nearly level is drawn with y upwards
  const Vector3d normal = plane_normal(points);
  const Vector3d upright = normal.z() > kFloor ? Vector3d::UnitY() : Vector3d::UnitZ();
  const Vector3d up = (upright - upright.dot(normal) * normal).normalized();
  const Vector3d right = up.cross(normal);
  const double level = std::sqrt(normal.x() * normal.x() + normal.y() * normal.y());
  return {.right = plane_direction(right, points, "across the plane"),
          .up = plane_direction(up, points, "up the plane"),
          .tilt_deg = math::atan2(level, normal.z()) * kDegPerRad};
}

DrawingPlane plane_of_frame(const RecordedFrame& frame) {
  const bool base = frame.name == kBaseName;
  const auto direction = [&](int axis, const char* name) {
    const Vector3d along = frame.base_T_frame.rotation.col(axis);
    const std::string label = base ? fmt::format("{} [mm]", name) : fmt::format("{} in {} [mm]", name, frame.name);
    return PlaneDirection{along, along.dot(frame.base_T_frame.position_mm), label};
  };
  return {.right = direction(0, "x"), .up = direction(1, "y"), .frame = base ? "the base" : "the frame " + frame.name};
}

bool is_level_in(const RecordedFrame& frame, const SpacePoints& points) {
  constexpr double kMostDepth = 0.5;  // of the width: a pen that goes down and up is still drawn from above
  const Transform frame_T_base = inverse(frame.base_T_frame);
  Vector3d low = frame_T_base * points.front();
  Vector3d high = low;
  for (const Vector3d& point : points) {
    const Vector3d inside = frame_T_base * point;
    low = low.cwiseMin(inside);
    high = high.cwiseMax(inside);
  }
  const Vector3d size = high - low;
  return size.z() <= kMostDepth * std::max(size.x(), size.y());
}

DrawingPlane plane_of_run(const RunRecord& run, const SpacePoints& drawn) {
  const auto frame = recorded_program_frame(run.summary);
  return frame && is_level_in(*frame, drawn) ? plane_of_frame(*frame) : drawing_plane(drawn);
}

}  // namespace armature::cosim
