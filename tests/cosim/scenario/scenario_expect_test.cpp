// [expect] of a scenario file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "cosim/scenario/files/scenario_loader.hpp"
#include "tests/cosim/support/scenario_files.hpp"
#include "tests/cosim/support/temp_folder.hpp"

namespace armature::cosim {
namespace {

using test::shipped;
using test::TempFolder;
using testing::ElementsAre;

constexpr const char* kEveryExpectation = R"(
description = "every expectation"
robot = "vo2021_6r"
duration_s = 2
variant = "paper"
[expect]
outcome = "fault:watchdog"
final_joint_deg = [1, 2, 3, 4, 5, 6]
tolerance_deg = 0.5
total_pulses = [1, -2, 3, -4, 5, -6]
final_error_counts = [0, 0, 500, 0, 0, 0]
move_ticks = [100, 0]
taken_ticks = [90]
profile = ["none", "triangle", "trapezoid", "none", "none", "none"]
peak_speed_deg_s = [1, 2, 3, 4, 5, 6]
peak_tolerance_deg_s = 0.25
peak_pulses_per_tick = 200
min_underruns = 4
refused_moves = 1
refusals = ["singular"]
unfinished_moves = 2
blended_moves = 3
min_held_s = 0.75
max_path_error_mm = 0.5
max_command_path_error_mm = 0.25
max_tool_speed_mm_s = 250
max_tool_accel_mm_s2 = 5000
final_tcp_mm = [1, 2, 3]
tcp_tolerance_mm = 0.125
final_rpy_deg = [4, -5, 6]
rpy_tolerance_deg = 0.0625
min_stretch = 2
max_stretch = 3
min_solved_poses = 7
max_solver_difference_pulses = 0.125
min_residual_deg = 0.5
max_residual_deg = 2
settled_within_s = 0.1
settled_counts = 3
max_overshoot_counts = 2
max_correction_pulses = 9
inexact_ticks = [0, 1, 2, 3, 4, 5]
max_residual_pulses = 15
lost_counts = [0, -1, 2, 0, 0, 0]
stopped_by = "watchdog"
faults = ["estop", "watchdog"]
)";

TEST(ScenarioExpect, ReadsEveryKey) {
  const TempFolder folder;
  const Scenario s = load_scenario(folder.write("all_keys/scenario.toml", kEveryExpectation), shipped());
  const ExpectSpec& e = s.expect;
  EXPECT_EQ(e.outcome, "fault:watchdog");
  EXPECT_THAT(e.final_joint_deg.value(), ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_EQ(e.tolerance_deg, 0.5);
  EXPECT_THAT(e.total_pulses.value(), ElementsAre(1, -2, 3, -4, 5, -6));
  EXPECT_THAT(e.final_error_counts.value(), ElementsAre(0, 0, 500, 0, 0, 0));
  EXPECT_THAT(e.move_ticks.value(), ElementsAre(100, 0));
  EXPECT_THAT(e.taken_ticks.value(), ElementsAre(90));
  EXPECT_THAT(e.profile.value(), ElementsAre("none", "triangle", "trapezoid", "none", "none", "none"));
  EXPECT_THAT(e.peak_speed_deg_s.value(), ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_EQ(e.peak_tolerance_deg_s, 0.25);
  EXPECT_EQ(e.peak_pulses_per_tick, 200);
  EXPECT_EQ(e.underruns, std::nullopt);
  EXPECT_EQ(e.min_underruns, 4);
  EXPECT_EQ(e.refused_moves, 1);
  EXPECT_THAT(e.refusals.value(), ElementsAre("singular"));
  EXPECT_EQ(e.unfinished_moves, 2);
  EXPECT_EQ(e.blended_moves, 3);
  EXPECT_EQ(e.min_held_s, 0.75);
  EXPECT_EQ(e.max_path_error_mm, 0.5);
  EXPECT_EQ(e.max_command_path_error_mm, 0.25);
  EXPECT_EQ(e.max_tool_speed_mm_s, 250);
  EXPECT_EQ(e.max_tool_accel_mm_s2, 5000);
  EXPECT_THAT(e.final_tcp_mm.value(), ElementsAre(1, 2, 3));
  EXPECT_EQ(e.tcp_tolerance_mm, 0.125);
  EXPECT_THAT(e.final_rpy_deg.value(), ElementsAre(4, -5, 6));
  EXPECT_EQ(e.rpy_tolerance_deg, 0.0625);
  EXPECT_EQ(e.min_stretch, 2);
  EXPECT_EQ(e.max_stretch, 3);
  EXPECT_EQ(e.min_solved_poses, 7);
  EXPECT_EQ(e.max_solver_difference_pulses, 0.125);
  EXPECT_EQ(e.min_residual_deg, 0.5);
  EXPECT_EQ(e.max_residual_deg, 2);
  EXPECT_EQ(e.settled_within_s, 0.1);
  EXPECT_EQ(e.settled_counts, 3);
  EXPECT_EQ(e.max_overshoot_counts, 2);
  EXPECT_EQ(e.max_correction_pulses, 9);
  EXPECT_THAT(e.inexact_ticks.value(), ElementsAre(0, 1, 2, 3, 4, 5));
  EXPECT_EQ(e.max_residual_pulses, 15);
  EXPECT_THAT(e.lost_counts.value(), ElementsAre(0, -1, 2, 0, 0, 0));
  EXPECT_EQ(e.stopped_by, "watchdog");
  EXPECT_EQ(e.faults, (std::vector<std::string>{"estop", "watchdog"}));
}

}  // namespace
}  // namespace armature::cosim
