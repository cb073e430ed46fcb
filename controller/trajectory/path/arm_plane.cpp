#include "controller/trajectory/path/arm_plane.hpp"

#include <algorithm>
#include <cmath>

#include "controller/base/math.hpp"
#include "controller/kinematics/five_r.hpp"
#include "controller/kinematics/turns.hpp"
#include "controller/trajectory/path/orientation_path.hpp"

namespace armature {
namespace {

using math::SinCos;

Eigen::Matrix3d about_axis_1(SinCos heading) {
  Eigen::Matrix3d m;
  m << heading.cos, -heading.sin, 0.0, heading.sin, heading.cos, 0.0, 0.0, 0.0, 1.0;
  return m;
}

// The heading of the plane for which a tool outside the plane by `aside` has `point` in front of it (x >= 0) or behind
// it.
SinCos heading_at(const Eigen::Vector3d& point, double x, double aside) {
  const double c = point.x() * x + point.y() * aside;
  const double s = point.y() * x - point.x() * aside;
  const double norm = math::hypot(c, s);
  return norm == 0.0 ? SinCos{.sin = 0.0, .cos = 1.0} : SinCos{.sin = s / norm, .cos = c / norm};
}

double distance_from_axis_1(const Eigen::Vector3d& point) {
  return math::hypot(point.x(), point.y());
}

// x of the tool point, from the square in factors; 0 if the square is not positive.
double distance_before(const Eigen::Vector3d& point, double aside) {
  const double rho = distance_from_axis_1(point);
  return std::sqrt(std::max((rho - std::fabs(aside)) * (rho + std::fabs(aside)), 0.0));
}

double missing_mm(const Eigen::Vector3d& point, double aside) {
  return std::max(std::fabs(aside) - distance_from_axis_1(point), 0.0);
}

// The angles of a rotation turned into the plane by the smallest angle: as in FiveR, but for a given plane.
PlaneAngles seen_in(const Eigen::Matrix3d& base_R_flange, SinCos heading) {
  const Eigen::Matrix3d m = about_axis_1(heading).transpose() * base_R_flange;
  return {.pitch_rad = math::atan2(-m(0, 2), -m(2, 2)), .roll_rad = math::atan2(-m(1, 0), -m(1, 1))};
}

}  // namespace

Eigen::Matrix3d rotation_in_plane(const PlaneAngles& angles) noexcept {
  const SinCos t = math::sin_cos(angles.pitch_rad), r = math::sin_cos(angles.roll_rad);
  Eigen::Matrix3d m;
  m << t.cos * r.cos, -t.cos * r.sin, -t.sin,  //
      -r.sin, -r.cos, 0.0,                     //
      -t.sin * r.cos, t.sin * r.sin, -t.cos;
  return m;
}

HeldTool hold_tool(const PlaneAngles& angles, const Eigen::Vector3d& tool_point_mm,
                   const Transform& flange_T_tool) noexcept {
  const Eigen::Matrix3d in_plane = rotation_in_plane(angles);
  const double aside = in_plane.row(1).dot(flange_T_tool.position_mm);
  const SinCos heading = heading_at(tool_point_mm, distance_before(tool_point_mm, aside), aside);
  return {.base_T_tool = {about_axis_1(heading) * in_plane * flange_T_tool.rotation, tool_point_mm},
          .missing_mm = missing_mm(tool_point_mm, aside)};
}

HeldTool into_plane(const Transform& base_T_tool, const Transform& flange_T_tool) noexcept {
  // The heading depends on the flange position, and that on the angles, but only weakly. Each iteration reduces the
  // error to tilt * offset / (distance of the flange from axis 1) of it.
  constexpr int kRounds = 4;
  const Eigen::Matrix3d base_R_flange = base_T_tool.rotation * flange_T_tool.rotation.transpose();
  const Eigen::Vector3d point = base_T_tool.position_mm;
  SinCos heading = heading_at(point - base_R_flange * flange_T_tool.position_mm, 1.0, 0.0);
  Eigen::Matrix3d in_plane = rotation_in_plane(seen_in(base_R_flange, heading));
  for (int round = 1; round < kRounds; ++round) {
    heading = heading_at(point - about_axis_1(heading) * in_plane * flange_T_tool.position_mm, 1.0, 0.0);
    in_plane = rotation_in_plane(seen_in(base_R_flange, heading));
  }
  // Exactly the tool point, also close to axis 1.
  const double before = heading.cos * point.x() + heading.sin * point.y();
  const double aside = in_plane.row(1).dot(flange_T_tool.position_mm);
  heading = heading_at(point, std::copysign(distance_before(point, aside), before), aside);
  return {.base_T_tool = {about_axis_1(heading) * in_plane * flange_T_tool.rotation, point},
          .missing_mm = missing_mm(point, aside)};
}

ArmPlane::ArmPlane(const ArmGeometry& arm, const Transform& flange_T_tool) noexcept
    : arm_{arm}, flange_T_tool_{flange_T_tool}, tool_T_flange_{inverse(flange_T_tool)} {}

double ArmPlane::max_residual_rad() const noexcept {
  return std::clamp(arm_.max_projection_rad, kNoResidual_rad, 0.25 * kTurn_rad - kNoResidual_rad);
}

double ArmPlane::tilt(const Transform& base_T_tool) const noexcept {
  const Eigen::Vector3d approach = base_T_tool.rotation * tool_T_flange_.rotation.col(2);
  return math::hypot(approach.x(), approach.y());
}

int ArmPlane::upright(const Transform& base_T_tool) const noexcept {
  if (!(tilt(base_T_tool) <= kUpright_rad)) return 0;
  return base_T_tool.rotation.row(2).dot(tool_T_flange_.rotation.col(2)) > 0.0 ? +1 : -1;
}

double ArmPlane::heading_rad(const Transform& base_T_tool) const noexcept {
  return FiveR{arm_}.from_transform(base_T_tool * tool_T_flange_).pose.heading_rad;
}

ArmPlane::Nearest ArmPlane::nearest(const Transform& base_T_tool) const noexcept {
  const NearestPose5 flange = FiveR{arm_}.from_transform(base_T_tool * tool_T_flange_);
  const SinCos heading = math::sin_cos(flange.pose.heading_rad);
  const Eigen::Vector3d& point = base_T_tool.position_mm;
  Nearest result{.angles = {.pitch_rad = flange.pose.pitch_rad, .roll_rad = flange.pose.roll_rad}};
  // In FiveR the flange is in front of the arm; here it is the tool point.
  if (heading.cos * point.x() + heading.sin * point.y() < 0.0) {
    result.angles = {.pitch_rad = -flange.pose.pitch_rad, .roll_rad = opposite(flange.pose.roll_rad)};
  }
  const HeldTool held = hold_tool(result.angles, point, flange_T_tool_);
  result.residual_rad = std::max(flange.residual_rad, turn(base_T_tool.rotation, held.base_T_tool.rotation).angle_rad);
  return result;
}

bool ArmPlane::passes_over_axis_1(const Transform& base_T_tool, const Eigen::Vector3d& to_mm) const noexcept {
  constexpr double kRounding = 1e-12;
  const SinCos heading = math::sin_cos(heading_rad(base_T_tool));
  const Eigen::Vector3d outwards{heading.cos, heading.sin, 0.0}, normal{-heading.sin, heading.cos, 0.0};
  const Eigen::Vector3d move_mm = to_mm - base_T_tool.position_mm;
  return outwards.dot(base_T_tool.position_mm) * outwards.dot(to_mm) <= 0.0 &&
         std::fabs(normal.dot(move_mm)) <= kRounding * move_mm.norm();
}

Eigen::Matrix3d ArmPlane::kept(const Transform& base_T_tool, const Eigen::Vector3d& to_mm,
                               bool straight) const noexcept {
  if (!exists() || upright(base_T_tool) != 0) return base_T_tool.rotation;
  if (straight && passes_over_axis_1(base_T_tool, to_mm)) return base_T_tool.rotation;
  return hold_tool(nearest(base_T_tool).angles, to_mm, flange_T_tool_).base_T_tool.rotation;
}

}  // namespace armature
