#include "cosim/report/judge/expect.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string_view>

#include "controller/core/timebase.hpp"
#include "cosim/report/judge/expect_checker.hpp"
#include "cosim/report/measure/tool_point.hpp"
#include "cosim/scenario/to_controller.hpp"
#include "cosim/text/angle_units.hpp"
#include "cosim/text/byte_text.hpp"
#include "cosim/text/names.hpp"
#include "cosim/text/number_text.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

std::vector<std::int64_t> durations(const RunFacts& facts) {
  std::vector<std::int64_t> ticks;
  for (const MoveStarted& move : facts.moves) ticks.push_back(move.duration.value());
  return ticks;
}

std::vector<std::int64_t> taken(const RunFacts& facts) {
  std::vector<std::int64_t> ticks;
  for (const std::optional<std::int64_t>& one : facts.taken_ticks) {
    if (one) ticks.push_back(*one);
  }
  return ticks;
}

std::int64_t unfinished(const RunFacts& facts) {
  return facts.moves_waiting + facts.moves_under_way;
}

std::string unfinished_text(const RunFacts& facts) {
  return fmt::format("{}: {} waiting, {} under way at the end", unfinished(facts), facts.moves_waiting,
                     facts.moves_under_way);
}

bool on_path(const MoveStarted& move) {
  return move.kind != MoveKind::kJoint;
}

std::vector<std::string> first_shapes(const RunFacts& facts) {
  std::vector<std::string> shapes;
  if (facts.moves.empty()) return shapes;
  for (const ProfileShape shape : of_axes(facts.moves.front().shape, facts.axis_count)) {
    shapes.emplace_back(shape_name(shape));
  }
  return shapes;
}

std::vector<std::string> refusal_names(const RunFacts& facts) {
  std::vector<std::string> names;
  for (const RefusedMove& refused : facts.refusals) names.emplace_back(refusal_name(refused.refusal.reason));
  return names;
}

std::vector<std::string> causes(const RunFacts& facts) {
  std::vector<std::string> names;
  for (const FaultEvent& fault : facts.faults) names.emplace_back(fault_name(fault.cause));
  return names;
}

std::string settle_text(const RunFacts& facts, std::int64_t counts) {
  if (!facts.settle_s && !facts.moved) return "no motion";
  if (facts.settle_s) return "after " + number_text(*facts.settle_s) + " s";
  return "never within " + std::to_string(counts) + " counts, at the end " + show_list(facts.final_error_counts);
}

ExpectWhere last_outside(const RunFacts& facts) {
  if (!facts.moved) return {};
  ExpectWhere where = at_place(facts.last_outside_at);
  if (facts.last_outside_at) where.text = "last outside: " + where.text;
  return where;
}

// Faults that were cleared again, and servo enables that dropped. A fault at the end is judged by `outcome`.
void check_unmentioned_faults(Checker& checker, const ExpectSpec& expect, const RunFacts& facts) {
  const bool outcome_is_fault = expect.outcome && *expect.outcome != kCompleted;
  if (!expect.faults) {
    std::vector<std::string> unmentioned = causes(facts);
    std::erase_if(unmentioned, [&](const std::string& cause) {
      return cause == expect.stopped_by || (outcome_is_fault && cause == cause_of(*expect.outcome)) ||
             cause == cause_of(facts.outcome());
    });
    checker.require(unmentioned.empty(), "faults", "none but those stated", "also " + show_list(unmentioned),
                    at_faults(facts));
  }
  const bool stop_is_mentioned = expect.stopped_by || outcome_is_fault || (expect.faults && !expect.faults->empty());
  if (!stop_is_mentioned) {
    checker.require(facts.stopped_by.empty(), "stopped_by", "no stop, as it is not stated", facts.stopped_by,
                    at_faults(facts));
  }
}

void check_unmentioned(Checker& checker, const ExpectSpec& expect, const RunFacts& facts) {
  if (!expect.outcome) {
    checker.require(facts.outcome() == kCompleted, "outcome", show(kCompleted), show(facts.outcome()),
                    at_faults(facts));
  }
  if (!expect.refused_moves && !expect.refusals) {
    std::string reasons;
    for (const std::string& name : refusal_names(facts)) reasons += (reasons.empty() ? ": " : ", ") + name;
    checker.require(facts.refusals.empty(), "refused_moves", "0, as it is not stated",
                    std::to_string(facts.refusals.size()) + reasons, at_refusals(facts));
  }
  if (!expect.unfinished_moves) {
    checker.require(unfinished(facts) == 0, "unfinished_moves", "0, as it is not stated", unfinished_text(facts));
  }
  if (!expect.underruns && !expect.min_underruns) {
    checker.require(facts.underruns == 0, "underruns", "0, as it is not stated", show(facts.underruns),
                    first_at(facts.first_underrun_at));
  }
  check_unmentioned_faults(checker, expect, facts);
}

