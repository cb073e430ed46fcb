// A run that can be taken back: it is stopped at a cycle, a tick or a condition, looked at, advanced, and taken back to
// an earlier cycle. Every state depends on the scenario and the cycle only, not on the way there.
//
//   ReversibleRun run{scenario, {&condition}};
//   RunState state = run.go_to(Cycles{1'000'000});
//   state = run.go_to(state.now() - Cycles{1});
//
// The run lives in a process of its own, with return points (cosim/snapshot). To go back, it returns to the latest
// point before and advances from there. Points are taken by host time, more densely where the run goes back.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "controller/base/units.hpp"
#include "cosim/rewind/run_messages.hpp"
#include "cosim/rewind/run_state.hpp"
#include "cosim/rewind/stop_condition.hpp"
#include "cosim/scenario/scenario.hpp"
#include "cosim/snapshot/message_channel.hpp"

namespace armature::cosim {

class ReversibleRun {
 public:
  // At cycle 0. The process of the run has its own scenario and conditions, as they are now. The trace, if it is kept,
  // is in its memory. Throws std::runtime_error, as the others, when the process cannot be made, has ended, or says
  // that the run cannot continue.
  explicit ReversibleRun(const Scenario& scenario, const std::vector<StopCondition*>& conditions = {},
                         KeepTrace keep_trace = KeepTrace::kNo);
  ReversibleRun(const ReversibleRun&) = delete;
  ReversibleRun& operator=(const ReversibleRun&) = delete;
  ~ReversibleRun();

  [[nodiscard]] const RunState& state() const { return state_; }

  // Goes to the cycle, or to the end of the run if that is earlier. The state is that of Simulation::look(). `cycle`:
  // from 0.
  const RunState& go_to(Cycles cycle);
  // Goes to the cycle after the trigger that ends the tick. Returns false when the run has no such tick; it is at its
  // end then. `tick`: from 0.
  bool go_to_tick(std::int64_t tick);
  // Advances to the cycle after the one in which the condition with this index is met, but not past the cycle `limit`.
  // Returns whether it is met.
  bool advance_to(std::size_t condition, Cycles limit);

  // Advances to the end of the run and ends it. The texts are those of summary.json and trace.csv of a run that went
  // there directly and was not compared with its golden; only the figures under "host" differ. The run can be taken
  // back afterwards, and be finished again. `trace` is empty if it was not kept.
  struct Results {
    std::string summary, trace;
  };
  [[nodiscard]] Results finish();

 private:
  RunAnswer ask(const RunRequest& request);
  bool go_behind(const RunAnswer& answer);
  [[nodiscard]] std::string receive_text();

  MessageChannel channel_;
  pid_t process_ = 0;
  RunState state_;
};

}  // namespace armature::cosim
