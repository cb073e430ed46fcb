// The judge of random chains has to bite: set-points of a good motion pass, and each thing that it judges fails when
// just that is wrong. A limit is broken by judging against requests or a robot with a slightly lower one.
#include "tests/controller/support/set_point_judge.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/controller/support/path_rig.hpp"

namespace armature {
namespace {

using test::degrees;
using test::kGentle;
using test::PathRig;
using test::RandomChain;
using test::SetPointJudge;

const JointAngles kStart = degrees({10, 20, 10, 5, 40, 0});

Transform turned_and_moved(const Transform& from, double angle_rad, double x_mm, double y_mm, double z_mm) {
  return test::turned_by(test::moved(from, x_mm, y_mm, z_mm), angle_rad, {1, 2, 3});
}

// Set-points of a chain of moves of an arm, those of the planner at first.
struct Motion {
  Motion(const RobotModel& robot, const JointAngles& start, const std::vector<SegmentRequest>& requests) : arm{robot} {
    PathRig rig{robot};
    chain.robot = robot;
    chain.start = start;
    chain.requests = requests;
    EXPECT_EQ(rig.plan(start, requests), CartesianPlanner::Progress::kDone);
    joints = rig.set_points();
  }

  [[nodiscard]] SetPointJudge judge() {
    chain.most = chain.requests[0].limits;
    for (const SegmentRequest& request : chain.requests) {
      const PathLimits& limits = request.limits;
      chain.most.speed_mm_s = std::max(chain.most.speed_mm_s, limits.speed_mm_s);
      chain.most.accel_mm_s2 = std::max(chain.most.accel_mm_s2, limits.accel_mm_s2);
      chain.most.turn_speed_rad_s = std::max(chain.most.turn_speed_rad_s, limits.turn_speed_rad_s);
      chain.most.turn_accel_rad_s2 = std::max(chain.most.turn_accel_rad_s2, limits.turn_accel_rad_s2);
    }
    return SetPointJudge{chain, arm};
  }
  std::string verdict(bool with_jerk = false) { return judge().judge(joints, {.with_jerk = with_jerk}); }
  std::string of_path() { return judge().tool(joints, false); }

  // Changes the tool at a set-point, as the inverse has it there.
  void put(std::size_t k, const Transform& tool) {
    const IkTracking there = arm.track(tool, joints[k]);
    ASSERT_TRUE(there.found);
    joints[k] = there.joints;
  }