double angle_deg(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  return Eigen::AngleAxisd{a.transpose() * b}.angle() * kDegPerRad;
}

void check_tool(Checker& checker, const ExpectSpec& expect, const RunFacts& facts) {
  checker.deviation_at_most("max_path_error_mm", expect.max_path_error_mm, facts.path_error);
  checker.deviation_at_most("max_command_path_error_mm", expect.max_command_path_error_mm, facts.command_path_error);
  if (expect.final_tcp_mm) {
    const Eigen::Vector3d wanted{expect.final_tcp_mm->data()};
    const double off_mm = facts.final_tcp_mm ? (*facts.final_tcp_mm - wanted).norm() : 0.0;
    checker.require(facts.final_tcp_mm && off_mm <= expect.tcp_tolerance_mm, "final_tcp_mm",
                    show_list(wanted) + checker.plus_minus(expect.tcp_tolerance_mm, "tcp_tolerance_mm"),
                    facts.final_tcp_mm
                        ? fmt::format("{}, {} mm away", show_list(*facts.final_tcp_mm), show_small(off_mm))
                        : "not measured");
  }
  if (expect.final_rpy_deg) {
    const auto& [roll, pitch, yaw] = *expect.final_rpy_deg;
    const Eigen::Matrix3d wanted = to_transform({.xyz_mm = {}, .rpy_deg = *expect.final_rpy_deg}).rotation;
    const double off_deg = facts.final_rotation ? angle_deg(wanted, *facts.final_rotation) : 0.0;
    checker.require(
        facts.final_rotation && off_deg <= expect.rpy_tolerance_deg, "final_rpy_deg",
        show_list(std::array{roll, pitch, yaw}) + checker.plus_minus(expect.rpy_tolerance_deg, "rpy_tolerance_deg"),
        facts.final_rotation
            ? fmt::format("{}, {} deg away", show_list(rpy_deg(*facts.final_rotation)), show_small(off_deg))
            : "not measured");
  }
  const bool ran_path = std::ranges::any_of(facts.moves, on_path);
  const std::string stretch = ran_path ? show(facts.largest_stretch()) : "no move on a line or an arc";
  if (expect.min_stretch) {
    checker.require(ran_path && facts.largest_stretch() >= *expect.min_stretch, "min_stretch",
                    "at least " + show(*expect.min_stretch), stretch);
  }
  if (expect.max_stretch) {
    checker.require(ran_path && facts.largest_stretch() <= *expect.max_stretch, "max_stretch",
                    "at most " + show(*expect.max_stretch), stretch);
  }
}

void check_serial(Checker& checker, const ExpectSpec& expect, const RunFacts& facts) {
  if (!expect.serial_sent) return;
  const auto text = [&](const std::string& bytes) {
    return expect.serial_as_hex ? '"' + hex_of_bytes(bytes) + '"' : quoted_bytes(bytes);
  };
  std::string got = text(facts.serial_sent);
  if (facts.serial_errors > 0) got += fmt::format(" with {} errors or breaks", facts.serial_errors);
  checker.require(facts.serial_errors == 0 && facts.serial_sent == *expect.serial_sent,
                  expect.serial_as_hex ? "serial_hex" : "serial_text", text(*expect.serial_sent), std::move(got));
}

std::string show_change(const OutputChangeSpec& change) {
  return fmt::format("pin {} = {} at {:.6f} s", change.pin, change.level ? 1 : 0, change.at_s);
}

std::string show_changes(const std::vector<OutputChangeSpec>& changes) {
  std::string text;
  for (const OutputChangeSpec& change : changes) text += (text.empty() ? "" : ", ") + show_change(change);
  return text.empty() ? "none" : text;
}

void check_outputs(Checker& checker, const ExpectSpec& expect, const RunFacts& facts) {
  checker.list_exactly("final_outputs", expect.final_outputs, facts.high_outputs());
  if (!expect.outputs) return;
  std::vector<OutputChangeSpec> got;
  for (const OutputChange& change : facts.outputs) {
    got.push_back({.at_s = to_seconds(change.at), .pin = change.pin, .level = change.level});
  }
  // A tick, and what a decimal fraction lacks.
  constexpr double kToleranceS = kTickSeconds + 1e-9;
  const bool met = std::ranges::equal(*expect.outputs, got, [](const OutputChangeSpec& a, const OutputChangeSpec& b) {
    return a.pin == b.pin && a.level == b.level && std::fabs(a.at_s - b.at_s) <= kToleranceS;
  });
  checker.require(met, "output", show_changes(*expect.outputs) + ", each +-50 us", show_changes(got));
}

}  // namespace

