// Flips each flop of the logic, one in a run, and judges what the arm does.
//
// All runs are those of one scenario on the RTL. For an instant the scenario runs up to it once; then a copy of the
// process makes each flip (cosim/snapshot). A copy ends as soon as the logic has the state of the run without a flip,
// and cores and arm have seen no difference: from there on both go on equally. If the scenario has a serial line, each
// copy runs to its end.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "controller/base/units.hpp"
#include "cosim/campaign/outcome.hpp"
#include "cosim/campaign/true_path.hpp"
#include "cosim/fabric/flops/flop.hpp"
#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

struct FlopFlipAt {
  std::string flop{};
  int bit = 0;
  Cycles at{};
};

struct FlopResult {
  FlopFlipAt flip{};
  Verdict verdict{};
};

// The run without a flip.
struct UnflippedRun {
  TruePath path;
  std::vector<std::uint64_t> states;  // at the trigger of each tick: logic, and all rows so far
  Verdict verdict;
};

// The flops of the logic of a scenario, in the order of their names.
[[nodiscard]] std::vector<Flop> flops_of(const Scenario& scenario);

// Runs the scenario without a flip. `stop` is asked often; none: it has stopped the run.
[[nodiscard]] std::optional<UnflippedRun> run_unflipped(const Scenario& scenario, const std::function<bool()>& stop);

struct FlopSweep {
  std::vector<FlopFlipAt> flips;                // in the order of their times
  int jobs = 1;                                 // processes at the same time
  std::function<bool()> stop;                   // is asked often
  std::function<void(std::size_t)> progress{};  // how many flips are done; empty: nobody asks
};

// The results in the order of the flips, whatever the number of jobs; fewer if `stop` has ended it. This process must
// not have other threads. Throws std::runtime_error if the process cannot be copied.
[[nodiscard]] std::vector<FlopResult> sweep_flops(const Scenario& scenario, const UnflippedRun& unflipped,
                                                  const FlopSweep& sweep);

}  // namespace armature::cosim
