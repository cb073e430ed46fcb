// The longest time that a run waits for the end of its program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "cosim/time/clock.hpp"
#include "tests/cosim/run/recorded_run.hpp"
#include "tests/cosim/support/scenario_files.hpp"
#include "tests/cosim/support/temp_folder.hpp"

namespace armature::cosim {
namespace {

using testing::HasSubstr;

Scenario scenario_of_program(const std::string& text) {
  const test::TempFolder folder;
  folder.write("s/part.ngc", text);
  return load_scenario(
      folder.write("s/scenario.toml", "description = \"d\"\nrobot = \"vo2021_6r\"\nprogram = \"part.ngc\"\n"),
      test::shipped());
}

TEST(ProgramLimit, IsTheDurationOfARunThatEndsWithItsProgram) {
  EXPECT_EQ(scenario_of_program("M2\n").duration_s, kLongestProgramRunS);
}

TEST(ProgramLimit, FailsARunWhoseProgramIsNotOver) {
  Scenario scenario = scenario_of_program("G4 P1000\nM2\n");
  scenario.duration_s = 0.05;  // in place of the limit
  test::RunUnderTest run{scenario};
  EXPECT_FALSE(run.advance(to_cycles(1.0)));
  const RunSummary summary = run.finish();
  EXPECT_EQ(run.now(), to_cycles(0.05));
  EXPECT_FALSE(summary.passed());
  ASSERT_TRUE(summary.failure.has_value());
  EXPECT_THAT(*summary.failure, HasSubstr("the program is not over after 0.05 s, the longest run without duration_s"));
}

TEST(ProgramLimit, DoesNotFailAProgramThatEndsBefore) {
  Scenario scenario = scenario_of_program("G4 P0.01\nM2\n");
  scenario.duration_s = 0.5;
  test::RunUnderTest run{scenario};
  EXPECT_FALSE(run.advance(to_cycles(1.0)));
  EXPECT_TRUE(run.finish().passed());
  EXPECT_LT(run.now(), to_cycles(0.3));
}

}  // namespace
}  // namespace armature::cosim
