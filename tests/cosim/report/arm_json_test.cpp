#include "cosim/report/format/json/arm_json.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <string>

#include "controller/base/angle_units.hpp"
#include "controller/kinematics/arm.hpp"
#include "cosim/scenario/to_controller.hpp"

namespace armature::cosim {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

RobotSpec robot_of(std::string_view family, std::size_t axis_count) {
  RobotSpec robot;
  robot.axis_count = axis_count;
  robot.kinematics = KinematicsSpec{.family = std::string{family},
                                    .a1_mm = 50,
                                    .a2_mm = 280,
                                    .a3_mm = 35,
                                    .a4_mm = 20,
                                    .d1_mm = 330,
                                    .d4_mm = 300,
                                    .d5_mm = 90,
                                    .d6_mm = 80};
  robot.kinematics->sign = {1, -1, 1, 1, -1, 1};
  robot.kinematics->offset_deg = {0, 90, -20, 0, 0, 30};
  return robot;
}

// The flange by the links, as their description in RESULTS.md reads.
Isometry3d flange(const Json& links, const std::vector<double>& joints_deg) {
  Isometry3d pose = Isometry3d::Identity();
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Json& link = links[i];
    const double theta_deg = link["sign"].get<double>() * joints_deg[i] + link["offset_deg"].get<double>();
    pose = pose * AngleAxisd{theta_deg * kRadPerDeg, Vector3d::UnitZ()} *
           Translation3d{link["a_mm"].get<double>(), 0, link["d_mm"].get<double>()} *
           AngleAxisd{link["alpha_deg"].get<double>() * kRadPerDeg, Vector3d::UnitX()};
  }
  return pose;
}

TEST(ArmJson, TheLinksGiveTheFlangeOfTheController) {
  const std::vector<double> joints_deg{12, -34, 56, -78, 90, 21};
  for (const auto& [family, axes] : {std::pair{kSixRFamily, 6U}, std::pair{kFiveRFamily, 5U}}) {
    const RobotSpec robot = robot_of(family, axes);
    const Json arm = arm_json(robot, {});
    ASSERT_EQ(arm["links"].size(), axes);
    JointAngles joints{};
    for (std::size_t i = 0; i < axes; ++i) joints[i] = Radians{joints_deg[i] * kRadPerDeg};
    const Transform wanted = Arm{to_robot_model(robot)}.forward(joints);
    const Isometry3d got = flange(arm["links"], joints_deg);
    EXPECT_LT((got.translation() - wanted.position_mm).norm(), 1e-9) << family;
    EXPECT_LT((got.rotation() - wanted.rotation).norm(), 1e-12) << family;
  }
}

TEST(ArmJson, ARobotWithoutKinematicsHasLimitsOnly) {
  RobotSpec robot;
  robot.axes[2].max_deg = 77;
  const Json arm = arm_json(robot, {});
  EXPECT_TRUE(arm["links"].is_null());
  EXPECT_TRUE(arm["tool"].is_null());
  EXPECT_EQ(arm["axes"][2]["max_deg"], 77);
  EXPECT_TRUE(arm["axes"][2]["max_jerk_deg_s3"].is_null());
}

TEST(ArmJson, SaysHowLongTheDrivesRespond) {
  RobotSpec robot;
  for (AxisSpec& axis : robot.axes) axis.drive = {.natural_hz = 50, .damping = 1};
  const auto ticks = arm_json(robot, {})["memory_ticks"].get<double>();
  const double wn_t = 2 * std::numbers::pi * 50 * ticks * 50e-6;  // of a critically damped drive
  EXPECT_LT((1 + wn_t) * std::exp(-wn_t), 2e-6);
  EXPECT_GT((1 + wn_t) * std::exp(-wn_t), 2e-7);
}

}  // namespace
}  // namespace armature::cosim
