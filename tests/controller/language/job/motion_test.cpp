#include "controller/language/job/execute/motion.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "controller/language/job/state/rconf.hpp"
#include "controller/robot/axis_units.hpp"
#include "tests/controller/language/job/cartesian_rigs.hpp"

namespace armature::job {
namespace {

using test::alarm_of;
using test::cartesian_job_of;
using test::kDeg;
using test::MachineRig;
using test::moved;
using test::path;
using testing::ElementsAre;
using Progress = Program::Progress;

TEST(Motion, SendsJointMovesToPulses) {
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

TEST(Motion, ReadsAnglesInDegrees) {
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

TEST(Motion, ReachesPosesInTheirPosture) {
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

TEST(Motion, SendsLinesWithTheirLimits) {
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

TEST(Motion, DrawsACircleThroughFourPoints) {
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

TEST(Motion, BeginsAnotherArcAtFpt) {
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

TEST(Motion, SendsACurveThroughItsPoints) {
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

TEST(Motion, MovesByAPositionVariable) {
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

TEST(Motion, RaisesAnAlarmForPositionsThatItCannotReach) {
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

TEST(Motion, AnInputEndsAMoveWithUntil) {
  MachineRig rig{test::moving_job_of("MOVJ C00001\nMOVJ C00002 VJ=5.00 UNTIL IN#(3)=ON\nMOVJ C00003\n")};
  rig.port.arrived = false;
  EXPECT_EQ(rig.run(), Program::Progress::kWaiting);
  EXPECT_EQ(rig.port.sent.size(), 1U);  // the stop must not drop the first move
  rig.port.arrived = true;
  EXPECT_EQ(rig.machine->step(rig.port), Program::Progress::kWaiting);
  EXPECT_EQ(rig.port.sent.size(), 2U);
}

TEST(Motion, WatchesTheInputOfUntilInEachTick) {
  MachineRig rig{test::moving_job_of("MOVJ C00001 UNTIL IN#(3)=ON\nMOVJ C00002\n")};
  rig.port.inputs[3] = false;
  while (rig.port.sent.empty()) static_cast<void>(rig.machine->step(rig.port));
  rig.port.arrived = false;
  EXPECT_EQ(rig.run(), Program::Progress::kWaiting);
  EXPECT_TRUE(rig.machine->waits_for_time());
  EXPECT_EQ(rig.port.stops, 0);
  rig.port.inputs[3] = true;
  EXPECT_EQ(rig.run(), Program::Progress::kWaiting);
  EXPECT_EQ(rig.run(), Program::Progress::kWaiting);
  EXPECT_EQ(rig.port.stops, 1);  // once
  rig.port.arrived = true;
  EXPECT_EQ(rig.run(), Program::Progress::kEnded);
  EXPECT_EQ(rig.port.sent.size(), 2U);
}

TEST(Motion, LeavesOutAMoveWhoseInputIsReachedBefore) {
  MachineRig rig{test::moving_job_of("MOVJ C00001 UNTIL IN#(3)=OFF\nMOVJ C00002\n")};
  EXPECT_EQ(rig.run(), Program::Progress::kEnded);
  EXPECT_EQ(rig.port.sent.size(), 1U);
  EXPECT_EQ(test::alarm_of("SET B000 17\nMOVJ P001 UNTIL IN#(B000)=ON\n"), "MOVJ: no pin of this number");
}

TEST(Motion, ContinuesFromWhereTheArmStandsBehindUntil) {
  MachineRig rig{cartesian_job_of("MOVL C0 UNTIL IN#(3)=ON\nIMOV P001 V=10.0\n")};
  rig.port.at = test::degrees({0, 10, 20, 0, 60, 0});
  EXPECT_EQ(rig.machine->step(rig.port), Progress::kWorking);  // NOP
  EXPECT_EQ(rig.machine->step(rig.port), Progress::kWaiting);
  rig.port.inputs[3] = true;
  ASSERT_EQ(rig.run(), Progress::kEnded);
  const Transform tool = rig.arm.forward(rig.port.at) * rig.setup.cell.flange_T_tool;
  EXPECT_LT((path(rig, 1).target.position_mm - tool.position_mm - Eigen::Vector3d(0, 10, 0)).norm(), 1e-9);
}

}  // namespace
}  // namespace armature::job
