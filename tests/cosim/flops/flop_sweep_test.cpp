#include "cosim/flops/flop_sweep.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "cosim/campaign/judge.hpp"
#include "cosim/campaign/judge_limits.hpp"
#include "cosim/flops/flop_table.hpp"
#include "cosim/time/clock.hpp"
#include "tests/cosim/support/scenario_files.hpp"
#include "tests/cosim/support/whole_run.hpp"

namespace armature::cosim {
namespace {

constexpr Cycles kEarly{1'000'123}, kLate{2'000'777};
constexpr std::int64_t kEvery = 997;  // bits

bool never() {
  return false;
}

Scenario short_move() {
  Scenario scenario = test::scenario_with(R"(
drop_out_us = 500
[[move]]
at_s = 0.002
type = "joint"
target_deg = [1, 1, 1, 1, 1, 1]
)");
  scenario.duration_s = 0.1;
  scenario.engine = Engine::kRtl;
  return scenario;
}

std::vector<FlopFlipAt> some_flips(const Scenario& scenario) {
  std::vector<FlopFlipAt> flips;
  for (const Cycles at : {kEarly, kLate}) {
    std::int64_t bits = 0;
    for (const Flop& flop : flops_of(scenario)) {
      for (int bit = 0; bit < flop.bits; ++bit) {
        if (bits++ % kEvery == 0) flips.push_back({flop.name, bit, at});
      }
    }
    flips.push_back({"servo_on_o", 2, at});
    flips.push_back({"g_rtl.u_encoder.u_core.u_position.position", 40, at});
  }
  return flips;
}

std::vector<FlopResult> swept(const Scenario& scenario, const UnflippedRun& unflipped, int jobs) {
  return sweep_flops(scenario, unflipped, {.flips = some_flips(scenario), .jobs = jobs, .stop = never});
}

// The whole run, from its begin to its end, with the fault in the scenario.
Verdict whole_run(Scenario scenario, const UnflippedRun& unflipped, const FlopFlipAt& flip) {
  scenario.faults = {{.at_s = to_seconds(flip.at), .kind = FlopFlip{.flop = flip.flop, .bit = flip.bit}}};
  const JudgeLimits limits = judge_limits(scenario.robot);
  CampaignJudge judge{limits, unflipped.path, flip.at};
  Run run{scenario};
  run.add(judge);
  test::run_out(run);
  return judge.verdict(run.finish().failure);
}

TEST(FlopSweep, JudgesEachFlipAsAWholeRunDoes) {
  const Scenario scenario = short_move();
  const UnflippedRun unflipped = run_unflipped(scenario, never).value();
  ASSERT_EQ(unflipped.verdict.outcome, Outcome::kFinished) << unflipped.verdict.reason;
  std::map<Outcome, int> seen;
  for (const FlopResult& result : swept(scenario, unflipped, 1)) {
    const Verdict whole = whole_run(scenario, unflipped, result.flip);
    EXPECT_EQ(result.verdict.outcome, whole.outcome)
        << result.flip.flop << ", bit " << result.flip.bit << " at cycle " << result.flip.at.value();
    EXPECT_EQ(result.verdict.reason, whole.reason) << result.flip.flop;
    EXPECT_EQ(result.verdict.latency_ticks, whole.latency_ticks) << result.flip.flop;
    ++seen[result.verdict.outcome];
  }
  EXPECT_GT(seen[Outcome::kMasked], 10);
  EXPECT_GT(seen[Outcome::kStopped], 1);
}

TEST(FlopSweep, ResultsDoNotDependOnTheNumberOfJobs) {
  const Scenario scenario = short_move();
  const UnflippedRun unflipped = run_unflipped(scenario, never).value();
  const auto texts = [](const std::vector<FlopResult>& results) {
    std::vector<std::string> lines;
    for (const FlopResult& result : results) lines.push_back(silent_flip_text(result, "s"));
    return lines;
  };
  EXPECT_EQ(texts(swept(scenario, unflipped, 3)), texts(swept(scenario, unflipped, 1)));
}

TEST(FlopTable, CountsByBlock) {
  EXPECT_EQ(block_of("g_rtl.u_encoder.u_core.u_position.position_q"), "u_encoder");
  EXPECT_EQ(block_of("u_xbar.write_wait_q"), "u_xbar");
  EXPECT_EQ(block_of("servo_on_o"), "pins");
  FlopTable table;
  table.add({{"u_xbar.a_q", 0, kEarly}, {.outcome = Outcome::kMasked}});
  table.add({{"u_xbar.a_q", 1, kEarly}, {.outcome = Outcome::kStopped, .reason = "r", .latency_ticks = 7}});
  table.add({{"servo_on_o", 1, kEarly}, {.outcome = Outcome::kHang, .reason = "stands"}});
  EXPECT_EQ(flop_table_text(table),
            "                                                                   ticks to the first response\n"
            "block               flips   masked  finished  stopped  silent   least  median    99 %    most\n"
            "pins                    1        0         0        0       1\n"
            "u_xbar                  2        1         0        1       0       7       7       7       7\n"
            "all                     3        1         0        1       1       7       7       7       7\n");
  EXPECT_EQ(
      silent_flip_text(table.silent.at(0), "a b"),
      "SILENT  bit 1 of servo_on_o at 0.02000246 s: hang: stands\n      to repeat it: armature run 'a b' --engine rtl "
      "--set 'fault=[{at_s=0.02000246,kind=\"flop_flip\",flop=\"servo_on_o\",bit=1}]'\n");
  EXPECT_EQ(to_json(table)["blocks"]["u_xbar"]["outcomes"]["masked"], 1);
  EXPECT_EQ(to_json(table)["silent"][0]["flop"], "servo_on_o");
}

}  // namespace
}  // namespace armature::cosim
