#include "controller/language/job/execute/circle_points.hpp"

#include <Eigen/Geometry>

#include "controller/base/math.hpp"
#include "controller/kinematics/turns.hpp"

namespace armature::job {
namespace {

constexpr double kFlattest = 1e-6;  // height of the triangle over its longest side

// `from` turned by half of the angle to `to`, counter-clockwise about the unit vector `axis`.
Eigen::Vector3d half_way(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Eigen::Vector3d& axis) noexcept {
  double angle = math::atan2(axis.dot(from.cross(to)), from.dot(to));
  if (angle < 0.0) angle += kTurn_rad;
  const math::SinCos half = math::sin_cos(0.5 * angle);
  return half.cos * from + half.sin * axis.cross(from);
}

}  // namespace

std::optional<ArcMiddles> middles_of_arcs(const Eigen::Vector3d& first_mm, const Eigen::Vector3d& second_mm,
                                          const Eigen::Vector3d& third_mm) noexcept {
  const Eigen::Vector3d a = second_mm - first_mm, b = third_mm - first_mm;
  const Eigen::Vector3d normal = a.cross(b);
  const double longest = std::max({a.squaredNorm(), b.squaredNorm(), (b - a).squaredNorm()});
  if (!(normal.norm() > kFlattest * longest)) return std::nullopt;
  const Eigen::Vector3d to_center =
      (b.squaredNorm() * normal.cross(a) + a.squaredNorm() * b.cross(normal)) / (2.0 * normal.squaredNorm());
  const Eigen::Vector3d center = first_mm + to_center;
  const Eigen::Vector3d axis = normal / normal.norm();
  return ArcMiddles{center + half_way(first_mm - center, second_mm - center, axis),
                    center + half_way(second_mm - center, third_mm - center, axis)};
}

}  // namespace armature::job
