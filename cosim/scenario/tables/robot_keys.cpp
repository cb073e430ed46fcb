// A robot file: its own keys, [defaults] and [[axis]].
#include <limits>

#include "controller/core/timebase.hpp"
#include "controller/regs/encoder_regs.hpp"
#include "controller/regs/pulse_train_regs.hpp"
#include "cosim/scenario/tables/tables.hpp"

namespace armature::cosim {
namespace {

constexpr double kMaxDeg = 100 * 360.0;  // far beyond any arm: keeps counts in range
constexpr double kMaxPulsesPerRev = std::numeric_limits<std::int32_t>::max();
constexpr double kMaxLines = regs::encoder::kCountsPerRevValueMask / kCountsPerLine;  // width of the register
constexpr double kMaxDirNs =
    regs::pulse_train::kDirSetupValueMask * static_cast<double>(kNsPerCycle);  // width of the registers

const KeyTable<DriveSpec>& drive_keys() {
  static const KeyTable<DriveSpec> kTable{
      .text = "The table describes the servo drive of an axis and its motor.",
      .keys = {
          key("natural_hz", &DriveSpec::natural_hz, between(1, 1000, "Hz"),
              "The natural frequency of the drive's position loop."),
          key("damping", &DriveSpec::damping, between(0.1, 10), "The damping ratio of the position loop."),
          key("max_speed_rpm", &DriveSpec::max_speed_rpm, above(0, 100'000, "rpm"), "The speed limit of the motor."),
          key("max_torque_nm", &DriveSpec::max_torque_nm, above(0, 10'000, "N m"), "The torque limit of the motor."),
          key("inertia_kg_m2", &DriveSpec::inertia_kg_m2, above(0, 100, "kg m^2"),
              "The inertia of the motor and of its load, reflected to the motor."),
          key("min_step_high_ns", &DriveSpec::min_step_high_ns, between(0, 50'000, "ns"),
              "The input of the drive needs pulses that are high for this time. Every pulse is checked."),
          key("min_step_low_ns", &DriveSpec::min_step_low_ns, between(0, 50'000, "ns"),
              "The input of the drive needs this time between two pulses."),
          key("dir_setup_ns", &DriveSpec::dir_setup_ns, between(0, kMaxDirNs, "ns"),
              "The direction must be stable for this time before a pulse."),
          key("dir_hold_ns", &DriveSpec::dir_hold_ns, between(0, kMaxDirNs, "ns"),
              "The direction must be stable for this time after a pulse."),
      }};
  return kTable;
}

}  // namespace

const KeyTable<AxisSpec>& axis_keys() {
  static const KeyTable<AxisSpec> kTable{
      .text =
          "Each table describes an axis. The arm has as many axes as `family` has joints, and six without "
          "`[kinematics]`. An axis inherits each key that it does not have from `[defaults]`.",
      .keys =
          {
              key("gear_ratio", &AxisSpec::gear_ratio, between(-10'000, 10'000),
                  "Motor turns for one turn of the joint. It is negative when they turn against each other, and at "
                  "least "
                  "0.01 either way.")
                  .required(),
              key("pulses_per_rev", &AxisSpec::pulses_per_rev, between(1, kMaxPulsesPerRev),
                  "The electronic gear of the drive: pulses for one turn of the motor.")
                  .required(),
              key("encoder_lines", &AxisSpec::encoder_lines, between(1, kMaxLines),
                  "Lines of the motor's encoder. A line gives 4 counts.")
                  .required(),
              key("min_deg", &AxisSpec::min_deg, between(-kMaxDeg, kMaxDeg, "deg"), "The lower limit of the joint.")
                  .required(),
              key("max_deg", &AxisSpec::max_deg, between(-kMaxDeg, kMaxDeg, "deg"), "The upper limit of the joint.")
                  .required(),
              key("max_speed_deg_s", &AxisSpec::max_speed_deg_s, above(0, 100'000, "deg/s"),
                  "The speed limit of the joint.")
                  .required(),
              key("max_accel_deg_s2", &AxisSpec::max_accel_deg_s2, above(0, 10'000'000, "deg/s^2"),
                  "The acceleration limit of the joint.")
                  .required(),
              key("max_jerk_deg_s3", &AxisSpec::max_jerk_deg_s3, above(0, 1e9, "deg/s^3"),
                  "The jerk limit of the joint. S-curves of the joints need it for every axis.")
                  .without("trapezoids only"),
              key("following_error_deg", &AxisSpec::following_error_deg, above(0, 360, "deg"),
                  "A larger difference between reference and encoder is a fault. It must be more than the drive's own "
                  "lag."),
          },
      .tables = {table("drive", &AxisSpec::drive, drive_keys())}};
  return kTable;
}

const KeyTable<RobotSpec>& robot_keys() {
  static const KeyTable<RobotSpec> kTable{
      .text = {},
      .keys = {
          key("name", &RobotSpec::name, anything(), "The name of the file without `.toml`.").required(),
          key("description", &RobotSpec::description, anything(), "A line about the robot for `armature list`."),
      }};
  return kTable;
}

TableInfo robot_file() {
  TableInfo file = robot_keys().info();
  TableInfo kinematics = kinematics_keys().info();
  kinematics.name = "kinematics";
  TableInfo defaults = axis_keys().info();
  defaults.name = "defaults";
  defaults.text = "All axes inherit these keys. The table has the keys of an `[[axis]]`; none is required here.";
  defaults.all_optional = true;
  defaults.same_as = "axis";
  TableInfo axis = axis_keys().info();
  axis.name = "axis";
  axis.repeated = true;
  axis.least = joints_of(kFiveRFamily);
  axis.most = kAxes;
  axis.all_optional = true;  // what an axis lacks, it inherits
  file.tables = {kinematics, defaults, axis};
  return file;
}

}  // namespace armature::cosim