std::vector<ExpectFailure> check(const ExpectSpec& expect, const RunFacts& facts) {
  Checker checker{expect, facts.axis_count};
  checker.exactly("outcome", expect.outcome, std::string{facts.outcome()}, at_faults(facts));
  checker.axes_near("final_joint_deg", expect.final_joint_deg, expect.tolerance_deg, "tolerance_deg",
                    facts.final_joint_deg);
  checker.axes_exactly("total_pulses", expect.total_pulses, facts.total_pulses);
  checker.axes_exactly("final_error_counts", expect.final_error_counts, facts.final_error_counts);
  checker.list_exactly("move_ticks", expect.move_ticks, durations(facts));
  checker.list_exactly("taken_ticks", expect.taken_ticks, taken(facts));
  if (expect.profile && (facts.moves.empty() || on_path(facts.moves.front()))) {
    checker.require(false, "profile", show_list(*expect.profile),
                    facts.moves.empty() ? "no move" : "a path of the tool, which has none of each joint");
  } else if (expect.profile) {
    checker.axes_words("profile", *expect.profile, first_shapes(facts));
  }
  checker.axes_near("peak_speed_deg_s", expect.peak_speed_deg_s, expect.peak_tolerance_deg_s, "peak_tolerance_deg_s",
                    facts.peak_speed_deg_s, facts.peak_speed_at);
  checker.exactly("peak_pulses_per_tick", expect.peak_pulses_per_tick, facts.peak_pulses_per_tick,
                  at_place(facts.peak_pulses_at));
  checker.exactly("underruns", expect.underruns, facts.underruns, first_at(facts.first_underrun_at));
  checker.at_least("min_underruns", expect.min_underruns, facts.underruns);
  checker.exactly("refused_moves", expect.refused_moves, static_cast<std::int64_t>(facts.refusals.size()),
                  at_refusals(facts));
  checker.list_exactly("refusals", expect.refusals, refusal_names(facts), at_refusals(facts));
  if (expect.unfinished_moves) {
    checker.require(unfinished(facts) == *expect.unfinished_moves, "unfinished_moves", show(*expect.unfinished_moves),
                    unfinished_text(facts));
  }
  checker.exactly("blended_moves", expect.blended_moves, facts.blended_moves());
  if (expect.min_held_s) {
    checker.require(facts.held_s >= *expect.min_held_s, "min_held_s",
                    "at least " + number_text(*expect.min_held_s) + " s", show(facts.held_s) + " s");
  }
  check_tool(checker, expect, facts);
  if (expect.settled_within_s) {
    checker.require(facts.settle_s && *facts.settle_s <= *expect.settled_within_s, "settled_within_s",
                    "at most " + number_text(*expect.settled_within_s) + " s",
                    settle_text(facts, expect.settled_counts), last_outside(facts));
  }
  const auto overshoot = std::max_element(facts.overshoot_counts.begin(), facts.overshoot_counts.end());
  checker.at_most("max_overshoot_counts", expect.max_overshoot_counts, *overshoot,
                  facts.overshoot_at.at(static_cast<std::size_t>(overshoot - facts.overshoot_counts.begin())));
  checker.at_most("max_correction_pulses", expect.max_correction_pulses, facts.max_correction_pulses,
                  facts.max_correction_at);
  checker.axes_exactly("inexact_ticks", expect.inexact_ticks, facts.inexact_ticks);
  checker.at_most("max_residual_pulses", expect.max_residual_pulses, facts.max_residual_pulses, facts.max_residual_at);
  checker.axes_exactly("lost_counts", expect.lost_counts, facts.lost_counts);
  if (expect.stopped_by) {
    checker.require(*expect.stopped_by == facts.stopped_by, "stopped_by", *expect.stopped_by,
                    facts.stopped_by.empty() ? "no stop" : facts.stopped_by, at_faults(facts));
  }
  checker.list_exactly("faults", expect.faults, causes(facts), at_faults(facts));
  check_serial(checker, expect, facts);
  check_outputs(checker, expect, facts);
  check_unmentioned(checker, expect, facts);
  return checker.take();
}

}  // namespace armature::cosim
