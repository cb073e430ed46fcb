// Where in a run a fact comes from: axis, tick and time, in words and as data.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cosim/report/measure/run_facts.hpp"

namespace armature::cosim {

struct FactWhere {
  std::string text{};                // in words; empty: no particular place
  std::vector<std::uint8_t> axes{};  // 1..6: the axes that differ; for one value of all axes, its axis
  std::optional<RunPlace> at{};      // of the value, or of the one with the largest difference
};

// `axis 2, tick 180, 0.009112 s`; without the axis where it is 0. No place: empty.
[[nodiscard]] FactWhere at_place(const std::optional<RunPlace>& place);
// The same after `the first: `, for something that happened several times.
[[nodiscard]] FactWhere first_at(const std::optional<RunPlace>& place);
// `watchdog, 0.3 s; estop, 0.5 s`: all faults of the run.
[[nodiscard]] FactWhere at_faults(const RunFacts& facts);
[[nodiscard]] FactWhere at_missed_stop(const RunFacts& facts);
// `block_hang motion, 0.1 s; estop for 0.02 s, 0.12 s`: all injected faults to which nothing responded.
[[nodiscard]] FactWhere at_unanswered_faults(const RunFacts& facts);
[[nodiscard]] FactWhere at_longest_stop(const RunFacts& facts);
// `before line 12 of part.ngc, tick 9000, 0.450020 s; before move[3], tick 9900, 0.495020 s`: the first of all unasked
// stops of the run.
[[nodiscard]] FactWhere at_unasked_stops(const RunFacts& facts);
// `the last trigger: tick 1998, 0.1 s`.
[[nodiscard]] FactWhere last_trigger(const RunFacts& facts);
// `core 0, read at 0x43C20010, 0.05 s`: all accesses that stopped a core.
[[nodiscard]] FactWhere at_bus_aborts(const RunFacts& facts);
// `line 12 of part.ngc; 0.3 s`: where the program ended, and when; or where the arm was in it when the run ended.
[[nodiscard]] FactWhere at_program(const RunFacts& facts);
// `move[3], 0.3 s; move[4], 0.3 s; and 7 more`: the first moves that were refused or dropped.
[[nodiscard]] FactWhere at_refusals(const RunFacts& facts);

}  // namespace armature::cosim
