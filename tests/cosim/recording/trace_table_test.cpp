#include "cosim/recording/trace_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "cosim/text/input_error.hpp"
#include "tests/cosim/support/temp_folder.hpp"

namespace armature::cosim {
namespace {

using test::TempFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(TraceTable, KeepsNumbersExactlyAsTheFileHasThem) {
  const TempFolder folder;
  const TraceTable table = read_trace_table(folder.write(
      "t.csv", "tick,time_s,state,a,b,digest\n0,0.00100000,idle,-7,-0.000000001,ff\n20,0.00200000,idle,8,12.5,ff\n"));
  EXPECT_EQ(table.rows(), 2U);
  EXPECT_EQ(table.column("b").digits, 9);
  EXPECT_THAT(table.column("b").values, ElementsAre(-1, 12'500'000'000));
  EXPECT_THAT(table.column("a").values, ElementsAre(-7, 8));
  EXPECT_EQ(table.column("time_s").number(1), 0.002);
  EXPECT_EQ(table.find("digest"), nullptr);
}

TEST(TraceTable, StatesAreSpansOfRows) {
  const TempFolder folder;
  const TraceTable table = read_trace_table(folder.write("t.csv", "tick,state\n0,idle\n1,moving\n2,moving\n3,idle\n"));
  ASSERT_EQ(table.states.size(), 3U);
  EXPECT_EQ(table.states[1].state, "moving");
  EXPECT_EQ(table.states[1].first_row, 1U);
  EXPECT_EQ(table.states[2].first_row, 3U);
}

TEST(TraceTable, NanIsNoNumber) {
  const TempFolder folder;
  const TraceTable table = read_trace_table(folder.write("t.csv", "tick,a\n0,nan\n1,0.25\n"));
  EXPECT_TRUE(std::isnan(table.column("a").number(0)));
  EXPECT_EQ(table.column("a").number(1), 0.25);
}

TEST(TraceTable, AMissingColumnAndAnEmptyFileAreErrorsThatNameTheFile) {
  const TempFolder folder;
  const auto file = folder.write("t.csv", "tick,a\n0,1\n");
  EXPECT_THAT([&] { (void)read_trace_table(file).column("b"); },
              ThrowsMessage<InputError>(HasSubstr("t.csv: has no column 'b'")));
  const auto empty = folder.write("e.csv", "tick,a\n");
  EXPECT_THAT([&] { (void)read_trace_table(empty); }, ThrowsMessage<InputError>(HasSubstr("e.csv: has no rows")));
}

}  // namespace
}  // namespace armature::cosim
