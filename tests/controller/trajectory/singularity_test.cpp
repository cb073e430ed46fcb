// Lines that pass singularities at 0 to 10 mm, with each way of passing them. Judged by the set-points alone.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <tuple>
#include <vector>

#include "tests/controller/support/draws.hpp"
#include "tests/controller/support/singular_pass.hpp"

namespace armature {
namespace {

using test::Deviation;
using test::deviation_of;
using test::kDeg;
using test::kSkewTool;
using test::kTolerance_rad;
using test::kWalk;
using test::Passage;
using Progress = CartesianPlanner::Progress;
constexpr std::array kMisses_mm{0.0, 1e-8, 1e-6, 1e-3, 0.1, 0.5, 2.0, 10.0};
constexpr double kHair_mm = 1e-5;  // a line that misses by less passes like one that does not miss
// Joint 4 at 90 deg turns its half turn within its limits; at 0 deg it would leave them. On the longer line a bend
// begins and ends in motion.
struct Direction {
  const char* name;
  double joint4_deg;
  Eigen::Vector3d along_mm, aside;  // along_mm: half of the line
  bool turns_within_limits;
};
const std::array kDirections{
    Direction{"across", 90, Eigen::Vector3d{0, 110, 0}, Eigen::Vector3d::UnitZ(), true},
    Direction{"upwards", 0, Eigen::Vector3d{0, 0, 50}, Eigen::Vector3d::UnitY(), false},
};

// With and without a tool, with and without limits of jerk.
class WristSingularity : public testing::TestWithParam<std::tuple<bool, ProfileKind>> {
 protected:
  // The forearm and the hand point forward.
  static JointAngles singular(const Direction& direction) {
    return test::degrees({0, 20, -20, direction.joint4_deg, 0, 0});
  }
  [[nodiscard]] static std::unique_ptr<test::PathRig> rig() {
    return std::make_unique<test::PathRig>(test::irb120(), PlanningConfig{}.max_stretch,
                                           std::get<0>(GetParam()) ? kSkewTool : Transform{});
  }
  static ProfileKind profile() { return std::get<1>(GetParam()); }
  static Passage pass(const test::PathRig& rig, const Direction& direction, double miss_mm, AtSingularity mode) {
    return test::pass(rig, singular(direction), direction.along_mm, direction.aside, miss_mm, mode, profile());
  }
  // The angle by which the hand misses the axis of the forearm.
  static double miss_rad(const test::PathRig& rig, const Direction& direction, double miss_mm) {
    const Passage passage = pass(rig, direction, miss_mm, AtSingularity::kSlow);
    const Transform middle = rig.tool_at(singular(direction));
    const Transform there{middle.rotation, middle.position_mm + miss_mm * direction.aside};
    const IkSolutions solutions = rig.arm.inverse(there * inverse(rig.flange_T_tool), passage.start);
    return std::fabs(rig.arm.wrist_sine(solutions.branches[static_cast<std::size_t>(solutions.selected)].joints));
  }
  static void expect_limits(const test::PathRig& rig) {
    const bool with_jerk = profile() == ProfileKind::kSCurve;
    for (const double shift : {0.0, 0.37}) {
      const std::vector<JointAngles> joints = rig.set_points(shift);
      const test::JointPeaks peaks = test::joint_peaks(rig.robot, joints);
      EXPECT_LE(peaks.speed, 1.0);
      EXPECT_LE(peaks.accel, 1.0) << "axis " << peaks.accel_axis;
      if (with_jerk) {
        EXPECT_LE(peaks.jerk, 1.0);
      }
      const test::HandPeaks hand = test::hand_peaks(rig, joints, kWalk);
      for (std::size_t order = 0; order < (with_jerk ? 3u : 2u); ++order) {
        const double most = order == 2 ? 1.05 : 1.002;
        EXPECT_LE(hand.move[order], most) << order;
        EXPECT_LE(hand.turn[order], most) << order;
      }
    }
  }
};

TEST_P(WristSingularity, SlowKeepsTheOrientationAndTheLimits) {
  for (const Direction& direction : kDirections) {
    for (const double miss_mm : test::cases(kMisses_mm)) {
      SCOPED_TRACE(testing::Message() << direction.name << " at " << miss_mm << " mm");
      const auto rig = WristSingularity::rig();
      const Passage passage = pass(*rig, direction, miss_mm, AtSingularity::kSlow);
      const Progress result = rig->plan(passage.start, passage.request);
      if (miss_mm > kHair_mm && !direction.turns_within_limits) {
        ASSERT_EQ(result, Progress::kRefused);
        EXPECT_EQ(rig->planner.problem().kind, PathProblem::Kind::kOutsideLimits);
        EXPECT_EQ(rig->planner.problem().axis, 4);
        continue;
      }
      ASSERT_EQ(result, Progress::kDone) << static_cast<int>(rig->planner.problem().kind);
      const CartesianPlan& plan = rig->planner.plan();
      const std::vector<JointAngles> joints = rig->set_points();
      const Deviation deviation = deviation_of(*rig, joints, passage.request);
      EXPECT_LT(deviation.beside_mm, 1e-8);
      EXPECT_LT(deviation.turned_rad, 1e-6);
      expect_limits(*rig);
      const double turned = std::fabs((joints.back()[3] - joints.front()[3]).value());
      if (miss_mm < kHair_mm) {
        EXPECT_LT(plan.segments[0].stretch, 1.02);
        EXPECT_LT(turned, 0.2) << "straight through";
      } else {
        EXPECT_GT(turned, 2.4) << "around the singularity";
        EXPECT_LT(plan.segments[0].stretch, 1.8) << "half a turn of joint 4 takes 0.6 s";
      }
    }
  }
}

TEST_P(WristSingularity, BendPassesAtFullSpeedWithinTheTolerance) {
  for (const Direction& direction : kDirections) {
    for (const double miss_mm : test::cases(kMisses_mm)) {
      SCOPED_TRACE(testing::Message() << direction.name << " at " << miss_mm << " mm");
      const auto rig = WristSingularity::rig();
      const Passage passage = pass(*rig, direction, miss_mm, AtSingularity::kBend);
      ASSERT_EQ(rig->plan(passage.start, passage.request), Progress::kDone);
      const CartesianPlan& plan = rig->planner.plan();
      EXPECT_EQ(plan.segments[0].stretch, 1.0);
      EXPECT_EQ(plan.bends.count, 1u);
      // At the limits of the tool.
      const double ideal_s = direction.along_mm.norm() / 50.0 + (profile() == ProfileKind::kSCurve ? 0.15 : 0.1);
      EXPECT_LT(seconds(plan.duration), 1.005 * ideal_s);
      const std::vector<JointAngles> joints = rig->set_points();
      const Deviation deviation = deviation_of(*rig, joints, passage.request);
      EXPECT_LT(deviation.beside_mm, 1e-8);
      EXPECT_LT(deviation.turned_rad, kTolerance_rad);
      EXPECT_NEAR(deviation.turned_rad, plan.segments[0].residual_rad, 1e-9) << "the reported one";
      // The hand has to pass the axis of the forearm; a bend adds little to that.
      const double miss = miss_rad(*rig, direction, miss_mm);
      EXPECT_GT(deviation.turned_rad, 0.6 * miss);
      EXPECT_LT(deviation.turned_rad, 1.1 * miss + 5e-4);
      EXPECT_LT(std::fabs((joints.back()[3] - joints.front()[3]).value()), 0.75);
      expect_limits(*rig);
      // Exactly the requested orientation at both ends.
      const Deviation ends = deviation_of(*rig, {joints.front(), joints.back()}, passage.request);
      EXPECT_LT(ends.turned_rad, 1e-12);
    }
  }
}

TEST_P(WristSingularity, RefuseAcceptsOnlyWhatPassesAtFullSpeed) {
  for (const Direction& direction : kDirections) {
    for (const double miss_mm : test::cases(kMisses_mm)) {
      SCOPED_TRACE(testing::Message() << direction.name << " at " << miss_mm << " mm");
      const auto rig = WristSingularity::rig();
      const Passage passage = pass(*rig, direction, miss_mm, AtSingularity::kRefuse);
      const Progress result = rig->plan(passage.start, passage.request);
      if (miss_mm < kHair_mm) {
        EXPECT_EQ(result, Progress::kDone);
        continue;
      }
      ASSERT_EQ(result, Progress::kRefused);
      const PathProblem& problem = rig->planner.problem();
      if (problem.kind == PathProblem::Kind::kOutsideLimits) continue;  // so far away that the joints would follow
      EXPECT_EQ(problem.kind, PathProblem::Kind::kTooFast);
      EXPECT_EQ(problem.singular, kWristSingular);
      EXPECT_NEAR(problem.at, 0.5, 0.1);
    }
  }
}

TEST_P(WristSingularity, ATighterToleranceThanTheMissIsAsSlow) {
  const auto bent = rig(), slow = rig();
  const Direction& across = kDirections[0];
  Passage passage = pass(*bent, across, 10.0, AtSingularity::kBend);
  passage.request.orientation_tolerance_rad = 0.5 * kDeg;
  ASSERT_EQ(bent->plan(passage.start, passage.request), Progress::kDone);
  passage.request.at_singularity = AtSingularity::kSlow;
  ASSERT_EQ(slow->plan(passage.start, passage.request), Progress::kDone);
  EXPECT_EQ(bent->planner.plan().bends.count, 0u);
  EXPECT_EQ(bent->planner.plan().duration, slow->planner.plan().duration);
}

TEST_P(WristSingularity, ABendKeepsARoundedCornerAndAnArc) {
  const auto rig = WristSingularity::rig();
  const Direction& up = kDirections[1];
  const Transform middle = rig->tool_at(singular(up));
  const auto at = [&](double y, double z) {
    return Transform{middle.rotation, middle.position_mm + Eigen::Vector3d{0, y, z}};
  };
  // The corner lies on the singularity; the arc passes it at 1 mm.
  std::vector<SegmentRequest> chain{test::line_to(at(0, 0), kWalk, 5.0), test::line_to(at(40, 20), kWalk),
                                    test::arc_to(at(1, 0).position_mm, at(-30, -30), kWalk)};
  for (SegmentRequest& request : chain) {
    request.profile = profile();
    request.at_singularity = AtSingularity::kBend;
    request.orientation_tolerance_rad = kTolerance_rad;
  }
  const IkSolutions solutions = rig->arm.inverse(at(0, -50) * inverse(rig->flange_T_tool), singular(up));
  const JointAngles start = solutions.branches[static_cast<std::size_t>(solutions.selected)].joints;
  ASSERT_EQ(rig->plan(start, chain), Progress::kDone) << static_cast<int>(rig->planner.problem().kind);
  const CartesianPlan& plan = rig->planner.plan();
  EXPECT_EQ(plan.bends.count, 2u);
  expect_limits(*rig);
  JointAngles joints = plan.start;
  for (std::int64_t tick = 1; tick <= plan.duration.value(); ++tick) {
    const double t_s = static_cast<double>(tick) * kTickSeconds;
    joints = position(plan, rig->arm, t_s, joints);
    const test::RealVector off = test::tool_of(rig->robot, joints, rig->flange_T_tool).position -
                                 tool_pose(plan, t_s).position_mm.cast<test::Real>();
    ASSERT_LT(off.norm(), 1e-8L) << tick;
  }
}

// Starting in the singularity, joint 4 need not be where the path leads.
TEST_P(WristSingularity, ABendLeavesTheSingularityInAnyDirection) {
  const auto rig = WristSingularity::rig();
  const JointAngles start = test::degrees({0, 20, -20, 40, 0, 0});
  const Transform there = rig->tool_at(start);
  SegmentRequest request = test::line_to(test::moved(there, 0, 0, 60), kWalk, 0.0, profile());
  if (profile() == ProfileKind::kTrapezoid) {  // with an S-curve it takes minutes to know
    EXPECT_EQ(rig->plan(start, request), Progress::kRefused);
  }
  request.at_singularity = AtSingularity::kBend;
  request.orientation_tolerance_rad = kTolerance_rad;
  ASSERT_EQ(rig->plan(start, request), Progress::kDone) << static_cast<int>(rig->planner.problem().kind);
  const std::vector<JointAngles> joints = rig->set_points();
  const Deviation deviation = deviation_of(*rig, joints, request);
  EXPECT_LT(deviation.beside_mm, 1e-8);
  EXPECT_LT(deviation.turned_rad, kTolerance_rad);
  EXPECT_GT(deviation.turned_rad, 0.01);
  expect_limits(*rig);
}

INSTANTIATE_TEST_SUITE_P(ToolsAndProfiles, WristSingularity,
                         testing::Combine(testing::Bool(),
                                          testing::Values(ProfileKind::kTrapezoid, ProfileKind::kSCurve)));

// Past axis 1, with the hand up: joint 1 turns by nearly half a turn. For both families.
TEST(ShoulderSingularity, IsPassedSlowlyOrRefused) {
  for (const bool five : {false, true}) {
    for (const double miss_mm : test::cases(kMisses_mm)) {
      for (const AtSingularity mode : {AtSingularity::kSlow, AtSingularity::kBend, AtSingularity::kRefuse}) {
        SCOPED_TRACE(testing::Message() << (five ? "five" : "six") << " joints at " << miss_mm << " mm, "
                                        << static_cast<int>(mode));
        const auto rig = std::make_unique<test::PathRig>(five ? test::hu2012(1e-4) : test::irb120());
        Eigen::Matrix3d down = Eigen::Vector3d{1, -1, -1}.asDiagonal();
        const Eigen::Matrix3d rotation = five ? down : Eigen::Matrix3d::Identity();
        const double z = five ? -20.0 : 862.0;
        const Transform from{rotation, {miss_mm, -60, z}};
        const IkSolutions solutions = rig->arm.inverse(from, {});
        ASSERT_GE(solutions.selected, 0);
        SegmentRequest request = test::line_to({rotation, {miss_mm, 60, z}}, kWalk);
        request.at_singularity = mode;
        request.orientation_tolerance_rad = kTolerance_rad;
        const Progress result =
            rig->plan(solutions.branches[static_cast<std::size_t>(solutions.selected)].joints, request);
        const PathProblem& problem = rig->planner.problem();
        if (result == Progress::kRefused) {
          EXPECT_EQ(problem.kind, PathProblem::Kind::kTooFast);
          EXPECT_EQ(problem.singular, kShoulderSingular);
          EXPECT_TRUE(mode == AtSingularity::kRefuse || miss_mm < 1e-5) << "only a hair may be refused";
          continue;
        }
        EXPECT_TRUE(mode != AtSingularity::kRefuse || miss_mm == 0.0);
        EXPECT_EQ(rig->planner.plan().bends.count, 0u);
        const test::JointPeaks peaks = test::joint_peaks(rig->robot, rig->set_points());
        EXPECT_LE(peaks.most(false), 1.0);
        for (std::int64_t tick = 0; tick <= rig->planner.plan().duration.value(); ++tick) {
          const Transform tool = tool_pose(rig->planner.plan(), static_cast<double>(tick) * kTickSeconds);
          ASSERT_NEAR(tool.position_mm.z(), z, 1e-9);
        }
      }
    }
  }
}

TEST(ElbowSingularity, IsApproachedSlowlyOrRefused) {
  test::PathRig rig{test::irb120()};
  const JointAngles start = test::degrees({0, 40, 0, 0, 30, 0});
  const Transform from = rig.tool_at(start);
  // The wrist centre goes outwards to 0.3 mm before its limit.
  const Eigen::Vector3d shoulder{0, 0, 290}, wrist = from.position_mm - 72.0 * from.rotation.col(2);
  const Eigen::Vector3d out = (wrist - shoulder).normalized();
  const double reach = 270.0 + std::hypot(70.0, 302.0) - 0.3 - (wrist - shoulder).norm();
  ASSERT_GT(reach, 20.0);
  SegmentRequest request = test::line_to({from.rotation, from.position_mm + reach * out}, test::kBrisk);
  EXPECT_EQ(rig.plan(start, request), Progress::kDone);
  EXPECT_GT(rig.planner.plan().segments[0].stretch, 1.002);
  request.at_singularity = AtSingularity::kRefuse;
  ASSERT_EQ(rig.plan(start, request), Progress::kRefused);
  EXPECT_EQ(rig.planner.problem().kind, PathProblem::Kind::kTooFast);
  EXPECT_EQ(rig.planner.problem().singular, kElbowSingular);
}

}  // namespace
}  // namespace armature
