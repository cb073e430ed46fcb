// Judges a run by the [expect] table of its scenario.
#pragma once

#include <string>
#include <vector>

#include "cosim/report/run_facts.hpp"
#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

struct ExpectFailure {
  std::string key;  // in [expect]
  std::string expected;
  std::string got;

  // `expect.underruns: expected 0, got 5`
  [[nodiscard]] std::string text() const;
};

// One failure for each key that is not met, in the order of the table. What a scenario does not mention must not
// happen: without a key for it a fault, a refused move, an underrun or a dropped servo enable is a failure too. A fault
// that `outcome`, `stopped_by` or `faults` names is mentioned, and so is the drop of the servo enables that it brings;
// the underruns and refused moves of such a run are not, not even those that make a watchdog trip.
[[nodiscard]] std::vector<ExpectFailure> check(const ExpectSpec& expect, const RunFacts& facts);

}  // namespace armature::cosim
