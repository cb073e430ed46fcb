// Shows the progress of a run on a terminal.
#pragma once

#include <ostream>

#include "cosim/report/format/progress_bar.hpp"
#include "cosim/run/run_listener.hpp"
#include "cosim/scenario/scenario.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {

class ProgressListener final : public RunListener {
 public:
  // Writes to `terminal`, and removes what it has written when it is destroyed.
  ProgressListener(const Scenario& scenario, std::ostream& terminal) : bar_{terminal, scenario.duration_s, true} {}

  void on_row(const TraceRow& row, const IntegerDigest&) override {
    if (row.tick % kEveryTicks == 0) bar_.update(to_seconds(Cycles{row.cycle}));
  }

 private:
  static constexpr std::int64_t kEveryTicks = 200;  // asking for the wall time costs as much as a tenth of a tick

  ProgressBar bar_;
};

}  // namespace armature::cosim
