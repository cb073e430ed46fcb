// Flips bits of the logic or of the memory of the cores, one in a run, and judges what the arm does.
//
// All runs are those of one scenario. For an instant the scenario runs up to it once; then a copy of the process makes
// each flip (cosim/snapshot). A copy ends early where its end is known, at a trigger at which the logic has the same
// state, and cores and arm have seen the same, as in another run. From there on both go on equally. The other run is
// the one without a flip, or that of the same bit at the next instant: the last instant comes first.
//
// Cores with a memory of their own may differ in it although they have seen the same. So their state is compared, too,
// at some of the triggers.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "controller/base/units.hpp"
#include "cosim/campaign/judge/outcome.hpp"
#include "cosim/campaign/judge/true_path.hpp"
#include "cosim/cpu/core_memory.hpp"
#include "cosim/fabric/flops/flop.hpp"
#include "cosim/flips/flip.hpp"
#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

struct FlipResult {
  Flip flip{};
  Cycles at{};
  Verdict verdict{};
};

// The run without a flip.
struct UnflippedRun {
  TruePath path;
  std::vector<std::optional<std::uint64_t>> states;  // at the trigger of each tick; none: not compared there
  Verdict verdict;
};

// What can flip in a scenario: flops in the order of their names, none of an engine without flops.
[[nodiscard]] std::vector<Flop> flops_of(const Scenario& scenario);
[[nodiscard]] CoreMemory memory_of(const Scenario& scenario);

// Runs the scenario without a flip. `stop` is asked often; none: it has stopped the run.
[[nodiscard]] std::optional<UnflippedRun> run_unflipped(const Scenario& scenario, const std::function<bool()>& stop);

struct FlipSweep {
  std::vector<Flip> flips;
  std::vector<Cycles> instants;                 // ascending; at each of them each flip is made
  int jobs = 1;                                 // processes at the same time
  std::function<bool()> stop;                   // is asked often
  std::function<void(std::size_t)> progress{};  // how many flips are done; empty: nobody asks
};

// The results in the order of the instants, and of the flips at each, whatever the number of jobs. If `stop` has ended
// it there are fewer: those of the first flips of an instant, and of all later ones. This process must not have other
// threads. Throws std::runtime_error if the process cannot be copied.
[[nodiscard]] std::vector<FlipResult> sweep_flips(const Scenario& scenario, const UnflippedRun& unflipped,
                                                  const FlipSweep& sweep);

}  // namespace armature::cosim
