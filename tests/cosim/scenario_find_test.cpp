// Where scenarios and robots are found.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "cosim/scenario/scenario_loader.hpp"
#include "tests/cosim/scenario_files.hpp"
#include "tests/cosim/temp_folder.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;
using test::error_of;
using test::kScenarios;
using test::shipped;
using test::TempFolder;
using testing::HasSubstr;

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

}  // namespace
}  // namespace armature::cosim
