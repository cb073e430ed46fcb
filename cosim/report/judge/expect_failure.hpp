// An expectation that a run does not meet.
#pragma once

#include <string>

#include "cosim/report/facts/fact_where.hpp"
#include "cosim/text/input_error.hpp"

namespace armature::cosim {

struct ExpectFailure {
  std::string key;  // in [expect]
  std::string expected;
  std::string got;
  FactWhere where{};
  std::string file{};  // of the scenario; empty: none
  Origin origin{};     // of the key; unset if the key is not written

  // `scenario.toml:17:1`, or `--set expect.underruns=7`; empty for no file.
  [[nodiscard]] std::string place() const;
  // `scenario.toml:17:1: expect.underruns: expected 0, got 5 (the first: tick 180, 0.009112 s)`
  [[nodiscard]] std::string text() const;
};

}  // namespace armature::cosim
