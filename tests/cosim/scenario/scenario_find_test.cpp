// Where scenarios and robots are found.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "cosim/scenario/files/robot_loader.hpp"
#include "cosim/scenario/files/scenario_loader.hpp"
#include "tests/cosim/support/scenario_files.hpp"
#include "tests/cosim/support/temp_folder.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;
using test::error_of;
using test::kScenarios;
using test::shipped;
using test::TempFolder;
using testing::HasSubstr;

constexpr const char* kNod = "description = \"d\"\nrobot = \"vo2021_6r\"\nduration_s = 1\n";

SearchPath path_of(const std::vector<fs::path>& folders) {
  SearchPath path;
  for (const fs::path& folder : folders) path.add({.path = folder});
  return path;
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
  EXPECT_THAT(error_of(folder.path()), HasSubstr("this folder has no scenario.toml"));
  folder.write("nod/scenario.toml", kNod);
  folder.write("bow/scenario.toml", kNod);
  EXPECT_THAT(error_of(folder.path()), HasSubstr("this folder has no scenario.toml; scenarios in it: bow, nod"));
}

TEST(ScenarioLoader, TakesTheFirstFolderOfTheSearchPathThatHasTheName) {
  const TempFolder folder;
  folder.write("one/nod/scenario.toml", kNod);
  folder.write("two/nod/scenario.toml", kNod);
  folder.write("two/bow/scenario.toml", kNod);
  const LoadOptions options{.search_path = path_of({folder.path() / "one", folder.path() / "two", kScenarios})};
  EXPECT_EQ(load_scenario("nod", options).file, (folder.path() / "one/nod/scenario.toml").string());
  EXPECT_EQ(load_scenario("bow", options).file, (folder.path() / "two/bow/scenario.toml").string());
  EXPECT_EQ(load_scenario("late_core", options).name, "late_core");
  EXPECT_THAT(options.search_path.scenario_names(), testing::IsSupersetOf({"nod", "bow", "late_core"}));
  const std::string searched =
      (folder.path() / "one").string() + ", " + (folder.path() / "two").string() + ", " + kScenarios.string();
  EXPECT_EQ(error_of("bwo", options), "bwo: no such scenario, did you mean bow? (searched: " + searched + ")");
  EXPECT_EQ(error_of("x/nod", options), "x/nod: no such file or folder") << "a path, not a name";
}

TEST(ScenarioLoader, AFolderOfResultsDoesNotHideTheScenarioOfItsName) {
  const TempFolder folder;
  folder.write("late_core/trace.csv", "");
  fs::current_path(folder.path());
  EXPECT_EQ(load_scenario("late_core", shipped()).file, (kScenarios / "late_core/scenario.toml").string());
}

TEST(ScenarioLoader, FindsARobotOnTheSearchPath) {
  const TempFolder folder;
  std::string robot = test::read_file(kScenarios / "robots/vo2021_6r.toml");
  robot.replace(robot.find("gear_ratio = 50"), 15, "gear_ratio = 40");
  folder.write("two/robots/vo2021_6r.toml", robot);
  const fs::path file = folder.write("s/nod/scenario.toml", kNod);
  LoadOptions options{.search_path = path_of({folder.path() / "one", folder.path() / "two", kScenarios})};
  EXPECT_EQ(load_scenario(file, options).robot.axes[0].gear_ratio, 40);
  EXPECT_EQ(find_robot("vo2021_6r", options.search_path).axes[0].gear_ratio, 40);
  EXPECT_EQ(find_robot("abb_irb120", options.search_path).name, "abb_irb120");
  EXPECT_THROW((void)find_robot("abb_irb121", options.search_path), InputError);
}

TEST(ScenarioLoader, AFolderOfScenariosMeansAllOfThem) {
  const TempFolder folder;
  const fs::path bow = folder.write("bow/scenario.toml", kNod);
  const fs::path nod = folder.write("nod/scenario.toml", kNod);
  folder.write("nod/part/scenario.toml", kNod);
  folder.write("robots/README.md", "");
  EXPECT_EQ(find_scenario_files(folder.path(), {}), (std::vector{bow, nod}));
  EXPECT_EQ(find_scenario_files(folder.path() / "nod", {}), (std::vector{nod})) << "a scenario, not a folder of them";
  EXPECT_EQ(find_scenario_files("nod", SearchPath{folder.path()}), (std::vector{nod}));
  EXPECT_THROW((void)find_scenario_files(folder.path() / "robots", {}), InputError);
}

TEST(SearchPath, SearchesAFolderOnceWhateverItIsCalled) {
  const TempFolder folder;
  folder.write("s/nod/scenario.toml", kNod);
  fs::create_directory_symlink(folder.path() / "s", folder.path() / "link");
  const SearchPath path = path_of({folder.path() / "s", folder.path() / "link", folder.path() / "s/nod/.."});
  ASSERT_EQ(path.folders().size(), 1);
  EXPECT_EQ(path.searched(), (folder.path() / "s").string());
}

TEST(SearchPath, TellsTheScenariosOfTheUserFromThoseOfTheProgram) {
  const TempFolder folder;
  const fs::path nod = folder.write("own/nod/scenario.toml", kNod);
  folder.write("program/nod/scenario.toml", kNod);
  const fs::path bow = folder.write("program/bow/scenario.toml", kNod);
  SearchPath path{folder.path() / "own"};
  path.add({.path = folder.path() / "program", .own = false});
  EXPECT_EQ(path.scenarios(true), (std::vector{nod}));
  EXPECT_EQ(path.scenarios(false), (std::vector{bow})) << "no name finds the other one";
}

TEST(ScenarioLoader, PrefersTheRobotsBesideTheScenario) {
  const TempFolder folder;
  const std::string robot = test::read_file(kScenarios / "robots/vo2021_6r.toml");
  std::string changed = robot;
  changed.replace(changed.find("gear_ratio = 50"), 15, "gear_ratio = 40");
  folder.write("robots/vo2021_6r.toml", changed);
  const fs::path file = folder.write("x/scenario.toml", kNod);
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
