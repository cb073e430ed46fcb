#include "controller/language/job/execute/planned_arm.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <optional>

#include "controller/language/job/state/rconf.hpp"
#include "tests/controller/language/job/cartesian_rigs.hpp"

namespace armature::job {
namespace {

using test::degrees;
using test::kDeg;
using test::MachineRig;
using test::MovingRig;
using testing::ElementsAre;
using Progress = Program::Progress;

TEST(PlannedArm, ContinuesBehindPathsWithAStatedPosture) {
  MovingRig rig{
      "MOVJ C0 VJ=50.00\nMOVL C1 V=200.0 PL=2\nMOVL C2 V=200.0 CR=5.0\nMOVL C0\nMOVC C0\nMOVC C1\nMOVC C2\n"
      "MOVL C0\nMOVS C0\nMOVS C1\nMOVS C2\nIMOV P001 V=10.0\nSFTON P001\nMOVL C0\nSFTOF\nMOVJ C1 PL=2\nMOVL C2\n"};
  EXPECT_EQ(rig.run_ahead(), Progress::kEnded);
  ASSERT_EQ(rig.port.sent.size(), 14U);
  for (const std::size_t line : {1U, 2U, 3U, 4U, 5U, 6U, 7U, 11U, 13U}) {
    const Configuration& posture = rig.port.sent_as<CartesianMove>(line).target.configuration;
    EXPECT_EQ(posture.shoulder, ShoulderSide::kFront) << line;
    EXPECT_EQ(posture.wrist, rig.arm.configuration(rig.port.at).wrist) << line;
  }
  EXPECT_EQ(rconf_of(rig.arm, rig.port.sent_as<JointMove>(12).target), 0);
}

TEST(PlannedArm, LeavesThePostureThatNoPositionStatesToTheDispatcher) {
  MovingRig rig{
      "SETE P010 (1) 300000\nSETE P010 (3) 350000\nSETE P010 (4) 1800000\nSETE P010 (6) 1800000\n"
      "MOVJ C0\nMOVL C1\nMOVJ P010 VJ=25.00 PL=4 ACC=50\nMOVL C2\n"};
  EXPECT_EQ(rig.run_ahead(), Progress::kEnded);
  ASSERT_EQ(rig.port.sent.size(), 4U);
  const auto& move = rig.port.sent_as<PoseMove>(2);
  EXPECT_EQ(move.target.frame, kBaseFrame);
  EXPECT_EQ(move.target.position_mm, (Eigen::Vector3d{300, 0, 350}));
  EXPECT_LT((*move.target.rotation - rotation_from_rpy(180 * kDeg, 0, 180 * kDeg)).norm(), 1e-12);
  EXPECT_EQ(move.target.configuration, Configuration{});
  EXPECT_EQ(move.speed, 0.25);
  EXPECT_EQ(move.accel, 0.5);
  EXPECT_EQ(move.blend.share, 0.5);
}

TEST(PlannedArm, WaitsWhereTheJointsBeforeDecide) {
  // An angle is free.
  EXPECT_TRUE(MovingRig{"MOVJ C0\nMOVL C1\nMOVL C6\n"}.waits_behind(2));
  EXPECT_TRUE(MovingRig{"MOVJ C0\nMOVL C1\nMOVJ C6\n"}.waits_behind(2));
  // Joints that are added to those of the arm.
  EXPECT_TRUE(MovingRig{"MOVJ C0\nMOVL C1\nIMOV P003 VJ=5.00\n"}.waits_behind(2));
}

TEST(PlannedArm, WaitsForWholeTurnsOfAJointMoveAndNotOfAPath) {
  RobotModel robot = test::irb120();
  robot.axes[5].min_rad = -600 * kDeg;
  robot.axes[5].max_rad = 600 * kDeg;
  EXPECT_TRUE((MovingRig{"MOVJ C0\nMOVL C1\nMOVJ C7\n", robot}.waits_behind(2)));
  EXPECT_EQ((MovingRig{"MOVJ C0\nMOVL C1\nMOVL C7\n", robot}.run_ahead()), Progress::kEnded);
}

TEST(PlannedArm, RaisesTheAlarmOfAPostureWhenTheArmStands) {
  MovingRig rig{"MOVJ C0\nMOVL C1\nMOVL C5\n"};
  EXPECT_EQ(rig.run_ahead(), Progress::kWaiting);
  EXPECT_EQ(rig.port.sent.size(), 2U);
  EXPECT_THAT(rig.port.alarms, ElementsAre());
  rig.port.arrived = true;
  EXPECT_EQ(rig.run(), Progress::kAlarm);
  EXPECT_THAT(rig.port.alarms, ElementsAre("MOVL: no solution in this posture (RCONF) within limits"));
}

struct PlannedArmTest : testing::Test {
  RobotModel robot = test::irb120();
  Arm arm{robot};
  MachineSetup setup{.cell = {.robot = robot, .arm = arm, .flange_T_tool = {.position_mm = {0, 0, 100}}}};
  Tools tools{setup};
  Positions positions{setup.cell, tools};
  PlannedArm planned{positions};
  test::RecordingPort port;
  std::array<Record, 1> records{};
  Step step{port, records, 0, 0};
  JointAngles joints = degrees({10, 20, -30, 40, 50, 60});
};

TEST_F(PlannedArmTest, KnowsThePoseOfJointsWithoutWaiting) {
  port.arrived = false;
  planned.set(joints, {});
  EXPECT_TRUE(planned.know_joints(step));
  EXPECT_TRUE(planned.know_pose(step));
  const Transform base_T_tool = arm.forward(joints) * setup.cell.flange_T_tool;
  EXPECT_EQ(planned.base_T_tool()->position_mm, base_T_tool.position_mm);
}

TEST_F(PlannedArmTest, KnowsTheJointsBehindAPathOnlyWhenTheArmStands) {
  port.arrived = false;
  planned.set(joints, {});
  planned.set(std::nullopt, {.position_mm = {300, 0, 300}});
  EXPECT_TRUE(planned.know_pose(step));
  EXPECT_EQ(planned.base_T_tool()->position_mm, Eigen::Vector3d(300, 0, 300));
  EXPECT_FALSE(planned.know_joints(step));
  EXPECT_EQ(step.progress(), Progress::kWaiting);
  port.arrived = true;
  port.at = joints;
  EXPECT_TRUE(planned.know_joints(step));
  EXPECT_EQ(planned.joints(), joints);
}

TEST_F(PlannedArmTest, SolvesNothingForStatedJointsOrWithoutAPosture) {
  Target stated{.joints = joints, .rconf = Position::kHasRconf};
  EXPECT_TRUE(planned.solve(step, PlannedArm::Solve::kJoints, stated));
  Target without{.base_T_tool = {.position_mm = {300, 0, 300}}};
  EXPECT_TRUE(planned.solve(step, PlannedArm::Solve::kJoints, without));
  EXPECT_FALSE(without.joints);
  EXPECT_EQ(port.inverses, 0);
}

TEST(PlannedArm, LooksAheadAgainBehindARecordThatHasWaited) {
  MovingRig rig{"MOVJ C0\nMOVL C1\nMOVL C6\nMOVL C1\nMOVL C2\n"};
  EXPECT_EQ(rig.run_ahead(), Progress::kWaiting);
  rig.port.arrived = true;
  while (rig.port.sent.size() < 3) ASSERT_EQ(rig.machine->step(rig.port), Progress::kWorking);
  rig.port.arrived = false;
  EXPECT_EQ(rig.run(), Progress::kEnded);
  EXPECT_EQ(rig.port.sent.size(), 5U);
}

}  // namespace
}  // namespace armature::job
