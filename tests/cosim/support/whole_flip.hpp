// What a sweep of flips must give: the verdict of a whole run.
#pragma once

#include "cosim/campaign/judge/judge.hpp"
#include "cosim/campaign/judge/judge_limits.hpp"
#include "cosim/flips/flip_sweep.hpp"
#include "cosim/time/clock.hpp"
#include "tests/cosim/support/whole_run.hpp"

namespace armature::cosim::test {

// From its begin to its end, with the fault in the scenario.
inline Verdict whole_run(Scenario scenario, const UnflippedRun& unflipped, const FlipResult& flipped) {
  scenario.faults = {{.at_s = to_seconds(flipped.at), .kind = fault_of(flipped.flip)}};
  const JudgeLimits limits = judge_limits(scenario.robot);
  CampaignJudge judge{limits, unflipped.path, flipped.at};
  Run run{scenario};
  run.add(judge);
  run_out(run);
  return judge.verdict(run.finish().failure);
}

}  // namespace armature::cosim::test
