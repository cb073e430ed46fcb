#include "cosim/report/tool_point.hpp"

#include <algorithm>

#include "cosim/scenario/to_controller.hpp"

namespace armature::cosim {

bool has_tool_columns(const Scenario& scenario) {
  const auto to_pose = [](const MoveSpec& move) { return move.xyz_mm.has_value(); };
  return scenario.trace.tcp.value_or(std::ranges::any_of(scenario.moves, to_pose));
}

bool needs_tool_point(const Scenario& scenario) {
  const ExpectSpec& expect = scenario.expect;
  const auto to_pose = [](const MoveSpec& move) { return move.xyz_mm.has_value(); };
  return has_tool_columns(scenario) || std::ranges::any_of(scenario.moves, to_pose) || expect.final_tcp_mm ||
         expect.max_path_error_mm || expect.max_command_path_error_mm;
}

ToolPointMeter::ToolPointMeter(const Scenario& scenario)
    : arm_{to_robot_model(scenario.robot)}, tool_mm_{to_transform(scenario.tool).position_mm} {}

ToolPoint ToolPointMeter::measure(const Telemetry& telemetry) const {
  return {arm_.forward(telemetry.reference) * tool_mm_, arm_.forward(telemetry.actual) * tool_mm_};
}

}  // namespace armature::cosim
