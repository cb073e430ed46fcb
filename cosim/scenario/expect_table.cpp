#include "cosim/scenario/scenario_tables.hpp"
#include "cosim/text/names.hpp"

namespace armature::cosim {
namespace {

template <std::size_t kCount>
Rule one_of(const std::array<std::string_view, kCount>& names) {
  Rule rule;
  rule.choices.assign(names.begin(), names.end());
  return rule;
}

// A tolerance without the value that it belongs to would silently check nothing.
void require_owner(TableReader& table, std::string_view tolerance, std::string_view owner) {
  if (table.has(tolerance) && !table.has(owner)) {
    table.problem(tolerance, "has no effect without " + table.path_of(owner));
  }
}

}  // namespace

void read_expect(TableReader& table, ExpectSpec& expect) {
  constexpr double kMaxDeg = 36'000;
  constexpr double kMaxSpeedDegS = 100'000;
  const Rule integer = anything();
  const Rule count = at_least(0);

  table.read("outcome", expect.outcome, one_of(kOutcomeNames));
  table.read("final_joint_deg", expect.final_joint_deg, between(-kMaxDeg, kMaxDeg, "deg"));
  table.read("tolerance_deg", expect.tolerance_deg, between(0, kMaxDeg, "deg"));
  table.read("total_pulses", expect.total_pulses, integer);
  table.read("final_error_counts", expect.final_error_counts, integer);
  table.read("move_ticks", expect.move_ticks, count);
  table.read("profile", expect.profile, one_of(kShapeNames));
  table.read("peak_speed_deg_s", expect.peak_speed_deg_s, between(0, kMaxSpeedDegS, "deg/s"));
  table.read("peak_tolerance_deg_s", expect.peak_tolerance_deg_s, between(0, kMaxSpeedDegS, "deg/s"));
  table.read("peak_pulses_per_tick", expect.peak_pulses_per_tick, count);
  table.read("underruns", expect.underruns, count);
  table.read("min_underruns", expect.min_underruns, count);
  table.read("refused_moves", expect.refused_moves, count);
  table.read("settled_within_s", expect.settled_within_s, between(0, 86'400, "s"));
  table.read("settled_counts", expect.settled_counts, count);
  table.read("max_overshoot_counts", expect.max_overshoot_counts, count);
  table.read("max_correction_pulses", expect.max_correction_pulses, count);
  table.read("stopped_by", expect.stopped_by, one_of(kCauseNames));
  Rule seen_by_controller = one_of(kCauseNames);
  std::erase(seen_by_controller.choices, cause_of(kControllerSilent));
  table.read("faults", expect.faults, seen_by_controller);

  require_owner(table, "tolerance_deg", "final_joint_deg");
  require_owner(table, "peak_tolerance_deg_s", "peak_speed_deg_s");
  require_owner(table, "settled_counts", "settled_within_s");
  if (expect.profile && expect.profile->size() != kAxes) {
    table.problem("profile", "expected " + std::to_string(kAxes) + " shapes, one an axis, found " +
                                 std::to_string(expect.profile->size()));
  }
  if (expect.underruns && expect.min_underruns) {
    table.problem("min_underruns", "cannot stand beside underruns, which is exact");
  }
}

}  // namespace armature::cosim
