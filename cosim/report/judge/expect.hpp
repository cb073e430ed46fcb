// Judges a run by the [expect] table of its scenario.
#pragma once

#include <vector>

#include "cosim/report/judge/expect_failure.hpp"
#include "cosim/report/judge/expect_result.hpp"
#include "cosim/report/measure/run_facts.hpp"
#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

// Returns one failure for each key that is not met, in the order of fact_list(). Then follow events that the scenario
// does not mention: faults, refused moves, unfinished moves, underruns, drops of the servo enables. `outcome`,
// `stopped_by` and `faults` mention a fault and the drop of the servo enables that it causes. They do not mention the
// underruns and refused moves of such a run, not even the underruns that trip the watchdog.
[[nodiscard]] std::vector<ExpectFailure> check(const ExpectSpec& expect, const RunFacts& facts);

// The comparison of every key of the scenario with the run, in the order of fact_list().
[[nodiscard]] std::vector<ExpectResult> expect_results(const ExpectSpec& expect, const RunFacts& facts);

}  // namespace armature::cosim
