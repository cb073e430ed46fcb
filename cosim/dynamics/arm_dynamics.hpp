// Rigid-body dynamics of a serial arm with up to six turning joints:
//
//   torque = M(q) qdd + bias(q, qd),   bias = Coriolis and centrifugal terms, and gravity
//
// Inverse dynamics by the recursive Newton-Euler method in link frames (Luh, Walker and Paul, 1980), the mass matrix by
// composite rigid bodies (Walker and Orin, 1982). Fixed sizes, no allocation; plain arithmetic and the controller's own
// sine and cosine, so the same bits on every machine. Against Orocos KDL at 10 000 random states: within 1e-12 of the
// largest torque and of the largest element (tests/cosim/dynamics).
//
// Frames: standard Denavit-Hartenberg, as controller/kinematics. Frame 0 is the base. Joint i turns about z of frame
// i-1; frame i is fixed to link i: A_i = Rz(theta_i) Tz(d_i) Tx(a_i) Rx(alpha_i), theta_i = sign_i q_i + offset_i. The
// last frame is the flange. All torques and the matrix belong to q, the user's joint angles.
#pragma once

#include <array>
#include <cstddef>

#include "controller/base/axes.hpp"
#include "cosim/dynamics/body.hpp"
#include "cosim/dynamics/vector3.hpp"

namespace armature::cosim {

struct ArmLink {
  double a_m = 0.0, d_m = 0.0;
  double sin_alpha = 0.0, cos_alpha = 1.0;
  double sign = 1.0;  // +1 or -1
  double offset_rad = 0.0;
  Body body;  // in frame i
};

struct ArmModel {
  std::size_t joints = 0;  // 0..6
  PerAxis<ArmLink> links;
  Vector3 gravity_m_s2;  // in the base frame: (0, 0, -9.81) where its z points up
};

using JointMatrix = std::array<PerAxis<double>, kAxes>;

// Elements of joints that the arm does not have are 0.
class ArmDynamics {
 public:
  explicit ArmDynamics(const ArmModel& model) : model_{model} {}

  // All results are for this posture, q in rad within +-1e6.
  void set_posture(const PerAxis<double>& q_rad);

  // Torques [N m] that give the accelerations `qdd` at the speeds `qd`.
  [[nodiscard]] PerAxis<double> torques(const PerAxis<double>& qd_rad_s, const PerAxis<double>& qdd_rad_s2) const;
  // The same without acceleration, and at rest.
  [[nodiscard]] PerAxis<double> bias(const PerAxis<double>& qd_rad_s) const { return torques(qd_rad_s, {}); }
  [[nodiscard]] PerAxis<double> gravity() const { return torques({}, {}); }

  // [kg m^2], symmetric.
  [[nodiscard]] JointMatrix mass_matrix() const;

  // Kinetic and potential energy [J]; the latter is 0 with all masses in the origin of the base.
  [[nodiscard]] double energy(const PerAxis<double>& qd_rad_s) const;

  [[nodiscard]] std::size_t joints() const { return model_.joints; }

 private:
  // The axis of joint i and the vector from the origin of frame i-1 to that of frame i, both in frame i: constant.
  [[nodiscard]] static Vector3 axis(const ArmLink& link) { return {0.0, link.sin_alpha, link.cos_alpha}; }
  [[nodiscard]] static Vector3 arm(const ArmLink& link) {
    return {link.a_m, link.d_m * link.sin_alpha, link.d_m * link.cos_alpha};
  }

  ArmModel model_;
  PerAxis<LinkRotation> rotations_{};
};

}  // namespace armature::cosim
