#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "controller/kinematics/six_r.hpp"

namespace armature {

SixRPosture SixR::posture(const Theta& theta) const noexcept {
  SixRPosture p;
  const PerAxis<double> angles{theta[0], theta[1], theta[1] + theta[2], theta[3], theta[4], theta[5]};
  PerAxis<math::SinCos> joints;
  math::sin_cos_each(angles, joints);
  p.j1 = joints[0];
  p.j2 = joints[1];
  p.j23 = joints[2];
  p.j4 = joints[3];
  p.j5 = joints[4];
  p.j6 = joints[5];
  const auto [s1, c1] = p.j1;
  const auto [s23, c23] = p.j23;
  p.base_R_forearm << c1 * c23, s1, c1 * s23,  //
      s1 * c23, -c1, s1 * s23,                 //
      s23, 0.0, -c23;
  p.ex_mm = geometry_.a3_mm * c23 + geometry_.d4_mm * s23;
  p.ey_mm = geometry_.a3_mm * s23 - geometry_.d4_mm * c23;
  p.x_mm = geometry_.a2_mm * p.j2.cos + p.ex_mm;
  p.y_mm = geometry_.a2_mm * p.j2.sin + p.ey_mm;
  p.r_mm = geometry_.a1_mm + p.x_mm;
  p.approach_forearm = {p.j4.cos * p.j5.sin, p.j4.sin * p.j5.sin, p.j5.cos};
  return p;
}

Transform SixR::flange_at(const SixRPosture& p) const noexcept {
  const auto [s4, c4] = p.j4;
  const auto [s5, c5] = p.j5;
  const auto [s6, c6] = p.j6;
  Eigen::Matrix3d forearm_R_flange;
  forearm_R_flange << c4 * c5 * c6 - s4 * s6, -c4 * c5 * s6 - s4 * c6, c4 * s5,  //
      s4 * c5 * c6 + c4 * s6, -s4 * c5 * s6 + c4 * c6, s4 * s5,                  //
      -s5 * c6, s5 * s6, c5;
  Transform base_T_flange;
  base_T_flange.rotation = p.base_R_forearm * forearm_R_flange;
  base_T_flange.position_mm = Eigen::Vector3d{p.j1.cos * p.r_mm, p.j1.sin * p.r_mm, geometry_.d1_mm + p.y_mm} +
                              geometry_.d6_mm * base_T_flange.rotation.col(2);
  return base_T_flange;
}

Jacobian SixR::jacobian(const Theta& theta) const noexcept {
  const SixRPosture p = posture(theta);
  const auto [s1, c1] = p.j1;
  const Eigen::Vector3d across{s1, -c1, 0.0};  // axes 2 and 3
  const Eigen::Vector3d axis2{c1 * geometry_.a1_mm, s1 * geometry_.a1_mm, geometry_.d1_mm};
  const Eigen::Vector3d axis3 = axis2 + geometry_.a2_mm * Eigen::Vector3d{c1 * p.j2.cos, s1 * p.j2.cos, p.j2.sin};
  const Eigen::Vector3d centre{c1 * p.r_mm, s1 * p.r_mm, geometry_.d1_mm + p.y_mm};  // axes 4, 5 and 6 meet here
  const Eigen::Vector3d axis5 = p.base_R_forearm * Eigen::Vector3d{-p.j4.sin, p.j4.cos, 0.0};
  const PerAxis<JointAxis> axes{{{Eigen::Vector3d::UnitZ(), Eigen::Vector3d::Zero()},
                                 {across, axis2},
                                 {across, axis3},
                                 {p.base_R_forearm.col(2), centre},
                                 {axis5, centre},
                                 {p.approach(), centre}}};
  return geometric_jacobian(axes, 6, centre + geometry_.d6_mm * p.approach());
}

RawSides SixR::sides(const Theta& theta) const noexcept {
  const std::array<double, 3> angles{theta[1], theta[1] + theta[2], theta[4]};
  std::array<math::SinCos, 3> joints;
  math::sin_cos_each(angles, joints);
  const auto [s2, c2] = joints[0];
  const auto [s23, c23] = joints[1];
  const double ex_mm = geometry_.a3_mm * c23 + geometry_.d4_mm * s23;
  const double ey_mm = geometry_.a3_mm * s23 - geometry_.d4_mm * c23;
  const double r_mm = geometry_.a1_mm + (geometry_.a2_mm * c2 + ex_mm);
  // elbow = -sin(theta_3 - phi)
  return {r_mm / longest_mm_, (s2 * ex_mm - c2 * ey_mm) / forearm_mm_, joints[2].sin};
}

Manipulability SixR::manipulability(const Theta& theta) const noexcept {
  return manipulability(theta, sides(theta));
}

Manipulability SixR::manipulability(const Theta&, const RawSides& s) const noexcept {
  return {std::fabs(s.shoulder), std::fabs(s.elbow), std::fabs(s.flip)};
}

Theta SixR::rates(const SixRPosture& p, const Eigen::Vector3d& v_mm_s, const Eigen::Vector3d& w_rad_s) const noexcept {
  const auto [s1, c1] = p.j1;
  const Eigen::Vector3d v = v_mm_s - w_rad_s.cross(geometry_.d6_mm * p.approach());  // of the wrist centre
  const double rate1 = (c1 * v.y() - s1 * v.x()) / p.r_mm;

  // In the plane of the arm: the forearm e turns about axis 3, the whole (x, y) about axis 2.
  const double outward = c1 * v.x() + s1 * v.y(), upward = v.z();
  const double area2 = geometry_.a2_mm * (p.j2.cos * p.ey_mm - p.j2.sin * p.ex_mm);  // a2 k sin(theta_3 - phi)
  const double rate2 = (p.ex_mm * outward + p.ey_mm * upward) / area2;
  const double rate3 = -(p.x_mm * outward + p.y_mm * upward) / area2;

  // The wrist makes the rest of the rotation.
  const Eigen::Vector3d turned{s1 * (rate2 + rate3), -c1 * (rate2 + rate3), rate1};
  const Eigen::Vector3d w = p.base_R_forearm.transpose() * (w_rad_s - turned);
  const double rate5 = p.j4.cos * w.y() - p.j4.sin * w.x();
  const double rate6 = (p.j4.cos * w.x() + p.j4.sin * w.y()) / p.j5.sin;
  return {rate1, rate2, rate3, w.z() - p.j5.cos * rate6, rate5, rate6};
}

}  // namespace armature
