// Counts and hashes what a run tells its listeners.
#pragma once

#include <cstdint>
#include <string>

#include "cosim/rewind/run_state.hpp"
#include "cosim/run/run_listener.hpp"
#include "cosim/text/sha256.hpp"

namespace armature::cosim {

class RunDigest final : public RunListener {
 public:
  void on_row(const TraceRow& row, const IntegerDigest& digest) override;
  void on_event(const Event& event, const RunPlace& place) override;
  void on_action(const ScriptAction& action, const RunPlace& place) override;
  void on_signal(const Signal& signal, const RunPlace& place) override;

  // Of the run that looks like this now.
  [[nodiscard]] RunState state(const SimulationState& seen) const;

 private:
  void begin(char kind, const RunPlace& place);
  void end();

  Sha256 heard_;
  std::int64_t count_ = 0;
  std::string bytes_;  // of the present call
};

}  // namespace armature::cosim
