#include "controller/language/job/state/tools.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "controller/kinematics/transform.hpp"
#include "tests/controller/language/job/machine_rig.hpp"

namespace armature::job {
namespace {

using test::MachineRig;
using test::path;
using testing::ElementsAre;
using Progress = Program::Progress;

constexpr double kDegree = 0.017453292519943295;

// Poses 10 mm beside each other, the second one as given.
std::string tools_job_of(const std::string& second, const std::string& instructions) {
  return "/JOB\n//NAME A\n//POS\n///NPOS 3,0,0,0,0,0\n///TOOL 2\n///POSTYPE BASE\n///RECTAN\nC0=300,0,300,180,0,180\n"
         "///TOOL 3\nC1=310,0,300,180,0,180\nC2=" +
         second + "\n//INST\nNOP\n" + instructions + "END\n";
}

struct ToolRig : MachineRig {
  ToolRig(const std::string& second, const std::string& instructions) : MachineRig{tools_job_of(second, instructions)} {
    setup.settings.flange_T_tool[3] =
        Transform{.rotation = rotation_from_rpy(0.3, -0.2, 0.1), .position_mm = {20.0, -30.0, 150.0}};
    begin();
  }
  // Where tool 3 is when the tool of the arm is at a pose.
  [[nodiscard]] Transform third(const Transform& base_T_tool) const {
    return base_T_tool * inverse(setup.cell.flange_T_tool) * *setup.settings.flange_T_tool[3];
  }
};

void expect_pose(const Transform& pose, const Eigen::Vector3d& place_mm, double roll_deg, double yaw_deg) {
  EXPECT_NEAR((pose.position_mm - place_mm).norm(), 0.0, 1e-6);
  const Eigen::Matrix3d stated = rotation_from_rpy(roll_deg * kDegree, 0.0, yaw_deg * kDegree);
  EXPECT_NEAR((pose.rotation - stated).norm(), 0.0, 1e-9);
}

TEST(Tools, AStatedToolComesToThePosesOfItsNumber) {
  // The last line turns the hand, but with tool 2, which is that of the arm.
  ToolRig rig{"310,20,300,180,0,180", "MOVJ C0\nMOVJ C1\nMOVL C2\nMOVL C0\n"};
  ASSERT_EQ(rig.run(), Progress::kEnded) << rig.port.alarms.front();
  ASSERT_EQ(rig.port.sent.size(), 4U);
  const auto forward = [&](std::size_t i) {
    return rig.arm.forward(rig.port.sent_as<JointMove>(i).target) * rig.setup.cell.flange_T_tool;
  };
  expect_pose(forward(0), {300, 0, 300}, 180, 180);
  expect_pose(rig.third(forward(1)), {310, 0, 300}, 180, 180);
  const auto& line = rig.port.sent_as<CartesianMove>(2);
  expect_pose(rig.third({.rotation = *line.target.rotation, .position_mm = line.target.position_mm}), {310, 20, 300},
              180, 180);
  EXPECT_NEAR((rig.port.sent_as<CartesianMove>(3).target.position_mm - Eigen::Vector3d(300, 0, 300)).norm(), 0, 1e-6);

  ToolRig reader{"310,20,300,180,0,180", "MOVJ C1\nGETS PX010 $PX001\nCNVRT PX011 PX010 BF\n"};
  reader.port.at = rig.port.sent_as<JointMove>(1).target;
  ASSERT_EQ(reader.run(), Progress::kEnded);
  for (const int variable : {10, 11}) {
    EXPECT_NEAR(reader.p(variable).value[0], 310.0, 1e-6);
    EXPECT_NEAR(reader.p(variable).value[1], 0.0, 1e-6);
    EXPECT_NEAR(reader.p(variable).value[2], 300.0, 1e-6);
    EXPECT_EQ(reader.p(variable).tool, 3);
  }
}

TEST(Tools, APathThatTurnsAStatedToolIsAnAlarm) {
  ToolRig rig{"310,20,300,180,0,170", "MOVJ C1\nMOVL C2\n"};
  EXPECT_EQ(rig.run(), Progress::kAlarm);
  EXPECT_EQ(rig.port.sent.size(), 1U);
  EXPECT_THAT(rig.port.alarms, ElementsAre("MOVL: a path that turns a tool of [[job.tool]]"));
}

TEST(Tools, AllowsOneTool) {
  MachineRig rig{
      "/JOB\n//NAME A\n//POS\n///NPOS 3,0,0,0,0,0\n///TOOL 2\n///POSTYPE BASE\n///RECTAN\nC0=300,0,300,180,0,180\n"
      "///TOOL 3\nC1=310,0,300,180,0,180\n///POSTYPE PULSE\n///PULSE\nC2=0,0,0,0,0,0\n//INST\nNOP\nMOVL C0\nMOVJ C2\n"
      "MOVL C1\nEND\n"};
  EXPECT_EQ(rig.run(), Progress::kAlarm);
  EXPECT_EQ(rig.port.sent.size(), 2U);
  EXPECT_THAT(rig.port.alarms, ElementsAre("MOVL: a second tool, of which [[job.tool]] says nothing"));
}

TEST(Tools, AreThatOfTheArmByOneNumberAndThoseThatAreStated) {
  const RobotModel robot = test::irb120();
  const Arm arm{robot};
  MachineSetup setup{.cell = {.robot = robot, .arm = arm, .flange_T_tool = {.position_mm = {0, 0, 100}}}};
  setup.settings.flange_T_tool[3] =
      Transform{.rotation = rotation_from_rpy(0.3, -0.2, 0.1), .position_mm = {20.0, -30.0, 150.0}};
  Tools tools{setup};
  EXPECT_EQ(tools.use(2), Alarm::kNone);
  EXPECT_EQ(tools.use(3), Alarm::kNone);
  EXPECT_EQ(tools.use(4), Alarm::kTool);
  EXPECT_EQ(tools.use(255), Alarm::kTool);
  EXPECT_EQ(tools.present(), 3);
  const Transform third = setup.cell.flange_T_tool * tools.arm_T_tool(3);
  EXPECT_LT((third.position_mm - Eigen::Vector3d(20, -30, 150)).norm(), 1e-12);
  EXPECT_LT((third.rotation - setup.settings.flange_T_tool[3]->rotation).norm(), 1e-12);
  EXPECT_EQ(tools.arm_T_tool(2).position_mm, Eigen::Vector3d::Zero());
  tools.reset();
  EXPECT_EQ(tools.use(4), Alarm::kNone);
}

}  // namespace
}  // namespace armature::job
