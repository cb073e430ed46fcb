// Robot files as the controller gets them.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "controller/robot/axis_units.hpp"
#include "cosim/scenario/files/robot_loader.hpp"
#include "cosim/scenario/to_controller.hpp"

namespace armature::cosim {
namespace {

const std::filesystem::path kRobotFolder = std::filesystem::path{ARMATURE_SOURCE_DIR} / "scenarios/robots";

TEST(RobotModelOfFile, HasTheHomingOfEachAxisWithTheDefaults) {
  const RobotModel model = to_robot_model(load_robot(kRobotFolder / "vo2021_6r.toml"));
  constexpr double kRad = std::numbers::pi / 180;
  ASSERT_TRUE(model.axes[0].homing && model.axes[2].homing);
  EXPECT_EQ(model.axes[0].homing->order, 2);
  EXPECT_EQ(model.axes[0].homing->direction, -1.0);
  EXPECT_DOUBLE_EQ(model.axes[0].homing->search_rad_s, 60 * kRad);
  EXPECT_DOUBLE_EQ(model.axes[0].homing->latch_rad_s, 20 * kRad);
  EXPECT_EQ(model.axes[2].homing->order, 1);
  EXPECT_EQ(model.axes[2].homing->direction, 1.0);
  EXPECT_DOUBLE_EQ(model.axes[2].homing->index_rad, 21.6 * kRad);
  EXPECT_DOUBLE_EQ(model.axes[2].homing->home_rad, 20 * kRad);
  EXPECT_FALSE(to_robot_model(load_robot(kRobotFolder / "abb_irb120.toml")).axes[0].homing);
}

TEST(RobotModelOfFile, HasTheGeometryInRadians) {
  const RobotModel model = to_robot_model(load_robot(kRobotFolder / "abb_irb120.toml"));
  EXPECT_EQ(model.axis_count, 6);
  EXPECT_EQ(model.arm.family, ArmFamily::kSixR);
  EXPECT_EQ(model.arm.a2_mm, 270);
  EXPECT_EQ(model.arm.a3_mm, 70);
  EXPECT_EQ(model.arm.d1_mm, 290);
  EXPECT_EQ(model.arm.d4_mm, 302);
  EXPECT_EQ(model.arm.d6_mm, 72);
  EXPECT_EQ(model.arm.a1_mm, 0);
  EXPECT_EQ(model.arm.sign, (PerAxis<double>{1, -1, -1, 1, -1, 1}));
  EXPECT_EQ(model.arm.offset_rad, (PerAxis<double>{0, std::numbers::pi / 2, 0, 0, 0, std::numbers::pi}));
  EXPECT_DOUBLE_EQ(model.axes[0].max_jerk_rad_s3, 10'000 * std::numbers::pi / 180);
}

TEST(RobotModelOfFile, HasTheFiveAxisArmAndItsProjection) {
  const RobotModel model = to_robot_model(load_robot(kRobotFolder / "hu2012_5r.toml"));
  EXPECT_EQ(model.axis_count, 5);
  EXPECT_EQ(model.arm.family, ArmFamily::kFiveR);
  EXPECT_EQ(model.arm.a1_mm, 11);
  EXPECT_EQ(model.arm.a2_mm, 100);
  EXPECT_EQ(model.arm.a3_mm, 95);
  EXPECT_EQ(model.arm.a4_mm, 32);
  EXPECT_EQ(model.arm.d5_mm, 145);
  EXPECT_DOUBLE_EQ(model.arm.max_projection_rad, 0.01 * std::numbers::pi / 180);
}

TEST(RobotModelOfFile, AnAxisThatTheArmHasNotMayOnlyStandStillAndConvertsToFiniteNumbers) {
  const AxisModel axis = to_robot_model(load_robot(kRobotFolder / "hu2012_5r.toml")).axes[5];
  EXPECT_EQ(axis.min_rad, 0);
  EXPECT_EQ(axis.max_rad, 0);
  EXPECT_GT(axis.max_speed_rad_s, 0) << "times are divided by it";
  const AxisUnits units{axis};
  EXPECT_EQ(units.to_pulses(Radians{0}), Pulses{0});
  EXPECT_GT(units.max_pulses_per_tick(), 0);
  EXPECT_TRUE(std::isfinite(units.pulses_per_count()));
}

TEST(RobotModelOfFile, WithoutKinematicsThereIsNoFamilyAndWithoutJerkNone) {
  RobotSpec spec = load_robot(kRobotFolder / "abb_irb120.toml");
  spec.kinematics.reset();
  spec.axes[3].max_jerk_deg_s3.reset();
  const RobotModel model = to_robot_model(spec);
  EXPECT_EQ(model.arm.family, ArmFamily::kNone);
  EXPECT_EQ(model.axes[3].max_jerk_rad_s3, 0);
}

}  // namespace
}  // namespace armature::cosim
