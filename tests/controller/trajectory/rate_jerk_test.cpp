// Changes of the rate of joint moves with limited jerk, judged by their set-points: within the limits whenever and to
// whatever the rate changes, and about as fast as the limits allow.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "controller/robot/axis_units.hpp"
#include "tests/controller/support/keeping_sampler.hpp"
#include "tests/controller/support/path_rig.hpp"
#include "tests/controller/support/random.hpp"

namespace armature {
namespace {

constexpr long double kSetPointTick = 50e-6L;
// Chains keep the law of rate_bend.hpp, with twice the limit. A joint that turns round in a move that begins in motion
// may need as much.
constexpr double kMaxOfMove = 1.05, kMaxOfChain = 2.02, kMaxOfOthers = 1.0 + 2e-6;

// The largest speed, acceleration and jerk of any joint as shares of its limits, from differences of set-points.
struct RateShares {
  double speed = 0.0, accel = 0.0, jerk = 0.0;
};

RateShares rate_shares(const RobotModel& robot, const std::vector<JointAngles>& joints, std::size_t from = 0) {
  RateShares most;
  for (std::size_t k = std::max<std::size_t>(from, 3); k < joints.size(); ++k) {
    for (std::size_t axis = 0; axis < robot.axis_count; ++axis) {
      const AxisModel& model = robot.axes[axis];
      const auto q = [&](std::size_t back) { return static_cast<long double>(joints[k - back][axis].value()); };
      const auto share = [](long double difference, double limit) {
        return static_cast<double>(std::fabs(difference) / static_cast<long double>(limit));
      };
      most.speed = std::max(most.speed, share((q(0) - q(1)) / kSetPointTick, AxisUnits{model}.max_speed_rad_s()));
      most.accel = std::max(most.accel,
                            share((q(0) - 2 * q(1) + q(2)) / (kSetPointTick * kSetPointTick), model.max_accel_rad_s2));
      const long double third = q(0) - 3 * (q(1) - q(2)) - q(3);
      most.jerk =
          std::max(most.jerk, share(third / (kSetPointTick * kSetPointTick * kSetPointTick), model.max_jerk_rad_s3));
    }
  }
  return most;
}

RobotModel soft_robot(test::Random& random) {
  RobotModel robot = test::irb120();
  const double soft = std::pow(10.0, random.real(-1.5, 0.0));
  for (AxisModel& axis : robot.axes) {
    axis.max_accel_rad_s2 *= random.real(0.2, 1.0);
    axis.max_jerk_rad_s3 *= soft * random.real(0.3, 1.0);
  }
  return robot;
}

JointAngles soft_joints(test::Random& random, const RobotModel& robot, double share) {
  JointAngles joints{};
  for (std::size_t axis = 0; axis < robot.axis_count; ++axis) {
    const AxisModel& model = robot.axes[axis];
    if (random.integer(0, 5) == 0) continue;
    joints[axis] = Radians{share * random.real(model.min_rad, model.max_rad)};
  }
  return joints;
}

// One move from rest to rest, or three through points without a stop.
Piece soft_plan(test::Random& random, const RobotModel& robot, PieceStore& store) {
  const double share = std::pow(10.0, random.real(-2.0, 0.0)), speed = random.real(0.2, 1.0);
  if (random.integer(0, 2) > 0) {
    return store.keep(
        plan_joint_move(robot, {}, soft_joints(random, robot, share), speed, SyncRule::kFig9, ProfileKind::kSCurve));
  }
  JointChain chain{plan_retarget(robot, {}, soft_joints(random, robot, share), speed, ProfileKind::kSCurve)};
  for (int i = 0; i < 2; ++i) {
    const JointRequest next{.target = soft_joints(random, robot, share), .speed = speed, .kind = ProfileKind::kSCurve};
    (void)append(chain, robot, next, 0.1 * share);
  }
  return store.keep(chain);
}

// Executes the active plan at rates that change at random. Returns the number of ticks in which it stands.
int drive(test::Random& random, Sampler& sampler, std::int64_t duration, std::vector<JointAngles>& joints) {
  int standstills = 0;
  double wanted = 1.0;
  std::int64_t change = random.integer(0, duration);
  for (std::int64_t tick = 0; sampler.busy(); ++tick) {
    if (tick >= 20 * duration + 200'000) {
      ADD_FAILURE() << "does not end";
      return standstills;
    }
    if (tick >= change) {
      const double choices[] = {0.0, 0.0, 1.0, 1.0, random.real(0.01, 1.0)};
      wanted = tick > 2 * duration + 20'000 ? 1.0 : choices[random.integer(0, 4)];
      change = tick + random.integer(1, random.integer(0, 1) == 0 ? duration : 200);
    }
    joints.push_back(sampler.advance(wanted));
    standstills += sampler.rate() == 0.0 ? 1 : 0;
  }
  return standstills;
}

TEST(RateJerk, KeepsEveryLimitOfRandomJointMovesAtRandomRates) {
  constexpr std::uint64_t kSeeds[]{1, 4'711};
  constexpr int kDraws = 125;
  const auto store = std::make_unique<PieceStore>();
  test::Random random{kSeeds[0]};
  RateShares most;
  int standstills = 0;
  for (int draw = 0; draw < 2 * kDraws; ++draw) {
    if (draw == kDraws) random = test::Random{kSeeds[1]};
    SCOPED_TRACE("seed " + std::to_string(kSeeds[draw / kDraws]) + ", draw " + std::to_string(draw % kDraws));
    const RobotModel robot = soft_robot(random);
    const Arm arm{robot};
    const Plan plan{soft_plan(random, robot, *store)};
    const auto duration = armature::duration(plan).value();
    Sampler sampler{robot, arm, {}};
    sampler.start(plan, random.integer(0, 1) == 0 ? 1.0 : random.real(0.01, 1.0));
    std::vector<JointAngles> joints(4, JointAngles{});
    standstills += drive(random, sampler, duration, joints);
    EXPECT_EQ(joints.back(), target_of(plan));
    joints.insert(joints.end(), 3, joints.back());
    const RateShares here = rate_shares(robot, joints);
    EXPECT_LE(here.speed, kMaxOfOthers);
    EXPECT_LE(here.accel, kMaxOfOthers);
    EXPECT_LE(here.jerk, plan.pieces[0].joints != nullptr ? kMaxOfMove : kMaxOfChain);
    most = {std::max(most.speed, here.speed), std::max(most.accel, here.accel), std::max(most.jerk, here.jerk)};
  }
  EXPECT_GT(standstills, 10'000);
  EXPECT_GT(most.jerk, 0.99);
  RecordProperty("jerk", std::to_string(most.jerk));
}

TEST(RateJerk, MovesThatBeginInMotionSeldomNeedMoreThanTheirJerk) {
  constexpr int kDraws = 150;
  test::Random random{2};
  int above = 0;
  for (int draw = 0; draw < kDraws; ++draw) {
    SCOPED_TRACE("draw " + std::to_string(draw));
    const RobotModel robot = soft_robot(random);
    const Arm arm{robot};
    const double share = std::pow(10.0, random.real(-2.0, 0.0)), speed = random.real(0.2, 1.0);
    const JointPlan first =
        plan_joint_move(robot, {}, soft_joints(random, robot, share), speed, SyncRule::kFig9, ProfileKind::kSCurve);
    test::KeepingSampler sampler{robot, arm, {}};
    sampler.start(first, 1.0);
    std::vector<JointAngles> joints(4, JointAngles{});
    const std::int64_t turn = random.integer(0, first.duration.value());
    for (std::int64_t tick = 0; tick < turn && sampler.busy(); ++tick) joints.push_back(sampler.advance(1.0));
    const JointAngles target = soft_joints(random, robot, share);
    const RetargetPlan second = plan_retarget(robot, sampler.state(), target, speed, ProfileKind::kSCurve);
    sampler.start(second);
    (void)drive(random, sampler, second.duration.value(), joints);
    EXPECT_EQ(joints.back(), target);
    joints.insert(joints.end(), 3, joints.back());
    const RateShares here = rate_shares(robot, joints);
    EXPECT_LE(here.speed, kMaxOfOthers);
    EXPECT_LE(here.accel, kMaxOfOthers);
    EXPECT_LE(here.jerk, kMaxOfChain);
    above += here.jerk > kMaxOfMove ? 1 : 0;
  }
  EXPECT_LE(above, kDraws / 50);
}

// A single joint in its cruise: the least time from the speed v to rest is v / a + a / j, or 2 sqrt(v / j) where the
// acceleration is not reached. The same holds for a resume.
TEST(RateJerk, AHoldAndAResumeInTheCruiseTakeTheLeastTimeThatTheLimitsAllow) {
  for (const double accel_share : {1.0, 0.3, 0.1}) {
    for (const double wanted : {0.0, 0.4, 0.9}) {
      SCOPED_TRACE(testing::Message() << "acceleration " << accel_share << ", to " << wanted);
      RobotModel robot = test::irb120();
      robot.axes[0].max_accel_rad_s2 *= accel_share;
      robot.axes[0].max_jerk_rad_s3 *= 0.1;
      const AxisModel& axis = robot.axes[0];
      const Arm arm{robot};
      const JointPlan plan = plan_joint_move(robot, test::degrees({-160, 0, 0, 0, 0, 0}),
                                             test::degrees({160, 0, 0, 0, 0, 0}), 0.5, {}, ProfileKind::kSCurve);
      const double v = (1.0 - wanted) * plan.profiles[0].peak_speed();
      const double a = axis.max_accel_rad_s2, j = axis.max_jerk_rad_s3;
      const double least_s = v * j > a * a ? v / a + a / j : 2.0 * std::sqrt(v / j);
      test::KeepingSampler sampler{robot, arm, plan.start};
      sampler.start(plan, 1.0);
      std::vector<JointAngles> joints(4, plan.start);
      const double middle = 0.4 * static_cast<double>(plan.duration.value());
      while (sampler.elapsed() < middle) joints.push_back(sampler.advance(1.0));
      const std::size_t from = joints.size();
      int down = 0, up = 0;
      for (; sampler.rate() != wanted && down < 20'000; ++down) joints.push_back(sampler.advance(wanted));
      for (int tick = 0; tick < 5; ++tick) joints.push_back(sampler.advance(wanted));
      const RateShares braking = rate_shares(robot, joints, from);
      for (; sampler.rate() != 1.0 && up < 20'000; ++up) joints.push_back(sampler.advance(1.0));
      EXPECT_LE(down * kTickSeconds, 1.05 * least_s);
      EXPECT_LE(up * kTickSeconds, 1.05 * least_s);
      EXPECT_GE(down * kTickSeconds, 0.97 * least_s);
      EXPECT_GT(braking.jerk, 0.97);
      EXPECT_LE(rate_shares(robot, joints).jerk, 1.01);
      EXPECT_LE(rate_shares(robot, joints).accel, kMaxOfOthers);
    }
  }
}

}  // namespace
}  // namespace armature
