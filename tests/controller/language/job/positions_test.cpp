#include "controller/language/job/execute/positions.hpp"

#include <gtest/gtest.h>

#include "controller/language/job/state/rconf.hpp"
#include "controller/robot/axis_units.hpp"
#include "tests/controller/language/job/cartesian_rigs.hpp"

namespace armature::job {
namespace {

using test::cartesian_job_of;
using test::kDeg;
using test::MachineRig;
using test::moved;
using test::path;
using Progress = Program::Progress;

struct PositionsTest : testing::Test {
  RobotModel robot = test::irb120();
  Arm arm{robot};
  MachineSetup setup{.cell = {.robot = robot, .arm = arm, .flange_T_tool = {.position_mm = {0, 0, 100}}}};
  Tools tools{setup};
  Positions positions{setup.cell, tools};
  Target target{};
};

TEST_F(PositionsTest, FindsAPoseInItsFrame) {
  // The frame is turned by 90 degrees about z: its x axis is the y axis of the base.
  setup.cell.base_T_user[1] =
      Transform{.rotation = rotation_from_rpy(0, 0, 90 * kDeg), .position_mm = {100.0, 20.0, 0.0}};
  ASSERT_EQ(positions.find({.value = {10, 0, 5, 0, 0, 0}, .frame = Frame::kUser, .user = 2, .rconf = 0x81}, target),
            Alarm::kNone);
  EXPECT_LT((target.base_T_tool.position_mm - Eigen::Vector3d(100, 30, 5)).norm(), 1e-12);
  EXPECT_LT((target.base_T_tool.rotation.col(0) - Eigen::Vector3d::UnitY()).norm(), 1e-12);
  EXPECT_FALSE(target.joints);
  EXPECT_EQ(target.rconf, 0x81);
}

TEST_F(PositionsTest, FindsTheJointsThatPulsesState) {
  ASSERT_EQ(positions.find({.value = {1'000, 0, 0, 0, 0, 0}, .frame = Frame::kPulse}, target), Alarm::kNone);
  ASSERT_TRUE(target.joints);
  EXPECT_EQ((*target.joints)[0].value(), 1'000 * AxisUnits{robot.axes[0]}.rad_per_pulse());
  EXPECT_EQ(target.base_T_tool.position_mm, positions.tool_at(*target.joints).position_mm);
}

TEST_F(PositionsTest, HasAnAlarmForFramesThatItDoesNotKnow) {
  EXPECT_EQ(positions.find({.frame = Frame::kUser, .user = 5}, target), Alarm::kFrame);
  EXPECT_EQ(positions.find({.frame = Frame::kUser, .user = 0}, target), Alarm::kFrame);
  EXPECT_EQ(positions.find({.frame = Frame::kTool}, target), Alarm::kUnsupported);
  EXPECT_EQ(positions.find({.frame = Frame::kMasterTool}, target), Alarm::kUnsupported);
}

TEST(Positions, ReachJointsWithAnArmWhoseGeometryIsNotKnown) {
  const RobotModel robot = test::paper_robot();
  const Arm arm{robot};
  MachineSetup setup{.cell = {.robot = robot, .arm = arm}};
  const Tools tools{setup};
  const Positions positions{setup.cell, tools};
  Target target;
  EXPECT_EQ(positions.find({.value = {90, 0, 0, 0, 0, 0}, .frame = Frame::kAngle}, target), Alarm::kNone);
  ASSERT_TRUE(target.joints);
  EXPECT_DOUBLE_EQ((*target.joints)[0].value(), 90 * kDeg);
}

TEST(Shift, TurnsTheToolAboutTheAxesOfTheBaseOrItsOwn) {
  const Transform pose{.rotation = rotation_from_rpy(0, 90 * kDeg, 0), .position_mm = {1, 2, 3}};
  const Transform by{.rotation = rotation_from_rpy(0, 0, 90 * kDeg), .position_mm = {0, 10, 0}};
  const Transform in_base = Shift{.in_base = by}.shifted(pose);
  EXPECT_EQ(in_base.position_mm, Eigen::Vector3d(1, 12, 3));
  // z of the tool is x of the base before and y after the turn.
  EXPECT_LT((in_base.rotation.col(2) - Eigen::Vector3d::UnitY()).norm(), 1e-12);
  const Transform in_tool = Shift{.in_tool = by}.shifted(pose);
  EXPECT_LT((in_tool.position_mm - Eigen::Vector3d(1, 12, 3)).norm(), 1e-12);
  EXPECT_LT((in_tool.rotation.col(2) - Eigen::Vector3d::UnitX()).norm(), 1e-12);
  EXPECT_FALSE(Shift{}.any());
}

TEST(Positions, ShiftsPositions) {
  const auto rig = moved("SFTON P001\nMOVL C0\nMOVJ C0\nSFTON P002 BF\nMOVL C0\nSFTOF\nMOVL C0\n");
  EXPECT_EQ(path(rig, 0).target.position_mm, (Eigen::Vector3d{300, 10, 300}));
  const Transform tool = rig.arm.forward(rig.port.sent_as<JointMove>(1).target) * rig.setup.cell.flange_T_tool;
  EXPECT_LT((tool.position_mm - Eigen::Vector3d{300, 10, 300}).norm(), 1e-9);
  EXPECT_EQ(path(rig, 3).target.position_mm, (Eigen::Vector3d{300, 0, 300}));
}

TEST(Positions, MakesUserFramesAndConvertsPositions) {
  MachineRig rig{
      cartesian_job_of("SETE P010 (1) 100000\nSETE P011 (1) 100000\nSETE P011 (2) 50000\nSETE P012 (1) 50000\n"
                       "MFRAME UF#(3) P010 P011 P012\nCNVRT PX020 PX012 UF#(3)\nGETE D000 P020 (2)\n"
                       "GETE D001 P020 (6)\nCNVRT PX021 PX003 BF\nCNVRT PX022 PX020 RF\n")};
  ASSERT_EQ(rig.run(), Progress::kEnded) << rig.port.alarms.front();
  // Origin (100, 0, 0), x along the y axis of the base, (50, 0, 0) on y: z is up.
  EXPECT_EQ(rig.d(0), 50'000);
  EXPECT_EQ(rig.d(1), -900'000);
  EXPECT_EQ(rig.p(20).frame, Frame::kUser);
  EXPECT_EQ(rig.p(20).user, 3);
  const JointAngles joints =
      test::degrees({1'000 * AxisUnits{rig.robot.axes[0]}.rad_per_pulse() / kDeg, 0, 0, 0, 0, 0});
  const Transform tool = rig.arm.forward(joints) * rig.setup.cell.flange_T_tool;
  EXPECT_NEAR(rig.p(21).value[0], tool.position_mm.x(), 1e-9);
  EXPECT_NEAR(rig.p(21).value[2], tool.position_mm.z(), 1e-9);
  EXPECT_EQ(rig.p(21).rconf, rconf_of(rig.arm, joints) | Position::kHasRconf);
  EXPECT_EQ(rig.p(22).frame, Frame::kRobot);
  EXPECT_NEAR(rig.p(22).value[0], 50.0, 1e-9);
  EXPECT_NEAR(rig.p(22).value[1], 0.0, 1e-9);
}

TEST(Positions, ReadsWhereTheArmStands) {
  MachineRig rig{cartesian_job_of("GETS PX010 $PX000\nGETS PX011 $PX001\n")};
  rig.port.at = test::degrees({10, 20, -30, 40, 50, 60});
  rig.port.arrived = false;
  EXPECT_EQ(rig.run(), Progress::kWaiting);
  rig.port.arrived = true;
  ASSERT_EQ(rig.run(), Progress::kEnded);
  const Transform tool = rig.arm.forward(rig.port.at) * rig.setup.cell.flange_T_tool;
  EXPECT_NEAR(rig.p(10).value[2], -30 * kDeg / AxisUnits{rig.robot.axes[2]}.rad_per_pulse(), 0.51);
  EXPECT_NEAR(rig.p(11).value[1], tool.position_mm.y(), 1e-9);
  EXPECT_EQ(rig.p(11).rconf & 0x3F, rconf_of(rig.arm, rig.port.at));
}

TEST(Positions, ConvertsWithoutTheShift) {
  auto rig = moved("SFTON P001\nCNVRT PX020 PX004 BF\nMOVL P004\n");
  EXPECT_NEAR(rig.p(20).value[1], 0.0, 1e-9);
  EXPECT_NEAR(path(rig, 0).target.position_mm.y(), 10.0, 1e-9);
}

TEST(Positions, KeepsThePostureOfJointsThatAreShifted) {
  const auto rig = moved("GETS PX010 $PX000\nSFTON P001\nMOVJ P010\n");
  const JointAngles& target = rig.port.sent_as<JointMove>(0).target;
  const Transform tool = rig.arm.forward(target) * rig.setup.cell.flange_T_tool;
  const Transform before = rig.arm.forward(rig.port.at) * rig.setup.cell.flange_T_tool;
  // GETS rounds to pulses.
  EXPECT_LT((tool.position_mm - before.position_mm - Eigen::Vector3d(0, 10, 0)).norm(), 0.02);
  EXPECT_EQ(rconf_of(rig.arm, target), rconf_of(rig.arm, rig.port.at));
}

}  // namespace
}  // namespace armature::job
