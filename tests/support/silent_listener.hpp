// A listener of a simulation that ignores everything. A derived class overrides what it needs.
#pragma once

#include "cosim/kernel/simulation.hpp"

namespace armature::cosim::test {

class SilentListener : public SimulationListener {
 public:
  void on_row(const TraceRow&) override {}
  void on_command(const CommandSpec&, Cycles) override {}
  void on_event(const Event&, Cycles) override {}
  bool stop_requested() override { return false; }
};

}  // namespace armature::cosim::test
