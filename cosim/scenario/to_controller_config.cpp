// What the controller starts with: the robot, the settings and the program.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string_view>
#include <vector>

#include "controller/base/angle_units.hpp"
#include "controller/base/timebase.hpp"
#include "controller/cell/conveyor_config.hpp"
#include "controller/trajectory/profile/synchronise.hpp"
#include "cosim/belt/belt_camera.hpp"
#include "cosim/programs/gcode_files.hpp"
#include "cosim/programs/program_name.hpp"
#include "cosim/scenario/program_start.hpp"
#include "cosim/scenario/to_controller.hpp"

namespace armature::cosim {
namespace {

// Whole cycles of the logic that last at least this long.
std::int32_t cycles_of_ns(double ns) {
  return static_cast<std::int32_t>(std::ceil(ns / static_cast<double>(kNsPerCycle)));
}

std::optional<HomingModel> to_homing_model(const std::optional<HomingSpec>& homing) {
  if (!homing) return std::nullopt;
  return HomingModel{.order = static_cast<std::uint8_t>(homing->order),
                     .direction = homing->direction == "positive" ? 1.0 : -1.0,
                     .search_rad_s = homing->search_deg_s * kRadPerDeg,
                     .latch_rad_s = homing->latch_deg_s * kRadPerDeg,
                     .index_rad = homing->index_deg * kRadPerDeg,
                     .home_rad = homing->position_deg * kRadPerDeg};
}

AxisModel to_axis_model(const AxisSpec& axis) {
  return {
      .gear_ratio = axis.gear_ratio,
      .pulses_per_rev = axis.pulses_per_rev,
      .counts_per_rev = axis.encoder_lines * kCountsPerLine,
      .index_at_zero = true,  // as the encoders of cosim/plant
      .min_rad = axis.min_deg * kRadPerDeg,
      .max_rad = axis.max_deg * kRadPerDeg,
      .max_speed_rad_s = axis.max_speed_deg_s * kRadPerDeg,
      .max_accel_rad_s2 = axis.max_accel_deg_s2 * kRadPerDeg,
      .max_jerk_rad_s3 = axis.max_jerk_deg_s3.value_or(0.0) * kRadPerDeg,
      .following_error_limit_rad = axis.following_error_deg * kRadPerDeg,
      .following_error_at_rest_rad = axis.following_error_at_rest_deg.value_or(0.0) * kRadPerDeg,
      .encoder_speed_rad_s = axis.encoder_speed_limit_deg_s.value_or(0.0) * kRadPerDeg,
      .encoder_accel_rad_s2 = axis.encoder_accel_limit_deg_s2.value_or(0.0) * kRadPerDeg,
      .drive_natural_rad_s = axis.drive.natural_hz * (2.0 * std::numbers::pi),
      .drive_damping = axis.drive.damping,
      .dir_setup_cycles = cycles_of_ns(axis.drive.dir_setup_ns),
      .dir_hold_cycles = cycles_of_ns(axis.drive.dir_hold_ns),
      .min_step_high_cycles = cycles_of_ns(axis.drive.min_step_high_ns),
      .min_step_low_cycles = cycles_of_ns(axis.drive.min_step_low_ns),
      .homing = to_homing_model(axis.homing),
  };
}

ArmGeometry to_arm_geometry(const KinematicsSpec& kinematics) {
  return {
      .family = kinematics.family == kFiveRFamily ? ArmFamily::kFiveR : ArmFamily::kSixR,
      .a1_mm = kinematics.a1_mm,
      .a2_mm = kinematics.a2_mm,
      .a3_mm = kinematics.a3_mm,
      .a4_mm = kinematics.a4_mm,
      .d1_mm = kinematics.d1_mm,
      .d4_mm = kinematics.d4_mm,
      .d5_mm = kinematics.d5_mm,
      .d6_mm = kinematics.d6_mm,
      .sign = kinematics.sign,
      .offset_rad = make_per_axis([&](std::size_t i) { return kinematics.offset_deg[i] * kRadPerDeg; }),
      .max_projection_rad = kinematics.family == kFiveRFamily ? kinematics.max_projection_deg * kRadPerDeg : 0.0,
  };
}

BeltPolicyConfig to_policy_config(const BeltPolicySpec& policy) {
  BeltPolicyConfig config = policy.network;
  config.where = policy.on;
  config.share = static_cast<std::uint8_t>(policy.percent / 100.0 * BeltPolicyConfig::kWhole);
  return config;
}

ConveyorConfig to_conveyor_config(const ConveyorSpec& conveyor) {
  std::optional<BeltPolicyConfig> policy;
  if (conveyor.policy) policy = to_policy_config(*conveyor.policy);
  std::optional<BeltCamera> camera;
  if (conveyor.camera) camera = to_camera(*conveyor.camera);
  return {.base_T_part = to_transform({.xyz_mm = conveyor.xyz_mm, .rpy_deg = conveyor.rpy_deg}),
          .direction = to_vector(conveyor.direction).normalized(),
          .mm_per_count = conveyor.mm_per_count,
          .from_mm = conveyor.window_mm[0],
          .to_mm = conveyor.window_mm[1],
          .max_speed_mm_s = conveyor.max_speed_mm_s,
          .accel_mm_s2 = conveyor.accel_mm_s2,
          .speed_tolerance = conveyor.speed_tolerance_percent / 100.0,
          .lead_s = conveyor.lead_ms * 1e-3,
          .camera = camera,
          .policy = policy};
}

UserFrames to_user_frames(const std::vector<FrameSpec>& frames) {
  UserFrames base_T_user{};
  for (std::size_t i = 0; i < frames.size(); ++i) base_T_user.at(i) = to_transform(frames[i].pose);
  return base_T_user;
}

gcode::MotionSettings to_gcode_settings(const GcodeSpec& gcode) {
  gcode::MotionSettings settings{.frame = FrameId{static_cast<std::uint8_t>(gcode.frame)},
                                 .orientation = gcode.orientation,
                                 .rapid_mm_s = gcode.rapid_mm_s,
                                 .rapid_turn_rad_s = gcode.rapid_turn_deg_s * kRadPerDeg,
                                 .accel_mm_s2 = gcode.accel_mm_s2,
                                 .turn_accel_rad_s2 = gcode.turn_accel_deg_s2 * kRadPerDeg,
                                 .corner_mm = gcode.corner_mm,
                                 .spindle_pin = static_cast<std::uint8_t>(gcode.spindle_pin),
                                 .mist_pin = static_cast<std::uint8_t>(gcode.mist_pin),
                                 .flood_pin = static_cast<std::uint8_t>(gcode.flood_pin)};
  for (const GcodeAnalogSpec& analog : gcode.analog) {
    settings.analog.at(static_cast<std::size_t>(analog.number)) = {
        .first_pin = static_cast<std::uint8_t>(analog.first_pin),
        .bits = static_cast<std::uint8_t>(analog.bits),
        .full = analog.full};
  }
  for (const std::int64_t tool : gcode.tools) settings.tools.set(static_cast<std::size_t>(tool));
  return settings;
}

job::MachineSettings to_job_settings(const JobSpec& job) {
  job::MachineSettings settings{.accel_mm_s2 = job.accel_mm_s2,
                                .turn_accel_rad_s2 = job.turn_accel_deg_s2 * kRadPerDeg};
  std::ranges::copy(job.pl_radius_mm, settings.pl_radius_mm.begin() + 1);
  const auto set_pin = [&](job::Device device, std::int64_t pin) {
    settings.device_pin[static_cast<std::size_t>(device)] = static_cast<std::uint8_t>(pin);
  };
  set_pin(job::Device::kArc, job.arc_pin);
  set_pin(job::Device::kWeave, job.weave_pin);
  set_pin(job::Device::kTool, job.tool_pin);
  for (const JobToolSpec& tool : job.tools) {
    settings.flange_T_tool[static_cast<std::size_t>(tool.number)] = to_transform(tool.pose);
  }
  return settings;
}

Ticks to_ticks(double time_s) {
  return Ticks{std::llround(time_s / kTickSeconds)};
}

}  // namespace

RobotModel to_robot_model(const RobotSpec& robot) {
  RobotModel model;
  for (std::size_t i = 0; i < kAxes; ++i) model.axes[i] = to_axis_model(robot.axes[i]);
  model.axis_count = static_cast<std::uint32_t>(robot.axis_count);
  for (std::size_t i = robot.axis_count; i < kAxes; ++i) model.axes[i].min_rad = model.axes[i].max_rad = 0.0;
  if (robot.kinematics) model.arm = to_arm_geometry(*robot.kinematics);
  return model;
}

ControllerConfig to_controller_config(const Scenario& scenario) {
  const ControllerSpec& controller = scenario.controller;
  ControllerConfig config;
  config.feedback = controller.feedback;
  config.sync = controller.sync == "const_acc"    ? SyncRule::kConstAcc
                : controller.sync == "time_scale" ? SyncRule::kTimeScale
                                                  : SyncRule::kFig9;
  if (scenario.variant == Variant::kPaper) {
    config.paper = {.axis = static_cast<std::uint32_t>(scenario.paper.encoder_axis - 1),
                    .switch_every = Ticks{scenario.paper.switch_every_ticks.value_or(0)}};
  }
  if (scenario.pendant) {
    config.pendant = {
        .profile = scenario.pendant->profile == "extended" ? pendant::Profile::kExtended : pendant::Profile::kStrict,
        .paper_logic = scenario.variant == Variant::kPaper};
  }
  config.max_stretch = controller.max_stretch;
  config.cordic = scenario.kinematics.solver == SetPointSolver::kCordic;
  config.referenced = !scenario.unreferenced_start_deg;
  config.flange_T_tool = to_transform(scenario.tool);
  config.base_T_user = to_user_frames(scenario.frames);
  if (scenario.conveyor) config.conveyor = to_conveyor_config(*scenario.conveyor);
  config.job = to_job_settings(scenario.job);
  config.gcode = to_gcode_settings(scenario.gcode);
  config.program_start.reset();
  if (scenario.program_at_s || !scenario.pendant) config.program_start = to_ticks(program_start_s(scenario));
  if (scenario.program_resumes_after_s) config.program_resumes_after = to_ticks(*scenario.program_resumes_after_s);
  return config;
}

host_memory::BootMemory to_boot_memory(const Scenario& scenario) {
  const JoinedGcode gcode{scenario.program_files};
  host_memory::BootProgram program;
  if (scenario.program) program.language = program_language(*scenario.program);
  for (std::size_t i = 0; i < scenario.program_files.size(); ++i) {
    const ProgramFile& file = scenario.program_files[i];
    const bool joined = program.language == ProgramLanguage::kGcode;
    program.files.push_back({.name = file.name, .text = joined ? gcode.file(i) : std::string_view{file.text}});
  }
  return {to_robot_model(scenario.robot), to_controller_config(scenario), program};
}

gcode::MotionSetup to_gcode_setup(const Scenario& scenario, const RobotModel& robot, const Arm& arm) {
  return {.cell = {.robot = robot,
                   .arm = arm,
                   .flange_T_tool = to_transform(scenario.tool),
                   .base_T_user = to_user_frames(scenario.frames)},
          .settings = to_gcode_settings(scenario.gcode)};
}

}  // namespace armature::cosim
