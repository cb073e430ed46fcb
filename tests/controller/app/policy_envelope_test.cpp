// Whatever a network answers, no joint leaves its limits. The whole controller follows a belt; an adversary stands in
// the place of the network: each tick it gives any byte as the output of policy_mlp, also beyond its bound. Every exact
// set-point is judged.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "controller/activity/conveyor/conveyor_source.hpp"
#include "controller/policy/policy_network.hpp"
#include "controller/regs/policy_mlp_regs.hpp"
#include "controller/regs/soc_map.hpp"
#include "tests/controller/support/conveyor_rig.hpp"
#include "tests/controller/support/draws.hpp"
#include "tests/controller/support/joint_envelope.hpp"
#include "tests/controller/support/random.hpp"
#include "tests/support/mlp_images.hpp"

namespace armature {
namespace {

using namespace test::conveyor;
namespace reg = regs::policy_mlp;

constexpr std::uint64_t kAdversarySeed = 53;
constexpr std::int64_t kTicksToStop = 4'000;  // more than the joints need after the end
constexpr RegAddr kOutput{regs::soc::kPolicyMlpBase + reg::kOutputOffset};
constexpr RegAddr kStatus{regs::soc::kPolicyMlpBase + reg::kStatusOffset};

// The output of each tick.
using Adversary = std::function<int(std::int64_t tick)>;

Adversary random_adversary(test::Random& random) {
  const std::int64_t half_ticks = random.integer(1, 400);
  switch (random.integer(0, 3)) {
    case 0:
      return [](std::int64_t) { return -128; };
    case 1:
      return [](std::int64_t tick) { return tick % 2 == 0 ? 127 : -128; };
    case 2:  // a square wave, of which some are near the bandwidth of the belt
      return [half_ticks](std::int64_t tick) { return tick / half_ticks % 2 == 0 ? 127 : -128; };
    default:
      return [&random](std::int64_t) { return static_cast<int>(random.integer(-128, 127)); };
  }
}

// Its inputs have such ranges that no belt is outside of them.
BeltPolicyConfig any_network(double full_mm) {
  test::RandomNetworks networks{kAdversarySeed};
  const test::TestImage image = test::image_of(networks.of({BeltPolicyConfig::kInputs, 16, 16, 1}), 8);
  BeltPolicyConfig config{
      .full_mm = full_mm, .crc = PolicyNetwork::checksum(image), .words = static_cast<std::uint32_t>(image.size())};
  config.inputs.fill({.low = -1e9, .high = 1e9});
  std::ranges::copy(image, config.image.begin());
  return config;
}

// From a share of the value to all of it, each factor equally likely.
double reduced(test::Random& random, double value, double least_share) {
  return value * std::pow(least_share, random.real(0.0, 1.0));
}

// In most runs a joint has limits that the way along the belt asks for, or goes beyond. Joints 2, 3 and 5 need more
// acceleration the farther the part has come.
RobotModel random_robot(test::Random& random) {
  constexpr std::array<std::size_t, 3> kNeedMore{1, 2, 4};
  RobotModel robot = test::irb120();
  for (AxisModel& axis : robot.axes) axis.max_accel_rad_s2 = 20.0;
  switch (random.integer(0, 3)) {
    case 0:
      robot.axes[0].max_rad = random.real(0.5, 20.0) * test::kDeg;
      break;
    case 1:
      robot.axes[random.integer(0, 1) == 0 ? 0 : 5].max_speed_rad_s = random.real(0.3, 0.6);
      break;
    case 2:
      robot.axes[kNeedMore[static_cast<std::size_t>(random.integer(0, 2))]].max_accel_rad_s2 = random.real(6.0, 12.0);
      break;
    default:
      break;
  }
  return robot;
}

ControllerConfig random_config(test::Random& random) {
  ControllerConfig config = with_conveyor(random.integer(0, 1) == 0 ? 250.0 : 3'000.0);
  config.conveyor->accel_mm_s2 = random.real(2'000.0, 7'000.0);
  config.conveyor->policy = any_network(reduced(random, 20.0, 0.01));
  return config;
}

// In a third of the runs the arm is stopped meanwhile.
void give_program(ConveyorRig& conveyor, test::Random& random) {
  for (std::uint32_t tag = 1; tag <= 3; ++tag) {
    const Eigen::Vector3d to_mm{random.real(-30, 30), random.real(-30, 30), random.real(-60, 0)};
    conveyor.rig.submit_at(10, ConveyorRig::line(kConveyorFrame, to_mm, Tag{tag}, random.real(30, 150)));
    conveyor.rig.submit_at(10, Dwell{.duration = Ticks{random.integer(1, 3'000)}, .tag = Tag{10 + tag}});
  }
  conveyor.rig.submit_at(10, JointMove{.target = test::degrees({0, 20, 10, 5, 40, -20}), .tag = Tag{20u}});
  conveyor.rig.submit_at(random.integer(40'000, 160'000), Stop{});
}

// The arm follows no part.
bool is_refused(const ConveyorRig& conveyor) {
  return conveyor.rig.parts.empty() && !conveyor.rig.refusals.empty();
}

// A run ends a little after the arm has left the part.
void plant(ConveyorRig& conveyor, const Adversary& adversary) {
  conveyor.rig.on_each_trigger = [&conveyor, adversary, before = conveyor.rig.on_each_trigger,
                                  is_over = false]() mutable {
    before();
    const auto output = static_cast<std::uint8_t>(adversary(conveyor.rig.logic.triggers()));
    conveyor.rig.logic.planted.plant(kOutput, output);
    conveyor.rig.logic.planted.plant(kStatus, reg::kStatusDoneMask);
    const bool over = conveyor.tick_of(PartPhase::kEnded) >= 0 || is_refused(conveyor);
    std::int64_t& last = conveyor.rig.logic.triggers_to_run;
    if (over && !is_over) last = std::min(last, conveyor.rig.logic.triggers() + kTicksToStop);
    is_over = over;
  };
}

std::vector<PerAxis<Radians>> set_points(const test::ControllerRig& rig) {
  std::vector<PerAxis<Radians>> points;
  for (const Telemetry& row : rig.rows) points.push_back(row.reference);
  return points;
}

TEST(PolicyEnvelope, NoOutputOfANetworkMovesAJointBeyondItsLimits) {
  test::Random random{kAdversarySeed};
  std::map<PartEnd, int> ends;
  test::JointEnvelope followed;  // from the time on at which the arm follows a part
  std::uint32_t corrected = 0;
  for (int draw = 0; draw < test::draws(100); ++draw) {
    const double at_s = random.real(0.8, 2.5), to_mm_s = random.real(0.0, 200.0), accel = random.real(200.0, 5'000.0);
    const ControllerConfig config = random_config(random);
    ConveyorRig conveyor{changing(at_s, to_mm_s, accel), config, random_robot(random)};
    give_program(conveyor, random);
    plant(conveyor, random_adversary(random));
    conveyor.rig.run(4 * kSecond + kTicksToStop);
    const std::string what = "seed " + std::to_string(kAdversarySeed) + " draw " + std::to_string(draw);
    const std::vector<PerAxis<Radians>> points = set_points(conveyor.rig);
    ASSERT_EQ(test::joint_envelope(conveyor.rig.robot, points).beyond, "") << what;
    ASSERT_TRUE(conveyor.rig.faults.empty()) << what;
    for (const PartEnd end : conveyor.ends()) ++ends[end];
    for (const PartFollowed& part : conveyor.rig.parts) corrected += part.corrected;
    const std::int64_t begun = conveyor.tick_of(PartPhase::kBegun);
    if (begun < 0) continue;
    followed.add(test::joint_envelope(conveyor.rig.robot, std::span{points}.subspan(static_cast<std::size_t>(begun))));
  }
  // The adversary was heard. It took the joints to their limits, and ended the motion in each way that it can.
  EXPECT_GT(corrected, 0u);
  EXPECT_GT(followed.speed, 0.9);
  EXPECT_GT(followed.accel, 0.999);
  EXPECT_GT(followed.range, 0.9);
  EXPECT_GE(ends[PartEnd::kReleased], test::least(5));
  EXPECT_GE(ends[PartEnd::kTooFast], test::least(1));
  EXPECT_GE(ends[PartEnd::kCannotFollow], test::least(8));
  EXPECT_GE(ends[PartEnd::kStopped], test::least(15));
}

// The frame cannot follow outputs that jump at this rate, and falls behind the part.
TEST(PolicyEnvelope, WithholdsTheCorrectionsOfANetworkThatLeadsTheToolAway) {
  constexpr double kLargest_mm = 2.0;
  ControllerConfig config = with_conveyor(3'000.0);
  config.conveyor->policy = any_network(kLargest_mm);
  ConveyorRig conveyor{hundred, config};
  conveyor.line_at(10, -40.0, 1u);
  conveyor.line_at(10, -60.0, 2u, 20.0);
  conveyor.leave();
  plant(conveyor, [](std::int64_t tick) {
    constexpr std::int64_t kSynchronised = 36'000;
    return tick < kSynchronised ? 0 : tick / 500 % 2 == 0 ? 127 : -127;
  });
  conveyor.rig.run(5 * kSecond);
  ASSERT_EQ(conveyor.ends(), std::vector{PartEnd::kReleased});
  const PartFollowed& end = conveyor.rig.parts.back();
  EXPECT_GT(end.deviation_mm, ConveyorSource::kMostDeviation_mm + kLargest_mm);
  EXPECT_LT(end.deviation_mm, ConveyorSource::kMostDeviation_mm + 1.5 * kLargest_mm);
  EXPECT_GT(end.corrected, 1'000u);
  EXPECT_GT(end.no_result, 10'000u);
}

}  // namespace
}  // namespace armature
