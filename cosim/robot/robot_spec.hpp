// A robot exactly as the user wrote it (scenarios/robots/<name>.toml), validated and in the user's units (those of the
// key names).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "controller/base/axes.hpp"
#include "cosim/text/input_file.hpp"

namespace armature::cosim {

// What a robot file can say of a motor.
inline constexpr double kMaxMotorRpm = 100'000;
inline constexpr double kMaxMotorNm = 10'000;

struct DriveSpec {
  double natural_hz = 40.0;       // natural frequency of the position loop
  double damping = 1.0;           // its damping ratio
  double max_speed_rpm = 3000.0;  // motor speed limit
  double max_torque_nm = 1.27;    // motor torque limit
  double inertia_kg_m2 = 2.0e-4;  // motor plus reflected load inertia
  double min_step_high_ns = 100;  // shortest pulse that the drive accepts; every pulse is checked
  double min_step_low_ns = 100;
  double dir_setup_ns = 500;
  double dir_hold_ns = 500;
};

// [axis.dynamics]: what plant = "dynamic" needs beyond [axis.drive]. Torques and inertias are at the motor, those of
// the gear and the joint at the joint.
struct DynamicsSpec {
  double rotor_inertia_kg_m2 = 0;  // motor and what turns with its speed
  double viscous_nm_s = 0;         // friction of motor and gear
  double coulomb_nm = 0;
  double current_hz = 1000;       // bandwidth of the current loop
  double integral_ms = 0;         // integral time of the speed loop; 0: no integral
  double feed_forward = 0;        // of the speed, 0..1
  double smoothing_ms = 0;        // time constant of the command filter
  double dynamic_brake_nm_s = 0;  // shorted windings
  double brake_nm = 0;            // holding brake; 0: none
  double brake_engage_ms = 0, brake_release_ms = 0;
  double stiffness_nm_rad = 0;   // of the gear
  double gear_damping_nm_s = 0;  // of the gear
  double backlash_deg = 0;       // whole play at the joint
  double joint_viscous_nm_s = 0;
  double rated_torque_nm = 0;                     // of the motor; 0: the drive has no overload alarm
  double overload_200_s = 0, overload_300_s = 0;  // until this alarm, cold, with so many % of the rated torque
};

// [axis.homing]: how the controller finds the joint angle, see controller/activity/homing/axis_homing.hpp.
struct HomingSpec {
  std::int64_t order = 1;
  std::string direction = "negative";  // "negative" | "positive"
  double search_deg_s = 10;
  double latch_deg_s = 2;
  double index_deg = 0;
  double position_deg = 0;
};

// Counts of an encoder line: the decoder counts every edge of both quadrature lines.
inline constexpr std::int32_t kCountsPerLine = 4;

struct AxisSpec {
  double gear_ratio = 50.0;
  std::int32_t pulses_per_rev = 10000;
  std::int32_t encoder_lines = 2500;
  double min_deg = -180, max_deg = 180;
  double max_speed_deg_s = 0, max_accel_deg_s2 = 0;
  std::optional<double> max_jerk_deg_s3;  // none: no S-curves with this robot
  double following_error_deg = 5.0;
  std::optional<double> following_error_at_rest_deg;      // none: only following_error_deg is checked
  std::optional<double> encoder_speed_limit_deg_s;        // none: not checked
  std::optional<double> encoder_accel_limit_deg_s2;       // none: not checked
  std::optional<std::array<double, 2>> home_switch_deg;   // active between these joint angles; none: no switch
  std::optional<std::array<double, 2>> limit_switch_deg;  // active up to the first one and from the second one on
  std::optional<HomingSpec> homing;                       // none: the axis cannot be homed
  DriveSpec drive;
  std::optional<DynamicsSpec> dynamics;  // with plant = "dynamic"
};

// Pulses of an angle, not rounded.
[[nodiscard]] constexpr double pulses_of(const AxisSpec& axis, double deg) {
  return deg / 360 * axis.gear_ratio * static_cast<double>(axis.pulses_per_rev);
}

inline constexpr std::string_view kSixRFamily = "six_r";
inline constexpr std::string_view kFiveRFamily = "five_r";

// Joints of a family's arm; 0 when there is no such family.
[[nodiscard]] constexpr std::size_t joints_of(std::string_view family) {
  return family == kSixRFamily ? 6 : family == kFiveRFamily ? 5 : 0;
}

// [kinematics]: one of the families of controller/robot/arm_geometry.hpp. Lengths that a family does not use are 0.
struct KinematicsSpec {
  std::string family;  // of those above
  double a1_mm = 0, a2_mm = 0, a3_mm = 0, a4_mm = 0;
  double d1_mm = 0, d4_mm = 0, d5_mm = 0, d6_mm = 0;
  PerAxis<double> sign{1, 1, 1, 1, 1, 1};  // of the axes that the family has
  PerAxis<double> offset_deg{};
  double max_projection_deg = 0.01;  // five_r
};

// [[link]], [tool] and [payload]: a rigid body. A link in its Denavit-Hartenberg frame at its far end, the others in
// the frame of the flange.
struct BodySpec {
  double mass_kg = 0;
  std::array<double, 3> centre_mm{};
  std::array<double, 6> inertia_kg_m2{};  // xx yy zz xy xz yz, about the centre of mass
};

// [meshes]: STL files with the shapes of the parts, for pictures of the arm. After loading, a name is a path.
struct MeshesSpec {
  std::string base;                // of the part that does not move; empty: none
  std::vector<std::string> links;  // of the part that each joint moves; empty: none
};

inline constexpr std::string_view kServoPlant = "servo";
inline constexpr std::string_view kIdealPlant = "ideal";
inline constexpr std::string_view kDynamicPlant = "dynamic";

// An axis whose gear, encoder and motor are not known: it follows at once, and nothing limits its motor.
[[nodiscard]] inline AxisSpec ideal_axis() {
  AxisSpec axis;
  axis.gear_ratio = 100;
  axis.drive.natural_hz = 200;
  axis.drive.max_speed_rpm = kMaxMotorRpm;
  axis.drive.max_torque_nm = kMaxMotorNm;
  return axis;
}

struct RobotSpec {
  std::string name;
  std::string description;
  std::string plant{kServoPlant};  // "servo" | "ideal" | "dynamic"
  std::size_t axis_count = kAxes;  // 5 with five_r; the axes beyond are not driven
  PerAxis<AxisSpec> axes;          // those beyond axis_count: copies of axis 5 that never move
  std::optional<KinematicsSpec> kinematics;
  std::vector<BodySpec> links;                             // of plant = "dynamic": one for each joint
  BodySpec tool, payload;                                  // mass 0: none
  std::array<double, 3> gravity_m_s2{0.0, 0.0, -9.80665};  // in the frame of the base
  MeshesSpec meshes;
  InputFile source;
  std::vector<InputFile> mesh_files;  // each once
};

}  // namespace armature::cosim
