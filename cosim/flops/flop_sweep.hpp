// Flips each flop of the logic, one in a run, and judges what the arm does.
//
// All runs are those of one scenario on the RTL. For an instant the scenario runs up to it once; then a copy of the
// process makes each flip (cosim/snapshot). A copy ends early where its end is known, at a trigger at which the logic
// has the same state, and cores and arm have seen the same, as in another run. From there on both go on equally. The
// other run is the one without a flip, or that of the same bit at the next instant: the last instant comes first.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "controller/base/units.hpp"
#include "cosim/campaign/judge/outcome.hpp"
#include "cosim/campaign/judge/true_path.hpp"
#include "cosim/fabric/flops/flop.hpp"
#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

struct FlopBit {
  std::string flop{};
  int bit = 0;
};

struct FlopResult {
  FlopBit flip{};
  Cycles at{};
  Verdict verdict{};
};

// The run without a flip.
struct UnflippedRun {
  TruePath path;
  std::vector<std::uint64_t> states;  // at the trigger of each tick: logic, and all that its surroundings have seen
  Verdict verdict;
};

// The flops of the logic of a scenario, in the order of their names.
[[nodiscard]] std::vector<Flop> flops_of(const Scenario& scenario);

// Runs the scenario without a flip. `stop` is asked often; none: it has stopped the run.
[[nodiscard]] std::optional<UnflippedRun> run_unflipped(const Scenario& scenario, const std::function<bool()>& stop);

struct FlopSweep {
  std::vector<FlopBit> bits;
  std::vector<Cycles> instants;                 // ascending; at each of them each bit is flipped
  int jobs = 1;                                 // processes at the same time
  std::function<bool()> stop;                   // is asked often
  std::function<void(std::size_t)> progress{};  // how many flips are done; empty: nobody asks
};

// The results in the order of the instants, and of the bits at each, whatever the number of jobs. If `stop` has ended
// it there are fewer: those of the first bits of an instant, and of all later ones. This process must not have other
// threads. Throws std::runtime_error if the process cannot be copied.
[[nodiscard]] std::vector<FlopResult> sweep_flops(const Scenario& scenario, const UnflippedRun& unflipped,
                                                  const FlopSweep& sweep);

}  // namespace armature::cosim
