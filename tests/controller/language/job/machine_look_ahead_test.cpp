// What the machine sends ahead of the arm, and what must wait until the arm stands.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "controller/language/job/rconf.hpp"
#include "tests/controller/language/job/machine_rig.hpp"

namespace armature::job {
namespace {

using test::degrees;
using test::kDeg;
using test::MachineRig;
using testing::ElementsAre;
using Progress = Interpreter::Progress;

// Positions in the base with the tool down. C6 is at the wrist singularity of the rig's arm. At C7 axis 6 is beyond
// half a turn. P001 is 10 mm along y, P003 has pulses.
std::string job_with_postures(const std::string& instructions) {
  return "/JOB\n//NAME TEST\n//POS\n///NPOS 8,0,0,2,0,0\n///TOOL 0\n///POSTYPE BASE\n///RECTAN\n"
         "///RCONF 0,0,0,0,0,0\nC0=300,0,300,180,0,180\nC1=350,50,300,180,0,180\nC2=400,0,300,180,0,180\n"
         "C3=350,-50,300,180,0,180\nC4=300,0,300,180,0,180\n///RCONF 1,0,0,0,0,0\nC5=300,0,300,180,0,180\n"
         "///RCONF 0,0,0,0,0,0\nC6=474,0,630,0,90,0\n"
         "///RCONF 0,0,0,0,1,0\nC7=350,0,300,180,0,180\n///RCONF 0,0,0,0,0,0\nP001=0,10,0,0,0,0\n///POSTYPE "
         "PULSE\n///PULSE\n"
         "P003=1000,0,0,0,0,0\n//INST\nNOP\n" +
         instructions + "END\n";
}

// The arm stands when the program begins, and moves from the first command on.
struct MovingRig : MachineRig {
  explicit MovingRig(const std::string& instructions, const RobotModel& model = test::irb120())
      : MachineRig{{job_with_postures(instructions)}, model} {
    port.at = degrees({0, 10, 20, 0, 60, 0});
  }

  Progress run_ahead() {
    while (port.sent.empty()) {
      const Progress progress = machine->step(port);
      if (progress != Progress::kWorking) return progress;
    }
    port.arrived = false;
    return run();
  }
  // True when the program waits for the arm with so many commands sent, and goes on when the arm stands.
  bool waits_behind(std::size_t commands) {
    if (run_ahead() != Progress::kWaiting || port.sent.size() != commands) return false;
    const std::int64_t inverses = port.inverses;
    if (run() != Progress::kWaiting || port.inverses != inverses) return false;  // and computes nothing meanwhile
    port.arrived = true;
    return run() == Progress::kEnded;
  }
};

TEST(MachineLookAhead, GoesOnBehindPathsWithAStatedPosture) {
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

TEST(MachineLookAhead, LeavesThePostureThatNoPositionStatesToTheDispatcher) {
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

TEST(MachineLookAhead, WaitsWhereTheJointsBeforeDecide) {
  // An angle is free.
  EXPECT_TRUE(MovingRig{"MOVJ C0\nMOVL C1\nMOVL C6\n"}.waits_behind(2));
  EXPECT_TRUE(MovingRig{"MOVJ C0\nMOVL C1\nMOVJ C6\n"}.waits_behind(2));
  // Joints that are added to those of the arm.
  EXPECT_TRUE(MovingRig{"MOVJ C0\nMOVL C1\nIMOV P003 VJ=5.00\n"}.waits_behind(2));
}

TEST(MachineLookAhead, WaitsForWholeTurnsOfAJointMoveAndNotOfAPath) {
  RobotModel robot = test::irb120();
  robot.axes[5].min_rad = -600 * kDeg;
  robot.axes[5].max_rad = 600 * kDeg;
  EXPECT_TRUE((MovingRig{"MOVJ C0\nMOVL C1\nMOVJ C7\n", robot}.waits_behind(2)));
  EXPECT_EQ((MovingRig{"MOVJ C0\nMOVL C1\nMOVL C7\n", robot}.run_ahead()), Progress::kEnded);
}

TEST(MachineLookAhead, RaisesTheAlarmOfAPostureWhenTheArmStands) {
  MovingRig rig{"MOVJ C0\nMOVL C1\nMOVL C5\n"};
  EXPECT_EQ(rig.run_ahead(), Progress::kWaiting);
  EXPECT_EQ(rig.port.sent.size(), 2U);
  EXPECT_THAT(rig.port.alarms, ElementsAre());
  rig.port.arrived = true;
  EXPECT_EQ(rig.run(), Progress::kAlarm);
  EXPECT_THAT(rig.port.alarms, ElementsAre("MOVL: no solution in this posture (RCONF) within limits"));
}

TEST(MachineLookAhead, WaitsForPinsAndNotForLevelsWithoutAPin) {
  EXPECT_TRUE(MovingRig{"MOVJ C0\nDIN B000 OT#(16)\n"}.waits_behind(1));
  EXPECT_TRUE(MovingRig{"MOVJ C0\nDIN B000 OG#(2)\n"}.waits_behind(1));
  EXPECT_TRUE(MovingRig{"MOVJ C0\nWAIT IN#(1)=OFF\n"}.waits_behind(1));
  MovingRig rig{"MOVJ C0\nDOUT OT#(17) ON\nDIN B000 OT#(17)\nDIN B001 OG#(3)\nWAIT OT#(17)=ON\nWAIT B000=1\nMOVL C1\n"};
  EXPECT_EQ(rig.run_ahead(), Progress::kEnded);
  EXPECT_EQ(rig.b(0), 1);
  EXPECT_EQ(rig.b(1), 1);
}

TEST(MachineLookAhead, CountsTheTimeOfAWaitFromTheRestOn) {
  MovingRig rig{"MOVJ C0\nWAIT OT#(17)=ON T=1.00\n"};
  EXPECT_EQ(rig.run_ahead(), Progress::kWaiting);
  rig.port.time = Ticks{100'000};
  EXPECT_EQ(rig.run(), Progress::kWaiting);
  rig.port.arrived = true;
  EXPECT_EQ(rig.run(), Progress::kWaiting);
  rig.port.time = Ticks{120'000};
  EXPECT_EQ(rig.run(), Progress::kEnded);
}

}  // namespace
}  // namespace armature::job
