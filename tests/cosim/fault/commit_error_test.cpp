// A set of counts becomes active otherwise than core 0 has committed it. The arm must end where it should.
//
// A program error writes COMMIT at any place of a tick. The counts that core 0 has written so far are then emitted
// under a sequence number that it does not know, once more or in place of its own. A campaign found that the feedback
// took the pulses of that tick for pulses that were emitted.
//
// A flipped flop of the logic loses the committed set, gives it another sequence number, or commits it again in every
// clock. A sweep of all flops found that the arm then stood some counts before its end, or went on at its speed, and
// that the controller did not notice.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "controller/regs/pulse_train_regs.hpp"
#include "controller/regs/soc_map.hpp"
#include "cosim/run/run.hpp"
#include "tests/cosim/support/whole_run.hpp"

namespace armature::cosim {
namespace {

constexpr std::int64_t kMoving = 4'000'000;  // a cycle in the move, in which a tick begins
constexpr std::int64_t kTickLength = 2'500;  // [cycles]

struct End {
  PerAxis<Counts> counts;
  std::uint32_t underruns;
};

End run_to_end(const Scenario& scenario) {
  Run run{scenario};
  test::run_out(run);
  const End end{run.look().motor_counts, run.look().telemetry.underruns};
  const RunSummary summary = run.finish();
  EXPECT_EQ(summary.failure, std::nullopt);
  EXPECT_EQ(summary.outcome(), "completed");
  return end;
}

PerAxis<Counts> counts_at_end(const Scenario& scenario) {
  return run_to_end(scenario).counts;
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

// A bit of pulse_train flips.
End end_with_flip(const std::string& flop, int bit, std::int64_t cycle) {
  Scenario scenario = scenario_with_move(Engine::kRtl);
  scenario.faults = {{.at_s = static_cast<double>(cycle) * 20e-9,
                      .kind = FlopFlip{.flop = "g_rtl.u_pulse_train." + flop, .bit = bit}}};
  return run_to_end(scenario);
}

TEST(StrayCommit, AtAnyPlaceOfATickIsMadeGood) {
  constexpr std::int64_t kStep = 47;
  const PerAxis<Counts> wanted = counts_at_end(scenario_with_move(Engine::kModel));
  for (std::int64_t cycle = kMoving; cycle < kMoving + kTickLength; cycle += kStep) {
    EXPECT_EQ(counts_at_end(with_stray_commit(cycle, Engine::kModel)), wanted) << "cycle " << cycle;
  }
}

TEST(StrayCommit, IsTheSameOnBothEngines) {
  for (const std::int64_t cycle : {kMoving + 300, kMoving + 900}) {
    EXPECT_EQ(counts_at_end(with_stray_commit(cycle, Engine::kLockstep)),
              counts_at_end(with_stray_commit(cycle, Engine::kModel)));
  }
}

TEST(LostCommit, IsSentAgain) {
  const PerAxis<Counts> wanted = counts_at_end(scenario_with_move(Engine::kModel));
  std::uint32_t lost = 0;
  for (std::int64_t cycle = kMoving; cycle < kMoving + kTickLength; cycle += 500) {
    const End end = end_with_flip("u_core.pending", 0, cycle);
    EXPECT_EQ(end.counts, wanted) << "cycle " << cycle;
    lost += end.underruns;
  }
  EXPECT_GE(lost, 3u);  // wherever the set waited
}

// In two ticks, since one of two numbers in a row becomes that of the set before.
TEST(CommitUnderAnotherNumber, IsNotSentAgain) {
  const PerAxis<Counts> wanted = counts_at_end(scenario_with_move(Engine::kModel));
  for (const std::int64_t waits : {kMoving + 2'000, kMoving + 2'000 + kTickLength}) {
    for (const int bit : {0, 15}) {
      EXPECT_EQ(end_with_flip("u_core.u_bank.sequence_q", bit, waits).counts, wanted) << "bit " << bit;
    }
  }
}

TEST(CommitInEveryClock, IsReplacedByTheNext) {
  const PerAxis<Counts> wanted = counts_at_end(scenario_with_move(Engine::kModel));
  for (std::int64_t cycle = kMoving; cycle < kMoving + kTickLength; cycle += 900) {
    EXPECT_EQ(end_with_flip("u_bus.reg_we_q", 0, cycle).counts, wanted) << "cycle " << cycle;
  }
}

}  // namespace
}  // namespace armature::cosim
