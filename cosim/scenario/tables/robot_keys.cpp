// A robot file: its own keys, [defaults] and [[axis]].
#include <fmt/format.h>

#include <cstdint>
#include <limits>
#include <string>

#include "controller/base/timebase.hpp"
#include "controller/regs/encoder_regs.hpp"
#include "controller/regs/pulse_train_regs.hpp"
#include "cosim/mesh/stl_file.hpp"
#include "cosim/scenario/tables/tables.hpp"
#include "cosim/text/number_text.hpp"

namespace armature::cosim {
namespace {

constexpr double kMaxDeg = 100 * 360.0;  // far beyond any arm: keeps counts in range
constexpr double kMaxPulsesPerRev = std::numeric_limits<std::int32_t>::max();
constexpr std::uint32_t kMaxLines = regs::encoder::kCountsPerRevValueMask / kCountsPerLine;  // width of the register
constexpr double kMaxDirNs =
    regs::pulse_train::kDirSetupValueMask * static_cast<double>(kNsPerCycle);  // width of the registers

const KeyTable<DriveSpec>& drive_keys() {
  static const KeyTable<DriveSpec> kTable{
      .text = "The servo drive of an axis and its motor.",
      .keys = {
          key("natural_hz", &DriveSpec::natural_hz, between(1, 1000, "Hz"),
              "Natural frequency of the drive's position loop."),
          key("damping", &DriveSpec::damping, between(0.1, 10), "Damping ratio of the position loop."),
          key("max_speed_rpm", &DriveSpec::max_speed_rpm, above(0, kMaxMotorRpm, "rpm"), "Speed limit of the motor."),
          key("max_torque_nm", &DriveSpec::max_torque_nm, above(0, kMaxMotorNm, "N m"), "Torque limit of the motor."),
          key("inertia_kg_m2", &DriveSpec::inertia_kg_m2, above(0, 100, "kg m^2"),
              "Inertia of the motor and of its load, reflected to the motor shaft."),
          key("min_step_high_ns", &DriveSpec::min_step_high_ns, between(0, 50'000, "ns"),
              "Shortest high time of a step pulse that the drive accepts. Every pulse is checked."),
          key("min_step_low_ns", &DriveSpec::min_step_low_ns, between(0, 50'000, "ns"),
              "Shortest low time between two step pulses that the drive accepts."),
          key("dir_setup_ns", &DriveSpec::dir_setup_ns, between(0, kMaxDirNs, "ns"),
              "Set-up time: the direction line must be stable for this time before a pulse."),
          key("dir_hold_ns", &DriveSpec::dir_hold_ns, between(0, kMaxDirNs, "ns"),
              "Hold time: the direction line must be stable for this time after a pulse."),
      }};
  return kTable;
}

const KeyTable<HomingSpec>& homing_keys() {
  static const KeyTable<HomingSpec> kTable{
      .text =
          "How the controller finds the joint angle of an axis that it does not know. The axis searches the home "
          "switch, and turns round at a limit switch. It leaves the home switch slowly on the side from which the "
          "search comes. There it moves on to the first index pulse of its encoder, which gives the angle, and then to "
          "its home position. An axis without this table cannot be homed.",
      .keys = {
          key("order", &HomingSpec::order, between(1, kAxes),
              "Axes with a lower number are homed first, those with the same number together."),
          key("direction", &HomingSpec::direction, one_of({"negative", "positive"}),
              "Direction of the joint in which the home switch is searched."),
          key("search_deg_s", &HomingSpec::search_deg_s, above(0, 100'000, "deg/s"), "Speed of the search."),
          key("latch_deg_s", &HomingSpec::latch_deg_s, above(0, 100'000, "deg/s"),
              "Speed from the switch to the index pulse."),
          key("index_deg", &HomingSpec::index_deg, between(-kMaxDeg, kMaxDeg, "deg"),
              "Joint angle at this index pulse. In the simulation, an encoder has one at joint angle 0 and at each "
              "whole turn of the motor from there."),
          key("position_deg", &HomingSpec::position_deg, between(-kMaxDeg, kMaxDeg, "deg"),
              "The home position: the joint angle where the axis stands at the end."),
      }};
  return kTable;
}

}  // namespace

const KeyTable<AxisSpec>& axis_keys() {
  static const KeyTable<AxisSpec> kTable{
      .text =
          "Each table describes one axis. The arm has as many axes as `family` has joints, and six without "
          "`[kinematics]`. An axis inherits each missing key from `[defaults]`.",
      .keys =
          {
              key("gear_ratio", &AxisSpec::gear_ratio, between(-10'000, 10'000),
                  "Motor turns for one turn of the joint. It is negative if motor and joint turn in opposite "
                  "directions. Its magnitude is at least 0.01.")
                  .required(),
              key("pulses_per_rev", &AxisSpec::pulses_per_rev, between(1, kMaxPulsesPerRev),
                  "Electronic gear of the drive: pulses for one turn of the motor.")
                  .required(),
              key("encoder_lines", &AxisSpec::encoder_lines, between(1, kMaxLines),
                  "Lines of the motor's encoder for one turn of the motor. One line gives 4 counts.")
                  .required(),
              key("min_deg", &AxisSpec::min_deg, between(-kMaxDeg, kMaxDeg, "deg"), "Lower limit of the joint angle.")
                  .required(),
              key("max_deg", &AxisSpec::max_deg, between(-kMaxDeg, kMaxDeg, "deg"), "Upper limit of the joint angle.")
                  .required(),
              key("max_speed_deg_s", &AxisSpec::max_speed_deg_s, above(0, 100'000, "deg/s"),
                  "Speed limit of the joint.")
                  .required(),
              key("max_accel_deg_s2", &AxisSpec::max_accel_deg_s2, above(0, 10'000'000, "deg/s^2"),
                  "Acceleration limit of the joint.")
                  .required(),
              key("max_jerk_deg_s3", &AxisSpec::max_jerk_deg_s3, above(0, 1e9, "deg/s^3"),
                  "Jerk limit of the joint. Joint moves with `profile = \"scurve\"` need it for every axis.")
                  .without("none: trapezoids only"),
              key("following_error_deg", &AxisSpec::following_error_deg, above(0, 360, "deg"),
                  "Largest allowed difference between reference and encoder. A larger one is the fault "
                  "`following_error`. Must be more than the lag of the drive."),
              key("following_error_at_rest_deg", &AxisSpec::following_error_at_rest_deg, above(0, 360, "deg"),
                  "Largest allowed difference between the encoder and where the drive would be with its nominal lag, "
                  "`natural_hz` and `damping`, while the axis rests. In motion, 0.6 times the lag is added. A larger "
                  "one is the fault `following_error`, long before `following_error_deg` is reached.")
                  .without("only `following_error_deg` is checked"),
              key("encoder_speed_limit_deg_s", &AxisSpec::encoder_speed_limit_deg_s, above(0, 1'000'000, "deg/s"),
                  "A higher speed of the encoder, as the mean of 1 ms, is the fault `encoder_speed`. Must be more than "
                  "`max_speed_deg_s`.")
                  .without("not checked"),
              key("encoder_accel_limit_deg_s2", &AxisSpec::encoder_accel_limit_deg_s2, above(0, 1e9, "deg/s^2"),
                  "A higher acceleration of the encoder, between the means of two times 5 ms, is the fault "
                  "`encoder_accel`. Must be more than `max_accel_deg_s2`.")
                  .without("not checked"),
              key("home_switch_deg", &AxisSpec::home_switch_deg, between(-kMaxDeg, kMaxDeg, "deg"),
                  "The home switch of the joint is active between these two joint angles.")
                  .without("no home switch"),
              key("limit_switch_deg", &AxisSpec::limit_switch_deg, between(-kMaxDeg, kMaxDeg, "deg"),
                  "The limit switches of the joint. The negative one is active at the first angle and below, the "
                  "positive one at the second angle and above. They are not within `min_deg` and `max_deg`.")
                  .without("no limit switches"),
          },
      .tables = {table("drive", &AxisSpec::drive, drive_keys()), table("homing", &AxisSpec::homing, homing_keys()),
                 table("dynamics", &AxisSpec::dynamics, dynamics_keys())}};
  return kTable;
}

const KeyTable<RobotSpec>& robot_keys() {
  static const std::string kPlantText = [] {
    const AxisSpec ideal = ideal_axis();
    return fmt::format(
        "How the drives, the gears and the arm behave. `servo`: each axis is a system of second order. No other axis "
        "and "
        "no load moves it. `dynamic`: the axes have the loops of their drives, friction, brakes and elastic gears, and "
        "move the rigid bodies of the arm. See `dynamics` and `[[link]]`. `ideal`: the axes follow at once. Few makers "
        "publish gears, encoders and motors. An axis then needs no `gear_ratio`, `pulses_per_rev` and `encoder_lines`. "
        "Their defaults are {}, {} and "
        "{}, and those of the drive are `natural_hz` = {}, `max_speed_rpm` = {} and `max_torque_nm` = {}, which limit "
        "nothing.",
        number_text(ideal.gear_ratio), ideal.pulses_per_rev, ideal.encoder_lines, number_text(ideal.drive.natural_hz),
        number_text(ideal.drive.max_speed_rpm), number_text(ideal.drive.max_torque_nm));
  }();
  static const KeyTable<RobotSpec> kTable{
      .text = {},
      .keys = {
          key("name", &RobotSpec::name, anything(),
              "Name of the robot. It must be the name of the file without `.toml`.")
              .required(),
          key("description", &RobotSpec::description, anything(), "One line about the robot for `armature list`."),
          key("plant", &RobotSpec::plant, one_of({kServoPlant, kIdealPlant, kDynamicPlant}), kPlantText),
          key("gravity_m_s2", &RobotSpec::gravity_m_s2, between(-100, 100, "m/s^2"),
              "Acceleration of gravity in the frame of the base, for `plant = \"dynamic\"`. An arm that hangs from a "
              "ceiling has it in the other direction."),
      }};
  return kTable;
}

const KeyTable<MeshesSpec>& meshes_keys() {
  static const std::string kText = fmt::format(
      "Shapes of the parts of the arm, for the report and `armature live`. They do not change a run. Each is an STL "
      "file, text or binary, with at most {} triangles. Its numbers are mm in the frame of the base, while all joint "
      "angles are 0: a CAD program writes it so when the whole arm stands in this pose. Names are relative to the "
      "folder of the robot file. The arm needs `[kinematics]`. A part without a file is drawn as a simple body.",
      kMaxMeshTriangles);
  static const KeyTable<MeshesSpec> kTable{
      .text = kText,
      .keys = {
          key("base", &MeshesSpec::base, anything(), "File of the part that does not move.").without("none"),
          key("links", &MeshesSpec::links, anything(),
              "One file for each joint, of the part that this joint moves. An empty text means none.")
              .without("none"),
      }};
  return kTable;
}

TableInfo robot_file() {
  TableInfo file = robot_keys().info();
  TableInfo kinematics = kinematics_keys().info();
  kinematics.name = "kinematics";
  TableInfo defaults = axis_keys().info();
  defaults.name = "defaults";
  defaults.text =
      "Values that all axes inherit. The table has the keys of an `[[axis]]`. None of them is required here.";
  defaults.all_optional = true;
  defaults.same_as = "axis";
  TableInfo axis = axis_keys().info();
  axis.name = "axis";
  axis.repeated = true;
  axis.least = joints_of(kFiveRFamily);
  axis.most = kAxes;
  axis.all_optional = true;  // an axis inherits missing keys
  TableInfo link = body_keys().info();
  link.name = "link";
  link.repeated = true;
  link.most = kAxes;
  TableInfo tool = body_keys().info();
  tool.name = "tool";
  tool.text = "The tool as a rigid body in the frame of the flange, for `plant = \"dynamic\"`.";
  TableInfo payload = tool;
  payload.name = "payload";
  payload.text = "What the tool carries, likewise.";
  TableInfo meshes = meshes_keys().info();
  meshes.name = "meshes";
  file.tables = {kinematics, defaults, axis, link, tool, payload, meshes};
  return file;
}

}  // namespace armature::cosim
