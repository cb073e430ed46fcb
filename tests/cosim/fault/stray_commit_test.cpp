// A program error writes COMMIT at any place of a tick. The counts that core 0 has written so far are then emitted
// under a sequence number that it does not know, once more or in place of its own. The arm must end where it should. A
// campaign found that the feedback took the pulses of that tick for pulses that were emitted.
#include <gtest/gtest.h>

#include <cstdint>

#include "controller/regs/pulse_train_regs.hpp"
#include "controller/regs/soc_map.hpp"
#include "cosim/run/run.hpp"
#include "tests/cosim/support/whole_run.hpp"

namespace armature::cosim {
namespace {

constexpr std::int64_t kMoving = 1'000'000;  // a cycle in the move

PerAxis<Counts> counts_at_end(const Scenario& scenario) {
  Run run{scenario};
  test::run_out(run);
  const PerAxis<Counts> counts = run.look().motor_counts;
  const RunSummary summary = run.finish();
  EXPECT_EQ(summary.failure, std::nullopt);
  EXPECT_EQ(summary.outcome(), "completed");
  return counts;
}

Scenario scenario_with_move(Engine engine) {
  return test::moving_scenario(0.2, engine, "1, 2, 1, 2, 1, 2");
}

Scenario with_stray_commit(std::int64_t cycle, Engine engine) {
  constexpr std::int64_t kSequence = 0xF928;
  Scenario scenario = scenario_with_move(engine);
  scenario.faults = {{.at_s = static_cast<double>(cycle) * 20e-9,
                      .kind = StrayWrite{.address = regs::soc::kPulseTrainBase + regs::pulse_train::kCommitOffset,
                                         .data = kSequence}}};
  return scenario;
}

TEST(StrayCommit, AtAnyPlaceOfATickIsMadeGood) {
  constexpr std::int64_t kStep = 47;
  const PerAxis<Counts> wanted = counts_at_end(scenario_with_move(Engine::kModel));
  for (std::int64_t cycle = kMoving; cycle < kMoving + 2'500; cycle += kStep) {
    EXPECT_EQ(counts_at_end(with_stray_commit(cycle, Engine::kModel)), wanted) << "cycle " << cycle;
  }
}

TEST(StrayCommit, IsTheSameOnBothEngines) {
  for (const std::int64_t cycle : {kMoving + 300, kMoving + 900}) {
    EXPECT_EQ(counts_at_end(with_stray_commit(cycle, Engine::kLockstep)),
              counts_at_end(with_stray_commit(cycle, Engine::kModel)));
  }
}

}  // namespace
}  // namespace armature::cosim
