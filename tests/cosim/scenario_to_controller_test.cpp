#include "cosim/scenario/to_controller.hpp"

#include <gtest/gtest.h>

#include <variant>

#include "cosim/scenario/robot_loader.hpp"

namespace armature::cosim {
namespace {

TEST(ToController, ConvertsEveryFieldOfAnAxis) {
  RobotSpec robot;
  AxisSpec& axis = robot.axes[4];
  axis.gear_ratio = -81.5;
  axis.pulses_per_rev = 8000;
  axis.encoder_lines = 1024;
  axis.min_deg = -90;
  axis.max_deg = 180;
  axis.max_speed_deg_s = 360;
  axis.max_accel_deg_s2 = 720;
  axis.following_error_deg = 4.5;
  axis.drive.natural_hz = 25;
  axis.drive.damping = 0.75;
  axis.drive.dir_setup_ns = 1000;
  axis.drive.dir_hold_ns = 1000.5;
  const AxisModel model = to_robot_model(robot).axes[4];
  constexpr double kPi = 3.14159265358979323846;
  EXPECT_EQ(model.gear_ratio, -81.5);
  EXPECT_EQ(model.pulses_per_rev, 8000);
  EXPECT_EQ(model.counts_per_rev, 4096);
  EXPECT_DOUBLE_EQ(model.min_rad, -kPi / 2);
  EXPECT_DOUBLE_EQ(model.max_rad, kPi);
  EXPECT_DOUBLE_EQ(model.max_speed_rad_s, 2 * kPi);
  EXPECT_DOUBLE_EQ(model.max_accel_rad_s2, 4 * kPi);
  EXPECT_DOUBLE_EQ(model.following_error_limit_rad, kPi / 40);
  EXPECT_DOUBLE_EQ(model.drive_natural_rad_s, 50 * kPi);
  EXPECT_EQ(model.drive_damping, 0.75);
  EXPECT_EQ(model.dir_setup_cycles, 50);
  EXPECT_EQ(model.dir_hold_cycles, 51);
}

TEST(ToController, NamesEverySynchronisationRule) {
  EXPECT_EQ(to_controller_config({.sync = "fig9", .feedback = true}).sync, SyncRule::kFig9);
  EXPECT_EQ(to_controller_config({.sync = "const_acc", .feedback = true}).sync, SyncRule::kConstAcc);
  EXPECT_EQ(to_controller_config({.sync = "time_scale", .feedback = true}).sync, SyncRule::kTimeScale);
  EXPECT_TRUE(to_controller_config({.sync = "fig9", .feedback = true}).feedback);
  EXPECT_FALSE(to_controller_config({.sync = "fig9", .feedback = false}).feedback);
}

TEST(ToController, ConvertsEveryKindOfMove) {
  MoveSpec move;
  move.target_deg = PerAxis<double>{90, 0, 0, 0, 0, -180};
  move.speed_percent = 25;
  const auto joint = std::get<JointMove>(to_command(move));
  EXPECT_DOUBLE_EQ(joint.target[0].value(), 1.57079632679489661923);
  EXPECT_DOUBLE_EQ(joint.target[5].value(), -3.14159265358979323846);
  EXPECT_EQ(joint.speed, 0.25);
  move.type = MoveType::kStop;
  EXPECT_TRUE(std::holds_alternative<Stop>(to_command(move)));
  move.type = MoveType::kClearFault;
  EXPECT_TRUE(std::holds_alternative<ClearFault>(to_command(move)));
}

}  // namespace
}  // namespace armature::cosim
