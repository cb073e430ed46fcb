#include "cosim/scenario/robot_loader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/cosim/temp_folder.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

const fs::path kRobots = fs::path{ARMATURE_SOURCE_DIR} / "scenarios/robots";

TEST(RobotLoader, ReadsTheArmOfTheFigure) {
  const RobotSpec robot = load_robot(kRobots / "vo2021_6r.toml");
  EXPECT_EQ(robot.name, "vo2021_6r");
  constexpr PerAxis<double> kFigure9Deg{80.4, -60.0, 50.0, 17.4, -17.4, 70.0};
  for (std::size_t i = 0; i < kAxes; ++i) {
    const AxisSpec& axis = robot.axes[i];
    EXPECT_EQ(axis.gear_ratio, 50);
    EXPECT_EQ(axis.pulses_per_rev, 10000);
    EXPECT_EQ(axis.encoder_lines * kCountsPerLine, 10000);
    EXPECT_EQ(axis.max_speed_deg_s, 120);
    EXPECT_EQ(axis.max_accel_deg_s2, i == 5 ? 660 : 600);
    EXPECT_LT(axis.min_deg, kFigure9Deg[i]);
    EXPECT_GT(axis.max_deg, kFigure9Deg[i]);
  }
}

TEST(RobotLoader, ReadsAnArmWhoseFullSpeedIsExactlyTheFullPulseRate) {
  for (const AxisSpec& axis : load_robot(kRobots / "vo2021_6r_131072.toml").axes) {
    EXPECT_EQ(axis.max_speed_deg_s * axis.gear_ratio * axis.pulses_per_rev / 360.0, 4e6);
    EXPECT_EQ(axis.encoder_lines * kCountsPerLine, axis.pulses_per_rev);
    EXPECT_EQ(axis.max_speed_deg_s / axis.max_accel_deg_s2, 0.1);
  }
}

TEST(RobotLoader, AxesInheritSingleKeysOfDefaultsAndOfTheirDrive) {
  const test::TempFolder folder;
  const fs::path file = folder.write("r.toml", R"(name = "r"
[defaults]
gear_ratio = 50
pulses_per_rev = 10_000
encoder_lines = 2500
min_deg = -90
max_deg = 90
max_speed_deg_s = 100
max_accel_deg_s2 = 500
[defaults.drive]
natural_hz = 60
damping = 0.8
[[axis]]
[[axis]]
gear_ratio = -30.5
[axis.drive]
damping = 1
[[axis]]
[[axis]]
[[axis]]
[[axis]]
)");
  const RobotSpec robot = load_robot(file);
  EXPECT_EQ(robot.axes[0].gear_ratio, 50);
  EXPECT_EQ(robot.axes[0].drive.natural_hz, 60);
  EXPECT_EQ(robot.axes[0].drive.damping, 0.8);
  EXPECT_EQ(robot.axes[0].drive.max_speed_rpm, DriveSpec{}.max_speed_rpm);
  EXPECT_EQ(robot.axes[0].following_error_deg, AxisSpec{}.following_error_deg);
  EXPECT_EQ(robot.axes[1].gear_ratio, -30.5);
  EXPECT_EQ(robot.axes[1].pulses_per_rev, 10000);
  EXPECT_EQ(robot.axes[1].drive.natural_hz, 60);
  EXPECT_EQ(robot.axes[1].drive.damping, 1);
  EXPECT_EQ(robot.axes[2].drive.damping, 0.8);
}

TEST(RobotLoader, NamesAFileThatCannotBeRead) {
  try {
    (void)load_robot("/nowhere/r.toml");
    FAIL() << "no exception";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "/nowhere/r.toml: cannot open: No such file or directory");
  }
}

TEST(RobotLoader, ListsTheRobotsOfAFolder) {
  EXPECT_THAT(list_robots(kRobots), testing::IsSupersetOf({"vo2021_6r", "vo2021_6r_131072"}));
  EXPECT_TRUE(list_robots("/nowhere").empty());
}

}  // namespace
}  // namespace armature::cosim
