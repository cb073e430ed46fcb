// Runs of whole scenarios.
#pragma once

#include <initializer_list>
#include <string>

#include "cosim/run/run.hpp"
#include "tests/cosim/support/scenario_files.hpp"

namespace armature::cosim::test {

// Advances to the end.
inline void run_out(Run& run) {
  while (run.advance(run.now() + Cycles{1'000'000})) {
  }
}

inline RunSummary summary_of(const Scenario& scenario, std::initializer_list<RunListener*> listeners = {}) {
  Run run{scenario};
  for (RunListener* listener : listeners) run.add(*listener);
  run_out(run);
  return run.finish();
}

// All joints move from 2 ms on.
inline Scenario moving_scenario(double duration_s, Engine engine,
                                const std::string& target_deg = "40, 40, 40, 40, 40, 40") {
  Scenario scenario = scenario_with("[[move]]\nat_s = 0.002\ntype = \"joint\"\ntarget_deg = [" + target_deg + "]\n");
  scenario.duration_s = duration_s;
  scenario.engine = engine;
  return scenario;
}

}  // namespace armature::cosim::test
