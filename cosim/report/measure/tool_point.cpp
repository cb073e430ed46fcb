#include "cosim/report/measure/tool_point.hpp"

#include <algorithm>

#include "controller/base/angle_units.hpp"
#include "cosim/scenario/to_controller.hpp"

namespace armature::cosim {
namespace {

bool any_move_to_a_pose(const Scenario& scenario) {
  return std::ranges::any_of(scenario.moves, [](const CommandSpec& move) { return pose_of(move.kind) != nullptr; });
}

bool any_output_at_a_point(const ExpectSpec& expect) {
  return expect.outputs &&
         std::ranges::any_of(*expect.outputs, [](const OutputChangeSpec& o) { return o.tcp_mm.has_value(); });
}

}  // namespace

ToolColumns tool_columns(const Scenario& scenario) {
  return scenario.trace.tcp.value_or(any_move_to_a_pose(scenario)) ? ToolColumns::kYes : ToolColumns::kNo;
}

bool needs_tool_point(const Scenario& scenario) {
  const ExpectSpec& expect = scenario.expect;
  return tool_columns(scenario) == ToolColumns::kYes || any_move_to_a_pose(scenario) || expect.final_tcp_mm ||
         expect.final_rpy_deg || expect.max_path_error_mm || expect.max_command_path_error_mm ||
         any_output_at_a_point(expect);
}

std::array<double, 3> rpy_deg(const Eigen::Matrix3d& rotation) {
  const RollPitchYaw rpy = rpy_from_rotation(rotation);
  return {rpy.roll_rad * kDegPerRad, rpy.pitch_rad * kDegPerRad, rpy.yaw_rad * kDegPerRad};
}

ToolPointMeter::ToolPointMeter(const Scenario& scenario)
    : arm_{to_robot_model(scenario.robot)}, flange_T_tool_{to_transform(scenario.tool)} {}

ToolPoint ToolPointMeter::measure(const Telemetry& telemetry) const {
  const Transform actual = arm_.forward(telemetry.actual) * flange_T_tool_;
  return {
      .reference_mm = set_point_mm(telemetry), .encoder_mm = actual.position_mm, .encoder_rotation = actual.rotation};
}

Eigen::Vector3d ToolPointMeter::set_point_mm(const Telemetry& telemetry) const {
  return arm_.forward(telemetry.reference) * flange_T_tool_.position_mm;
}

}  // namespace armature::cosim
