// What the look-ahead of a job makes of its moves: the tool passes corners without a stop, and postures are kept.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>

#include "tests/controller/app/job_rig.hpp"

namespace armature {
namespace {

using State = ProgramClient::State;

// Positions with the tool down, in front of the arm. C0 has no posture. C5 is C1 with axis 4 turned by half a turn.
std::string job_with_postures(const std::string& instructions) {
  return "/JOB\n//NAME TEST\n//POS\n///NPOS 6,0,0,0,0,0\n///TOOL 0\n///POSTYPE BASE\n///RECTAN\n"
         "C0=300,0,340,180,0,180\n///RCONF 0,0,0,0,0,0\nC1=350,50,300,180,0,180\nC2=400,0,300,180,0,180\n"
         "C3=350,-50,300,180,0,180\nC4=300,0,300,180,0,180\n///RCONF 1,0,0,0,0,0\nC5=350,50,300,180,0,180\n"
         "//INST\nNOP\n" +
         instructions + "END\n";
}

struct JobLookAhead : test::JobRig {
  void execute(const std::string& instructions) {
    start(job_with_postures(instructions));
    rig->run(60'000);
  }
  [[nodiscard]] std::ptrdiff_t blended() const {
    return std::ranges::count_if(rig->moves, [](const MoveStarted& move) { return move.continues; });
  }
};

TEST_F(JobLookAhead, RoundsTheCornersOfLinesWithAStatedPosture) {
  execute("MOVJ C4 VJ=50.00\nMOVL C1 V=200.0 PL=2\nMOVL C2 V=400.0\n");
  EXPECT_EQ(state(), State::kEnded);
  EXPECT_EQ(blended(), 1);
}

TEST_F(JobLookAhead, RoundsTheCornersOfARadius) {
  execute("MOVJ C4 VJ=50.00\nMOVL C1 V=200.0 CR=5.0\nMOVL C2 V=200.0 CR=5.0\nMOVL C3 V=200.0\n");
  EXPECT_EQ(state(), State::kEnded);
  EXPECT_EQ(blended(), 2);
}

TEST_F(JobLookAhead, GoesOnFromArcToArc) {
  execute("SPEED V=300.0\nMOVJ C4 VJ=50.00\nMOVC C4\nMOVC C1\nMOVC C2\nMOVC C3\nMOVC C4\n");
  EXPECT_EQ(state(), State::kEnded);
  EXPECT_EQ(blended(), 3);
}

TEST_F(JobLookAhead, LeavesAPathWithoutAStopForAPostureThatIsNotStated) {
  execute("MOVJ C4 VJ=50.00\nMOVL C1 V=200.0\nMOVL C2 V=200.0 PL=2\nMOVJ C0 VJ=50.00\n");
  EXPECT_EQ(state(), State::kEnded);
  EXPECT_EQ(blended(), 1);
  const Transform tool = arm.forward(rig->last().reference) * flange_T_tool;
  EXPECT_LT((tool.position_mm - Eigen::Vector3d{300, 0, 340}).norm(), 1e-6);
}

TEST_F(JobLookAhead, RefusesAPathThatEndsInAnotherPosture) {
  robot.axes[3].min_rad = -350 * test::kDeg;
  robot.axes[3].max_rad = 350 * test::kDeg;
  arm = Arm{robot};
  execute("MOVJ C4 VJ=50.00\nMOVL C2 V=200.0 PL=2\nMOVL C5 V=200.0\nMOVL C3 V=200.0\n");
  EXPECT_EQ(state(), State::kFailed);
  ASSERT_FALSE(rig->refusals.empty());
  EXPECT_TRUE(std::ranges::any_of(
      rig->refusals, [](const MoveRefused& refusal) { return refusal.reason == Refusal::kConfiguration; }));
}

}  // namespace
}  // namespace armature
