#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "cosim/scenario/scenario_tables.hpp"
#include "cosim/text/names.hpp"
#include "cosim/text/number_text.hpp"

namespace armature::cosim {
namespace {

// A tolerance without the value that it belongs to would silently check nothing.
void require_owner(TableReader& table, std::string_view tolerance, std::string_view owner) {
  if (table.has(tolerance) && !table.has(owner)) {
    table.problem(tolerance, "has no effect without " + table.path_of(owner));
  }
}

// Each pin once, in the order in which the run's are listed.
void require_ascending(TableReader& table, std::string_view key, const std::vector<std::int64_t>& pins) {
  if (std::ranges::adjacent_find(pins, std::greater_equal{}) == pins.end()) return;
  std::string found;
  for (const std::int64_t pin : pins) found += (found.empty() ? "" : ", ") + std::to_string(pin);
  table.problem(key, "expected pins in ascending order, each once, found [" + found + "]");
}

}  // namespace

void read_expect(TableReader& table, const ScenarioRobot& robot, bool paper_keys, ExpectSpec& expect) {
  constexpr double kMaxSpeedDegS = 100'000;
  const Rule integer = anything();
  const Rule count = at_least(0);

  table.read("outcome", expect.outcome, one_of(kOutcomeNames));
  read_per_axis(table, "final_joint_deg", expect.final_joint_deg, between(-kMaxAngleDeg, kMaxAngleDeg, "deg"), robot);
  table.read("tolerance_deg", expect.tolerance_deg, between(0, kMaxAngleDeg, "deg"));
  read_per_axis(table, "total_pulses", expect.total_pulses, integer, robot);
  read_per_axis(table, "final_error_counts", expect.final_error_counts, integer, robot);
  table.read("move_ticks", expect.move_ticks, count);
  table.read("taken_ticks", expect.taken_ticks, count);
  Rule shapes = one_of(kShapeNames);
  shapes.count = robot.axis_count();
  table.read("profile", expect.profile, shapes);
  read_per_axis(table, "peak_speed_deg_s", expect.peak_speed_deg_s, between(0, kMaxSpeedDegS, "deg/s"), robot);
  table.read("peak_tolerance_deg_s", expect.peak_tolerance_deg_s, between(0, kMaxSpeedDegS, "deg/s"));
  table.read("peak_pulses_per_tick", expect.peak_pulses_per_tick, count);
  table.read("underruns", expect.underruns, count);
  table.read("min_underruns", expect.min_underruns, count);
  table.read("refused_moves", expect.refused_moves, count);
  table.read("refusals", expect.refusals, one_of(kRefusalNames));
  table.read("unfinished_moves", expect.unfinished_moves, count);
  table.read("blended_moves", expect.blended_moves, count);
  table.read("min_held_s", expect.min_held_s, between(0, 86'400, "s"));
  table.read("max_path_error_mm", expect.max_path_error_mm, between(0, kMaxPlaceMm, "mm"));
  table.read("max_command_path_error_mm", expect.max_command_path_error_mm, between(0, kMaxPlaceMm, "mm"));
  table.read("final_tcp_mm", expect.final_tcp_mm, between(-kMaxPlaceMm, kMaxPlaceMm, "mm"));
  table.read("tcp_tolerance_mm", expect.tcp_tolerance_mm, between(0, kMaxPlaceMm, "mm"));
  table.read("final_rpy_deg", expect.final_rpy_deg, between(-kMaxAngleDeg, kMaxAngleDeg, "deg"));
  table.read("rpy_tolerance_deg", expect.rpy_tolerance_deg, between(0, 180, "deg"));
  table.read("min_stretch", expect.min_stretch, at_least(1));
  table.read("max_stretch", expect.max_stretch, at_least(1));
  table.read("settled_within_s", expect.settled_within_s, between(0, 86'400, "s"));
  table.read("settled_counts", expect.settled_counts, count);
  table.read("max_overshoot_counts", expect.max_overshoot_counts, count);
  table.read("max_correction_pulses", expect.max_correction_pulses, count);
  read_per_axis(table, "inexact_ticks", expect.inexact_ticks, count, robot);
  table.read("max_residual_pulses", expect.max_residual_pulses, count);
  read_per_axis(table, "lost_counts", expect.lost_counts, integer, robot);
  table.read("stopped_by", expect.stopped_by, one_of(kCauseNames));
  Rule seen_by_controller = one_of(kCauseNames);
  std::erase(seen_by_controller.choices, cause_of(kControllerSilent));
  table.read("faults", expect.faults, seen_by_controller);

  if (std::string bytes; table.read("serial_text", bytes, anything())) expect.serial_sent = bytes;
  if (std::string bytes; read_hex(table, "serial_hex", bytes)) expect.serial_sent = bytes;
  expect.serial_as_hex = table.has("serial_hex");
  if (table.has("serial_text") && table.has("serial_hex")) {
    table.problem("serial_hex", "cannot stand beside serial_text");
  }

  if (table.read("final_outputs", expect.final_outputs, between(1, kToolPins))) {
    require_ascending(table, "final_outputs", *expect.final_outputs);
  }

  require_owner(table, "tolerance_deg", "final_joint_deg");
  require_owner(table, "peak_tolerance_deg_s", "peak_speed_deg_s");
  require_owner(table, "tcp_tolerance_mm", "final_tcp_mm");
  require_owner(table, "rpy_tolerance_deg", "final_rpy_deg");
  require_owner(table, "settled_counts", "settled_within_s");
  if (robot.lacks_kinematics()) {
    for (const std::string_view key :
         {"max_path_error_mm", "max_command_path_error_mm", "final_tcp_mm", "final_rpy_deg"}) {
      if (table.has(key)) table.problem(key, "needs [kinematics] in " + robot.file);
    }
  }
  if (!paper_keys) {
    for (const std::string_view key : {"inexact_ticks", "max_residual_pulses", "lost_counts"}) {
      if (table.has(key)) table.problem(key, "needs variant = \"paper\"");
    }
  }
  if (expect.min_stretch && expect.max_stretch && *expect.min_stretch > *expect.max_stretch) {
    table.problem("min_stretch", "expected at most max_stretch = " + number_text(*expect.max_stretch) + ", found " +
                                     number_text(*expect.min_stretch));
  }
  if (expect.underruns && expect.min_underruns) {
    table.problem("min_underruns", "cannot stand beside underruns, which is exact");
  }
}

}  // namespace armature::cosim
