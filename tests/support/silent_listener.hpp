// A listener of a simulation that ignores everything. A derived class overrides what it needs. And a whole run in one
// go.
#pragma once

#include <limits>

#include "cosim/kernel/simulation.hpp"

namespace armature::cosim::test {

class SilentListener : public SimulationListener {
 public:
  void on_row(TraceRow&) override {}
  void on_event(const Event&, Cycles) override {}
  void on_action(const ScriptAction&, Cycles) override {}
  void on_signal(const Signal&, Cycles) override {}
};

inline SimulationEnd run_to_end(Simulation&& simulation) {
  simulation.advance(Cycles{std::numeric_limits<std::int64_t>::max()});
  return simulation.finish();
}

}  // namespace armature::cosim::test
