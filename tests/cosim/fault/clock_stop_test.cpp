// The clock of the logic stops at any place of a tick: within an access of a core, while core 0 computes, or while it
// waits. The run goes on, and the controller notices that four ticks are missing.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <string>

#include "cosim/run/run.hpp"
#include "tests/cosim/support/whole_run.hpp"

namespace armature::cosim {
namespace {

constexpr double kStop_s = 2e-4;

Scenario stopped_at(std::int64_t cycle, Engine engine) {
  Scenario scenario = test::moving_scenario(0.03, engine);
  scenario.faults = {{.at_s = static_cast<double>(cycle) * 20e-9, .kind = ClockStop{.duration_s = kStop_s}}};
  return scenario;
}

std::string end_of(const Scenario& scenario) {
  Run run{scenario};
  test::run_out(run);
  const unsigned referenced = run.look().telemetry.referenced;
  const RunSummary summary = run.finish();
  constexpr std::int64_t kTwoTicks = 20;  // of motion [counts]
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (std::abs(summary.facts.lost_counts[axis]) <= kTwoTicks) continue;
    EXPECT_EQ(referenced >> axis & 1u, 0u) << "axis " << axis + 1 << " has a false position";
  }
  EXPECT_EQ(summary.failure, std::nullopt);
  EXPECT_EQ(summary.facts.missed_stop(), std::nullopt);
  return fmt::format("{} {} {}", summary.outcome(), summary.facts.bus_writes, summary.facts.total_pulses[0]);
}

TEST(ClockStop, AtAnyPlaceOfATickIsFoundAndEndsNoAccess) {
  constexpr std::int64_t kSome = 1'000'000, kStep = 37;
  for (std::int64_t cycle = kSome; cycle < kSome + 2'500; cycle += kStep) {
    const std::string end = end_of(stopped_at(cycle, Engine::kModel));
    const std::string outcome = end.substr(0, end.find(' '));
    EXPECT_TRUE(outcome == "fault:clock" || outcome == "fault:encoder") << outcome << " at cycle " << cycle;
  }
}

TEST(ClockStop, WithinAnAccessIsTheSameOnBothEngines) {
  for (const std::int64_t cycle : {1'000'100, 1'000'350, 1'000'800, 1'001'030}) {
    EXPECT_EQ(end_of(stopped_at(cycle, Engine::kModel)), end_of(stopped_at(cycle, Engine::kLockstep)));
  }
}

// A campaign found it: an access timed out, as the time before the second stop was not taken for a time without a
// clock.
TEST(ClockStop, WithAnotherOneInItIsAsAlone) {
  for (const Engine engine : {Engine::kModel, Engine::kRtl}) {
    for (const std::int64_t cycle : {1'000'100, 1'000'350, 1'000'800, 1'001'030}) {
      const Scenario alone = stopped_at(cycle, engine);
      Scenario two = alone;
      two.faults.push_back(
          {.at_s = alone.faults[0].at_s + 0.75 * kStop_s, .kind = ClockStop{.duration_s = 0.1 * kStop_s}});
      EXPECT_EQ(end_of(two), end_of(alone)) << "cycle " << cycle;
    }
  }
}

}  // namespace
}  // namespace armature::cosim
