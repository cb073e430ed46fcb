#include "cosim/scenario/files/robot_loader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "cosim/text/text_file.hpp"
#include "tests/cosim/support/temp_folder.hpp"

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

TEST(RobotLoader, AnArmWithoutPublishedGearsAndMotorsHasThoseOfTheIdealPlant) {
  const std::string axes = R"(
[defaults]
min_deg = -90
max_deg = 90
max_speed_deg_s = 500
max_accel_deg_s2 = 5000
[[axis]]
gear_ratio = -30
[axis.drive]
max_speed_rpm = 2500
[[axis]]
[[axis]]
[[axis]]
[[axis]]
[[axis]]
)";
  const test::TempFolder folder;
  const RobotSpec robot = load_robot(folder.write("r.toml", "name = \"r\"\nplant = \"ideal\"" + axes));
  EXPECT_EQ(robot.axes[0].gear_ratio, -30);
  EXPECT_EQ(robot.axes[0].drive.max_speed_rpm, 2500);
  EXPECT_EQ(robot.axes[1].gear_ratio, 100);
  EXPECT_EQ(robot.axes[1].pulses_per_rev, 10'000);
  EXPECT_EQ(robot.axes[1].encoder_lines, 2500);
  EXPECT_EQ(robot.axes[5].drive.max_speed_rpm, 100'000);
  EXPECT_EQ(robot.axes[5].drive.max_torque_nm, 10'000);
  // KEYS.md tells these numbers.
  const std::string keys = read_text_file(kRobots / "KEYS.md");
  EXPECT_THAT(keys,
              testing::HasSubstr("Their defaults are 100, 10000 and 2500, and those of the drive are `natural_hz` = "
                                 "200, `max_speed_rpm` = 100000 and `max_torque_nm` = 10000"));
  std::vector<Problem> problems;
  static_cast<void>(load_robot(folder.write("r.toml", "name = \"r\"" + axes), problems));
  ASSERT_EQ(problems.size(), 7U);
  EXPECT_EQ(problems[0].key, "defaults.pulses_per_rev");
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

TEST(RobotLoader, ReadsTheDimensionsOfASixAxisArm) {
  const RobotSpec robot = load_robot(kRobots / "kuka_kr6_r900.toml");
  ASSERT_TRUE(robot.kinematics);
  const KinematicsSpec& arm = *robot.kinematics;
  EXPECT_EQ(robot.axis_count, 6);
  EXPECT_EQ(arm.family, "six_r");
  EXPECT_EQ((std::array{arm.a1_mm, arm.a2_mm, arm.a3_mm, arm.a4_mm}), (std::array{25.0, 455.0, 35.0, 0.0}));
  EXPECT_EQ((std::array{arm.d1_mm, arm.d4_mm, arm.d5_mm, arm.d6_mm}), (std::array{400.0, 420.0, 0.0, 80.0}));
  EXPECT_EQ(arm.sign, (PerAxis<double>{-1, -1, -1, -1, -1, -1}));
  EXPECT_EQ(arm.offset_deg, (PerAxis<double>{0, 0, 90, 0, 0, 180}));
}

TEST(RobotLoader, ReadsTheDimensionsOfAFiveAxisArm) {
  const RobotSpec robot = load_robot(kRobots / "hu2012_5r.toml");
  ASSERT_TRUE(robot.kinematics);
  const KinematicsSpec& arm = *robot.kinematics;
  EXPECT_EQ(robot.axis_count, 5);
  EXPECT_EQ(arm.family, "five_r");
  // Table 1 in mm.
  EXPECT_EQ((std::array{arm.a1_mm, arm.a2_mm, arm.a3_mm, arm.a4_mm}), (std::array{11.0, 100.0, 95.0, 32.0}));
  EXPECT_EQ((std::array{arm.d1_mm, arm.d4_mm, arm.d5_mm, arm.d6_mm}), (std::array{0.0, 0.0, 145.0, 0.0}));
  EXPECT_EQ(arm.max_projection_deg, 0.01);
}

TEST(RobotLoader, AnAxisThatTheArmHasNotIsACopyOfTheLast) {
  const RobotSpec robot = load_robot(kRobots / "hu2012_5r.toml");
  EXPECT_EQ(robot.axes[4].max_deg, 180);
  EXPECT_EQ(robot.axes[5].max_deg, 180);
  EXPECT_EQ(robot.axes[5].gear_ratio, robot.axes[4].gear_ratio);
  EXPECT_EQ(robot.axes[5].max_speed_deg_s, robot.axes[4].max_speed_deg_s);
}

TEST(RobotLoader, KinematicsAndJerkAreOptional) {
  const test::TempFolder folder;
  const std::string axes = R"([defaults]
gear_ratio = 50
pulses_per_rev = 10_000
encoder_lines = 2500
min_deg = -90
max_deg = 90
max_speed_deg_s = 100
max_accel_deg_s2 = 500
[[axis]]
[[axis]]
[[axis]]
max_jerk_deg_s3 = 4000
[[axis]]
[[axis]]
[[axis]]
)";
  const RobotSpec robot = load_robot(folder.write("r.toml", "name = \"r\"\n" + axes));
  EXPECT_FALSE(robot.kinematics);
  EXPECT_EQ(robot.axis_count, 6);
  EXPECT_FALSE(robot.axes[0].max_jerk_deg_s3);
  EXPECT_EQ(robot.axes[2].max_jerk_deg_s3, 4000);
}

TEST(RobotLoader, EveryRobotOfTheProjectCanDoWhatTheCommandsOffer) {
  for (const std::string& name : list_robots(kRobots)) {
    SCOPED_TRACE(name);
    const RobotSpec robot = load_robot(kRobots / (name + ".toml"));
    EXPECT_TRUE(robot.kinematics);
    for (const AxisSpec& axis : robot.axes) EXPECT_TRUE(axis.max_jerk_deg_s3);
    for (const AxisSpec& axis : robot.axes) EXPECT_TRUE(axis.min_deg <= 0 && axis.max_deg >= 0) << "runs begin at 0";
  }
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
  EXPECT_THAT(list_robots(kRobots), testing::IsSupersetOf({"abb_irb120", "fanuc_lrmate200id", "hu2012_5r",
                                                           "kuka_kr6_r900", "vo2021_6r", "vo2021_6r_131072"}));
  EXPECT_TRUE(list_robots("/nowhere").empty());
}

}  // namespace
}  // namespace armature::cosim
