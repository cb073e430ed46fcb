#include "cosim/flips/flip_sweep.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "cosim/flips/drawn_flips.hpp"
#include "cosim/flips/flip_table.hpp"
#include "cosim/text/input_error.hpp"
#include "tests/cosim/support/scenario_files.hpp"
#include "tests/cosim/support/whole_flip.hpp"
#include "tests/cosim/support/whole_run.hpp"

namespace armature::cosim {
namespace {

constexpr Cycles kEarly{800'555}, kMiddle{1'000'123}, kLate{2'000'777};
constexpr std::int64_t kEvery = 997;  // bits

bool never() {
  return false;
}

Scenario short_move() {
  Scenario scenario = test::moving_scenario(0.1, Engine::kRtl, "1, 1, 1, 1, 1, 1");
  scenario.drop_out_us = 500;
  return scenario;
}

Scenario short_move_by_pendant() {
  Scenario scenario = test::scenario_with(R"(
drop_out_us = 500
[pendant]
[[pendant.step]]
do = "send"
command = "servo"
parameter = 1
[[pendant.step]]
do = "move"
joints_deg = [1, 1, 1, 1, 1, 1]
[[pendant.step]]
do = "wait"
state = "ready"
within_ms = 150
)");
  scenario.duration_s = 0.2;
  scenario.engine = Engine::kRtl;
  return scenario;
}

std::vector<FlipResult> swept(const Scenario& scenario, const UnflippedRun& unflipped, int jobs) {
  std::vector<Flip> flips = flips_of(flops_of(scenario), "", kEvery);
  flips.push_back({.name = "servo_on_o", .bit = 2});
  flips.push_back({.name = "g_rtl.u_encoder.u_core.u_position.position", .bit = 40});
  return sweep_flips(scenario, unflipped,
                     {.flips = std::move(flips), .instants = {kEarly, kMiddle, kLate}, .jobs = jobs, .stop = never});
}

std::map<Outcome, int> compare_with_whole_runs(const Scenario& scenario, const UnflippedRun& unflipped,
                                               const std::vector<FlipResult>& results) {
  std::map<Outcome, int> seen;
  for (const FlipResult& result : results) {
    const Verdict whole = test::whole_run(scenario, unflipped, result);
    EXPECT_EQ(result.verdict.outcome, whole.outcome) << keys_of(result.flip) << " at cycle " << result.at.value();
    EXPECT_EQ(result.verdict.reason, whole.reason) << keys_of(result.flip);
    EXPECT_EQ(result.verdict.latency_ticks, whole.latency_ticks) << keys_of(result.flip);
    ++seen[result.verdict.outcome];
  }
  return seen;
}

TEST(FlipSweep, JudgesEachFlipAsAWholeRunDoes) {
  const Scenario scenario = short_move();
  const UnflippedRun unflipped = run_unflipped(scenario, never).value();
  ASSERT_EQ(unflipped.verdict.outcome, Outcome::kFinished) << unflipped.verdict.reason;
  const auto seen = compare_with_whole_runs(scenario, unflipped, swept(scenario, unflipped, 1));
  EXPECT_GT(seen.at(Outcome::kMasked), 10);
  EXPECT_GT(seen.at(Outcome::kStopped), 1);
}

TEST(FlipSweep, JudgesAFlipBesideASerialLineAsAWholeRunDoes) {
  const Scenario scenario = short_move_by_pendant();
  const UnflippedRun unflipped = run_unflipped(scenario, never).value();
  ASSERT_EQ(unflipped.verdict.outcome, Outcome::kFinished) << unflipped.verdict.reason;
  const std::vector<Flip> flips = flips_of(flops_of(scenario), "u_axi_uart16550", 101);
  ASSERT_GT(flips.size(), 4U);
  const auto results =
      sweep_flips(scenario, unflipped, {.flips = flips, .instants = {kEarly, kMiddle}, .jobs = 1, .stop = never});
  compare_with_whole_runs(scenario, unflipped, results);
}

TEST(FlipSweep, ResultsDoNotDependOnTheNumberOfJobs) {
  const Scenario scenario = short_move();
  const UnflippedRun unflipped = run_unflipped(scenario, never).value();
  const auto texts = [](const std::vector<FlipResult>& results) {
    std::vector<std::string> lines;
    for (const FlipResult& result : results) lines.push_back(silent_flip_text(result, {}));
    return lines;
  };
  EXPECT_EQ(texts(swept(scenario, unflipped, 3)), texts(swept(scenario, unflipped, 1)));
}

TEST(FlipTable, CountsByPart) {
  EXPECT_EQ(block_of("g_rtl.u_encoder.u_core.u_position.position_q"), "u_encoder");
  EXPECT_EQ(block_of("u_xbar.write_wait_q"), "u_xbar");
  EXPECT_EQ(block_of("servo_on_o"), "pins");
  FlipTable table;
  table.add({{.part = "u_xbar", .name = "u_xbar.a_q", .bit = 0}, kMiddle, {.outcome = Outcome::kMasked}});
  table.add({{.part = "u_xbar", .name = "u_xbar.a_q", .bit = 1},
             kMiddle,
             {.outcome = Outcome::kStopped, .reason = "r", .latency_ticks = 7}});
  table.add(
      {{.part = "pins", .name = "servo_on_o", .bit = 1}, kMiddle, {.outcome = Outcome::kHang, .reason = "stands"}});
  EXPECT_EQ(flip_table_text(table),
            "                                                                   ticks to the first response\n"
            "part                flips   masked  finished  stopped  silent   least  median    99 %    most\n"
            "pins                    1        0         0        0       1\n"
            "u_xbar                  2        1         0        1       0       7       7       7       7\n"
            "all                     3        1         0        1       1       7       7       7       7\n");
  EXPECT_EQ(silent_flip_text(table.silent.at(0), {.scenario = "a b", .run = "armature run --engine rtl"}),
            "SILENT  flop_flip of bit 1 of servo_on_o at 0.02000246 s: hang: stands\n      to repeat it: armature run "
            "--engine rtl "
            "'a b' --set 'fault=[{at_s=0.02000246,kind=\"flop_flip\",flop=\"servo_on_o\",bit=1}]'\n");
  EXPECT_EQ(to_json(table)["parts"]["u_xbar"]["outcomes"]["masked"], 1);
  EXPECT_EQ(to_json(table)["silent"][0]["name"], "servo_on_o");
}

// Every third flip of a sweep, from this one on.
FlipTable table_of_shard(int shard) {
  FlipTable table{.head = {.scenario = "s", .instants_s = {0.02, 0.04}, .bits = "--every 1", .flips = 30},
                  .shards = {std::to_string(shard) + "/3"}};
  for (int flip = shard; flip < 30; flip += 3) {
    table.add({{.part = "u_xbar", .name = "u_xbar.a_q", .bit = flip},
               flip < 15 ? kMiddle : kLate,
               {.outcome = flip % 4 == 0 ? Outcome::kHang : Outcome::kStopped, .reason = "r", .latency_ticks = flip}});
  }
  return table;
}

TEST(FlipTable, ShardsAddUpToTheWholeThroughFiles) {
  FlipTable whole = table_of_shard(0);
  whole.shards.clear();
  for (const int shard : {1, 2}) {
    for (const FlipTable part = table_of_shard(shard); const auto& [name, row] : part.parts) {
      add_counts(whole.parts[name].outcomes, row.outcomes);
      add_counts(whole.parts[name].latencies, row.latencies);
    }
  }
  const auto from_file = [](int shard) { return flip_table(to_json(table_of_shard(shard)).dump(), "f"); };
  FlipTable merged = from_file(2);
  merged.merge(from_file(0), "f");
  EXPECT_EQ(merged.missing(), 10);
  merged.merge(from_file(1), "f");
  EXPECT_EQ(merged.missing(), 0);
  EXPECT_EQ(merged.shards, std::vector<std::string>{});
  EXPECT_EQ(flip_table_text(merged), flip_table_text(whole));
  ASSERT_EQ(merged.silent.size(), 8U);
  for (std::size_t i = 0; i < merged.silent.size(); ++i) {
    EXPECT_EQ(merged.silent[i].flip.bit, 4 * static_cast<int>(i));
    EXPECT_EQ(merged.silent[i].at, i < 4 ? kMiddle : kLate);
  }
}

TEST(FlipTable, OthersAreRefused) {
  FlipTable table = table_of_shard(0);
  EXPECT_THROW(table.merge(table_of_shard(0), "f"), InputError);
  FlipTable other = table_of_shard(1);
  other.head.seed = 7;
  EXPECT_THROW(table.merge(other, "f"), InputError);
  EXPECT_THROW((void)flip_table("{}", "f"), InputError);
}

}  // namespace
}  // namespace armature::cosim
