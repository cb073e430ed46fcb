// Tools that turn with the tangent of their path, and those of a five-axis arm that cannot.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "controller/activity/plans/stages/path_requests.hpp"
#include "tests/controller/support/path_rig.hpp"
#include "tests/controller/support/tool_jerk.hpp"

namespace armature {
namespace {

using test::kDeg;
using test::kGentle;
using test::kReady;
using Progress = CartesianPlanner::Progress;

CartesianMove tangent_arc(const Eigen::Vector3d& via_mm, const Eigen::Vector3d& to_mm,
                          SegmentRequest::Kind kind = SegmentRequest::Kind::kArc) {
  CartesianMove move{.kind = kind, .target = {.position_mm = to_mm}, .via_mm = via_mm, .limits = kGentle};
  move.orientation = CartesianMove::Orientation::kTangent;
  return move;
}

constexpr PathLimits kSmoothLimits{.speed_mm_s = 100.0,
                                   .accel_mm_s2 = 1'000.0,
                                   .jerk_mm_s3 = 20'000.0,
                                   .turn_speed_rad_s = 1.5,
                                   .turn_accel_rad_s2 = 15.0,
                                   .turn_jerk_rad_s3 = 200.0};

CartesianMove with_s_curve(CartesianMove move) {
  move.profile = ProfileKind::kSCurve;
  move.limits = kSmoothLimits;
  return move;
}

// The direction of motion in the frame of the tool, from two close poses.
Eigen::Vector3d motion_in_tool(const CartesianPlan& plan, double t_s) {
  const Transform a = tool_pose(plan, t_s - 1e-4), b = tool_pose(plan, t_s + 1e-4);
  return tool_pose(plan, t_s).rotation.transpose() * (b.position_mm - a.position_mm).normalized();
}

struct ChainRig : test::PathRig {
  using test::PathRig::PathRig;
  Progress plan_moves(const JointAngles& start, std::initializer_list<CartesianMove> moves) {
    const ArmPlane plane{robot.arm, flange_T_tool};
    chain.restart(tool_at(start));
    for (const CartesianMove& move : moves) chain.add(move, {}, plane);
    return plan(start, chain.requests());
  }
  PathRequests chain;
};

TEST(TangentOrientation, KeepsTheDirectionOfMotionInTheFrameOfTheTool) {
  ChainRig rig{test::irb120()};
  const Eigen::Vector3d p = rig.tool_at(kReady).position_mm;
  // In a tilted plane; by 90 deg, and by 270 deg, where the shorter rotation goes the other way round.
  for (const double sweep : {0.5 * std::numbers::pi, 1.5 * std::numbers::pi}) {
    const Eigen::Vector3d x{1, 0, 0}, y = Eigen::Vector3d{0, 1, 0.3}.normalized(), centre = p - 30.0 * x;
    const auto on = [&](double angle) {
      return Eigen::Vector3d{centre + 30.0 * (std::cos(angle) * x + std::sin(angle) * y)};
    };
    ASSERT_EQ(rig.plan_moves(kReady, {tangent_arc(on(0.5 * sweep), on(sweep))}), Progress::kDone);
    const CartesianPlan& plan = rig.planner.plan();
    const double end_s = seconds(plan.duration);
    const Eigen::Vector3d first = motion_in_tool(plan, 0.1 * end_s);
    for (const double share : {0.3, 0.5, 0.7, 0.9}) {
      EXPECT_LT((motion_in_tool(plan, share * end_s) - first).norm(), 1e-6) << sweep << " " << share;
    }
    const Eigen::Matrix3d turned =
        Eigen::AngleAxisd{sweep, x.cross(y).normalized()}.toRotationMatrix() * rig.tool_at(kReady).rotation;
    EXPECT_LT((rig.tool_at(plan.target).rotation - turned).norm(), 1e-9);
    const test::JointPeaks peaks = test::joint_peaks(rig.robot, rig.set_points());
    EXPECT_LE(peaks.most(false), 1.0);
    EXPECT_LE(test::tool_peaks(plan, kGentle).most(), 1.001);
  }
}

TEST(TangentOrientation, TurnsOnceWithACircleAndComesBack) {
  ChainRig rig{test::irb120()};
  const Transform start = rig.tool_at(kReady);
  const CartesianMove circle =
      tangent_arc(start.position_mm + Eigen::Vector3d{-20, 20, 0}, start.position_mm + Eigen::Vector3d{-40, 0, 0},
                  SegmentRequest::Kind::kCircle);
  ASSERT_EQ(rig.plan_moves(kReady, {circle}), Progress::kDone);
  const CartesianPlan& plan = rig.planner.plan();
  EXPECT_NEAR(turn_angle_rad(plan.segments[0]), 2 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(std::fabs((plan.target[5] - plan.start[5]).value()), 2 * std::numbers::pi, 1e-6) << "joint 6";
  EXPECT_LT((rig.tool_at(plan.target).rotation - start.rotation).norm(), 1e-9);
  const Eigen::Vector3d first = motion_in_tool(plan, 0.1 * seconds(plan.duration));
  EXPECT_LT((motion_in_tool(plan, 0.6 * seconds(plan.duration)) - first).norm(), 1e-6);
}

TEST(TangentOrientation, AnSCurveLimitsTheJerkOfTheTurn) {
  ChainRig rig{test::irb120()};
  const Eigen::Vector3d p = rig.tool_at(kReady).position_mm;
  // A line, a tangent arc of 10 mm, and a line: the turn sets the speed of the arc.
  const Eigen::Vector3d centre = p + Eigen::Vector3d{30, 10, 0};
  const auto on = [&](double angle) {
    return Eigen::Vector3d{centre + 10.0 * Eigen::Vector3d{std::sin(angle), -std::cos(angle), 0}};
  };
  CartesianMove in{.target = {.position_mm = on(0.0)}, .limits = kGentle, .blend_mm = 0.2};
  CartesianMove bow = tangent_arc(on(0.8), on(1.6));
  bow.blend_mm = 0.2;
  const Eigen::Vector3d onwards{std::cos(1.6), std::sin(1.6), 0.0};
  const CartesianMove out{.target = {.position_mm = on(1.6) + 30.0 * onwards}, .limits = kGentle};
  ASSERT_EQ(rig.plan_moves(kReady, {with_s_curve(in), with_s_curve(bow), with_s_curve(out)}), Progress::kDone);
  const CartesianPlan& plan = rig.planner.plan();
  const test::JointPeaks peaks = test::joint_peaks(rig.robot, rig.set_points());
  EXPECT_LE(peaks.most(true), 1.0);
  for (const double shift : {0.0, 0.37}) {
    const test::ToolJerks jerks = test::tool_jerks(plan, kSmoothLimits, shift);
    EXPECT_LE(jerks.move, 1.05L);
    EXPECT_LE(jerks.turn, 1.05L);
    EXPECT_GT(jerks.turn, 0.5L) << "the turn counts";
  }
  const Eigen::Matrix3d turned =
      Eigen::AngleAxisd{1.6, Eigen::Vector3d::UnitZ()}.toRotationMatrix() * rig.tool_at(kReady).rotation;
  EXPECT_LT((rig.tool_at(plan.target).rotation - turned).norm(), 1e-9);
}

TEST(TangentOrientation, TurnsWithEveryTurnOfAHelix) {
  for (const double angle_deg : {540.0, -450.0}) {
    ChainRig rig{test::irb120()};
    const JointAngles start = test::degrees({0, 0, 0, 0, 90, angle_deg > 0 ? 350.0 : -350.0});
    const Transform tool = rig.tool_at(start);
    CartesianMove helix{.kind = SegmentRequest::Kind::kArcAbout,
                        .via_mm = tool.position_mm + Eigen::Vector3d{-20, 0, 0},
                        .about = {.angle_rad = angle_deg * kDeg, .advance_mm = 15.0},
                        .limits = kGentle};
    helix.orientation = CartesianMove::Orientation::kTangent;
    ASSERT_EQ(rig.plan_moves(start, {with_s_curve(helix)}), Progress::kDone)
        << static_cast<int>(rig.planner.problem().kind);
    const CartesianPlan& plan = rig.planner.plan();
    const double end_s = seconds(plan.duration);
    const Eigen::Vector3d first = motion_in_tool(plan, 0.1 * end_s);
    for (const double share : {0.3, 0.5, 0.7, 0.9}) {
      EXPECT_LT((motion_in_tool(plan, share * end_s) - first).norm(), 1e-6) << share;
    }
    EXPECT_NEAR(std::fabs((plan.target[5] - plan.start[5]).value()), std::fabs(angle_deg) * kDeg, 0.2)
        << "joint 1 turns a little";
    EXPECT_LE(test::tool_jerks(plan, kSmoothLimits).turn, 1.05L);
    EXPECT_LE(test::joint_peaks(rig.robot, rig.set_points()).most(true), 1.0);
  }
}

TEST(TangentOrientation, ARoundedChainGoesOnInTheFrameOfTheTurnedTool) {
  ChainRig rig{test::irb120()};
  const Eigen::Vector3d p = rig.tool_at(kReady).position_mm;
  CartesianMove arc = tangent_arc(p + Eigen::Vector3d{-30 + 30 * std::sqrt(0.5), 30 * std::sqrt(0.5), 0},
                                  p + Eigen::Vector3d{-30, 30, 0});
  arc.blend_mm = 2.0;
  // The tool points down; its x axis has turned by 90 deg about z.
  CartesianMove ahead{.target = {.frame = kToolFrame, .position_mm = {0, 0, 10}}, .limits = kGentle};
  ASSERT_EQ(rig.plan_moves(kReady, {arc, ahead}), Progress::kDone);
  const Eigen::Matrix3d turned =
      Eigen::AngleAxisd{0.5 * std::numbers::pi, Eigen::Vector3d::UnitZ()}.toRotationMatrix() *
      rig.tool_at(kReady).rotation;
  const Transform end = rig.tool_at(rig.planner.plan().target);
  EXPECT_LT((end.rotation - turned).norm(), 1e-9);
  EXPECT_LT((end.position_mm - (p + Eigen::Vector3d{-30, 30, 0} + 10.0 * turned.col(2))).norm(), 1e-6);
}

TEST(TangentOrientation, OnALineTheToolKeepsItsOrientation) {
  ChainRig rig{test::irb120()};
  CartesianMove line{.target = {.position_mm = rig.tool_at(kReady).position_mm + Eigen::Vector3d{20, 30, 10}},
                     .limits = kGentle};
  line.orientation = CartesianMove::Orientation::kTangent;
  ASSERT_EQ(rig.plan_moves(kReady, {line}), Progress::kDone);
  EXPECT_EQ(turn_angle_rad(rig.planner.plan().segments[0]), 0.0);
}

class FiveAxisTangent : public testing::Test {
 protected:
  // The hand hangs down at (x, y), or is tilted by `tilt` in the plane of the arm.
  JointAngles joints_at(double x_mm, double y_mm, double tilt_rad) {
    const double heading = std::atan2(y_mm, x_mm);
    const Eigen::Matrix3d rotation = Eigen::AngleAxisd{heading, Eigen::Vector3d::UnitZ()}.toRotationMatrix() *
                                     Eigen::AngleAxisd{tilt_rad, Eigen::Vector3d::UnitY()}.toRotationMatrix() *
                                     Eigen::Matrix3d{Eigen::Vector3d{1, -1, -1}.asDiagonal()};
    const IkSolutions solutions = rig.arm.inverse({rotation, {x_mm, y_mm, -60}}, {});
    EXPECT_GE(solutions.selected, 0);
    return solutions.branches[static_cast<std::size_t>(std::max(solutions.selected, 0))].joints;
  }
  ChainRig rig{test::hu2012(1e-4)};
};

TEST_F(FiveAxisTangent, AVerticalHandTurnsOnAHorizontalArc) {
  const JointAngles start = joints_at(140, 0, 0.0);
  ASSERT_EQ(rig.plan_moves(start, {tangent_arc({120 + 20 * std::sqrt(0.5), 20 * std::sqrt(0.5), -60}, {120, 20, -60})}),
            Progress::kDone);
  const CartesianPlan& plan = rig.planner.plan();
  const Eigen::Vector3d first = motion_in_tool(plan, 0.2 * seconds(plan.duration));
  EXPECT_LT((motion_in_tool(plan, 0.8 * seconds(plan.duration)) - first).norm(), 1e-6);
  EXPECT_LT(plan.segments[0].residual_rad, 1e-9);
}

TEST_F(FiveAxisTangent, ATiltedHandTurnsOnlyAboutAxis1) {
  const JointAngles start = joints_at(170, 0, -0.4);
  const auto about = [](double centre_mm, double angle) {
    const double radius = 170 - centre_mm;
    return Eigen::Vector3d{centre_mm + radius * std::cos(angle), radius * std::sin(angle), -60};
  };
  ASSERT_EQ(rig.plan_moves(start, {tangent_arc(about(0, 0.4), about(0, 0.8))}), Progress::kDone);
  const CartesianPlan& plan = rig.planner.plan();
  const Eigen::Vector3d first = motion_in_tool(plan, 0.2 * seconds(plan.duration));
  EXPECT_LT((motion_in_tool(plan, 0.8 * seconds(plan.duration)) - first).norm(), 1e-5);

  CartesianMove turns{.kind = SegmentRequest::Kind::kArcAbout,
                      .via_mm = about(140, 0.0) - Eigen::Vector3d{30, 0, 0},
                      .about = {.angle_rad = 32 * 2 * std::numbers::pi},
                      .limits = kGentle};
  turns.orientation = CartesianMove::Orientation::kTangent;
  ASSERT_EQ(rig.plan_moves(start, {turns}), Progress::kRefused);
  EXPECT_EQ(rig.planner.problem().kind, PathProblem::Kind::kOrientation);

  ASSERT_EQ(rig.plan_moves(start, {tangent_arc(about(140, 0.4), about(140, 0.8))}), Progress::kRefused);
  EXPECT_EQ(rig.planner.problem().kind, PathProblem::Kind::kOrientation);
  EXPECT_GT(rig.planner.problem().residual_rad, 0.1);
}

// A tilted hand on a line. Its orientation is judged by the slerp of quaternions.
struct SlerpOf {
  Transform from, to;
  [[nodiscard]] double angle_to(const Transform& tool) const {
    const double share = (tool.position_mm - from.position_mm).norm() / (to.position_mm - from.position_mm).norm();
    const Eigen::Quaterniond a{from.rotation}, b{to.rotation}, held{tool.rotation};
    return a.slerp(share, b).angularDistance(held);
  }
};

TEST(FiveAxisSlerp, LeavesTheSlerpByTheReportedAngleOnly) {
  ChainRig rig{test::hu2012(0.2)};
  const JointAngles start = test::degrees({20, -60, 70, 40, 30, 0}), end = test::degrees({10, -50, 75, 20, 0, 0});
  const SlerpOf slerp{rig.tool_at(start), rig.tool_at(end)};
  CartesianMove line{.target = {.position_mm = slerp.to.position_mm, .rotation = slerp.to.rotation}, .limits = kGentle};
  double steady_rad = 0.0, slerp_rad = 0.0;
  for (const auto orientation : {CartesianMove::Orientation::kSteady, CartesianMove::Orientation::kSlerp}) {
    line.orientation = orientation;
    ASSERT_EQ(rig.plan_moves(start, {line}), Progress::kDone) << static_cast<int>(rig.planner.problem().kind);
    double& worst = orientation == CartesianMove::Orientation::kSlerp ? slerp_rad : steady_rad;
    for (const JointAngles& q : rig.set_points()) worst = std::max(worst, slerp.angle_to(rig.tool_at(q)));
    EXPECT_LT((rig.tool_at(rig.planner.plan().target).rotation - slerp.to.rotation).norm(), 1e-9);
    EXPECT_LE(test::joint_peaks(rig.robot, rig.set_points()).most(false), 1.0);
  }
  EXPECT_GT(slerp_rad, 1e-3);
  EXPECT_LT(slerp_rad, steady_rad);
  EXPECT_NEAR(slerp_rad, rig.planner.plan().segments[0].residual_rad, 0.01 * slerp_rad);
}

TEST(FiveAxisSlerp, IsRefusedWhereThePlaneOfTheArmDoesNotPermitIt) {
  ChainRig rig{test::hu2012(1e-4)};
  const JointAngles start = test::degrees({20, -60, 70, 40, 30, 0}), end = test::degrees({10, -50, 75, 20, 0, 0});
  const Transform to = rig.tool_at(end);
  CartesianMove line{.target = {.position_mm = to.position_mm, .rotation = to.rotation}, .limits = kGentle};
  line.orientation = CartesianMove::Orientation::kSlerp;
  ASSERT_EQ(rig.plan_moves(start, {line}), Progress::kRefused);
  EXPECT_EQ(rig.planner.problem().kind, PathProblem::Kind::kOrientation);
  EXPECT_GT(rig.planner.problem().residual_rad, 1e-3);
  EXPECT_LT(rig.planner.problem().at, 0.1);
  line.orientation = CartesianMove::Orientation::kSteady;
  EXPECT_EQ(rig.plan_moves(start, {line}), Progress::kDone);
}

TEST(FiveAxisSlerp, IsExactInOneVerticalPlane) {
  ChainRig rig{test::hu2012(1e-4)};
  const JointAngles start = test::degrees({20, -60, 70, 40, 30, 0}), end = test::degrees({20, -50, 75, 20, 30, 0});
  const SlerpOf slerp{rig.tool_at(start), rig.tool_at(end)};
  CartesianMove line{.target = {.position_mm = slerp.to.position_mm, .rotation = slerp.to.rotation}, .limits = kGentle};
  line.orientation = CartesianMove::Orientation::kSlerp;
  ASSERT_EQ(rig.plan_moves(start, {line}), Progress::kDone);
  EXPECT_LT(rig.planner.plan().segments[0].residual_rad, 1e-9);
  for (const JointAngles& q : rig.set_points()) ASSERT_LT(slerp.angle_to(rig.tool_at(q)), 1e-6);
}

}  // namespace
}  // namespace armature
