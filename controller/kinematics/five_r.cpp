#include "controller/kinematics/five_r.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "controller/base/math.hpp"
#include "controller/kinematics/turns.hpp"

namespace armature {
namespace {

constexpr double kReachTolerance = 1e-9;     // of a2 + a3
constexpr double kVerticalTolerance = 1e-9;  // sine of the approach's angle to axis 1
constexpr double kTrackingTolerance = 1e-7;  // instead of both in track()
constexpr double kAgreement = 1e-12;         // of the arm's length: tool point and approach in one plane
constexpr double kNoResidual_rad = 1e-9;     // size of rounding errors
constexpr double kNormalTolerance = 1e-9;    // cosine of the approach's angle to the plane

double reach_of(const ArmGeometry& arm) {
  return arm.a2_mm + arm.a3_mm;
}

double length_of(const ArmGeometry& arm) {
  return std::fabs(arm.a1_mm) + reach_of(arm) + std::fabs(arm.a4_mm) + std::fabs(arm.d5_mm);
}

Eigen::Matrix3d rotation_of(math::SinCos th1, math::SinCos t, math::SinCos th5) {
  Eigen::Matrix3d rotation;
  rotation << th1.cos * t.cos * th5.cos + th1.sin * th5.sin, -th1.cos * t.cos * th5.sin + th1.sin * th5.cos,
      -th1.cos * t.sin,  //
      th1.sin * t.cos * th5.cos - th1.cos * th5.sin, -th1.sin * t.cos * th5.sin - th1.cos * th5.cos,
      -th1.sin * t.sin,  //
      -t.sin * th5.cos, t.sin * th5.sin, -t.cos;
  return rotation;
}

// A pose projected into its vertical plane through axis 1, in coordinates of that plane.
struct InPlane {
  double theta1 = 0.0, theta5 = 0.0, pitch = 0.0;  // of the shoulder +1
  double r = 0.0, z = 0.0;                         // tool point in the plane
  double a_r = 0.0, a_z = 0.0;                     // approach, of unit length
  double residual = 0.0;
  bool free_heading = false;
  bool normal = false;  // the approach is normal to the plane: pitch and roll are undefined
};

InPlane in_plane(const ArmGeometry& arm, const Transform& pose, double free_heading, double free_below) {
  const double px = pose.position_mm.x();
  const double py = pose.position_mm.y();
  const double ax = pose.rotation(0, 2);
  const double ay = pose.rotation(1, 2);
  const double az = pose.rotation(2, 2);
  const double reach = reach_of(arm);
  const double rho = math::hypot(px, py);
  const double horizontal = math::hypot(ax, ay);
  const bool on_axis = rho < kReachTolerance * reach;
  const bool free = rho < free_below * reach && horizontal < free_below;
  const bool agree = std::fabs(px * ay - py * ax) <= kAgreement * length_of(arm) * horizontal;

  InPlane plane;
  double c = 0.0;
  double s = 0.0;
  if (free) {
    const auto heading = math::sin_cos(free_heading);
    c = heading.cos;
    s = heading.sin;
    plane.theta1 = wrapped(free_heading);
    plane.free_heading = true;
    plane.r = c * px + s * py;
  } else if (on_axis || (agree && horizontal * reach > rho)) {
    const bool backwards = !on_axis && px * ax + py * ay < 0.0;
    c = (backwards ? -ax : ax) / horizontal;
    s = (backwards ? -ay : ay) / horizontal;
    plane.theta1 = math::atan2(s, c);
    plane.r = c * px + s * py;
  } else {
    c = px / rho;
    s = py / rho;
    plane.theta1 = math::atan2(py, px);
    plane.r = rho;
  }
  plane.z = pose.position_mm.z();

  // The smallest rotation that turns the approach into the plane. It keeps the directions of (a_r, a_z) and of the
  // normal's components along the tool's x and y axes: only their lengths change.
  const double out_of_plane = c * ay - s * ax;
  const double radial = c * ax + s * ay;
  const double inside = math::hypot(radial, az);
  plane.residual = math::atan2(std::fabs(out_of_plane), inside);
  plane.normal = inside < kNormalTolerance;
  if (plane.normal) return plane;
  plane.a_r = radial / inside;
  plane.a_z = az / inside;
  plane.pitch = math::atan2(-plane.a_r, -plane.a_z);
  plane.theta5 =
      math::atan2(s * pose.rotation(0, 0) - c * pose.rotation(1, 0), s * pose.rotation(0, 1) - c * pose.rotation(1, 1));
  return plane;
}

// theta_1, theta_5 and t of one shoulder, and the remaining triangle of a2 and a3.
struct Shoulder {
  double theta1 = 0.0, theta5 = 0.0, pitch = 0.0;
  double overshoot_mm = 0.0;  // beyond the reach when positive
  double gamma = 0.0;         // direction from joint 2 to joint 4
  double beta = 0.0;          // angle at joint 2, 0 .. pi
  double delta = 0.0;         // angle between both links, |theta_3|
  bool reachable = false;
  bool clamped = false;
  std::uint8_t singular = 0;
};

Shoulder shoulder_of(const ArmGeometry& arm, const InPlane& plane, int sign) {
  Shoulder shoulder;
  shoulder.theta1 = sign > 0 ? plane.theta1 : opposite(plane.theta1);
  shoulder.theta5 = sign > 0 ? plane.theta5 : opposite(plane.theta5);
  shoulder.pitch = sign > 0 ? plane.pitch : -plane.pitch;

  const double a2 = arm.a2_mm;
  const double a3 = arm.a3_mm;
  const double r = sign > 0 ? plane.r : -plane.r;
  const double a_r = sign > 0 ? plane.a_r : -plane.a_r;
  const double x = r - arm.a1_mm - arm.d5_mm * a_r + arm.a4_mm * plane.a_z;
  const double y = -plane.z + arm.d5_mm * plane.a_z + arm.a4_mm * a_r;
  const double distance = math::hypot(x, y);
  const double farthest = a2 + a3;
  const double nearest = std::fabs(a2 - a3);
  const double tolerance = kReachTolerance * farthest;
  shoulder.overshoot_mm = std::max(distance - farthest, nearest - distance);
  shoulder.reachable = shoulder.overshoot_mm <= tolerance;
  shoulder.clamped = shoulder.reachable && shoulder.overshoot_mm > 0.0;
  // 2 a2 a3 sin(delta) by Heron's formula in factors: no arc cosine, no cancellation at the ends of the reach.
  const double square = distance * distance;
  const double twice_area =
      shoulder.overshoot_mm > 0.0
          ? 0.0
          : std::sqrt((farthest - distance) * (distance - nearest) * ((farthest + distance) * (distance + nearest)));
  shoulder.gamma = math::atan2(y, x);
  shoulder.beta = math::atan2(twice_area, square + a2 * a2 - a3 * a3);
  shoulder.delta = math::atan2(twice_area, square - a2 * a2 - a3 * a3);
  if (shoulder.overshoot_mm >= -tolerance) shoulder.singular |= kElbowSingular;
  if (distance <= tolerance) shoulder.singular |= kFoldedSingular;
  return shoulder;
}

RawBranch branch_of(const InPlane& plane, const Shoulder& shoulder, int shoulder_sign, int elbow,
                    const Theta& previous) {
  const bool folded = (shoulder.singular & kFoldedSingular) != 0;
  const double theta2 = wrapped(folded ? previous[1] : shoulder.gamma - elbow * shoulder.beta);
  const double theta3 = elbow * shoulder.delta;

  RawBranch branch;
  branch.theta = {shoulder.theta1, theta2, theta3, wrapped(shoulder.pitch - theta2 - theta3), shoulder.theta5, 0.0};
  branch.shoulder = static_cast<std::int8_t>(shoulder_sign);
  branch.elbow = static_cast<std::int8_t>(elbow);
  branch.flip = 0;
  branch.clamped = shoulder.clamped;
  branch.singular = shoulder.singular;
  if (plane.free_heading) branch.singular |= kShoulderSingular;
  return branch;
}

// kOk, or why there is no branch for any reach. Where the heading is free, the residual results from that freedom and
// is not an error of the pose.
IkStatus refusal(const ArmGeometry& arm, const InPlane& plane) {
  const bool accepted = plane.free_heading || plane.residual <= std::max(arm.max_projection_rad, kNoResidual_rad);
  return accepted && !plane.normal ? IkStatus::kOk : IkStatus::kOrientation;
}

}  // namespace

Transform FiveR::forward(const Theta& theta) const noexcept {
  const ArmGeometry& arm = geometry_;
  const auto th1 = math::sin_cos(theta[0]);
  const auto th2 = math::sin_cos(theta[1]);
  const auto th23 = math::sin_cos(theta[1] + theta[2]);
  const auto t = math::sin_cos(theta[1] + theta[2] + theta[3]);
  const auto th5 = math::sin_cos(theta[4]);
  const double r = arm.a1_mm + arm.a2_mm * th2.cos + arm.a3_mm * th23.cos + arm.a4_mm * t.cos - arm.d5_mm * t.sin;
  const double down = arm.a2_mm * th2.sin + arm.a3_mm * th23.sin + arm.a4_mm * t.sin + arm.d5_mm * t.cos;
  return {rotation_of(th1, t, th5), {th1.cos * r, th1.sin * r, -down}};
}

RawSolutions FiveR::inverse(const Transform& base_T_flange, const Theta& previous) const noexcept {
  RawSolutions solutions;
  if (!is_rigid(base_T_flange) || !are_angles(previous)) {
    solutions.status = IkStatus::kInvalidInput;
    return solutions;
  }
  const InPlane plane = in_plane(geometry_, base_T_flange, previous[0], kVerticalTolerance);
  solutions.residual_rad = plane.residual;
  solutions.status = refusal(geometry_, plane);
  if (solutions.status != IkStatus::kOk) return solutions;

  const std::array<int, 2> signs{+1, -1};
  std::array<double, 2> overshoot_mm{};
  for (std::size_t i = 0; i < signs.size(); ++i) {
    const Shoulder shoulder = shoulder_of(geometry_, plane, signs[i]);
    overshoot_mm[i] = shoulder.overshoot_mm;
    if (!shoulder.reachable) continue;
    for (const int elbow : signs) {
      solutions.branches[solutions.count++] = branch_of(plane, shoulder, signs[i], elbow, previous);
    }
  }
  if (solutions.count == 0) {
    solutions.status = IkStatus::kUnreachable;
    solutions.margin_mm = std::min(overshoot_mm[0], overshoot_mm[1]);
  }
  return solutions;
}

RawTracking FiveR::track(const Transform& base_T_flange, const Theta& previous) const noexcept {
  RawTracking tracking;
  if (!is_rigid(base_T_flange) || !are_angles(previous)) {
    tracking.status = IkStatus::kInvalidInput;
    return tracking;
  }
  const InPlane plane = in_plane(geometry_, base_T_flange, previous[0], kTrackingTolerance);
  tracking.residual_rad = plane.residual;
  tracking.status = refusal(geometry_, plane);
  if (plane.normal && !plane.free_heading) return tracking;

  const double quarter_turn = kTurn_rad / 4.0;
  const bool forwards = std::fabs(nearest_turn(plane.theta1, previous[0]) - previous[0]) <= quarter_turn;
  const Shoulder shoulder = shoulder_of(geometry_, plane, forwards ? +1 : -1);
  const int elbow = wrapped(previous[2]) >= 0.0 ? +1 : -1;
  const RawBranch branch = branch_of(plane, shoulder, forwards ? +1 : -1, elbow, previous);
  for (std::size_t joint = 0; joint < 5; ++joint) {
    tracking.theta[joint] = nearest_turn(branch.theta[joint], previous[joint]);
  }
  tracking.found = true;
  tracking.singular = branch.singular;
  if (tracking.status != IkStatus::kOk) return tracking;
  tracking.status = shoulder.reachable ? status_of(branch) : IkStatus::kUnreachable;
  if (!shoulder.reachable) tracking.margin_mm = shoulder.overshoot_mm;
  return tracking;
}

Jacobian FiveR::jacobian(const Theta& theta) const noexcept {
  const Transform flange = forward(theta);
  const auto th2 = math::sin_cos(theta[1]);
  const auto th23 = math::sin_cos(theta[1] + theta[2]);
  const auto [s1, c1] = math::sin_cos(theta[0]);
  const Eigen::Vector3d outwards{c1, s1, 0.0};
  const Eigen::Vector3d horizontal{-s1, c1, 0.0};
  const Eigen::Vector3d down{0.0, 0.0, -1.0};

  PerAxis<JointAxis> axes{};
  axes[1] = {horizontal, geometry_.a1_mm * outwards};
  axes[2] = {horizontal, axes[1].origin_mm + geometry_.a2_mm * (th2.cos * outwards + th2.sin * down)};
  axes[3] = {horizontal, axes[2].origin_mm + geometry_.a3_mm * (th23.cos * outwards + th23.sin * down)};
  axes[4] = {flange.rotation.col(2), flange.position_mm};
  return geometric_jacobian(axes, 5, flange.position_mm);
}

RawSides FiveR::sides(const Theta& theta) const noexcept {
  const ArmGeometry& arm = geometry_;
  const auto t = math::sin_cos(theta[1] + theta[2] + theta[3]);
  const double r = arm.a1_mm + arm.a2_mm * math::cos(theta[1]) + arm.a3_mm * math::cos(theta[1] + theta[2]) +
                   arm.a4_mm * t.cos - arm.d5_mm * t.sin;
  return {.shoulder = r / reach_of(arm), .elbow = math::sin(theta[2])};
}

Manipulability FiveR::manipulability(const Theta& theta) const noexcept {
  return manipulability(theta, sides(theta));
}

Manipulability FiveR::manipulability(const Theta& theta, const RawSides& s) const noexcept {
  const double tilt = math::sin(theta[1] + theta[2] + theta[3]);
  return {.shoulder = math::hypot(s.shoulder, tilt), .elbow = std::fabs(s.elbow), .wrist = 1.0};
}

Transform FiveR::to_transform(const Pose5& pose) const noexcept {
  auto th1 = math::sin_cos(pose.heading_rad);
  const double rho = math::hypot(pose.x_mm, pose.y_mm);
  // As in in_plane(): where heading and tool point agree, the heading is better conditioned.
  const bool agree = std::fabs(th1.cos * pose.y_mm - th1.sin * pose.x_mm) <= kAgreement * length_of(geometry_) &&
                     th1.cos * pose.x_mm + th1.sin * pose.y_mm >= 0.0;
  if (rho >= kReachTolerance * reach_of(geometry_) && !agree) th1 = {.sin = pose.y_mm / rho, .cos = pose.x_mm / rho};
  return {rotation_of(th1, math::sin_cos(pose.pitch_rad), math::sin_cos(pose.roll_rad)),
          {pose.x_mm, pose.y_mm, pose.z_mm}};
}

NearestPose5 FiveR::from_transform(const Transform& base_T_flange, double free_heading_rad) const noexcept {
  const InPlane plane = in_plane(geometry_, base_T_flange, free_heading_rad, kVerticalTolerance);
  return {.pose = {.x_mm = base_T_flange.position_mm.x(),
                   .y_mm = base_T_flange.position_mm.y(),
                   .z_mm = base_T_flange.position_mm.z(),
                   .pitch_rad = plane.pitch,
                   .roll_rad = plane.theta5,
                   .heading_rad = plane.theta1},
          .residual_rad = plane.residual};
}

}  // namespace armature
