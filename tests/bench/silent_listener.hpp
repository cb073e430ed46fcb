// A listener of a simulation that ignores everything.
#pragma once

#include "cosim/kernel/simulation.hpp"

namespace armature::bench {

class SilentListener : public cosim::SimulationListener {
 public:
  void on_row(const cosim::TraceRow&) override {}
  void on_command(const cosim::MoveSpec&, Cycles) override {}
  void on_event(const Event&, Cycles) override {}
  bool stop_requested() override { return false; }
};

}  // namespace armature::bench