  Arm arm;
  RandomChain chain;
  std::vector<JointAngles> joints;
};

Motion line_with_turn(const PathLimits& limits = kGentle, ProfileKind profile = ProfileKind::kTrapezoid) {
  const Transform from = PathRig{test::irb120()}.tool_at(kStart);
  return {test::irb120(), kStart, {test::line_to(turned_and_moved(from, 0.05, 30, 20, -10), limits, 0.0, profile)}};
}
// Turns as fast as it may, for its way is short.
Motion turn_of(double way_mm) {
  const Transform from = PathRig{test::irb120()}.tool_at(kStart);
  return {test::irb120(), kStart, {test::line_to(turned_and_moved(from, 0.3, way_mm, 0, 0), kGentle)}};
}
Motion arc_with_turn() {
  const Transform from = PathRig{test::irb120()}.tool_at(kStart);
  const Eigen::Vector3d via_mm = from.position_mm + Eigen::Vector3d{15, 15, 0};
  return {test::irb120(), kStart, {test::arc_to(via_mm, turned_and_moved(from, 0.2, 0, 30, 0), kGentle)}};
}
Motion circle() {
  const Transform from = PathRig{test::irb120()}.tool_at(kStart);
  const Eigen::Vector3d via_mm = from.position_mm + Eigen::Vector3d{10, 10, 0};
  return {test::irb120(), kStart, {test::circle_through(via_mm, test::moved(from, 0, 20, 0), kGentle)}};
}

bool begins(const std::string& verdict, const std::string& with) {
  return verdict.compare(0, with.size(), with) == 0;
}
#define EXPECT_BEGINS(verdict, with) EXPECT_PRED2(begins, (verdict), (with))

TEST(SetPointJudge, AcceptsWhatThePlannerPlans) {
  for (Motion motion : {line_with_turn(), turn_of(0.0), turn_of(1.0), arc_with_turn(), circle()}) {
    EXPECT_EQ(motion.verdict(), "");
    EXPECT_EQ(motion.judge().end(motion.joints.back()), "");
  }
  EXPECT_EQ(line_with_turn(test::kBrisk, ProfileKind::kSCurve).verdict(true), "");
}

TEST(SetPointJudge, SeesJointLimitsExceeded) {
  Motion motion = line_with_turn(test::kBrisk, ProfileKind::kSCurve);
  const test::JointPeaks peaks = test::joint_peaks(motion.chain.robot, motion.joints);
  const RobotModel robot = motion.chain.robot;
  for (AxisModel& axis : motion.chain.robot.axes) axis.max_speed_rad_s *= 0.99 * peaks.speed;
  EXPECT_BEGINS(motion.verdict(true), "joint speed");
  motion.chain.robot = robot;
  for (AxisModel& axis : motion.chain.robot.axes) axis.max_accel_rad_s2 *= 0.99 * peaks.accel;
  EXPECT_BEGINS(motion.verdict(true), "joint acceleration");
  motion.chain.robot = robot;
  for (AxisModel& axis : motion.chain.robot.axes) axis.max_jerk_rad_s3 *= 0.99 * peaks.jerk;
  EXPECT_BEGINS(motion.verdict(true), "joint jerk");
  EXPECT_EQ(motion.verdict(false), "");
}

TEST(SetPointJudge, SeesAnotherBranchAndAJointOutsideItsRange) {
  Motion motion = line_with_turn();
  const std::size_t middle = motion.joints.size() / 2;
  const JointAngles before = motion.joints[middle];
  const IkSolutions all = motion.arm.inverse(motion.arm.forward(before), before);
  int others = 0;
  for (const IkBranch& branch : std::span{all.branches}.first(all.count)) {
    if (std::fabs((branch.joints[2] - before[2]).value()) < 1e-3) continue;  // a flip of the wrist may be
    ++others;
    motion.joints[middle] = branch.joints;
    EXPECT_NE(motion.judge().branch(motion.joints), "");
  }
  EXPECT_GE(others, 1);
  motion.joints[middle] = before;
  motion.chain.robot.axes[0].max_rad = before[0].value() - 1e-6;
  EXPECT_BEGINS(motion.judge().branch(motion.joints), "joint range");
}

TEST(SetPointJudge, SeesLimitsOfTheToolExceeded) {
  Motion line = line_with_turn();
  line.chain.requests[0].limits.speed_mm_s *= 0.99;
  EXPECT_BEGINS(line.verdict(), "tool speed");
  line = line_with_turn();
  line.chain.requests[0].limits.accel_mm_s2 *= 0.99;
  EXPECT_BEGINS(line.verdict(), "tool acceleration");
  EXPECT_EQ(line.judge().judge(line.joints, {.with_tool = false}), "") << "a stop may";
  Motion turn = turn_of(1.0);
  turn.chain.requests[0].limits.turn_speed_rad_s *= 0.99;
  EXPECT_BEGINS(turn.verdict(), "turn speed");
  turn = turn_of(1.0);
  turn.chain.requests[0].limits.turn_accel_rad_s2 *= 0.99;
  EXPECT_BEGINS(turn.verdict(), "turn acceleration");
}

TEST(SetPointJudge, SeesPitchAndRollOfFiveJointsExceeded) {
  const JointAngles start = degrees({10, -60, 80, 10, 20, 0});
  const Transform from = PathRig{test::hu2012(1.0)}.tool_at(start);
  const auto turn = [&] {
    Motion motion{test::hu2012(1.0), start, {test::line_to(turned_and_moved(from, 0.5, 2, 1, 1), kGentle)}};
    motion.chain.exact = false;
    return motion;
  };
  EXPECT_EQ(turn().verdict(), "");
  Motion motion = turn();
  motion.chain.requests[0].limits.turn_speed_rad_s *= 0.8;
  EXPECT_BEGINS(motion.verdict(), "turn speed");
  motion = turn();
  motion.chain.requests[0].limits.turn_accel_rad_s2 *= 0.8;
  EXPECT_BEGINS(motion.verdict(), "turn acceleration");
}

TEST(SetPointJudge, SeesTheLimitsOfOneMoveExceededThatAnotherMoveHas) {
  const Transform from = PathRig{test::irb120()}.tool_at(kStart);
  const Transform corner = test::moved(from, 30, 0, 0);
  for (const double blend_mm : {0.0, 2.0}) {
    Motion motion{test::irb120(),
                  kStart,
                  {test::line_to(corner, kGentle, blend_mm), test::line_to(test::moved(corner, 0, 30, 0), kGentle)}};
    EXPECT_EQ(motion.verdict(), "");
    for (std::size_t slow : {0u, 1u}) {
      Motion other = motion;
      other.chain.requests[slow].limits.speed_mm_s *= 0.99;
      EXPECT_BEGINS(other.verdict(), "tool speed");
      other = motion;
      other.chain.requests[slow].limits.accel_mm_s2 *= 0.99;
      EXPECT_BEGINS(other.verdict(), "tool acceleration");
    }
  }
}

TEST(SetPointJudge, SeesAToolBesideThePath) {
  for (Motion motion : {line_with_turn(), arc_with_turn(), circle()}) {
    const std::size_t middle = motion.joints.size() / 2;
    const Transform there = motion.arm.forward(motion.joints[middle]);
    motion.put(middle, test::moved(there, 0, 0, 1e-5));
    EXPECT_BEGINS(motion.of_path(), "path at set-point " + std::to_string(middle));
  }
}

TEST(SetPointJudge, SeesAToolThatHasTurnedByAnotherShare) {
  for (Motion motion : {line_with_turn(), turn_of(0.0), arc_with_turn(), circle()}) {
    const std::size_t middle = motion.joints.size() / 2;
    const Transform there = motion.arm.forward(motion.joints[middle]);
    motion.put(middle, test::turned_by(there, 1e-5, {1, -1, 0}));
    EXPECT_BEGINS(motion.of_path(), "path at set-point " + std::to_string(middle));
  }
}

TEST(SetPointJudge, SeesACircleTheWrongWayRoundOrNotDrawn) {
  Motion motion = circle();
  const std::vector<JointAngles> good = motion.joints;
  std::reverse(motion.joints.begin(), motion.joints.end());
  EXPECT_BEGINS(motion.of_path(), "path at set-point");
  std::fill(motion.joints.begin(), motion.joints.end(), good[0]);
  EXPECT_EQ(motion.of_path(), "path left out");
  motion.joints.assign(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(good.size() / 2));
  EXPECT_EQ(motion.of_path(), "path left out");
}

TEST(SetPointJudge, SeesAPieceOfThePathRetracedOrLeftOut) {
  for (const Motion& motion : {line_with_turn(), turn_of(0.0), arc_with_turn(), circle()}) {
    const auto middle = motion.joints.begin() + static_cast<std::ptrdiff_t>(motion.joints.size() / 2);
    Motion back = motion;
    back.joints.assign(motion.joints.begin(), middle);
    back.joints.insert(back.joints.end(), middle - 20, motion.joints.end());
    EXPECT_BEGINS(back.of_path(), "path at set-point");
  }
  // There and back: the way back alone, which is at the end as well.
  const Transform from = PathRig{test::irb120()}.tool_at(kStart);
  Motion twice{
      test::irb120(), kStart, {test::line_to(test::moved(from, 30, 0, 0), kGentle), test::line_to(from, kGentle)}};
  EXPECT_EQ(twice.verdict(), "");
  std::fill(twice.joints.begin(), twice.joints.end(), kStart);
  EXPECT_EQ(twice.of_path(), "path left out");
}

TEST(SetPointJudge, SeesAnEndThatWasNotAskedFor) {
  Motion motion = line_with_turn();
  const JointAngles end = motion.joints.back();
  motion.put(motion.joints.size() - 1, test::moved(motion.arm.forward(end), 1e-6, 0, 0));
  EXPECT_EQ(motion.judge().end(motion.joints.back()), "end position");
  motion.joints.back() = end;
  motion.put(motion.joints.size() - 1, test::turned_by(motion.arm.forward(end), 1e-5, {0, 1, 0}));
  EXPECT_EQ(motion.judge().end(motion.joints.back()), "end rotation");
}

}  // namespace
}  // namespace armature
