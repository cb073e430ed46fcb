// Of plant = "dynamic": [axis.dynamics], [[link]], [tool] and [payload] of a robot file.
#include <algorithm>
#include <array>
#include <string>

#include "cosim/scenario/tables/tables.hpp"

namespace armature::cosim {
namespace {

constexpr double kMaxInertia = 1000;
constexpr double kMaxMs = 10'000;
constexpr double kMaxOverloadS = 10'000;

// The moments of a body about three axes: none is larger than the sum of the others, and each is above 0. Products of
// inertia must leave the tensor positive.
std::string check_inertia(const BodySpec& body, const KeyContext&) {
  const auto& [xx, yy, zz, xy, xz, yz] = body.inertia_kg_m2;
  const double largest = std::max({xx, yy, zz});
  if (std::min({xx, yy, zz}) <= 0) return "expected moments ixx, iyy and izz above 0";
  if (2 * largest > xx + yy + zz) return "expected moments of which none is larger than the sum of the two others";
  const double minor = xx * yy - xy * xy;
  const double determinant = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
  if (minor <= 0 || determinant <= 0) return "expected smaller products ixy, ixz and iyz: no body has this tensor";
  return {};
}

}  // namespace

const KeyTable<DynamicsSpec>& dynamics_keys() {
  static const KeyTable<DynamicsSpec> kTable{
      .text =
          "The loops of the drive, the motor, its brakes and the gear, for `plant = \"dynamic\"`. The gains of the "
          "loops "
          "follow from `natural_hz` (wn), `damping` (zeta) and `inertia_kg_m2` of `drive`. The position gain is wn / "
          "(2 zeta). The speed loop has the bandwidth 2 zeta wn with that inertia.",
      .keys = {
          key("rotor_inertia_kg_m2", &DynamicsSpec::rotor_inertia_kg_m2, above(0, 100, "kg m^2"),
              "Inertia of the motor and of what turns with it, at the motor.")
              .required(),
          key("viscous_nm_s", &DynamicsSpec::viscous_nm_s, between(0, 1000, "N m s"),
              "Viscous friction of motor and gear, at the motor."),
          key("coulomb_nm", &DynamicsSpec::coulomb_nm, between(0, 10'000, "N m"),
              "Dry friction of motor and gear, at the motor. A motor that stands is held by up to this torque."),
          key("current_hz", &DynamicsSpec::current_hz, between(10, 1e6, "Hz"), "Bandwidth of the current loop."),
          key("integral_ms", &DynamicsSpec::integral_ms, between(0, kMaxMs, "ms"),
              "Integral time of the speed loop. 0: no integral, so a weight leaves an error."),
          key("feed_forward", &DynamicsSpec::feed_forward, between(0, 1),
              "Part of the commanded speed that is fed forward."),
          key("smoothing_ms", &DynamicsSpec::smoothing_ms, between(0, kMaxMs, "ms"),
              "Time constant of the filter that smooths the pulses. 0: no filter."),
          key("dynamic_brake_nm_s", &DynamicsSpec::dynamic_brake_nm_s, between(0, 1000, "N m s"),
              "Torque of the shorted windings for a speed of 1 rad/s, while the servo is off or in alarm."),
          key("brake_nm", &DynamicsSpec::brake_nm, between(0, 10'000, "N m"),
              "Holding torque of the brake, at the motor. A larger load makes it slip. 0: no brake."),
          key("brake_engage_ms", &DynamicsSpec::brake_engage_ms, between(0, kMaxMs, "ms"),
              "Time from servo off until the brake holds. Until then only the dynamic brake acts."),
          key("brake_release_ms", &DynamicsSpec::brake_release_ms, between(0, kMaxMs, "ms"),
              "Time from servo on until the brake is open. The motor is controlled at once."),
          key("stiffness_nm_rad", &DynamicsSpec::stiffness_nm_rad, above(0, 1e9, "N m/rad"),
              "Torsional stiffness of the gear, at the joint.")
              .required(),
          key("gear_damping_nm_s", &DynamicsSpec::gear_damping_nm_s, between(0, 1e6, "N m s"),
              "Damping of this spring, at the joint."),
          key("backlash_deg", &DynamicsSpec::backlash_deg, between(0, 10, "deg"),
              "Whole play of the gear, at the joint."),
          key("joint_viscous_nm_s", &DynamicsSpec::joint_viscous_nm_s, between(0, 1e6, "N m s"),
              "Viscous friction of the joint, behind the gear."),
          key("rated_torque_nm", &DynamicsSpec::rated_torque_nm, between(0, kMaxMotorNm, "N m"),
              "Torque that the motor may have for good. With a number above 0 the drive has an overload alarm: its "
              "heat rises with the square of the torque, and falls below the rated torque. The alarm is that of the "
              "pin "
              "`drive_alarm`. 0: no such alarm."),
          key("overload_200_s", &DynamicsSpec::overload_200_s, between(0, kMaxOverloadS, "s"),
              "Time until the overload alarm with twice the rated torque, from cold."),
          key("overload_300_s", &DynamicsSpec::overload_300_s, between(0, kMaxOverloadS, "s"),
              "The same with three times this torque, at most 3/8 of `overload_200_s`. The two times say which torque "
              "never trips the alarm: less than 3/8 gives one above the rated torque."),
      }};
  return kTable;
}

const KeyTable<BodySpec>& body_keys() {
  static const KeyTable<BodySpec> kTable{
      .text =
          "A rigid body of the arm, for `plant = \"dynamic\"`. There is one `[[link]]` for each joint, in the order of "
          "the joints. Link i has the Denavit-Hartenberg frame i at its far end. Its numbers are in this frame.",
      .keys = {
          key("mass_kg", &BodySpec::mass_kg, above(0, 10'000, "kg"), "Mass.").required(),
          key("centre_mm", &BodySpec::centre_mm, between(-10'000, 10'000, "mm"), "Centre of mass.").required(),
          key("inertia_kg_m2", &BodySpec::inertia_kg_m2, between(-kMaxInertia, kMaxInertia, "kg m^2"),
              "Inertia about the centre of mass, in the directions of the frame: ixx, iyy, izz, ixy, ixz, iyz.")
              .required()
              .checked(check_inertia),
      }};
  return kTable;
}

}  // namespace armature::cosim
