#include "cosim/dynamics/arm_dynamics.hpp"

#include "controller/base/math.hpp"

namespace armature::cosim {
namespace {

// Several links that are fixed to each other, about the origin of a frame.
struct Composite {
  double mass = 0.0;
  Vector3 moment;      // mass x centre
  Symmetric3 inertia;  // about the origin

  void add(const Body& body) {
    const Symmetric3 p = of_point(body.centre_m);
    const double m = body.mass_kg;
    mass += m;
    moment = moment + m * body.centre_m;
    inertia = inertia + body.inertia_kg_m2 + Symmetric3{m * p.xx, m * p.yy, m * p.zz, m * p.xy, m * p.xz, m * p.yz};
  }

  // In the frame below, about its origin. `arm`: from there to the origin of this frame, in this frame.
  [[nodiscard]] Composite down(const LinkRotation& rotation, const Vector3& arm) const {
    const Vector3 moved = moment + mass * arm;
    // The sum of both cross terms of the shift: 2 (r h) E - r h^T - h r^T, and m (r^2 E - r r^T).
    const Vector3& r = arm;
    const Vector3 h = moment + moved;  // 2 h + m r, of which each product takes half
    const Symmetric3 shift{r.y * h.y + r.z * h.z,          r.x * h.x + r.z * h.z,
                           r.x * h.x + r.y * h.y,          -0.5 * (r.x * h.y + h.x * r.y),
                           -0.5 * (r.x * h.z + h.x * r.z), -0.5 * (r.y * h.z + h.y * r.z)};
    return {mass, rotation.down(moved), rotation.down(inertia + shift)};
  }
};

}  // namespace

void ArmDynamics::set_posture(const PerAxis<double>& q_rad) {
  PerAxis<double> theta{};
  PerAxis<math::SinCos> turns{};
  for (std::size_t i = 0; i < model_.joints; ++i) {
    theta[i] = model_.links[i].sign * q_rad[i] + model_.links[i].offset_rad;
  }
  math::sin_cos_each(theta, turns);
  for (std::size_t i = 0; i < model_.joints; ++i) {
    const ArmLink& link = model_.links[i];
    rotations_[i] = {turns[i].sin, turns[i].cos, link.sin_alpha, link.cos_alpha};
  }
}

PerAxis<double> ArmDynamics::torques(const PerAxis<double>& qd_rad_s, const PerAxis<double>& qdd_rad_s2) const {
  PerAxis<Vector3> forces{}, moments{};  // of the masses: at the centre of mass
  Vector3 w{}, wd{};
  Vector3 accel = -1.0 * model_.gravity_m_s2;  // of the origin, as if the base accelerated against gravity
  for (std::size_t i = 0; i < model_.joints; ++i) {
    const ArmLink& link = model_.links[i];
    const LinkRotation& rotation = rotations_[i];
    const double speed = link.sign * qd_rad_s[i], faster = link.sign * qdd_rad_s2[i];
    // In frame i-1, whose z is the axis: w x (z speed) = (w.y, -w.x, 0) speed.
    const Vector3 turned{wd.x + w.y * speed, wd.y - w.x * speed, wd.z + faster};
    w = rotation.up(Vector3{w.x, w.y, w.z + speed});
    wd = rotation.up(turned);
    const Vector3 r = arm(link);
    accel = rotation.up(accel) + cross(wd, r) + cross(w, cross(w, r));
    const Body& body = link.body;
    const Vector3 at_centre = accel + cross(wd, body.centre_m) + cross(w, cross(w, body.centre_m));
    forces[i] = body.mass_kg * at_centre;
    moments[i] = body.inertia_kg_m2 * wd + cross(w, body.inertia_kg_m2 * w);
  }
  PerAxis<double> torques{};
  Vector3 force{}, moment{};  // from link i+1 on link i, in frame i and about its origin
  for (std::size_t i = model_.joints; i-- > 0;) {
    const ArmLink& link = model_.links[i];
    const Vector3 r = arm(link);
    moment = moment + moments[i] + cross(r + link.body.centre_m, forces[i]) + cross(r, force);
    force = force + forces[i];
    torques[i] = link.sign * dot(axis(link), moment);
    force = rotations_[i].down(force);
    moment = rotations_[i].down(moment);
  }
  return torques;
}

JointMatrix ArmDynamics::mass_matrix() const {
  JointMatrix matrix{};
  Composite outer;
  for (std::size_t j = model_.joints; j-- > 0;) {
    const ArmLink& link = model_.links[j];
    outer.add(link.body);
    // The force and the moment about the origin of frame j-1 that a unit acceleration of joint j takes.
    const Vector3 z = axis(link), r = arm(link), accel = cross(z, r);
    Vector3 force = outer.mass * accel + cross(z, outer.moment);
    Vector3 moment = outer.inertia * z + cross(outer.moment, accel) + cross(r, force);
    matrix[j][j] = dot(z, moment);
    for (std::size_t i = j; i-- > 0;) {
      force = rotations_[i + 1].down(force);
      moment = rotations_[i + 1].down(moment) + cross(arm(model_.links[i]), force);
      matrix[i][j] = matrix[j][i] = link.sign * model_.links[i].sign * dot(axis(model_.links[i]), moment);
    }
    outer = outer.down(rotations_[j], r);
  }
  return matrix;
}

double ArmDynamics::energy(const PerAxis<double>& qd_rad_s) const {
  const JointMatrix matrix = mass_matrix();
  double energy = 0.0;
  for (std::size_t i = 0; i < model_.joints; ++i) {
    for (std::size_t j = 0; j < model_.joints; ++j) energy += 0.5 * qd_rad_s[i] * matrix[i][j] * qd_rad_s[j];
  }
  Composite outer;
  for (std::size_t i = model_.joints; i-- > 0;) {
    outer.add(model_.links[i].body);
    outer = outer.down(rotations_[i], arm(model_.links[i]));
  }
  return energy - dot(model_.gravity_m_s2, outer.moment);
}

}  // namespace armature::cosim
