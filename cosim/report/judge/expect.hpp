// Judges a run by the [expect] table of its scenario.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cosim/report/measure/run_facts.hpp"
#include "cosim/scenario/scenario.hpp"
#include "cosim/text/input_error.hpp"

namespace armature::cosim {

// Where in the run a value is from that is not met.
struct ExpectWhere {
  std::string text{};                // in words; empty: nowhere in particular
  std::vector<std::uint8_t> axes{};  // 1..6: those that are off; of values of all axes together, the one of the value
  std::optional<FactPlace> at{};     // of the value, or of the one that is farthest off
};

struct ExpectFailure {
  std::string key;  // in [expect]
  std::string expected;
  std::string got;
  ExpectWhere where{};
  std::string file{};  // of the scenario; empty: of none
  Origin origin{};     // of the key; a key that is not written has none

  // `scenario.toml:17:1`, or `--set expect.underruns=7`; empty for no file.
  [[nodiscard]] std::string place() const;
  // `scenario.toml:17:1: expect.underruns: expected 0, got 5 (the first at tick 180, 0.009112 s)`
  [[nodiscard]] std::string text() const;
};

// One failure for each key that is not met, in the order of the table. What a scenario does not mention must not
// happen: without a key for it a fault, a refused move, an underrun or a dropped servo enable is a failure too. A fault
// that `outcome`, `stopped_by` or `faults` names is mentioned, and so is the drop of the servo enables that it brings;
// the underruns and refused moves of such a run are not, not even those that make a watchdog trip.
[[nodiscard]] std::vector<ExpectFailure> check(const ExpectSpec& expect, const RunFacts& facts);

}  // namespace armature::cosim
