#include "cosim/report/facts/fact_where.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "cosim/scenario/fault_text.hpp"
#include "cosim/text/names.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

std::string seconds(Cycles at) {
  return fmt::format("{:.6f} s", to_seconds(at));
}

void add(std::string& text, const std::string& more) {
  text += (text.empty() ? "" : "; ") + more;
}

void add_first(std::string& text, const std::vector<std::string>& all) {
  constexpr std::size_t kMax = 5;
  for (const std::string& one : std::span{all}.first(std::min(kMax, all.size()))) add(text, one);
  if (all.size() > kMax) add(text, fmt::format("and {} more", all.size() - kMax));
}

}  // namespace

FactWhere at_place(const std::optional<RunPlace>& place) {
  if (!place) return {};
  FactWhere where;
  where.at = place;
  where.text = fmt::format("tick {}, {}", place->tick, seconds(place->at));
  if (place->axis == 0) return where;
  where.axes.push_back(place->axis);
  where.text = fmt::format("axis {}, ", place->axis) + where.text;
  return where;
}

FactWhere first_at(const std::optional<RunPlace>& place) {
  FactWhere where = at_place(place);
  if (place) where.text = "the first: " + where.text;
  return where;
}

FactWhere at_faults(const RunFacts& facts) {
  FactWhere where;
  for (const FaultEvent& fault : facts.faults) {
    const std::uint8_t axis = fault.where.axis;
    add(where.text, fmt::format("{}{}, {}", word_of(fault.cause),
                                axis == 0 ? std::string{} : fmt::format(" of axis {}", axis), seconds(fault.where.at)));
    if (axis != 0) where.axes.push_back(axis);
    if (!where.at) where.at = fault.where;
  }
  return where;
}

FactWhere at_missed_stop(const RunFacts& facts) {
  const std::optional<DemandedStop> stop = facts.missed_stop();
  return stop ? at_place(stop->where) : FactWhere{};
}

FactWhere at_unanswered_faults(const RunFacts& facts) {
  FactWhere where;
  for (const InjectedFault& fault : facts.injected_faults) {
    if (fault.answered) continue;
    if (!where.at) where.at = fault.when;
    add(where.text, fmt::format("{}, {}", fault_text(fault.spec), seconds(fault.when.at)));
  }
  return where;
}

FactWhere at_longest_stop(const RunFacts& facts) {
  FactWhere where;
  for (const InjectedFault& fault : facts.injected_faults) {
    if (where.at || !fault.stop_ticks() || fault.stop_ticks() != facts.stop_ticks()) continue;
    where.at = fault.when;
    where.text = fmt::format("{}, {}", fault_text(fault.spec), seconds(fault.when.at));
  }
  return where;
}

FactWhere at_unasked_stops(const RunFacts& facts) {
  FactWhere where;
  std::vector<std::string> stops;
  for (const MoveStarted& move : facts.moves) {
    if (!move.unasked_stop) continue;
    const std::int64_t tick = move.start_tick.value();
    std::string stop = fmt::format("before {}, tick {}", facts.names.of(move.tag), tick);
    if (const std::optional<RunPlace>& first = facts.first_trigger_at) {
      const RunPlace place{.tick = tick, .at = first->at + Cycles{(tick - first->tick) * kTickCycles}};
      if (!where.at) where.at = place;
      stop += ", " + seconds(place.at);
    }
    stops.push_back(stop);
  }
  add_first(where.text, stops);
  return where;
}

FactWhere last_trigger(const RunFacts& facts) {
  FactWhere where = at_place(facts.last_trigger_at);
  where.text = facts.last_trigger_at ? "the last trigger: " + where.text : "there was no trigger";
  return where;
}

FactWhere at_bus_aborts(const RunFacts& facts) {
  FactWhere where;
  for (const BusAbortEvent& abort : facts.bus_aborts) {
    if (!where.at) where.at = abort.where;
    add(where.text, fmt::format("core {}, {} at 0x{:08X}, {}", abort.core, abort.write ? "write" : "read",
                                abort.address, seconds(abort.where.at)));
  }
  return where;
}

FactWhere at_program(const RunFacts& facts) {
  FactWhere where;
  if (const ProgramEvent* last = facts.program_last()) {
    where.text = facts.names.line_text(*facts.program_place());
    if (facts.program_end() != "running") add(where.text, seconds(last->at));
  }
  return where;
}

FactWhere at_refusals(const RunFacts& facts) {
  FactWhere where;
  std::vector<std::string> refusals;
  for (const RefusedMove& refused : facts.refusals) {
    refusals.push_back(fmt::format("{}, {}", facts.names.of(refused.refusal.tag), seconds(refused.at)));
  }
  add_first(where.text, refusals);
  return where;
}

}  // namespace armature::cosim
