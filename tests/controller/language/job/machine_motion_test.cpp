// Moves: what the machine sends for positions of each kind.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "controller/language/job/rconf.hpp"
#include "controller/robot/axis_units.hpp"
#include "tests/controller/language/job/machine_rig.hpp"

namespace armature::job {
namespace {

using test::alarm_of;
using test::kDeg;
using test::MachineRig;
using testing::ElementsAre;
using Progress = Interpreter::Progress;

// Positions in the base, with the tool down, in front of the arm; NOP is line 22. P1 is 10 mm along y.
std::string cartesian_job_of(const std::string& instructions) {
  return "/JOB\n//NAME TEST\n//POS\n///NPOS 6,0,0,4,0,0\n///TOOL 0\n///POSTYPE BASE\n///RECTAN\n///RCONF 0,0,0,0,0,0\n"
         "C00000=300,0,300,180,0,180\nC00001=350,50,300,180,0,180\nC00002=400,0,300,180,0,180\nC00003=350,-50,300,180,"
         "0,180\n"
         "C00004=300,0,300,180,0,180\n///RCONF 1,0,0,0,0,0\nC00005=300,0,300,180,0,180\n///RCONF "
         "0,0,0,0,0,0\nP001=0,10,0,0,0,0\n"
         "P002=0,0,0,0,0,90\nP004=400,0,300,180,0,180\n///POSTYPE PULSE\n///PULSE\nP003=1000,0,0,0,0,0\n//INST\nNOP\n" +
         instructions + "END\n";
}

const CartesianMove& path(const MachineRig& rig, std::size_t i) {
  return rig.port.sent_as<CartesianMove>(i);
}

// A rig whose arm stands at a place from which these positions are near.
MachineRig moved(const std::string& instructions) {
  MachineRig rig{cartesian_job_of(instructions)};
  rig.port.at = test::degrees({0, 10, 20, 0, 60, 0});
  EXPECT_EQ(rig.run(), Progress::kEnded) << (rig.port.alarms.empty() ? "" : rig.port.alarms.front());
  return rig;
}

TEST(MachineMotion, SendsJointMovesToPulses) {
  MachineRig rig{
      test::moving_job_of("MOVJ C1 VJ=25.00 ACC=50 DEC=40\nSPEED VJ=5.00\nMOVJ C2 PL=4\nSET I000 1234\n"
                          "MOVJ C3 VJ=I000\n")};
  ASSERT_EQ(rig.run(), Progress::kEnded);
  ASSERT_EQ(rig.port.sent.size(), 3U);
  const auto& first = rig.port.sent_as<JointMove>(0);
  EXPECT_EQ(first.target[0].value(), 1'000 * AxisUnits{rig.robot.axes[0]}.rad_per_pulse());
  EXPECT_EQ(first.target[1].value(), 0.0);
  EXPECT_EQ(first.speed, 0.25);
  EXPECT_EQ(first.accel, 0.4);
  EXPECT_FALSE(first.blend.wanted());
  EXPECT_EQ(rig.port.sent[0].second, Machine::place_of(0, 15));
  EXPECT_EQ(rig.port.sent_as<JointMove>(1).speed, 0.05);
  EXPECT_EQ(rig.port.sent_as<JointMove>(1).blend.share, 0.5);
  EXPECT_DOUBLE_EQ(rig.port.sent_as<JointMove>(2).speed, 0.1234);
}

TEST(MachineMotion, ReadsAnglesInDegrees) {
  MachineRig rig{
      "/JOB\n//NAME A\n//POS\n///NPOS 1,0,0,0,0,0\n///POSTYPE ANGLE\n///ANGLE\nC000=10.5,-20,30,0,-45,90\n//INST\n"
      "NOP\nMOVJ C000\nEND\n"};
  ASSERT_EQ(rig.run(), Progress::kEnded);
  const auto& move = rig.port.sent_as<JointMove>(0);
  EXPECT_DOUBLE_EQ(move.target[0].value(), 10.5 * kDeg);
  EXPECT_DOUBLE_EQ(move.target[5].value(), 90 * kDeg);
  EXPECT_EQ(rig.port.inverses, 0);
  EXPECT_EQ(move.speed, 0.1);
}

TEST(MachineMotion, ReachesPosesInTheirPosture) {
  const auto rig = moved("MOVJ C0\n");
  const auto& move = rig.port.sent_as<JointMove>(0);
  const Transform tool = rig.arm.forward(move.target) * rig.setup.cell.flange_T_tool;
  EXPECT_LT((tool.position_mm - Eigen::Vector3d{300, 0, 300}).norm(), 1e-9);
  EXPECT_LT((tool.rotation - rotation_from_rpy(180 * kDeg, 0, 180 * kDeg)).norm(), 1e-12);
  EXPECT_EQ(rconf_of(rig.arm, move.target), 0);
  EXPECT_EQ(rig.port.inverses, static_cast<std::int64_t>(IkSolutions::kMax));
  // Without a flip, axis 4 would have to turn by half a turn, and it has less.
  MachineRig other{cartesian_job_of("MOVJ C5\n")};
  EXPECT_EQ(other.run(), Progress::kAlarm);
  EXPECT_THAT(other.port.alarms, ElementsAre("MOVJ: no solution in this posture (RCONF) within limits"));
}

TEST(MachineMotion, SendsLinesWithTheirLimits) {
  const auto rig = moved(
      "MOVL C0 V=25.5 PL=0 ACC=50\nMOVL C1 VR=30.0 PL=2\nMOVL C2 CR=7.5\nSPEED V=40.0\nMOVL C3\n"
      "SET I000 123\nMOVL C4 V=I000\n");
  EXPECT_EQ(path(rig, 0).kind, SegmentRequest::Kind::kLine);
  EXPECT_EQ(path(rig, 0).target.position_mm, (Eigen::Vector3d{300, 0, 300}));
  EXPECT_EQ(path(rig, 0).limits.speed_mm_s, 25.5);
  EXPECT_EQ(path(rig, 0).limits.accel_mm_s2, 500.0);
  EXPECT_EQ(path(rig, 0).limits.joint_accel, 0.5);
  EXPECT_TRUE(path(rig, 0).exact_stop);
  EXPECT_EQ(path(rig, 0).target.configuration.shoulder, ShoulderSide::kFront);
  EXPECT_FALSE(path(rig, 0).target.configuration.turns);
  EXPECT_DOUBLE_EQ(path(rig, 1).limits.turn_speed_rad_s, 30 * kDeg);
  EXPECT_EQ(path(rig, 1).limits.speed_mm_s, 100.0);
  EXPECT_EQ(path(rig, 1).blend_mm, 25.0);
  EXPECT_FALSE(path(rig, 1).exact_stop);
  EXPECT_EQ(path(rig, 2).blend_mm, 7.5);
  EXPECT_EQ(path(rig, 3).limits.speed_mm_s, 40.0);
  EXPECT_EQ(path(rig, 3).blend_mm, 0.0);
  EXPECT_FALSE(path(rig, 3).exact_stop);
  EXPECT_DOUBLE_EQ(path(rig, 4).limits.speed_mm_s, 12.3);
}

TEST(MachineMotion, DrawsACircleThroughFourPoints) {
  const auto rig = moved("MOVC C0 V=50.0\nMOVC C1\nMOVC C2\nDOUT OT#(1) ON\nMOVC C3\nMOVC C4\n");
  EXPECT_EQ(path(rig, 0).kind, SegmentRequest::Kind::kLine);
  const Eigen::Vector3d center{350, 0, 300};
  const double h = 50 * std::sqrt(0.5);
  const std::array<Eigen::Vector3d, 4> middles{Eigen::Vector3d{-h, h, 0}, {h, h, 0}, {h, -h, 0}, {-h, -h, 0}};
  const std::array<std::size_t, 4> sent{1, 2, 4, 5};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(path(rig, sent[i]).kind, SegmentRequest::Kind::kArc);
    EXPECT_LT((path(rig, sent[i]).via_mm - center - middles[i]).norm(), 1e-9) << i;
  }
}

TEST(MachineMotion, BeginsAnotherArcAtFpt) {
  // Without FPT, C2 would be reached on the circle through C1, C2 and P010.
  const auto rig = moved(
      "SET P010 P004\nSETE P010 (3) 350000\nSET P011 P004\nSETE P011 (1) 350000\n"
      "SETE P011 (3) 400000\nMOVC C0\nMOVC C1\nMOVC C2 FPT\nMOVC P010\nMOVC P011\n");
  ASSERT_EQ(rig.port.sent.size(), 5U);
  const double h = 50 * std::sqrt(0.5);
  EXPECT_LT((path(rig, 2).via_mm - Eigen::Vector3d{350 + h, h, 300}).norm(), 1e-9);
  // C2, P010 and P011 are on a circle in the plane of x and z.
  EXPECT_EQ(path(rig, 3).kind, SegmentRequest::Kind::kArc);
  EXPECT_NEAR(path(rig, 3).via_mm.y(), 0.0, 1e-9);
  EXPECT_EQ(path(rig, 4).kind, SegmentRequest::Kind::kArc);
}

TEST(MachineMotion, SendsACurveThroughItsPoints) {
  const auto rig = moved("MOVS C0 V=10.0\nMOVS C1 V=20.0 PL=0\nMOVS C2\nMOVS C3\n");
  ASSERT_EQ(rig.port.sent.size(), 2U);
  EXPECT_EQ(path(rig, 0).kind, SegmentRequest::Kind::kLine);
  EXPECT_EQ(path(rig, 1).kind, SegmentRequest::Kind::kSpline);
  EXPECT_EQ(path(rig, 1).limits.speed_mm_s, 20.0);
  ASSERT_EQ(path(rig, 1).through.count, 2);
  EXPECT_EQ(path(rig, 1).through.mm[0], (Eigen::Vector3d{350, 50, 300}));
  EXPECT_EQ(path(rig, 1).through.mm[1], (Eigen::Vector3d{400, 0, 300}));
  EXPECT_EQ(path(rig, 1).target.position_mm, (Eigen::Vector3d{350, -50, 300}));
}

TEST(MachineMotion, MovesByAPositionVariable) {
  const auto rig =
      moved("MOVL C0\nIMOV P001 V=10.0\nIMOV P001 V=10.0 TF\nIMOV P002 V=10.0 BF\nMOVJ C0\nIMOV P003 VJ=5.00\n");
  EXPECT_LT((path(rig, 1).target.position_mm - Eigen::Vector3d{300, 10, 300}).norm(), 1e-9);
  // The y axis of the tool is that of the base, because it points down and its x axis to the back.
  EXPECT_LT((path(rig, 2).target.position_mm - Eigen::Vector3d{300, 20, 300}).norm(), 1e-9);
  EXPECT_LT((path(rig, 3).target.position_mm - Eigen::Vector3d{300, 20, 300}).norm(), 1e-9);
  EXPECT_LT((*path(rig, 3).target.rotation - rotation_from_rpy(180 * kDeg, 0, 270 * kDeg)).norm(), 1e-12);
  EXPECT_NEAR(rig.port.sent_as<JointMove>(5).target[0].value() - rig.port.sent_as<JointMove>(4).target[0].value(),
              1'000 * AxisUnits{rig.robot.axes[0]}.rad_per_pulse(), 1e-12);
}

TEST(MachineMotion, ShiftsPositions) {
  const auto rig = moved("SFTON P001\nMOVL C0\nMOVJ C0\nSFTON P002 BF\nMOVL C0\nSFTOF\nMOVL C0\n");
  EXPECT_EQ(path(rig, 0).target.position_mm, (Eigen::Vector3d{300, 10, 300}));
  const Transform tool = rig.arm.forward(rig.port.sent_as<JointMove>(1).target) * rig.setup.cell.flange_T_tool;
  EXPECT_LT((tool.position_mm - Eigen::Vector3d{300, 10, 300}).norm(), 1e-9);
  EXPECT_EQ(path(rig, 3).target.position_mm, (Eigen::Vector3d{300, 0, 300}));
}

TEST(MachineMotion, RaisesAnAlarmForPositionsThatItCannotReach) {
  const auto alarm = [](const std::string& instructions) {
    MachineRig rig{cartesian_job_of(instructions)};
    EXPECT_EQ(rig.run(), Progress::kAlarm);
    return rig.port.alarms.empty() ? "" : rig.port.alarms.front();
  };
  EXPECT_EQ(alarm("MOVJ P010\n"), "MOVJ: a position variable that is not set");
  EXPECT_EQ(alarm("SETE P001 (1) 9000000\nMOVJ P001\n"), "MOVJ: no solution in this posture (RCONF) within limits");
  EXPECT_EQ(alarm("SFTON P001 UF#(2)\n"), "SFTON: a frame that is not defined");
  EXPECT_EQ(alarm("SFTON P003\n"), "SFTON: operands of kinds that do not go together");
  EXPECT_EQ(alarm("MOVL C0 +MOVJ EC1\n"), "MOVL: not supported");
  EXPECT_EQ(alarm("MOVJ EC1\n"), "MOVJ: not supported");
  EXPECT_EQ(alarm("SET I000 9\nMOVL C0 PL=I000\n"), "MOVL: a value out of the range of its variable");
  EXPECT_EQ(alarm("SET I000 0\nMOVL C0 V=I000\n"), "MOVL: a value out of the range of its variable");
  EXPECT_EQ(alarm("MFRAME UF#(1) P001 P001 P002\n"), "MFRAME: points of a frame on one line");
}

TEST(MachineMotion, MakesUserFramesAndConvertsPositions) {
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
  EXPECT_NEAR(rig.p(22).value[0], 50.0, 1e-9);
  EXPECT_NEAR(rig.p(22).value[1], 0.0, 1e-9);
}

TEST(MachineMotion, ReadsWhereTheArmStands) {
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

TEST(MachineMotion, AllowsOneTool) {
  MachineRig rig{
      "/JOB\n//NAME A\n//POS\n///NPOS 3,0,0,0,0,0\n///TOOL 2\n///POSTYPE BASE\n///RECTAN\nC0=300,0,300,180,0,180\n"
      "///TOOL 3\nC1=310,0,300,180,0,180\n///POSTYPE PULSE\n///PULSE\nC2=0,0,0,0,0,0\n//INST\nNOP\nMOVL C0\nMOVJ C2\n"
      "MOVL C1\nEND\n"};
  EXPECT_EQ(rig.run(), Progress::kAlarm);
  EXPECT_EQ(rig.port.sent.size(), 2U);
  EXPECT_THAT(rig.port.alarms, ElementsAre("MOVL: a second tool, of which [[job.tool]] says nothing"));
}

TEST(MachineMotion, AnInputEndsAMoveWithUntil) {
  MachineRig rig{test::moving_job_of("MOVJ C00001\nMOVJ C00002 VJ=5.00 UNTIL IN#(3)=ON\nMOVJ C00003\n")};
  rig.port.arrived = false;
  EXPECT_EQ(rig.run(), Interpreter::Progress::kWaiting);
  EXPECT_EQ(rig.port.sent.size(), 1U);  // the stop must not drop the first move
  rig.port.arrived = true;
  EXPECT_EQ(rig.machine->step(rig.port), Interpreter::Progress::kWaiting);
  EXPECT_EQ(rig.port.sent.size(), 2U);
}

TEST(MachineMotion, WatchesTheInputOfUntilInEachTick) {
  MachineRig rig{test::moving_job_of("MOVJ C00001 UNTIL IN#(3)=ON\nMOVJ C00002\n")};
  rig.port.inputs[3] = false;
  while (rig.port.sent.empty()) static_cast<void>(rig.machine->step(rig.port));
  rig.port.arrived = false;
  EXPECT_EQ(rig.run(), Interpreter::Progress::kWaiting);
  EXPECT_TRUE(rig.machine->waits_for_time());
  EXPECT_EQ(rig.port.stops, 0);
  rig.port.inputs[3] = true;
  EXPECT_EQ(rig.run(), Interpreter::Progress::kWaiting);
  EXPECT_EQ(rig.run(), Interpreter::Progress::kWaiting);
  EXPECT_EQ(rig.port.stops, 1);  // once
  rig.port.arrived = true;
  EXPECT_EQ(rig.run(), Interpreter::Progress::kEnded);
  EXPECT_EQ(rig.port.sent.size(), 2U);
}

TEST(MachineMotion, LeavesOutAMoveWhoseInputIsReachedBefore) {
  MachineRig rig{test::moving_job_of("MOVJ C00001 UNTIL IN#(3)=OFF\nMOVJ C00002\n")};
  EXPECT_EQ(rig.run(), Interpreter::Progress::kEnded);
  EXPECT_EQ(rig.port.sent.size(), 1U);
  EXPECT_EQ(test::alarm_of("SET B000 17\nMOVJ P001 UNTIL IN#(B000)=ON\n"), "MOVJ: no pin of this number");
}

}  // namespace
}  // namespace armature::job
