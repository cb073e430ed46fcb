#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "cosim/scenario/scenario_loader.hpp"
#include "tests/cosim/temp_folder.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;
using test::TempFolder;
using testing::ElementsAre;
using testing::HasSubstr;

const fs::path kScenarios = fs::path{ARMATURE_SOURCE_DIR} / "scenarios";

LoadOptions shipped() {
  return {.scenarios_dir = kScenarios, .overrides = {}};
}

std::string error_of(const fs::path& where, const LoadOptions& options = shipped()) {
  try {
    (void)load_scenario(where, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

constexpr const char* kEveryKey = R"(
description = "every key"
robot = "vo2021_6r"
duration_s = 2
seed = 42
[controller]
sync = "time_scale"
feedback = false
max_stretch = 50
[cpu]
interrupt_entry_cycles = 1
tick_compute_cycles = 2
plan_compute_cycles = 3
inverse_compute_cycles = 8
[bus]
latency_cycles = 4
timeout_cycles = 500
stall_probability = 0.25
[trace]
every_ticks = 7
tcp = false
[[move]]
at_s = 1.5
type = "stop"
[[move]]
at_s = 0.5
type = "joint"
target_deg = [1, -2, 3.5, 4, 5, 6]
speed_percent = 50
[[move]]
at_s = 1.75
type = "clear_fault"
[[fault]]
at_s = 1.0
kind = "estop"
duration_s = 0.125
[[fault]]
at_s = 0.25
kind = "pulse_loss"
axis = 3
count = 500
[[fault]]
at_s = 1.25
kind = "slow_core"
compute_us = 300
[expect]
outcome = "fault:watchdog"
final_joint_deg = [1, 2, 3, 4, 5, 6]
tolerance_deg = 0.5
total_pulses = [1, -2, 3, -4, 5, -6]
final_error_counts = [0, 0, 500, 0, 0, 0]
move_ticks = [100, 0]
profile = ["none", "triangle", "trapezoid", "none", "none", "none"]
peak_speed_deg_s = [1, 2, 3, 4, 5, 6]
peak_tolerance_deg_s = 0.25
peak_pulses_per_tick = 200
min_underruns = 4
refused_moves = 1
refusals = ["singular"]
max_path_error_mm = 0.5
max_command_path_error_mm = 0.25
final_tcp_mm = [1, 2, 3]
tcp_tolerance_mm = 0.125
min_stretch = 2
max_stretch = 3
settled_within_s = 0.1
settled_counts = 3
max_overshoot_counts = 2
max_correction_pulses = 9
stopped_by = "watchdog"
faults = ["estop", "watchdog"]
[golden]
sha256 = "0123456789abcdef0123456789abcdef0123456789abcdef0123456789abcdef"
)";

TEST(ScenarioLoader, ReadsEveryKeyOfTheSchema) {
  const TempFolder folder;
  const Scenario s = load_scenario(folder.write("all_keys/scenario.toml", kEveryKey), shipped());
  EXPECT_EQ(s.name, "all_keys");
  EXPECT_EQ(s.directory, (folder.path() / "all_keys").string());
  EXPECT_EQ(s.description, "every key");
  EXPECT_EQ(s.robot_name, "vo2021_6r");
  EXPECT_EQ(s.robot.name, "vo2021_6r");
  EXPECT_EQ(s.duration_s, 2.0);
  EXPECT_EQ(s.seed, 42u);
  EXPECT_EQ(s.controller.sync, "time_scale");
  EXPECT_FALSE(s.controller.feedback);
  EXPECT_EQ(s.cpu.interrupt_entry_cycles, 1);
  EXPECT_EQ(s.cpu.tick_compute_cycles, 2);
  EXPECT_EQ(s.cpu.plan_compute_cycles, 3);
  EXPECT_EQ(s.bus.latency_cycles, 4);
  EXPECT_EQ(s.bus.timeout_cycles, 500);
  EXPECT_EQ(s.bus.stall_probability, 0.25);
  EXPECT_EQ(s.trace.every_ticks, 7);
  EXPECT_EQ(s.trace.tcp, false);
  EXPECT_EQ(s.controller.max_stretch, 50);
  EXPECT_EQ(s.cpu.inverse_compute_cycles, 8);

  ASSERT_EQ(s.moves.size(), 3u);
  EXPECT_EQ(s.moves[0].type, MoveType::kJoint);
  EXPECT_EQ(s.moves[0].at_s, 0.5);
  EXPECT_THAT(*s.moves[0].target_deg, ElementsAre(1, -2, 3.5, 4, 5, 6));
  EXPECT_EQ(s.moves[0].speed_percent, 50);
  EXPECT_EQ(s.moves[0].line, 25);
  EXPECT_EQ(s.moves[1].type, MoveType::kStop);
  EXPECT_EQ(s.moves[2].type, MoveType::kClearFault);

  ASSERT_EQ(s.faults.size(), 3u);
  EXPECT_EQ(s.faults[0].kind, FaultKind::kPulseLoss);
  EXPECT_EQ(s.faults[0].axis, 3);
  EXPECT_EQ(s.faults[0].count, 500);
  EXPECT_EQ(s.faults[1].kind, FaultKind::kEstop);
  EXPECT_EQ(s.faults[1].duration_s, 0.125);
  EXPECT_EQ(s.faults[2].kind, FaultKind::kSlowCore);
  EXPECT_EQ(s.faults[2].compute_us, 300);

  const ExpectSpec& e = s.expect;
  EXPECT_EQ(e.outcome, "fault:watchdog");
  EXPECT_THAT(e.final_joint_deg.value(), ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_EQ(e.tolerance_deg, 0.5);
  EXPECT_THAT(e.total_pulses.value(), ElementsAre(1, -2, 3, -4, 5, -6));
  EXPECT_THAT(e.final_error_counts.value(), ElementsAre(0, 0, 500, 0, 0, 0));
  EXPECT_THAT(e.move_ticks.value(), ElementsAre(100, 0));
  EXPECT_THAT(e.profile.value(), ElementsAre("none", "triangle", "trapezoid", "none", "none", "none"));
  EXPECT_THAT(e.peak_speed_deg_s.value(), ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_EQ(e.peak_tolerance_deg_s, 0.25);
  EXPECT_EQ(e.peak_pulses_per_tick, 200);
  EXPECT_EQ(e.underruns, std::nullopt);
  EXPECT_EQ(e.min_underruns, 4);
  EXPECT_EQ(e.refused_moves, 1);
  EXPECT_THAT(e.refusals.value(), ElementsAre("singular"));
  EXPECT_EQ(e.max_path_error_mm, 0.5);
  EXPECT_EQ(e.max_command_path_error_mm, 0.25);
  EXPECT_THAT(e.final_tcp_mm.value(), ElementsAre(1, 2, 3));
  EXPECT_EQ(e.tcp_tolerance_mm, 0.125);
  EXPECT_EQ(e.min_stretch, 2);
  EXPECT_EQ(e.max_stretch, 3);
  EXPECT_EQ(e.settled_within_s, 0.1);
  EXPECT_EQ(e.settled_counts, 3);
  EXPECT_EQ(e.max_overshoot_counts, 2);
  EXPECT_EQ(e.max_correction_pulses, 9);
  EXPECT_EQ(e.stopped_by, "watchdog");
  EXPECT_EQ(e.faults, (std::vector<std::string>{"estop", "watchdog"}));
  EXPECT_EQ(s.golden.sha256->substr(0, 4), "0123");
}

constexpr const char* kEveryPose = R"(
description = "every key of moves to poses"
robot = "vo2021_6r"
duration_s = 2
[tool]
xyz_mm = [1, 2, 3]
rpy_deg = [4, 5, 6]
[[frame]]
name = "table"
xyz_mm = [7, 8, 9]
rpy_deg = [10, 11, 12]
[[frame]]
name = "box"
[[move]]
at_s = 0.0
type = "joint"
xyz_mm = [400, 0, 300]
rpy_deg = [0, 90, 0]
profile = "scurve"
[[move]]
at_s = 0.1
type = "line"
xyz_mm = [1, 0, 0]
frame = "tool"
[[move]]
at_s = 0.2
type = "arc"
via_mm = [1, 2, 0]
xyz_mm = [3, 4, 0]
frame = "box"
speed_mm_s = 11
accel_mm_s2 = 12
jerk_mm_s3 = 13
turn_speed_deg_s = 14
turn_accel_deg_s2 = 15
turn_jerk_deg_s3 = 16
profile = "scurve"
blend_mm = 17
[[move]]
at_s = 0.3
type = "circle"
via_mm = [1, 2, 0]
xyz_mm = [3, 4, 0]
frame = "base"
[[move]]
at_s = 0.4
type = "hold"
[[move]]
at_s = 0.5
type = "resume"
[[move]]
at_s = 0.6
type = "override"
speed_percent = 30
)";

TEST(ScenarioLoader, ReadsMovesToPoses) {
  const TempFolder folder;
  const Scenario s = load_scenario(folder.write("poses/scenario.toml", kEveryPose), shipped());
  EXPECT_THAT(s.tool.xyz_mm, ElementsAre(1, 2, 3));
  EXPECT_THAT(s.tool.rpy_deg, ElementsAre(4, 5, 6));
  ASSERT_EQ(s.frames.size(), 2u);
  EXPECT_EQ(s.frames[0].name, "table");
  EXPECT_THAT(s.frames[0].pose.xyz_mm, ElementsAre(7, 8, 9));
  EXPECT_THAT(s.frames[0].pose.rpy_deg, ElementsAre(10, 11, 12));
  EXPECT_EQ(s.frames[1].name, "box");

  ASSERT_EQ(s.moves.size(), 7u);
  EXPECT_EQ(s.moves[0].type, MoveType::kJoint);
  EXPECT_FALSE(s.moves[0].target_deg);
  EXPECT_THAT(s.moves[0].xyz_mm.value(), ElementsAre(400, 0, 300));
  EXPECT_THAT(s.moves[0].rpy_deg.value(), ElementsAre(0, 90, 0));
  EXPECT_EQ(s.moves[0].frame, 0u);
  EXPECT_EQ(s.moves[0].profile, "scurve");

  EXPECT_EQ(s.moves[1].type, MoveType::kLine);
  EXPECT_EQ(s.moves[1].frame, kToolFrameIndex);
  EXPECT_FALSE(s.moves[1].rpy_deg);
  EXPECT_EQ(s.moves[1].profile, "trapezoid");
  EXPECT_EQ(s.moves[1].speed_mm_s, 100);
  EXPECT_EQ(s.moves[1].accel_mm_s2, 1000);
  EXPECT_EQ(s.moves[1].turn_speed_deg_s, 90);
  EXPECT_EQ(s.moves[1].turn_accel_deg_s2, 900);
  EXPECT_EQ(s.moves[1].blend_mm, 0);

  EXPECT_EQ(s.moves[2].type, MoveType::kArc);
  EXPECT_THAT(s.moves[2].via_mm, ElementsAre(1, 2, 0));
  EXPECT_EQ(s.moves[2].frame, 2u);
  EXPECT_EQ(s.moves[2].speed_mm_s, 11);
  EXPECT_EQ(s.moves[2].accel_mm_s2, 12);
  EXPECT_EQ(s.moves[2].jerk_mm_s3, 13);
  EXPECT_EQ(s.moves[2].turn_speed_deg_s, 14);
  EXPECT_EQ(s.moves[2].turn_accel_deg_s2, 15);
  EXPECT_EQ(s.moves[2].turn_jerk_deg_s3, 16);
  EXPECT_EQ(s.moves[2].blend_mm, 17);

  EXPECT_EQ(s.moves[3].type, MoveType::kCircle);
  EXPECT_EQ(s.moves[3].frame, 0u);
  EXPECT_EQ(s.moves[4].type, MoveType::kHold);
  EXPECT_EQ(s.moves[5].type, MoveType::kResume);
  EXPECT_EQ(s.moves[6].type, MoveType::kOverride);
  EXPECT_EQ(s.moves[6].speed_percent, 30);
}

TEST(ScenarioLoader, TakesOneNumberForEachOfFiveAxes) {
  const TempFolder folder;
  const Scenario s = load_scenario(folder.write("five/scenario.toml", R"(
description = "d"
robot = "hu2012_5r"
duration_s = 1
[[move]]
at_s = 0.1
type = "joint"
target_deg = [1, -2, 3, 4, 5]
[expect]
total_pulses = [1, 2, 3, 4, 5]
profile = ["none", "none", "none", "none", "scurve"]
)"),
                                   shipped());
  EXPECT_EQ(s.robot.axis_count, 5u);
  EXPECT_THAT(s.moves[0].target_deg.value(), ElementsAre(1, -2, 3, 4, 5, 0));
  EXPECT_THAT(s.expect.total_pulses.value(), ElementsAre(1, 2, 3, 4, 5, 0));
  EXPECT_EQ(s.expect.profile->size(), 5u);
}

TEST(ScenarioLoader, KeepsTheDefaultsOfWhatIsNotWritten) {
  const TempFolder folder;
  const Scenario s = load_scenario(
      folder.write("x/scenario.toml", "description = \"d\"\nrobot = \"vo2021_6r\"\nduration_s = 1\n"), shipped());
  EXPECT_EQ(s.seed, 1u);
  EXPECT_EQ(s.controller.sync, "fig9");
  EXPECT_TRUE(s.controller.feedback);
  EXPECT_EQ(s.trace.every_ticks, 20);
  EXPECT_TRUE(s.moves.empty());
  EXPECT_EQ(s.expect.outcome, std::nullopt);
  EXPECT_EQ(s.golden.sha256, std::nullopt);
}

TEST(ScenarioLoader, FindsAScenarioByFolderFileOrName) {
  EXPECT_EQ(load_scenario(kScenarios / "fig9_joint_move", shipped()).name, "fig9_joint_move");
  EXPECT_EQ(load_scenario(kScenarios / "fig9_joint_move/", shipped()).name, "fig9_joint_move");
  EXPECT_EQ(load_scenario(kScenarios / "fig9_joint_move/scenario.toml", shipped()).name, "fig9_joint_move");
  const Scenario by_name = load_scenario("fig9_joint_move", shipped());
  EXPECT_EQ(by_name.name, "fig9_joint_move");
  EXPECT_EQ(by_name.file, (kScenarios / "fig9_joint_move/scenario.toml").string());
  fs::current_path(kScenarios / "late_core");
  EXPECT_EQ(load_scenario("scenario.toml").name, "late_core");
  EXPECT_EQ(load_scenario(".").name, "late_core");
}

TEST(ScenarioLoader, SaysWhatIsMissingWhenAScenarioCannotBeFound) {
  EXPECT_THAT(error_of("fig9_jont_move"), HasSubstr("did you mean fig9_joint_move?"));
  EXPECT_EQ(error_of("/nowhere/at_all"), "/nowhere/at_all: no such file or folder");
  const TempFolder folder;
  EXPECT_THAT(error_of(folder.path()), HasSubstr("this folder holds no scenario.toml"));
}

TEST(ScenarioLoader, PrefersTheRobotsBesideTheScenario) {
  const TempFolder folder;
  const std::string robot = test::read_file(kScenarios / "robots/vo2021_6r.toml");
  std::string changed = robot;
  changed.replace(changed.find("gear_ratio = 50"), 15, "gear_ratio = 40");
  folder.write("robots/vo2021_6r.toml", changed);
  const fs::path file = folder.write("x/scenario.toml", "description = \"d\"\nrobot = \"vo2021_6r\"\nduration_s = 1\n");
  EXPECT_EQ(load_scenario(file, shipped()).robot.axes[0].gear_ratio, 40);

  std::string renamed = robot;
  renamed.replace(renamed.find("name = \"vo2021_6r\""), 18, "name = \"mine\"");
  folder.write("x/mine.toml", renamed);
  LoadOptions options = shipped();
  options.overrides = {"robot=mine.toml"};
  EXPECT_EQ(load_scenario(file, options).robot.axes[0].gear_ratio, 50);
  options.overrides = {"robot=puma"};
  EXPECT_THAT(error_of(file, options), HasSubstr("unknown robot \"puma\"; known: vo2021_6r, abb_irb120, "));
}

TEST(ScenarioLoader, ReadsEveryShippedScenario) {
  const std::vector<std::string> names = list_scenarios(kScenarios);
  EXPECT_THAT(names, testing::IsSupersetOf({"fig9_joint_move", "joint_there_and_back", "max_rate_4mpps",
                                            "zero_and_tiny_moves", "pulse_loss_recovered", "pulse_loss_open_loop",
                                            "late_core", "soft_limit_refused", "stop_on_path", "estop_and_clear"}));
  for (const std::string& name : names) {
    EXPECT_EQ(error_of(name), "");
  }
  EXPECT_TRUE(list_scenarios("/nowhere").empty());
}

TEST(ScenarioOverride, ChangesScalarsElementsAndWholeValues) {
  LoadOptions options = shipped();
  options.overrides = {"controller.feedback=false",
                       "controller.sync=const_acc",
                       "seed=7",
                       "move[0].target_deg[2]=12.5",
                       "bus={ latency_cycles = 9 }",
                       "description=\"quoted\"",
                       "expect.total_pulses=[1, 2, 3, 4, 5, 6]",
                       "move[0].at_s = 0.25"};
  // The last one has a blank around `=`; blanks are not part of a key.
  EXPECT_THAT(error_of("fig9_joint_move", options), HasSubstr("--set move[0].at_s = 0.25: expected key=value"));
  options.overrides.back() = "move[0].at_s=0.25";
  const Scenario s = load_scenario("fig9_joint_move", options);
  EXPECT_FALSE(s.controller.feedback);
  EXPECT_EQ(s.controller.sync, "const_acc");
  EXPECT_EQ(s.seed, 7u);
  EXPECT_EQ((*s.moves[0].target_deg)[2], 12.5);
  EXPECT_EQ(s.bus.latency_cycles, 9);
  EXPECT_EQ(s.description, "quoted");
  EXPECT_EQ(s.expect.total_pulses.value()[5], 6);
  EXPECT_EQ(s.moves[0].at_s, 0.25);
}

TEST(ScenarioOverride, NamesTheOverrideInEveryMessage) {
  const std::pair<const char*, const char*> cases[] = {
      {"controller.feedbak=1", "--set controller.feedbak=1: controller.feedbak: unknown key, did you mean feedback?"},
      {"contoller.feedback=true", "--set contoller.feedback=true: contoller: unknown key, did you mean controller?"},
      {"duration_s=-1", "--set duration_s=-1: duration_s: expected a number above 0 up to 86400 (s), found -1"},
      {"move[4].at_s=1", "--set move[4].at_s=1: move[4]: no such element, move has 1"},
      {"seed.x=1", "--set seed.x=1: seed: expected a table to set a key of, found 1"},
      {"seed", "--set seed: expected key=value with a dotted key, such as controller.feedback=false"},
      {"a b=1", "--set a b=1: expected key=value with a dotted key, such as controller.feedback=false"},
      {"move[x].at_s=1",
       "--set move[x].at_s=1: expected key=value with a dotted key, such as controller.feedback=false"},
      {"seed=1\nduration_s = 9",
       "--set seed=1\nduration_s = 9: seed: expected an integer of at least 0, found the string \"1\nduration_s = 9\""},
  };
  for (const auto& [assignment, message] : cases) {
    LoadOptions options = shipped();
    options.overrides = {assignment};
    EXPECT_EQ(error_of("fig9_joint_move", options), message);
  }
}

}  // namespace
}  // namespace armature::cosim
