#include "cosim/trace/compare.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cosim/text/input_error.hpp"
#include "tests/cosim/support/temp_folder.hpp"

namespace armature::cosim {
namespace {

using test::TempFolder;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kBase =
    "tick,j1_cmd_pulses,j1_ref_deg\n"
    "0,0,0.000000\n"
    "20,5,1.000000\n"
    "40,9,2.000000\n";

struct Compare : testing::Test {
  Comparison against(const std::string& other, const std::string& base = kBase) {
    return compare_traces(folder.write("a.csv", base), folder.write("b.csv", other));
  }
  std::string error_of(const std::string& text) {
    try {
      (void)against(kBase, text);
    } catch (const InputError& error) {
      const std::string what = error.what();
      return what.substr(what.rfind('/') + 1);
    }
    return "";
  }
  TempFolder folder;
};

TEST_F(Compare, EqualFilesPass) {
  const Comparison c = against(kBase);
  EXPECT_TRUE(c.equal());
  EXPECT_EQ(c.rows, 3);
  EXPECT_THAT(c.verdict(), testing::MatchesRegex("PASS .*a.csv and .*b.csv are equal: 3 rows, 3 columns"));
  EXPECT_EQ(c.report(), c.verdict() + "\n");
}

TEST_F(Compare, AnIntegerMayNotDifferByOne) {
  const Comparison c = against("tick,j1_cmd_pulses,j1_ref_deg\n0,0,0.000000\n20,6,1.000000\n40,12,2.000000\n");
  EXPECT_FALSE(c.equal());
  EXPECT_EQ(c.rows_differ, 2);
  ASSERT_TRUE(c.first);
  EXPECT_EQ(c.first->at.tick, 20);
  EXPECT_EQ(c.first->at.line_a, 3);
  EXPECT_EQ(c.first->at.line_b, 3);
  EXPECT_EQ(c.first->column, "j1_cmd_pulses");
  EXPECT_EQ(c.first->value_a, "5");
  EXPECT_EQ(c.first->value_b, "6");
  EXPECT_EQ(c.columns[1].largest, 3);
  EXPECT_EQ(c.columns[1].tick, 40);
  EXPECT_EQ(c.columns[1].rows, 2);
  EXPECT_THAT(c.report(), HasSubstr("2 of 3 common rows differ"));
  EXPECT_THAT(c.report(), HasSubstr("  first mismatch at tick 20, j1_cmd_pulses: " + c.a.file + ": 5 (line 3), " +
                                    c.b.file + ": 6 (line 3)\n"));
  EXPECT_THAT(c.report(), HasSubstr("j1_cmd_pulses: 3 at tick 40, 2 rows differ"));
}

TEST_F(Compare, LargeIntegersAreComparedExactly) {
  EXPECT_FALSE(against("tick,j1_cmd_pulses\n0,9007199254740993\n", "tick,j1_cmd_pulses\n0,9007199254740992\n").equal());
}

TEST_F(Compare, AFloatMayDifferByOneUnitOfItsLastDigitOnly) {
  const Comparison one = against("tick,j1_cmd_pulses,j1_ref_deg\n0,0,0.000000\n20,5,1.000001\n40,9,2.000000\n");
  EXPECT_TRUE(one.equal());
  EXPECT_NEAR(one.columns[2].largest, 1e-6, 1e-12);
  EXPECT_THAT(one.report(), HasSubstr("j1_ref_deg: 0.000001 at tick 20, 0 rows beyond"));
  const Comparison two = against("tick,j1_cmd_pulses,j1_ref_deg\n0,0,0.000000\n20,5,1.000002\n40,9,2.000000\n");
  EXPECT_FALSE(two.equal());
  EXPECT_EQ(two.first->column, "j1_ref_deg");
}

TEST_F(Compare, NotANumberEqualsNothing) {
  const char* const nan = "tick,j1_cmd_pulses,j1_ref_deg\n0,0,nan\n20,5,1.000000\n40,9,2.000000\n";
  EXPECT_FALSE(against(nan).equal());
  EXPECT_FALSE(against(nan, nan).equal());
  EXPECT_THAT(against(nan, nan).report(), HasSubstr("j1_ref_deg: no number (nan) at tick 0, 1 rows beyond"));
}

TEST_F(Compare, MissingAndExtraRowsAreFoundByTheirTick) {
  const std::string base = kBase;
  const Comparison c = against(base + "80,9,2.000000\n100,9,2\n", base + "60,9,2.000000\n");
  EXPECT_FALSE(c.equal());
  EXPECT_EQ(c.rows, 3);
  EXPECT_EQ(c.rows_differ, 0);
  EXPECT_EQ(c.rows_only_a, 1);
  EXPECT_EQ(c.first_tick_only_a, 60);
  EXPECT_EQ(c.rows_only_b, 2);
  EXPECT_EQ(c.first_tick_only_b, 80);
  EXPECT_THAT(c.verdict(), HasSubstr("0 of 3 common rows differ, 1 missing, 2 extra"));
}

TEST_F(Compare, RowsBetweenThoseOfATraceWithALongerIntervalAreNoDifference) {
  const std::string coarse = "tick,j1_cmd_pulses,j1_ref_deg\n0,0,0.000000\n40,9,2.000000\n";
  for (const bool swapped : {false, true}) {
    const Comparison c = swapped ? against(kBase, coarse) : against(coarse, kBase);
    EXPECT_TRUE(c.equal());
    EXPECT_EQ(c.counts(), "2 rows, 3 columns; 1 rows between them are in one trace only");
  }
  // Such a trace still has to end where the other one does.
  EXPECT_TRUE(against(std::string{kBase} + "60,9,2\n", coarse).equal());
  const Comparison longer = against(std::string{kBase} + "60,9,2\n80,9,2\n", coarse);
  EXPECT_FALSE(longer.equal());
  EXPECT_EQ(longer.first_tick_only_b, 80);
  // No interval is a multiple of the other one: a row has a wrong tick.
  EXPECT_FALSE(against("tick,j1_cmd_pulses,j1_ref_deg\n0,0,0\n21,5,1\n40,9,2\n").equal());
  EXPECT_FALSE(against("tick,j1_cmd_pulses,j1_ref_deg\n0,0,0\n10,5,1\n40,9,2\n").equal());
  EXPECT_FALSE(against("tick,j1_cmd_pulses,j1_ref_deg\n0,0,0\n20,5,1\n30,5,1\n40,9,2\n").equal());
}

TEST_F(Compare, TheLastEqualRowIsTheOneBeforeTheFirstDifference) {
  EXPECT_EQ(against(kBase).last_equal_tick, 40);
  EXPECT_EQ(against("tick,j1_cmd_pulses,j1_ref_deg\n0,0,0\n20,6,1\n40,9,2\n").last_equal_tick, 0);
  EXPECT_EQ(against("tick,j1_cmd_pulses,j1_ref_deg\n0,1,0\n20,5,1\n40,9,2\n").last_equal_tick, -1);
}

TEST_F(Compare, RowsOrColumnsThatOnlyOneFileHasAreADifference) {
  const std::string base = kBase;
  EXPECT_FALSE(against(base + "60,9,2.000000\n").equal());
  EXPECT_FALSE(against(base, base + "60,9,2.000000\n").equal());
  const std::string wide = "tick,j1_cmd_pulses,j1_ref_deg,x\n0,0,0,1\n20,5,1,1\n40,9,2,1\n";
  EXPECT_FALSE(against(wide).equal());
  EXPECT_FALSE(against(base, wide).equal());
}

TEST_F(Compare, ColumnsAreMatchedByName) {
  EXPECT_TRUE(against("tick,j1_ref_deg,j1_cmd_pulses\n0,0,0\n20,1,5\n40,2,9\n").equal());
  const Comparison c = against("tick,j1_cmd_pulses,j2_ref_deg\n0,0,0\n20,5,1\n40,9,2\n");
  EXPECT_FALSE(c.equal());
  EXPECT_THAT(c.columns_only_a, ElementsAre("j1_ref_deg"));
  EXPECT_THAT(c.columns_only_b, ElementsAre("j2_ref_deg"));
}

TEST_F(Compare, NamesTheValuesInTheOrderOfTheFilesWithTimeAndLine) {
  const std::string base = "tick,time_s,j1_cmd_pulses\n0,0.00006216,1\n180,0.00906216,90\n";
  const std::string other = "tick,time_s,j1_cmd_pulses\n180,0.00906216,0\n";
  const Comparison c = against(other, base);
  EXPECT_THAT(c.verdict(),
              testing::MatchesRegex("FAIL .*a.csv and .*b.csv differ: 1 of 1 common rows differ, 1 missing"));
  EXPECT_THAT(c.details(), HasSubstr("first mismatch at tick 180 (0.009062 s), j1_cmd_pulses: " + c.a.file +
                                     ": 90 (line 3), " + c.b.file + ": 0 (line 2)\n"));
  const Comparison named =
      compare_traces(folder.write("golden.csv", base), folder.write("trace.csv", other),
                     {.file = "s/golden.csv", .value = "golden"}, {.file = "out/s/trace.csv", .value = "this run"});
  EXPECT_THAT(named.details(),
              HasSubstr("first mismatch at tick 180 (0.009062 s), j1_cmd_pulses: golden 90 (golden.csv "
                        "line 3), this run 0 (trace.csv line 2)\n"));
}

TEST_F(Compare, WordsMustBeEqualAndTimesWithinHalfATick) {
  const std::string base = "tick,time_s,state\n0,0.00006216,idle\n20,0.00106216,moving\n";
  EXPECT_TRUE(against(base, base).equal());
  const Comparison word = against("tick,time_s,state\n0,0.00006216,idle\n20,0.00106216,fault\n", base);
  EXPECT_FALSE(word.equal());
  EXPECT_EQ(word.first->value_b, "fault");
  EXPECT_THAT(word.details(), HasSubstr("state: differs first at tick 20, 1 rows differ"));
  EXPECT_TRUE(against("tick,time_s,state\n0,0.00006216,idle\n20,0.00108714,moving\n", base).equal());
  const Comparison time = against("tick,time_s,state\n0,0.00006216,idle\n20,0.00108718,moving\n", base);
  EXPECT_FALSE(time.equal());
  EXPECT_THAT(time.details(), HasSubstr("time_s: 0.00002502 at tick 20, 1 rows beyond 2.5e-05"));
}

constexpr const char* kHashed =
    "tick,time_s,j1_cmd_pulses,digest\n"
    "0,0.00006216,0,aaaa\n"
    "20,0.00106216,0,bbbb\n"
    "40,0.00206216,0,cccc\n"
    "60,0.00306216,0,dddd\n";

TEST_F(Compare, ADigestThatDiffersAloneTellsBetweenWhichRowsTheRunsDo) {
  EXPECT_TRUE(against(kHashed, kHashed).equal());
  const std::string other =
      "tick,time_s,j1_cmd_pulses,digest\n0,0.00006216,0,aaaa\n20,0.00106216,0,bbbb\n40,0.00206216,0,cccd\n"
      "60,0.00306216,0,ddde\n";
  Comparison c = against(other, kHashed);
  EXPECT_FALSE(c.equal());
  EXPECT_EQ(c.rows_differ, 0);
  EXPECT_EQ(c.digest->rows, 2);
  EXPECT_FALSE(c.first);
  c.a.value = "golden", c.b.value = "this run";
  c.scenario = "my scenarios/x";
  EXPECT_THAT(c.counts(), HasSubstr("0 of 4 common rows differ, but ticks between them differ"));
  EXPECT_EQ(c.details(),
            "  the runs first differ between tick 20 (0.001062 s; a.csv line 3, b.csv line 3) and tick 40 (0.002062 s; "
            "a.csv line 4, b.csv line 4)\n"
            "  these ticks: armature run 'my scenarios/x' --set trace.every_ticks=1 --out out/full_rate; sed -n "
            "'1p;22,42p' out/full_rate/trace.csv\n");
}

TEST_F(Compare, ADigestThatDiffersFromTheBeginningSaysSo) {
  const Comparison c = against("tick,time_s,j1_cmd_pulses,digest\n0,0.00006216,0,x\n", kHashed);
  EXPECT_THAT(c.details(), HasSubstr("the runs differ already in the first common row, tick 0 (0.000062 s; "));
}

TEST_F(Compare, DigestsOfTriggersAtOtherCyclesAreNotCompared) {
  std::string later = kHashed;
  later.replace(later.find("0.00106216,0,bbbb"), 17, "0.00106218,0,bbbx");
  later.replace(later.find("cccc"), 4, "cccx");
  const Comparison c = against(later, kHashed);
  EXPECT_TRUE(c.equal());
  EXPECT_TRUE(c.other_cycles);
  EXPECT_THAT(c.report(),
              HasSubstr("4 rows, 4 columns; ticks between them are not compared, because triggers come at"));
}

TEST_F(Compare, DigestsOfTwoVersionsAreNotCompared) {
  std::string other = kHashed;
  other.replace(other.find("digest"), 6, "digest2");
  other.replace(other.find("bbbb"), 4, "0000");
  const Comparison c = against(other, kHashed);
  EXPECT_FALSE(c.equal());
  EXPECT_TRUE(c.equal_but_for_version());
  EXPECT_FALSE(c.digest);
  EXPECT_THAT(c.details(), HasSubstr("the digests are of two versions of armature, so nothing is known of the ticks"));
  other.replace(other.find("0.00106216,0"), 12, "0.00106216,5");
  EXPECT_FALSE(against(other, kHashed).equal_but_for_version());
}

TEST_F(Compare, AnotherColumnThatDiffersIsShownBeforeTheDigest) {
  const Comparison c = against(
      "tick,time_s,j1_cmd_pulses,digest\n0,0.00006216,0,aaaa\n20,0.00106216,0,bbbx\n40,0.00206216,3,cccx\n"
      "60,0.00306216,0,dddx\n",
      kHashed);
  EXPECT_EQ(c.rows_differ, 1);
  EXPECT_EQ(c.first->column, "j1_cmd_pulses");
  EXPECT_THAT(c.details(), HasSubstr("the runs first differ between tick 0 "));
  EXPECT_THAT(c.details(), testing::Not(HasSubstr("    digest:")));
}

TEST_F(Compare, AnOlderFileIsComparedOnTheColumnsThatBothHave) {
  const std::string older = "tick,j1_cmd_pulses\n0,0\n20,0\n40,7\n60,0\n";
  const Comparison c = against(kHashed, older);
  EXPECT_FALSE(c.equal());
  EXPECT_EQ(c.rows_differ, 1);
  EXPECT_THAT(c.columns_only_b, ElementsAre("time_s", "digest"));
  EXPECT_THAT(c.report(), HasSubstr("columns only in " + c.b.file + ": time_s, digest\n"));
  EXPECT_THAT(c.report(), HasSubstr("first mismatch at tick 40 (0.002062 s), j1_cmd_pulses: "));
}

TEST_F(Compare, AnEmptyRunDiffersFromARun) {
  EXPECT_FALSE(against("tick,j1_cmd_pulses,j1_ref_deg\n").equal());
}

TEST_F(Compare, ToleratesWindowsLineEnds) {
  EXPECT_TRUE(against("tick,j1_cmd_pulses\r\n0,1\r\n", "tick,j1_cmd_pulses\n0,1\n").equal());
}

TEST_F(Compare, MalformedFilesAreNamedWithTheirPlace) {
  EXPECT_EQ(error_of(""), "a.csv: is empty, expected a header line");
  EXPECT_EQ(error_of("time,a\n"), "a.csv:1:1: expected the column \"tick\", found another text");
  EXPECT_EQ(error_of("tick,a,a\n"), "a.csv:1:8: duplicate column \"a\"");
  EXPECT_EQ(error_of("tick,,a\n"), "a.csv:1:6: empty column name");
  EXPECT_EQ(error_of("tick,a\n0,1\n20\n"), "a.csv:3:1: expected 2 values as in the header, found 1");
  EXPECT_EQ(error_of("tick,a\n0,1,2\n"), "a.csv:2:3: expected 2 values as in the header, found 3");
  EXPECT_EQ(error_of("tick,j1_cmd_pulses\n0,1.5\n"), "a.csv:2:3: j1_cmd_pulses: expected an integer, found \"1.5\"");
  EXPECT_EQ(error_of("tick,j1_cmd_pulses\n0,\n"), "a.csv:2:3: j1_cmd_pulses: expected an integer, found \"\"");
  EXPECT_EQ(error_of("tick,j1_ref_deg\n0,1.5x\n"), "a.csv:2:3: j1_ref_deg: expected a number, found \"1.5x\"");
  EXPECT_EQ(error_of("tick,a\nx,1\n"), "a.csv:2:1: tick: expected an integer, found \"x\"");
  EXPECT_EQ(error_of("tick,a\n20,1\n20,1\n"), "a.csv:3:1: expected a tick above 20, found 20");
  EXPECT_THROW((void)compare_traces("/nowhere.csv", "/nowhere.csv"), InputError);
  EXPECT_THROW((void)compare_traces(folder.path(), folder.path()), InputError);
}

}  // namespace
}  // namespace armature::cosim
