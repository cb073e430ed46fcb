// The five-axis arm of Hu 2012 (Table 1): forward and closed-form inverse kinematics with all 4 branches, in
// Denavit-Hartenberg angles.
//
// Model: alpha = -90 0 0 -90 0 deg, a = a1 a2 a3 a4 0, d = 0 0 0 0 d5. Axes 2, 3, 4 are parallel and horizontal, so the
// tool point p and the approach vector a (third column of the rotation) stay in one vertical plane through axis 1. With
// t = theta_2 + theta_3 + theta_4:
//   r = a1 + a2 cos(theta_2) + a3 cos(theta_2 + theta_3) + a4 cos(t) - d5 sin(t)
//   p = (r cos(theta_1), r sin(theta_1), -(a2 sin(theta_2) + a3 sin(theta_2 + theta_3) + a4 sin(t) + d5 cos(t)))
//   a = (-cos(theta_1) sin(t), -sin(theta_1) sin(t), -cos(t))
// The base's z points up; a positive theta_2 lowers the arm.
//
// Where the print of Hu 2012 is wrong (each shown by tests/controller/kinematics/errata_five_r_test.cpp):
//   (2)   the column (a1 cos, a1 sin, 0, 1) of a1 is missing, and with it - a1 in (14)
//   (10)  arctan(p_y / p_x) is not arctan2(p_y, p_x); the second branch theta_1 + pi is missing
//   (12)  the quotient has to become a two-argument arctangent, as in (13), (14), (15)
//   (13)  m, n, k are never defined. Here: theta_2 = gamma -+ beta by two arctangents, exact at full stretch
//   (14)  the numerator's last term is + d5 a_z
//   (15)  both the numerator and the denominator have the wrong sign
//   "8 groups" multiplies signs that are not independent: there are 2 (theta_1) x 2 (elbow) = 4 solutions. The values
//   printed in Figure 2 contain no solution: the pose has only the double root (0, -90, 0, -90, 0) deg.
//
// A pose with six degrees of freedom is in general not in the plane. It is projected: the tool point stays, and the
// rotation is changed by the smallest angle that brings the approach into the plane. Every result contains that angle,
// `residual_rad`. Above the larger of ArmGeometry::max_projection_rad and 1e-9 (rounding) the pose is refused as
// kOrientation. A pose whose approach is normal to the plane is always refused, with pi/2, because every pitch is
// equally near.
//
// Plane. It contains the tool point. Near axis 1 its direction is better determined by the approach than by the tool
// point. Where both agree to 1e-12 of the arm's length, the better determined one is used. On axis 1 (closer than 1e-9
// of the reach a2 + a3) only the approach is used. Where the approach is vertical as well (to 1e-9), the heading is
// free: theta_1 is the previous one for shoulder +1 and half a turn away for -1, marked kShoulderSingular. Pose and
// solution then differ by at most those 1e-9.
//
// Elbow. If joint 4 is beyond its reach |a2 - a3| .. a2 + a3 by at most 1e-9 (a2 + a3), it is set to the limit and
// marked clamped. Within the same distance of either limit (stretched, folded) both elbows are returned, marked
// kElbowSingular, although they are one double root. With a2 = a3 and joint 4 on joint 2, theta_2 is free: it is the
// previous one, marked kFoldedSingular.
#pragma once

#include "controller/kinematics/ik_result.hpp"
#include "controller/kinematics/jacobian.hpp"
#include "controller/kinematics/pose5.hpp"
#include "controller/kinematics/raw_solutions.hpp"
#include "controller/kinematics/transform.hpp"
#include "controller/robot/arm_geometry.hpp"

namespace armature {

class FiveR {
 public:
  // Requires the family kFiveR, a2 > 0 and a3 > 0. With another family the object may only be constructed.
  explicit FiveR(const ArmGeometry& geometry) noexcept : geometry_{geometry} {}

  // base_T_flange; the flange is the tool frame of Hu 2012. Not finite where an angle, theta_2 + theta_3 or t is beyond
  // kLargestTheta_rad.
  [[nodiscard]] Transform forward(const Theta& theta) const noexcept;

  // All branches (none, 2 or 4), in the order shoulder (+, -) > elbow (+, -). `previous` is used for free angles only.
  [[nodiscard]] RawSolutions inverse(const Transform& base_T_flange, const Theta& previous) const noexcept;

  // The shoulder with theta_1 within a quarter turn of the previous one, the elbow with the sign of the previous
  // sin(theta_3): on a path this is the nearest branch of inverse(). It never changes to another branch: kUnreachable
  // when this one ends. The heading counts as free up to 1e-7 instead of 1e-9, because there the rounding noise of
  // theta_1 would exceed acceleration limits. Pose and solution then differ by at most that.
  [[nodiscard]] RawTracking track(const Transform& base_T_flange, const Theta& previous) const noexcept;

  // Columns 1..5.
  [[nodiscard]] Jacobian jacobian(const Theta& theta) const noexcept;

  // elbow: |sin theta_3|. shoulder: hypot(r / (a2 + a3), sin t); it exceeds 1 where the arm reaches far. r = 0 alone is
  // no singularity, because the approach still determines the heading. Their product, with r in place of r / (a2 + a3),
  // is sqrt(det(J^T J)) / (a2 a3). wrist: 1.
  [[nodiscard]] Manipulability manipulability(const Theta& theta) const noexcept;
  [[nodiscard]] RawSides sides(const Theta& theta) const noexcept;
  // The same, where its sides() are known.
  [[nodiscard]] Manipulability manipulability(const Theta& theta, const RawSides& sides) const noexcept;

  // The pose with this tool point, pitch and roll, even if it is out of reach. Angles as in forward().
  [[nodiscard]] Transform to_transform(const Pose5& pose) const noexcept;

  // The inverse: exact for results of to_transform() and forward(), otherwise the nearest pose (pitch and roll are 0
  // when the residual is pi/2). The heading is `free_heading_rad` where tool point and approach do not determine it.
  // The transform must be rigid.
  [[nodiscard]] NearestPose5 from_transform(const Transform& base_T_flange,
                                            double free_heading_rad = 0.0) const noexcept;

 private:
  ArmGeometry geometry_;
};

}  // namespace armature
