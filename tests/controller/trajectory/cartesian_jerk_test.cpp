// Changes of the rate on S-curves of every arm of the project: the jerk of the tool, of its rotation and of every
// joint stays within its limit wherever and however the rate changes.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

#include "controller/trajectory/run/sampler.hpp"
#include "tests/controller/support/draws.hpp"
#include "tests/controller/support/keeping_sampler.hpp"
#include "tests/controller/support/path_rig.hpp"
#include "tests/controller/support/random.hpp"
#include "tests/controller/support/robot_files.hpp"

namespace armature {
namespace {

using test::PathRig;
using test::Random;

constexpr std::uint64_t kJerkSeed = 9'100;

struct RobotOf {
  const char* file;
};
void PrintTo(const RobotOf& robot, std::ostream* out) {
  *out << robot.file;
}

// Elbow, shoulder and wrist well away from their singularities.
JointAngles ready(Random& random, const RobotModel& robot) {
  constexpr double kPi = std::numbers::pi;
  const bool six = robot.arm.family == ArmFamily::kSixR;
  JointAngles joints{};
  const auto put = [&](std::size_t i, double theta_rad) {
    joints[i] = Radians{(theta_rad - robot.arm.offset_rad[i]) / robot.arm.sign[i]};
  };
  put(0, random.real(-0.8, 0.8));
  if (six) {
    put(1, random.real(0.3 * kPi, 0.5 * kPi));
    put(2, random.real(-0.2, 0.2));
    put(3, random.real(-0.6, 0.6));
    put(4, (random.integer(0, 1) == 0 ? 1.0 : -1.0) * random.real(0.6, 1.3));
    put(5, robot.arm.offset_rad[5] + random.real(-0.8, 0.8));
  } else {
    put(1, random.real(-1.2, -0.7));
    put(2, random.real(1.0, 1.6));
    put(3, random.real(-0.8, 0.6));
    put(4, random.real(-0.8, 0.8));
  }
  return joints;
}

// So much acceleration that an S-curve never reaches it, nor does the rate: where accelerations decide how fast the
// rate changes, jerk may be exceeded.
PathLimits random_limits(Random& random) {
  const double pace = std::exp(random.real(std::log(0.5), std::log(6.0)));
  return {.speed_mm_s = 100.0 * pace,
          .accel_mm_s2 = 1'000.0 * pace,
          .jerk_mm_s3 = 10'000.0 * pace,
          .turn_speed_rad_s = 0.5 * pace,
          .turn_accel_rad_s2 = 5.0 * pace,
          .turn_jerk_rad_s3 = 50.0 * pace};
}

SegmentRequest random_move(Random& random, const PathRig& rig, const JointAngles& start) {
  const bool six = rig.robot.arm.family == ArmFamily::kSixR;
  const Transform from = rig.tool_at(start);
  const double reach_mm = six ? 60.0 : 0.2 * (rig.robot.arm.a2_mm + rig.robot.arm.a3_mm);
  const auto vector = [&](double size) {
    Eigen::Vector3d v;
    for (double& x : v) x = random.real(-size, size);
    return v;
  };
  const Eigen::Vector3d way_mm = vector(reach_mm), axis = vector(1.0), bend_mm = vector(0.5 * reach_mm);
  const double angle_rad = random.real(0.0, 0.4);
  const PathLimits limits = random_limits(random);
  const Transform to = test::turned_by(test::moved(from, way_mm.x(), way_mm.y(), way_mm.z()), angle_rad, axis);
  if (random.integer(0, 1) == 0) return test::line_to(to, limits, 0.0, ProfileKind::kSCurve);
  return test::arc_to(from.position_mm + 0.5 * way_mm + bend_mm, to, limits, 0.0, ProfileKind::kSCurve);
}

// By how much the tool turns between two set-points, as its limits count it: in space; five joints, whose tool is
// tilted here, by pitch and roll.
Eigen::Vector3d turn(const PathRig& rig, const JointAngles& before, const JointAngles& after) {
  const ArmGeometry& arm = rig.robot.arm;
  if (arm.family == ArmFamily::kSixR) {
    const Eigen::Matrix3d m = rig.tool_at(after).rotation * rig.tool_at(before).rotation.transpose();
    return 0.5 * Eigen::Vector3d{m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1)};
  }
  const auto theta = [&](std::size_t i) { return arm.sign[i] * (after[i] - before[i]).value(); };
  return {theta(1) + theta(2) + theta(3), theta(4), 0.0};
}

// The rate goes to `wanted` at set-point `begin` and to 1 again `ticks` later. Begins with the arm at rest.
std::vector<JointAngles> set_points(const PathRig& rig, double wanted, std::int64_t begin, std::int64_t ticks) {
  const CartesianPlan& plan = rig.planner.plan();
  test::KeepingSampler sampler{rig.robot, rig.arm, plan.start};
  sampler.start(plan, 1.0);
  std::vector<JointAngles> joints(4, plan.start);
  for (std::int64_t tick = 0; sampler.busy() && tick < 200'000; ++tick) {
    joints.push_back(sampler.advance(tick >= begin && tick < begin + ticks ? wanted : 1.0));
  }
  EXPECT_EQ(joints.back(), plan.target) << "does not end";
  joints.insert(joints.end(), 3, joints.back());
  return joints;
}

// As shares of the limits.
struct JerkPeaks {
  double tool = 0.0, turn = 0.0, joints = 0.0;
};

JerkPeaks jerk_peaks(const PathRig& rig, const SegmentRequest& request, const std::vector<JointAngles>& joints) {
  constexpr double kTick3 = kTickSeconds * kTickSeconds * kTickSeconds;
  JerkPeaks peaks{.joints = test::joint_peaks(rig.robot, joints).jerk};
  std::array<Eigen::Vector3d, 4> tool;
  tool.fill(rig.tool_at(joints[0]).position_mm);
  std::array<Eigen::Vector3d, 3> turns;
  turns.fill(Eigen::Vector3d::Zero());
  for (std::size_t k = 1; k < joints.size(); ++k) {
    tool = {rig.tool_at(joints[k]).position_mm, tool[0], tool[1], tool[2]};
    turns = {turn(rig, joints[k - 1], joints[k]), turns[0], turns[1]};
    const double tool_jerk = (tool[0] - 3.0 * tool[1] + 3.0 * tool[2] - tool[3]).norm() / kTick3;
    const double turn_jerk = (turns[0] - 2.0 * turns[1] + turns[2]).norm() / kTick3;
    peaks.tool = std::max(peaks.tool, tool_jerk / request.limits.jerk_mm_s3);
    peaks.turn = std::max(peaks.turn, turn_jerk / request.limits.turn_jerk_rad_s3);
  }
  return peaks;
}

class CartesianJerk : public testing::TestWithParam<RobotOf> {};

TEST_P(CartesianJerk, StaysWithinItsLimitWhileTheRateChanges) {
  constexpr double kMax = 1.05;
  RobotModel robot = test::robot_of_file(GetParam().file);
  if (robot.arm.family == ArmFamily::kFiveR) robot.arm.max_projection_rad = 1.0;  // random turns leave the arm's plane
  Random random{kJerkSeed};
  int lines = 0, arcs = 0;
  JerkPeaks most;
  for (int draw = 0; draw < test::draws(20); ++draw) {
    SCOPED_TRACE("seed " + std::to_string(kJerkSeed) + ", draw " + std::to_string(draw));
    PathRig rig{robot};
    const JointAngles start = ready(random, robot);
    const SegmentRequest request = random_move(random, rig, start);
    if (rig.plan(start, request) != CartesianPlanner::Progress::kDone) continue;
    ++(request.kind == SegmentRequest::Kind::kLine ? lines : arcs);
    const auto duration = rig.planner.plan().duration.value();
    const double slow = random.real(0.05, 0.95);
    for (const double wanted : {0.0, slow}) {
      const std::int64_t begin = random.integer(0, duration);
      const std::int64_t ticks = random.integer(100, 6'000);
      const std::vector<JointAngles> joints = set_points(rig, wanted, begin, ticks);
      SCOPED_TRACE(testing::Message() << "to " << wanted << " at " << begin << " for " << ticks);
      const JerkPeaks peaks = jerk_peaks(rig, request, joints);
      EXPECT_LE(peaks.tool, kMax);
      EXPECT_LE(peaks.turn, kMax);
      EXPECT_LE(peaks.joints, kMax);
      most.tool = std::max(most.tool, peaks.tool);
      most.turn = std::max(most.turn, peaks.turn);
      most.joints = std::max(most.joints, peaks.joints);
    }
  }
  EXPECT_GE(lines, test::least(8));
  EXPECT_GE(arcs, test::least(3));
  if (!test::few_draws()) {
    EXPECT_GT(most.tool, 0.95);
    EXPECT_GT(most.turn, 0.95);
  }
  RecordProperty("tool", std::to_string(most.tool));
  RecordProperty("turn", std::to_string(most.turn));
  RecordProperty("joints", std::to_string(most.joints));
}

INSTANTIATE_TEST_SUITE_P(Arms, CartesianJerk,
                         testing::Values(RobotOf{"abb_irb120"}, RobotOf{"kuka_kr6_r900"}, RobotOf{"fanuc_lrmate200id"},
                                         RobotOf{"vo2021_6r"}, RobotOf{"hu2012_5r"}),
                         [](const auto& robot) { return std::string{robot.param.file}; });

// A long line far from singularities, S-shaped, held or slowed down anywhere: jerk from the set-points alone.
TEST(CartesianJerkOfALine, StaysWithinItsLimitWhereverTheRateChanges) {
  PathRig rig{test::irb120()};
  const JointAngles start = test::degrees({10, 20, 10, 5, 40, 0});
  const Transform end = test::moved(rig.tool_at(start), 100, 60, -40);
  for (const PathLimits& limits : {test::kGentle, test::kBrisk}) {
    ASSERT_EQ(rig.plan(start, test::line_to(end, limits, 0.0, ProfileKind::kSCurve)),
              CartesianPlanner::Progress::kDone);
    const auto duration = static_cast<double>(rig.planner.plan().duration.value());
    for (const double share : {0.02, 0.1, 0.2, 0.5, 0.8, 0.9, 0.98}) {
      for (const double wanted : {0.0, 0.3, 0.9}) {
        SCOPED_TRACE(testing::Message() << "to " << wanted << " at " << share << " of the plan");
        test::KeepingSampler sampler{rig.robot, rig.arm, start};
        sampler.start(rig.planner.plan(), 1.0);
        std::vector<JointAngles> joints(4, start);
        std::vector<Eigen::Vector3d> tool(4, rig.tool_at(start).position_mm);
        double jerk = 0.0;
        for (int tick = 0; sampler.busy(); ++tick) {
          ASSERT_LT(tick, 100'000);
          const double since = tick - share * duration;
          joints.push_back(sampler.advance(since > 0.0 && since < 4'000.0 ? wanted : 1.0));
          tool.push_back(rig.tool_at(joints.back()).position_mm);
          const Eigen::Vector3d* p = &tool.back() - 3;
          constexpr double kTick3 = kTickSeconds * kTickSeconds * kTickSeconds;
          jerk = std::max(jerk, (p[3] - 3.0 * p[2] + 3.0 * p[1] - p[0]).norm() / kTick3);
        }
        EXPECT_LE(jerk, 1.05 * limits.jerk_mm_s3);
        EXPECT_LE(test::joint_peaks(rig.robot, joints).jerk, 1.05);
        EXPECT_EQ(joints.back(), rig.planner.plan().target);
      }
    }
  }
}

// The last braking step of a trapezoid is sudden. It does not belong to the S-curve that begins where it stops.
TEST(CartesianJerkOfALine, AHoldOfAnSCurveTakesNoLongerAfterATrapezoid) {
  RobotModel robot = test::irb120();
  for (AxisModel& axis : robot.axes) axis.max_jerk_rad_s3 = 300.0 * std::numbers::pi / 180.0;  // soft drives
  const JointAngles start = test::degrees({10, 20, 10, 5, 40, 0});
  std::vector<std::int64_t> braking, durations;
  for (const ProfileKind first : {ProfileKind::kSCurve, ProfileKind::kTrapezoid}) {
    PathRig rig{robot};
    const Transform middle = test::moved(rig.tool_at(start), 60, 0, 0), end = test::moved(middle, 0, 120, 0);
    const std::vector<SegmentRequest> chain{test::line_to(middle, test::kGentle, 0.0, first),
                                            test::line_to(end, test::kGentle, 0.0, ProfileKind::kSCurve)};
    ASSERT_EQ(rig.plan(start, chain), CartesianPlanner::Progress::kDone);
    const CartesianSegment& held = rig.planner.plan().segments[1];
    durations.push_back(held.duration.value());
    const std::int64_t from = held.start.value() + held.duration.value() / 2;
    test::KeepingSampler sampler{rig.robot, rig.arm, start};
    sampler.start(rig.planner.plan(), 1.0);
    JointAngles last = start;
    std::int64_t tick = 0, stood_at = -1;
    for (; sampler.busy() && stood_at < 0 && tick < from + 100'000; ++tick) {
      const JointAngles joints = sampler.advance(tick < from ? 1.0 : 0.0);
      if (tick > from && joints == last) stood_at = tick;
      last = joints;
    }
    ASSERT_GE(stood_at, 0) << "the hold was not kept";
    braking.push_back(stood_at - from);
  }
  EXPECT_NEAR(static_cast<double>(durations[1]) / static_cast<double>(durations[0]), 1.0, 0.05);
  EXPECT_NEAR(static_cast<double>(braking[1]) / static_cast<double>(braking[0]), 1.0, 0.05);
}

}  // namespace
}  // namespace armature
