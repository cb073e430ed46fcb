// Judges a run by the [expect] table of its scenario.
#pragma once

#include <vector>

#include "cosim/report/judge/expect_failure.hpp"
#include "cosim/report/measure/run_facts.hpp"
#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

// One failure for each key that is not met, in the order of fact_list(); then what happened though the scenario does
// not mention it: a fault, a refused move, an unfinished move, an underrun, a drop of the servo enables. `outcome`,
// `stopped_by` and `faults` mention a fault and the drop of the servo enables that it causes. They mention no underruns
// and no refused moves of such a run, not even the underruns that make a watchdog trip.
[[nodiscard]] std::vector<ExpectFailure> check(const ExpectSpec& expect, const RunFacts& facts);

}  // namespace armature::cosim
