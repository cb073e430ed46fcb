// One axis of a ServoArm with a load of one link, stepped by hand.
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>

#include "controller/base/axes.hpp"
#include "cosim/servo/servo_arm.hpp"

namespace armature::cosim::test {

inline constexpr double kServoStep = 5e-6;
inline constexpr double kTwoPi = 2 * std::numbers::pi;

// A drive whose loops of second order are alone: no friction, filter or integral, and a current loop without a delay.
inline AxisSpec plain_servo() {
  AxisSpec axis;
  axis.gear_ratio = 50;
  axis.encoder_lines = 2500;
  axis.drive = {.natural_hz = 10, .damping = 0.7, .max_speed_rpm = 1e5, .max_torque_nm = 1e4, .inertia_kg_m2 = 2e-4};
  axis.dynamics =
      DynamicsSpec{.rotor_inertia_kg_m2 = 2e-4, .current_hz = 1e6, .stiffness_nm_rad = 1e4, .gear_damping_nm_s = 1};
  return axis;
}

// A link that turns about z. Its weight, if any, pulls at right angles at joint angle 0: a torque of -mass x centre x
// g.
struct OneLink {
  double inertia_kg_m2 = 1e-4;  // about the joint
  double weight_nm = 0;

  [[nodiscard]] ArmModel model() const {
    ArmModel model{.joints = 1, .links = {}, .gravity_m_s2 = {0, -10, 0}};
    // A mass far out would have its own inertia about the joint, which is part of the whole one.
    const double mass = 1.0, centre = weight_nm / (10 * mass);
    model.links[0].body = {mass, {centre, 0, 0}, {.zz = inertia_kg_m2 - mass * centre * centre}};
    return model;
  }
};

class ServoRig {
 public:
  explicit ServoRig(const AxisSpec& spec, const OneLink& link = {}, int renewal = 10)
      : rad_per_count{kTwoPi / (spec.gear_ratio * 4 * spec.encoder_lines)},
        arm{servo_numbers(make_per_axis([&](std::size_t) { return spec; }), kServoStep), link.model(), renewal} {}

  void step(bool controlled = true) { arm.step(controlled ? 1 : 0, reference, error, speed); }
  void run(double seconds, bool controlled = true) {
    for (long i = std::lround(seconds / kServoStep); i > 0; --i) step(controlled);
  }
  // The command moves on by so many counts, as pulses do it.
  void move_command(double counts) {
    reference[0] += counts;
    error[0] -= counts;
  }
  void ramp(double counts_per_s, double seconds) {
    for (long i = std::lround(seconds / kServoStep); i > 0; --i) {
      move_command(counts_per_s * kServoStep);
      step();
    }
  }
  [[nodiscard]] double motor() const { return reference[0] + error[0]; }                      // [counts]
  [[nodiscard]] double motor_rad_s() const { return speed[0] / kServoStep * rad_per_count; }  // at the joint
  [[nodiscard]] double motor_rad() const { return motor() * rad_per_count; }
  [[nodiscard]] double load_rad() const { return motor_rad() - arm.twist_rad(0); }

  double rad_per_count;
  ServoArm arm;
  AxisNumbers reference, error, speed;
};

}  // namespace armature::cosim::test
