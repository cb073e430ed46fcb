#include "cosim/trace/compare.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cosim/text/input_error.hpp"
#include "tests/cosim/temp_folder.hpp"

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
  EXPECT_THAT(c.verdict(), testing::MatchesRegex("PASS .*b.csv equals .*a.csv: 3 rows, 3 columns"));
  EXPECT_EQ(c.report(), c.verdict() + "\n");
}

TEST_F(Compare, AnIntegerMayNotDifferByOne) {
  const Comparison c = against("tick,j1_cmd_pulses,j1_ref_deg\n0,0,0.000000\n20,6,1.000000\n40,12,2.000000\n");
  EXPECT_FALSE(c.equal());
  EXPECT_EQ(c.rows_differ, 2);
  ASSERT_TRUE(c.first);
  EXPECT_EQ(c.first->tick, 20);
  EXPECT_EQ(c.first->line_a, 3);
  EXPECT_EQ(c.first->line_b, 3);
  EXPECT_EQ(c.first->column, "j1_cmd_pulses");
  EXPECT_EQ(c.first->value_a, "5");
  EXPECT_EQ(c.first->value_b, "6");
  EXPECT_EQ(c.columns[1].largest, 3);
  EXPECT_EQ(c.columns[1].tick, 40);
  EXPECT_EQ(c.columns[1].rows, 2);
  EXPECT_THAT(c.report(), HasSubstr("2 of 3 common rows differ"));
  EXPECT_THAT(c.report(), HasSubstr("first mismatch at tick 20, j1_cmd_pulses: 5 (line 3) against 6 (line 3)"));
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

TEST_F(Compare, NotANumberEqualsOnlyItself) {
  const char* const nan = "tick,j1_cmd_pulses,j1_ref_deg\n0,0,nan\n20,5,1.000000\n40,9,2.000000\n";
  EXPECT_FALSE(against(nan).equal());
  EXPECT_TRUE(against(nan, nan).equal());
}

TEST_F(Compare, MissingAndExtraRowsAreFoundByTheirTick) {
  const Comparison c = against("tick,j1_cmd_pulses,j1_ref_deg\n0,0,0.000000\n40,9,2.000000\n60,9,2.000000\n80,9,2\n");
  EXPECT_FALSE(c.equal());
  EXPECT_EQ(c.rows, 2);
  EXPECT_EQ(c.rows_differ, 0);
  EXPECT_EQ(c.rows_only_a, 1);
  EXPECT_EQ(c.first_tick_only_a, 20);
  EXPECT_EQ(c.rows_only_b, 2);
  EXPECT_EQ(c.first_tick_only_b, 60);
  EXPECT_THAT(c.verdict(), HasSubstr("0 of 2 common rows differ, 1 missing, 2 extra"));
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

TEST_F(Compare, AnEmptyRunDiffersFromARun) {
  EXPECT_FALSE(against("tick,j1_cmd_pulses,j1_ref_deg\n").equal());
}

TEST_F(Compare, ToleratesWindowsLineEnds) {
  EXPECT_TRUE(against("tick,j1_cmd_pulses\r\n0,1\r\n", "tick,j1_cmd_pulses\n0,1\n").equal());
}

TEST_F(Compare, MalformedFilesAreNamedWithTheirPlace) {
  EXPECT_EQ(error_of(""), "a.csv: is empty, expected a header line");
  EXPECT_EQ(error_of("time,a\n"), "a.csv:1:1: expected the column \"tick\", found \"time\"");
  EXPECT_EQ(error_of("tick,a,a\n"), "a.csv:1:8: second column \"a\"");
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
