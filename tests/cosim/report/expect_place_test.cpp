// What the message about an expectation that is not met says of where: the key in the file, axis, tick and time.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cosim/report/judge/expect.hpp"
#include "tests/cosim/support/scenario_files.hpp"

namespace armature::cosim {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::IsEmpty;
using testing::StartsWith;

constexpr RunPlace kPlace{.tick = 180, .at = Cycles{453'108}, .axis = 2};

ExpectFailure only_failure(const ExpectSpec& expect, const RunFacts& facts) {
  const std::vector<ExpectFailure> failures = check(expect, facts);
  EXPECT_EQ(failures.size(), 1u);
  return failures.empty() ? ExpectFailure{} : failures.front();
}

struct ExpectPlace : testing::Test {
  [[nodiscard]] Scenario load(const std::string& tables, std::vector<std::string> overrides = {}) const {
    LoadOptions options = test::shipped();
    options.overrides = std::move(overrides);
    return load_scenario(
        folder.write("s/scenario.toml", "description = \"d\"\nrobot = \"vo2021_6r\"\nduration_s = 1\n" + tables),
        options);
  }
  [[nodiscard]] std::string file() const { return (folder.path() / "s/scenario.toml").string(); }
  test::TempFolder folder;
};

TEST_F(ExpectPlace, IsFileLineAndColumnOfTheKey) {
  RunFacts facts;
  const ExpectFailure failure =
      only_failure(load("[expect]\noutcome = \"completed\"\n  min_underruns = 3\n").expect, facts);
  EXPECT_EQ(failure.text(), file() + ":6:3: expect.min_underruns: expected at least 3, got 0");
  EXPECT_EQ(failure.place(), file() + ":6:3");
  EXPECT_EQ(only_failure(load("expect.min_underruns = 3\n").expect, facts).place(), file() + ":4:8");
}

TEST_F(ExpectPlace, IsTheFileForAKeyThatIsNotWritten) {
  RunFacts facts;
  facts.underruns = 5;
  facts.first_underrun_at = RunPlace{.tick = 180, .at = Cycles{453'108}};
  for (const char* tables : {"", "[expect]\noutcome = \"completed\"\n"}) {
    EXPECT_EQ(only_failure(load(tables).expect, facts).text(),
              file() + ": expect.underruns: expected 0, as it is not stated, got 5 (the first: tick 180, 0.009062 s)");
  }
}

TEST_F(ExpectPlace, IsTheTextOfAnOverrideWhetherOfAllOrAPart) {
  RunFacts facts;
  const std::string tables = "[expect]\nunderruns = 0\ntotal_pulses = [0, 0, 0, 0, 0, 0]\n";
  EXPECT_EQ(only_failure(load(tables, {"expect.underruns=7"}).expect, facts).text(),
            "--set expect.underruns=7: expect.underruns: expected 7, got 0");
  EXPECT_THAT(only_failure(load(tables, {"expect.total_pulses[2]=4"}).expect, facts).text(),
              StartsWith("--set expect.total_pulses[2]=4: expect.total_pulses: expected "));
  EXPECT_EQ(only_failure(load("", {"expect.min_underruns=1"}).expect, facts).place(), "--set expect.min_underruns=1");
  // The key of the file is missed because of a tolerance that is not the file's.
  facts.final_joint_deg[0] = 0.01;
  const std::string near = "[expect]\nfinal_joint_deg = [0, 0, 0, 0, 0, 0]\ntolerance_deg = 1\n";
  EXPECT_THAT(only_failure(load(near, {"expect.tolerance_deg=0.001"}).expect, facts).text(),
              StartsWith(file() + ":5:1: expect.final_joint_deg: expected [0, 0, 0, 0, 0, 0] +-0.001 (--set "
                                  "expect.tolerance_deg=0.001), got [0.01, 0, 0, 0, 0, 0] (axis 1 differs"));
}

TEST_F(ExpectPlace, OfAnArrayOfTablesIsTheFirst) {
  const ExpectSpec expect = load("[[expect.output]]\nat_s = 0.1\npin = 1\nlevel = 1\n").expect;
  EXPECT_THAT(only_failure(expect, {}).text(), StartsWith(file() + ":4:"));
  EXPECT_THAT(only_failure(
                  load("[[expect.output]]\nat_s = 0.1\npin = 1\nlevel = 1\n", {"expect.output[0].at_s=0.2"}).expect, {})
                  .text(),
              StartsWith("--set expect.output[0].at_s=0.2: expect.output: "));
}

TEST(ExpectWhere, NamesAxisTickAndTimeOfALargestValue) {
  RunFacts facts;
  facts.max_correction_pulses = facts.peak_pulses_per_tick = facts.max_residual_pulses = 4;
  facts.max_correction_at = facts.peak_pulses_at = facts.max_residual_at = kPlace;
  facts.overshoot_counts = {0, 4, 0, 0, 0, 0};
  facts.overshoot_at[1] = kPlace;
  const auto spoiled = [&](auto set) {
    ExpectSpec expect;
    set(expect);
    const ExpectFailure failure = only_failure(expect, facts);
    EXPECT_THAT(failure.text(), EndsWith(", got 4 (axis 2, tick 180, 0.009062 s)"));
    EXPECT_THAT(failure.where.axes, ElementsAre(2));
    EXPECT_EQ(failure.where.at.value_or(RunPlace{}).tick, 180);
  };
  spoiled([](ExpectSpec& expect) { expect.max_correction_pulses = 3; });
  spoiled([](ExpectSpec& expect) { expect.peak_pulses_per_tick = 3; });
  spoiled([](ExpectSpec& expect) { expect.max_residual_pulses = 3; });
  spoiled([](ExpectSpec& expect) { expect.max_overshoot_counts = 3; });
}

TEST(ExpectWhere, NamesTheAxesThatAreOffAndTheWorstOfThem) {
  RunFacts facts;
  facts.peak_speed_deg_s = {1, 2.5, 3, 4, 5, 4};
  facts.peak_speed_at.fill(RunPlace{.tick = 7, .at = Cycles{50'000}, .axis = 1});
  facts.peak_speed_at[5] = RunPlace{.tick = 180, .at = Cycles{453'108}, .axis = 6};
  ExpectSpec expect;
  expect.peak_speed_deg_s = PerAxis<double>{1, 2, 3, 4, 5, 6};
  const ExpectFailure failure = only_failure(expect, facts);
  EXPECT_THAT(failure.text(),
              EndsWith("(axes 2, 6 differ, axis 6 most: expected 6, got 4, difference -2, tick 180, 0.009062 s)"));
  EXPECT_THAT(failure.where.axes, ElementsAre(2, 6));
  EXPECT_EQ(failure.where.at.value_or(RunPlace{}).axis, 6);
}

TEST(ExpectWhere, NamesTheAxisThatSettledLast) {
  RunFacts facts;
  facts.moved = true;
  facts.settle_s = 0.5;
  facts.last_outside_at = kPlace;
  ExpectSpec expect;
  expect.settled_within_s = 0.1;
  EXPECT_THAT(only_failure(expect, facts).text(),
              EndsWith("got after 0.5 s (last outside: axis 2, tick 180, 0.009062 s)"));
  facts.moved = false;
  facts.settle_s.reset();
  EXPECT_THAT(only_failure(expect, facts).text(), EndsWith("got no motion"));
}

TEST(ExpectWhere, NamesWhenFaultsAndRefusalsWere) {
  RunFacts facts;
  facts.faults = {{FaultCause::kEstop, {.tick = 0, .at = Cycles{50'000}, .axis = 0}},
                  {FaultCause::kDriveAlarm, {.tick = 0, .at = Cycles{453'108}, .axis = 4}}};
  facts.refusals = {{{.reason = Refusal::kNotReady, .tag = 3}, Cycles{500'000}}};
  ExpectSpec expect;
  expect.faults = {"estop"};
  expect.refused_moves = 0;
  const std::vector<ExpectFailure> failures = check(expect, facts);
  ASSERT_EQ(failures.size(), 2u);
  EXPECT_THAT(failures[0].text(), EndsWith("got 1: not_ready (move[3], 0.010000 s)"));

  // Of many, the first ones are named, and each reason once.
  facts.refusals.push_back({{.reason = Refusal::kUnreachable, .tag = 4}, Cycles{500'000}});
  for (std::uint32_t tag = 5; tag < 300; ++tag) {
    facts.refusals.push_back({{.reason = Refusal::kNotReady, .tag = tag}, Cycles{500'000}});
  }
  EXPECT_THAT(check(expect, facts)[0].text(),
              EndsWith("got 297: 296 times not_ready, unreachable (move[3], 0.010000 s; move[4], 0.010000 s; move[5], "
                       "0.010000 s; move[6], 0.010000 s; move[7], 0.010000 s; and 292 more)"));
  EXPECT_THAT(failures[1].text(), EndsWith("(estop, 0.001000 s; drive_alarm of axis 4, 0.009062 s)"));
}

TEST(ExpectWhere, IsEmptyWhereTheRunHasNone) {
  ExpectSpec expect;
  expect.peak_pulses_per_tick = 3;
  const ExpectFailure failure = only_failure(expect, {});
  EXPECT_EQ(failure.text(), "expect.peak_pulses_per_tick: expected 3, got 0");
  EXPECT_THAT(failure.where.axes, IsEmpty());
}

}  // namespace
}  // namespace armature::cosim
