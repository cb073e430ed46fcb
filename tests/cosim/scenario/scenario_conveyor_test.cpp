// [conveyor], the motion of its belt, and what the controller gets.
#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "controller/message/command.hpp"
#include "cosim/belt/belt_motion.hpp"
#include "cosim/scenario/to_controller.hpp"
#include "tests/cosim/support/scenario_files.hpp"

namespace armature::cosim {
namespace {

TEST(ScenarioConveyor, ReadsTheBeltAndItsFrame) {
  const test::TempFolder folder;
  const Scenario scenario = load_scenario(folder.write("s/scenario.toml", R"(description = "test"
robot = "abb_irb120"
duration_s = 3
[conveyor]
xyz_mm = [400, -200, 100]
direction = [0, 2, 0]
window_mm = [10, 300]
part_s = [0.5, 1]
lead_ms = 5
speed_mm_s = 50
[[conveyor.speed]]
at_s = 2
speed_mm_s = 0
[[move]]
at_s = 0
type = "line"
xyz_mm = [0, 0, 10]
frame = "conveyor"
)"),
                                          test::shipped());
  const ControllerConfig config = to_controller_config(scenario);
  ASSERT_TRUE(config.conveyor);
  EXPECT_EQ(config.conveyor->direction, Eigen::Vector3d::UnitY());
  EXPECT_EQ(config.conveyor->base_T_part.position_mm, Eigen::Vector3d(400, -200, 100));
  EXPECT_EQ(config.conveyor->from_mm, 10);
  EXPECT_EQ(config.conveyor->to_mm, 300);
  EXPECT_DOUBLE_EQ(config.conveyor->lead_s, 0.005);
  EXPECT_EQ(std::get<CartesianMove>(to_command(scenario.moves[0])).target.frame, kConveyorFrame);
}

TEST(ScenarioConveyor, TheControllerGetsTheTimesOfACameraInTicks) {
  const test::TempFolder folder;
  const Scenario scenario = load_scenario(folder.write("s/scenario.toml", R"(description = "test"
robot = "abb_irb120"
duration_s = 3
[conveyor]
xyz_mm = [400, -200, 100]
window_mm = [10, 300]
[conveyor.camera]
period_ms = 33.33
dead_time_ms = 60
[[conveyor.speed]]
at_s = 1
speed_mm_s = -80
)"),
                                          test::shipped());
  const std::optional<BeltCamera> camera = to_controller_config(scenario).conveyor->camera;
  ASSERT_TRUE(camera);
  EXPECT_EQ(camera->period, Ticks{667});
  EXPECT_EQ(camera->dead_time, Ticks{1'200});
  EXPECT_EQ(scenario.conveyor->camera->noise_mm, 0.2);
  const BeltMotion belt{*scenario.conveyor};
  EXPECT_NEAR(belt.position_mm(3) - belt.position_mm(2), -80, 1e-9);
}

constexpr const char* kWithPolicy = R"(description = "test"
robot = "abb_irb120"
duration_s = 3
[conveyor]
xyz_mm = [400, -200, 100]
window_mm = [10, 300]
[conveyor.policy]
file = "a.policy"
on = "arm"
percent = 50
)";

TEST(ScenarioConveyor, TheControllerGetsTheNetworkOfTheFile) {
  const test::TempFolder folder;
  std::string network = "full_mm 0.5\ncrc 0000000f\nimage 00000007\n";
  for (int i = 0; i < 10; ++i) network += "input -1 2\n";
  folder.write("s/a.policy", network);
  const Scenario scenario = load_scenario(folder.write("s/scenario.toml", kWithPolicy), test::shipped());
  const std::optional<BeltPolicyConfig> policy = to_controller_config(scenario).conveyor->policy;
  ASSERT_TRUE(policy);
  EXPECT_EQ(policy->where, BeltPolicyConfig::Where::kArm);
  EXPECT_EQ(policy->share, 63);  // never more than the half
  EXPECT_EQ(policy->full_mm, 0.5);
  EXPECT_EQ(policy->image[0], 7u);
  EXPECT_EQ(scenario.sources.size(), 3u);
}

TEST(ScenarioConveyor, ANetworkThatIsMissingIsAProblem) {
  const test::TempFolder folder;
  EXPECT_THROW((void)load_scenario(folder.write("s/scenario.toml", kWithPolicy), test::shipped()), InputError);
}

TEST(ScenarioConveyor, TheBeltRampsToEachSpeed) {
  ConveyorSpec spec;
  spec.speed_mm_s = 50;
  spec.belt_accel_mm_s2 = 100;
  spec.part_s = {1};
  // The second change comes in the middle of the ramp of the first one.
  spec.speeds = {{.at_s = 2, .speed_mm_s = 0}, {.at_s = 2.25, .speed_mm_s = 45}};
  const BeltMotion belt{spec};
  EXPECT_DOUBLE_EQ(belt.position_mm(2), 100);
  EXPECT_DOUBLE_EQ(belt.position_mm(2.25), 100 + 50 * 0.25 - 50 * 0.0625);
  const double at_speed = 109.375 + 25 * 0.2 + 50 * 0.04;
  EXPECT_NEAR(belt.position_mm(2.45), at_speed, 1e-12);
  EXPECT_NEAR(belt.position_mm(3.45), at_speed + 45, 1e-12);
  EXPECT_EQ(belt.counts(2), 10'000);
  EXPECT_DOUBLE_EQ(belt.displacement_mm(0, 2), 50);
}

TEST(ScenarioConveyor, AnEccentricDrumMovesTheBeltAroundItsMeanPosition) {
  ConveyorSpec spec;
  spec.speed_mm_s = 100;
  spec.wave_mm = 0.5;
  spec.wave_length_mm = 400;
  const BeltMotion belt{spec};
  EXPECT_NEAR(belt.position_mm(1), 100.5, 1e-12);
  EXPECT_NEAR(belt.position_mm(3), 299.5, 1e-12);
  EXPECT_NEAR(belt.position_mm(4), 400, 1e-12);
}

}  // namespace
}  // namespace armature::cosim
