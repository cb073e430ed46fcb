#include "cosim/live/live_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "controller/base/angle_units.hpp"
#include "controller/message/fault.hpp"
#include "cosim/live/live_faults.hpp"
#include "cosim/mesh/stl_file.hpp"
#include "cosim/page/arm_meshes.hpp"
#include "cosim/report/format/json/arm_json.hpp"
#include "cosim/text/names.hpp"
#include "cosim/text/text_file.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

using pendant::Page;

constexpr std::size_t kShownMessages = 8;

// Rounded, so that the message stays short: more digits than a picture or a display can show.
double short_number(double value) {
  constexpr double kSteps = 1e4;
  return std::round(value * kSteps) / kSteps;
}

Json angles_json(const JointAngles& angles, std::size_t count) {
  Json json = Json::array();
  for (std::size_t i = 0; i < count; ++i) json.push_back(short_number(angles[i].value() * kDegPerRad));
  return json;
}

Json tool_json(const LiveView& view) {
  if (!view.kinematics.known()) return nullptr;
  Json tool = view.kinematics.forward(view.watch.telemetry().actual);
  for (Json& numbers : tool) {
    for (Json& number : numbers) number = short_number(number.get<double>());
  }
  return tool;
}

std::string alarm_text(const OperatorLink& link) {
  const std::int32_t alarm = link.page(Page::kAlarm);
  if (alarm == 0) return {};
  std::string cause{word_of(static_cast<FaultCause>(pendant::kAlarmCause.of(alarm)))};
  std::ranges::replace(cause, '_', ' ');
  const int axis = pendant::kAlarmAxis.of(alarm);
  return axis == 0 ? cause : fmt::format("{}, axis {}", cause, axis);
}

Json breakpoints_json(const OperatorLink& link) {
  Json lines = Json::array();
  for (const std::int32_t place : link.breakpoints()) lines.push_back(pendant::kLineLine.of(place));
  return lines;
}

Json program_json(const LiveView& view) {
  const OperatorLink& link = view.pendant.link();
  const auto number = static_cast<std::size_t>(link.page(Page::kProgram));
  const std::optional<std::size_t> job = link.job_of(view.program);
  const std::int32_t place = link.page(Page::kLine);
  const bool here = !job || pendant::kLineJob.of(place) == static_cast<std::int32_t>(*job);
  return {{"name", view.program},
          {"loaded", link.has_sent() && job.has_value()},
          {"loading", link.downloading()},
          {"state", number < pendant::kProgramNames.size() ? pendant::kProgramNames[number] : "none"},
          {"line", here ? pendant::kLineLine.of(place) : 0},
          {"breakpoints", breakpoints_json(link)}};
}

// A move is many commands; those that stage its target say nothing when all is well.
bool is_of_a_target(std::string_view message) {
  return message == "target: ok" || message == "target_option: ok" || message == "set_coordinates: ok";
}

Json messages_json(const OperatorLink& link) {
  std::vector<std::string> shown;
  for (const std::string& message : link.messages()) {
    if (!is_of_a_target(message)) shown.push_back(message);
  }
  if (shown.size() > kShownMessages) shown.erase(shown.begin(), shown.end() - kShownMessages);
  return shown;
}

Json lamps_json(const SimulationState& state) {
  return {{"servo", state.outputs.servo_on},
          {"drive_alarm", state.inputs.drive_alarm},
          {"in_position", state.inputs.in_position},
          {"home", state.inputs.home},
          {"limit_pos", state.inputs.limit_pos},
          {"limit_neg", state.inputs.limit_neg},
          {"estop", !state.inputs.estop_n},
          {"outputs", state.outputs.gpio},
          {"inputs", state.inputs.gpio}};
}

RecordedInput read_mesh(const std::string& file) {
  return {.content = read_binary_file(file, kMaxMeshBytes)};
}

}  // namespace

Json live_scenario(const Scenario& scenario) {
  Json programs = Json::array();
  std::set<std::string, std::less<>> names;
  const auto add = [&](const std::string& name, const std::string& text) {
    if (names.insert(name).second) programs.push_back({{"name", name}, {"text", text}});
  };
  for (const ProgramFile& file : scenario.program_files) add(file.name, file.text);
  if (scenario.pendant) {
    for (const PendantStepSpec& step : scenario.pendant->steps) {
      if (step.act == PendantAct::kDownload) add(step.file, step.text);
    }
  }
  const Json arm = arm_json(scenario.robot, scenario.tool);
  return {{"scenario", scenario.name},
          {"description", scenario.description},
          {"robot", scenario.robot_name},
          {"family", scenario.robot.kinematics ? Json(scenario.robot.kinematics->family) : Json(nullptr)},
          {"arm", arm},
          {"meshes", arm_meshes(arm.value("meshes", Json(nullptr)), read_mesh)},
          {"programs", std::move(programs)},
          {"faults", fault_kinds_json(scenario.robot)}};
}

Json live_state(const LiveView& view) {
  const OperatorLink& link = view.pendant.link();
  const Telemetry& telemetry = view.watch.telemetry();
  const std::optional<pendant::State> state = link.state();
  const std::size_t joints = view.scenario.robot.axis_count;
  const std::string_view unknown = link.connected() ? "no telemetry" : "no connection";
  return {{"t", short_number(to_seconds(view.state.now))},
          {"factor", short_number(view.factor)},
          {"joints_deg", angles_json(telemetry.actual, joints)},
          {"set_deg", angles_json(telemetry.reference, joints)},
          {"tool", tool_json(view)},
          {"state", state ? pendant::kStateNames[static_cast<std::size_t>(*state)] : unknown},
          {"motion", word_of(telemetry.state)},
          {"rate", short_number(telemetry.rate)},
          {"drives", link.drives_on()},
          {"extended", link.extended()},
          {"alarm", alarm_text(link)},
          {"estop_pressed", link.estop_pressed()},
          {"system", link.coordinates()},
          {"lamps", lamps_json(view.state)},
          {"held", view.cell.held()},
          {"program", program_json(view)},
          {"command", view.watch.command()},
          {"messages", messages_json(link)},
          {"events", Json(view.watch.events())}};
}

}  // namespace armature::cosim
