#include "cosim/report/facts/fact_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <span>
#include <vector>

#include "cosim/report/facts/value_text.hpp"
#include "cosim/scenario/to_controller.hpp"
#include "cosim/text/names.hpp"
#include "cosim/text/number_text.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

std::vector<std::string> reasons(const RunFacts& facts) {
  std::vector<std::string> names;
  for (const RefusedMove& refused : facts.refusals) names.emplace_back(word_of(refused.refusal.reason));
  return names;
}

std::int64_t unfinished(const RunFacts& facts) {
  return facts.moves_waiting + facts.moves_under_way;
}

bool on_path(const MoveStarted& move) {
  return is_path(move.kind);
}

}  // namespace

FactValue refused_moves(const RunFacts& facts) {
  return std::int64_t{std::ssize(facts.refusals)};
}

FactValue refusals(const RunFacts& facts) {
  return reasons(facts);
}

FactValue jog_ends(const RunFacts& facts) {
  std::vector<std::string> names;
  for (const JogRun& jog : facts.jogs) {
    if (jog.ended) names.emplace_back(word_of(jog.ended->how));
  }
  return names;
}

FactValue homing_ends(const RunFacts& facts) {
  std::vector<HomingEnded> ends;
  for (const HomingRun& axis : facts.homings) {
    if (axis.ended) ends.push_back(*axis.ended);
  }
  std::ranges::stable_sort(ends, {}, &HomingEnded::tick);
  std::vector<std::string> names;
  names.reserve(ends.size());
  for (const HomingEnded& end : ends) names.emplace_back(word_of(end.how));
  return names;
}

std::string refused_moves_text(const RunFacts& facts) {
  std::vector<std::string> names = reasons(facts), different;
  for (const std::string& name : names) {
    if (std::ranges::find(different, name) == different.end()) different.push_back(name);
  }
  for (std::string& name : different) {
    const auto times = std::ranges::count(names, name);
    if (times > 1) name = fmt::format("{} times {}", times, name);
  }
  return fmt::format("{}{}{}", names.size(), different.empty() ? "" : ": ", fmt::join(different, ", "));
}

FactValue unfinished_moves(const RunFacts& facts) {
  return unfinished(facts);
}

std::string unfinished_moves_text(const RunFacts& facts) {
  return fmt::format("{}: {} waiting, {} under way at the end", unfinished(facts), facts.moves_waiting,
                     facts.moves_under_way);
}

FactValue move_ticks(const RunFacts& facts) {
  std::vector<std::int64_t> ticks;
  for (const MoveStarted& move : facts.moves) ticks.push_back(move.duration.value());
  return ticks;
}

FactValue taken_ticks(const RunFacts& facts) {
  std::vector<std::int64_t> ticks;
  for (const std::optional<std::int64_t>& one : facts.taken_ticks) {
    if (one) ticks.push_back(*one);
  }
  return ticks;
}

FactValue first_profile(const RunFacts& facts) {
  if (facts.moves.empty() || on_path(facts.moves.front())) return {};
  OfAxes<std::string> shapes;
  for (std::size_t i = 0; i < facts.axis_count; ++i) shapes.values.emplace_back(word_of(facts.moves.front().shape[i]));
  return shapes;
}

std::string first_profile_text(const RunFacts& facts) {
  if (facts.moves.empty()) return "no move";
  if (on_path(facts.moves.front())) return "a path of the tool, which has no profile for each joint";
  return value_text(first_profile(facts));
}

std::optional<FactValue> wanted_profile(const ExpectSpec& expect, std::size_t) {
  if (!expect.profile) return std::nullopt;
  return OfAxes<std::string>{*expect.profile};
}

FactValue stopped_by(const RunFacts& facts) {
  return facts.stopped_by.empty() ? FactValue{} : facts.stopped_by;
}

std::string stopped_by_text(const RunFacts& facts) {
  return facts.stopped_by.empty() ? "no stop" : facts.stopped_by;
}

std::string stop_ticks_text(const RunFacts& facts) {
  const std::optional<std::int64_t> ticks = facts.stop_ticks();
  return ticks ? std::to_string(*ticks) : "no stop";
}

FactValue missed_stop(const RunFacts& facts) {
  const std::optional<DemandedStop> stop = facts.missed_stop();
  if (!stop) return {};
  return fmt::format("the stop by {}: {}", stop->by,
                     stop->executed ? fmt::format("the servos were on for {:.3f} ms",
                                                  to_seconds(*stop->executed - stop->where.at) * 1e3)
                                    : std::string{"the servos stay on"});
}

FactValue fault_causes(const RunFacts& facts) {
  std::vector<std::string> names;
  for (const FaultEvent& fault : facts.faults) names.emplace_back(word_of(fault.cause));
  return names;
}

FactValue program_end(const RunFacts& facts) {
  const std::string_view end = facts.program_end();
  return end.empty() ? FactValue{} : std::string{end};
}

FactValue program_end_line(const RunFacts& facts) {
  const std::optional<std::uint32_t> place = facts.program_place();
  return place ? std::int64_t{facts.names.line(*place).line} : FactValue{};
}

std::string program_end_text(const RunFacts& facts) {
  std::string text{facts.program_end()};
  const ProgramEvent* last = facts.program_last();
  if (last == nullptr || last->note.kind != ProgramNoted::Kind::kAlarm) return text;
  return text.append(": ").append(printable(last->note.view()));
}

std::string settle_text(const RunFacts& facts) {
  if (facts.settle_s) return "after " + number_text(*facts.settle_s) + " s";
  if (!facts.moved) return "no motion";
  return fmt::format("never within {} counts, at the end {}", facts.settled_counts,
                     show_list(std::span{facts.final_error_counts}.first(facts.axis_count)));
}

FactWhere last_outside(const RunFacts& facts) {
  if (!facts.moved) return {};
  FactWhere where = at_place(facts.last_outside_at);
  if (facts.last_outside_at) where.text = "last outside: " + where.text;
  return where;
}

std::optional<FactValue> wanted_orientation(const ExpectSpec& expect, std::size_t) {
  if (!expect.final_rpy_deg) return std::nullopt;
  return Orientation{.rotation = to_transform({.xyz_mm = {}, .rpy_deg = *expect.final_rpy_deg}).rotation,
                     .rpy_deg = *expect.final_rpy_deg};
}

std::string no_path(const RunFacts& facts) {
  return std::ranges::any_of(facts.moves, on_path) ? "" : "no move on a line or an arc";
}

FactValue serial_sent(const RunFacts& facts) {
  return SerialText{.bytes = facts.serial_sent, .errors = facts.serial_errors};
}

std::optional<FactValue> wanted_outputs(const ExpectSpec& expect, std::size_t) {
  if (!expect.outputs) return std::nullopt;
  std::vector<OutputChange> changes;
  for (const OutputChangeSpec& change : *expect.outputs) {
    changes.push_back({.pin = static_cast<int>(change.pin), .level = change.level, .at = to_cycles(change.at_s)});
    if (!change.tcp_mm) continue;
    const auto& [x, y, z] = *change.tcp_mm;
    changes.back().tool_mm = Eigen::Vector3d{x, y, z};
    changes.back().tolerance_mm = change.tcp_tolerance_mm;
  }
  return changes;
}

}  // namespace armature::cosim
