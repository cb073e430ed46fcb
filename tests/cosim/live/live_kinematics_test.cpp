#include "cosim/live/live_kinematics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "controller/base/angle_units.hpp"
#include "cosim/scenario/files/scenario_loader.hpp"

namespace armature::cosim {
namespace {

using testing::HasSubstr;

Scenario scenario_of(const std::string& name) {
  const std::filesystem::path scenarios = ARMATURE_SOURCE_DIR "/scenarios";
  return load_scenario(scenarios / name, {.search_path = scenarios});
}

JointAngles angles(const Scenario& scenario, const Json& deg) {
  JointAngles joints{};
  for (std::size_t i = 0; i < scenario.robot.axis_count; ++i) joints[i] = Radians{deg[i].get<double>() * kRadPerDeg};
  return joints;
}

Eigen::Vector3d vector(const Json& numbers) {
  return {numbers[0].get<double>(), numbers[1].get<double>(), numbers[2].get<double>()};
}

// Joint angles, then the place of the hand, then back: as the sliders of Hu 2012, Figure 4, in both directions.
void expect_directions_agree(const std::string& name, std::size_t solutions, bool with_orientation) {
  const Scenario scenario = scenario_of(name);
  const LiveKinematics kinematics{scenario};
  std::mt19937 random{7};
  std::size_t most = 0;
  for (int draw = 0; draw < 200; ++draw) {
    Json deg = Json::array();
    for (std::size_t i = 0; i < scenario.robot.axis_count; ++i) {
      const AxisSpec& axis = scenario.robot.axes.at(i);
      const double share = 0.05 + 0.9 * static_cast<double>(random() % 10'000) / 1e4;
      deg.push_back(axis.min_deg + share * (axis.max_deg - axis.min_deg));
    }
    const JointAngles joints = angles(scenario, deg);
    const Json there = kinematics.forward(joints);
    LiveKinematics::Wish wish{.xyz_mm = vector(there["xyz_mm"]), .from = joints};
    if (with_orientation) wish.rpy_deg = vector(there["rpy_deg"]);
    const Json answer = kinematics.inverse(wish);
    ASSERT_TRUE(answer["why_not"].is_null()) << "draw " << draw << ": " << answer << deg;
    const Json& chosen = answer["solutions"][answer["selected"].get<std::size_t>()];
    for (std::size_t i = 0; i < scenario.robot.axis_count; ++i) {
      EXPECT_NEAR(chosen["joints_deg"][i].get<double>(), deg[i].get<double>(), 1e-5)
          << "draw " << draw << ", joint " << i;
    }
    for (const Json& one : answer["solutions"]) {
      const Json again = kinematics.forward(angles(scenario, one["joints_deg"]));
      EXPECT_LT((vector(again["xyz_mm"]) - wish.xyz_mm).norm(), 1e-6) << "draw " << draw;
    }
    most = std::max(most, answer["solutions"].size());
  }
  EXPECT_EQ(most, solutions);
}

TEST(LiveKinematics, BothDirectionsAgreeForFiveAxesWithFourSolutions) {
  expect_directions_agree("arm_5r_pick_place", 4, false);
}

TEST(LiveKinematics, BothDirectionsAgreeForSixAxesWithEightSolutions) {
  expect_directions_agree("pendant_jog", 8, true);
}

TEST(LiveKinematics, TheHandOfFiveAxesTurnsWithThePlaneOfTheArm) {
  const Scenario scenario = scenario_of("arm_5r_pick_place");
  const LiveKinematics kinematics{scenario};
  const JointAngles from = angles(scenario, Json::array({0, 30, 40, 20, 10}));
  const Eigen::Vector3d here = vector(kinematics.forward(from)["xyz_mm"]);
  const double turn = 25 * kRadPerDeg;
  const Eigen::Vector3d there{std::cos(turn) * here.x() - std::sin(turn) * here.y(),
                              std::sin(turn) * here.x() + std::cos(turn) * here.y(), here.z()};
  const Json answer = kinematics.inverse({.xyz_mm = there, .from = from});
  ASSERT_TRUE(answer["why_not"].is_null()) << answer;
  const Json& chosen = answer["solutions"][answer["selected"].get<std::size_t>()]["joints_deg"];
  // Only joint 1, about the vertical, has to turn.
  EXPECT_NEAR(std::fabs(chosen[0].get<double>()), 25, 1e-6);
  const double others[] = {30, 40, 20, 10};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(chosen[i + 1].get<double>(), others[i], 1e-6) << i;
}

TEST(LiveKinematics, SaysInWordsWhyAPlaceCannotBeReached) {
  const Scenario scenario = scenario_of("arm_5r_pick_place");
  const LiveKinematics kinematics{scenario};
  const JointAngles from = angles(scenario, Json::array({0, 30, 40, 20, 10}));
  const Json far = kinematics.inverse({.xyz_mm = {3'000, 0, 0}, .from = from});
  EXPECT_TRUE(far["selected"].is_null());
  EXPECT_THAT(far["why_not"].get<std::string>(), HasSubstr("out of reach by"));
  const Json twisted =
      kinematics.inverse({.xyz_mm = {200, 0, -100}, .rpy_deg = Eigen::Vector3d{60, 0, 50}, .from = from});
  EXPECT_THAT(twisted["why_not"].get<std::string>(), HasSubstr("five joints cannot"));
}

}  // namespace
}  // namespace armature::cosim
