#include "controller/language/gcode/run/program_runner.hpp"

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>

#include "tests/controller/language/gcode/gcode_rig.hpp"

namespace armature::test {
namespace {

using Progress = Program::Progress;

struct GcodeRunner : testing::Test {
  void begin(std::string_view text) {
    runner = std::make_unique<gcode::ProgramRunner>(cell.setup);
    runner->load({.text = text});
    runner->start();
  }
  Progress start(std::string_view text) {
    begin(text);
    return run(*runner, port);
  }
  // Until the first move is sent; the arm is then under way, and the program waits for it.
  void wait_for_the_first_move(std::string_view text) {
    port.is_done = true;
    begin(text);
    while (port.sent.empty()) ASSERT_EQ(runner->step(port), Progress::kWorking);
    port.is_done = false;
    EXPECT_EQ(run(*runner, port), Progress::kWaiting);
  }
  Cell cell;
  KeepingPort port{cell};
  std::unique_ptr<gcode::ProgramRunner> runner;
};

TEST_F(GcodeRunner, SendsEachMoveWithItsLine) {
  ASSERT_EQ(start("G21 F600\nG0 X0 Y0 Z60\nG1 X20\n\nG1 Y10\nM2\n"), Progress::kEnded);
  ASSERT_EQ(port.sent.size(), 3U);
  EXPECT_EQ(port.sent[0].place, 2U);
  EXPECT_EQ(port.sent[1].place, 3U);
  EXPECT_EQ(port.sent[2].place, 5U);
  const auto moves = port.all<CartesianMove>();
  EXPECT_EQ(moves[1].target.frame, FrameId{1});
  EXPECT_NEAR((moves[2].target.position_mm - Eigen::Vector3d(20.0, 10.0, 60.0)).norm(), 0.0, 1e-12);
  EXPECT_DOUBLE_EQ(moves[0].limits.speed_mm_s, cell.setup.settings.rapid_mm_s);
  EXPECT_DOUBLE_EQ(moves[1].limits.speed_mm_s, 10.0);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(moves[i].rapid, i == 0) << i;
  EXPECT_EQ(port.notes_of(ProgramNote::Kind::kLine).back().place, 6U);
}

// The check before the run does not take the stop for an error: what comes before it is executed.
TEST_F(GcodeRunner, StopsWhereTheProgramAborts) {
  ASSERT_EQ(start("G1 F600 X0 Y0 Z60\nX5\n(ABORT, no part)\nX9\nM3\nM2\n"), Progress::kAlarm);
  EXPECT_EQ(port.sent.size(), 2U);
  EXPECT_EQ(port.notes_of(ProgramNote::Kind::kMessage).back().text.view(), "no part");
  const ProgramNote alarm = port.notes_of(ProgramNote::Kind::kAlarm).back();
  EXPECT_EQ(alarm.place, 3U);
  EXPECT_EQ(alarm.text.view(), "the program stops itself with (ABORT, ...)");
}

TEST_F(GcodeRunner, SaysThatAProgramEndsWithoutACode) {
  ASSERT_EQ(start("G1 F600 X0 Y0 Z60\nX5"), Progress::kEnded);
  EXPECT_EQ(port.sent.size(), 2U);
  ASSERT_EQ(port.notes_of(ProgramNote::Kind::kMessage).size(), 1U);
  EXPECT_EQ(port.notes_of(ProgramNote::Kind::kMessage).back().text.view(), gcode::CanonInterpreter::kNoEndCode);
  ASSERT_EQ(start("G1 F600 X0 Y0 Z60\nM2\n"), Progress::kEnded);
  EXPECT_EQ(port.notes_of(ProgramNote::Kind::kMessage).size(), 1U);
}

TEST_F(GcodeRunner, ExecutesTheFilesOfSubroutines) {
  const std::string text = "G1 F600 X0 Y0 Z60\nM98 P7\nM2\nO7\nX5\nM99\n";
  const std::array ends{static_cast<std::uint32_t>(text.find("O7")), static_cast<std::uint32_t>(text.size())};
  runner = std::make_unique<gcode::ProgramRunner>(cell.setup);
  runner->load({.text = text, .ends = ends});
  runner->start();
  ASSERT_EQ(run(*runner, port), Progress::kEnded);
  ASSERT_EQ(port.sent.size(), 2U);
  EXPECT_EQ(port.sent[1].place, 5U);
  EXPECT_TRUE(port.notes_of(ProgramNote::Kind::kMessage).empty());
}

TEST_F(GcodeRunner, TurnsACoordinateSystemByAnyNumberOfTurns) {
  ASSERT_EQ(start("G10 L2 P1 R360000090\nG1 F600 X10 Y0 Z60\nM2\n"), Progress::kEnded);
  const auto moves = port.all<CartesianMove>();
  EXPECT_NEAR(moves.back().target.position_mm.x(), 0.0, 1e-9);
  EXPECT_NEAR(moves.back().target.position_mm.y(), 10.0, 1e-9);
}

TEST_F(GcodeRunner, TakesTheSineOfAnyNumberOfTurns) {
  ASSERT_EQ(start("G1 F600 X[20*SIN[3600000030]] Y[20*COS[-3600000060]] Z60\nM2\n"), Progress::kEnded);
  EXPECT_NEAR((port.all<CartesianMove>().back().target.position_mm - Eigen::Vector3d(10.0, 10.0, 60.0)).norm(), 0.0,
              1e-9);
}

TEST_F(GcodeRunner, BeginsWhereTheToolIs) {
  const Eigen::Vector3d place = cell.user_T_tool().position_mm;
  ASSERT_EQ(start("G91 G1 F600 X10\nM2\n"), Progress::kEnded);
  EXPECT_NEAR((port.all<CartesianMove>()[0].target.position_mm - place - Eigen::Vector3d(10.0, 0.0, 0.0)).norm(), 0.0,
              1e-9);
}

TEST_F(GcodeRunner, SendsNoMoreThanThePortTakes) {
  port.room = 2;
  EXPECT_EQ(start("G1 F600 X0 Y0 Z60\nX10\nX20\nX30\nM2\n"), Progress::kWaiting);
  EXPECT_EQ(port.sent.size(), 2U);
  port.room = 100;
  EXPECT_EQ(run(*runner, port), Progress::kEnded);
  EXPECT_EQ(port.sent.size(), 4U);
}

TEST_F(GcodeRunner, NamesALineWithAnErrorBeforeAnythingMoves) {
  ASSERT_EQ(start("G1 F600 X0 Y0 Z60\nX10\nG41\nM2\n"), Progress::kAlarm);
  EXPECT_TRUE(port.sent.empty());
  const auto alarms = port.notes_of(ProgramNote::Kind::kAlarm);
  ASSERT_EQ(alarms.size(), 1U);
  EXPECT_EQ(alarms[0].place, 3U);
  EXPECT_EQ(alarms[0].text.view(), "G41: the code is not supported: cutter compensation left");
}

TEST_F(GcodeRunner, NamesTheFirstLineOutOfReachBeforeAnythingMoves) {
  ASSERT_EQ(start("G1 F600 X0 Y0 Z60\nX10\nM0\nX900\nX1000\nM2\n"), Progress::kAlarm);
  EXPECT_TRUE(port.sent.empty());
  const auto alarms = port.notes_of(ProgramNote::Kind::kAlarm);
  ASSERT_EQ(alarms.size(), 1U);
  EXPECT_EQ(alarms[0].place, 4U);
}

TEST_F(GcodeRunner, ChargesTheInverseKinematicsOfTheReachCheck) {
  ASSERT_EQ(start("G0 X0 Y0 Z60\nG1 F600 X20\nM2\n"), Progress::kEnded);
  const std::int64_t shorter = port.inverses;
  EXPECT_GT(shorter, 0);
  // At least one more every 5 mm.
  ASSERT_EQ(start("G0 X0 Y0 Z60\nG1 F600 X20\nY10\nM2\n"), Progress::kEnded);
  EXPECT_EQ(port.inverses - shorter, shorter + 3);
}

TEST_F(GcodeRunner, NamesAnArcThatLeavesTheReachBetweenItsEnds) {
  ASSERT_EQ(start("G1 F600 X0 Y0 Z60\nG3 X0 Y0 I300\nM2\n"), Progress::kAlarm);
  EXPECT_EQ(port.notes_of(ProgramNote::Kind::kAlarm).at(0).place, 2U);
}

TEST_F(GcodeRunner, NamesALineThatLeavesTheLimitsOfAJoint) {
  cell.robot.axes[0].max_rad = 2.0 * kDeg;
  cell.arm = Arm{cell.robot};
  ASSERT_EQ(start("G1 F600 X0 Y0 Z60\nY10\nY-10\nY60\nM2\n"), Progress::kAlarm);
  const auto alarms = port.notes_of(ProgramNote::Kind::kAlarm);
  EXPECT_EQ(alarms.at(0).place, 4U);
  EXPECT_EQ(alarms.at(0).text.view(), "the path needs joint 1 at 2.2 deg, its limit is 2.0 deg");
}

TEST_F(GcodeRunner, KeepsWhatTheProgramStoresOnlyOnceAlthoughItIsCheckedBefore) {
  ASSERT_EQ(start("G1 F600 X0 Y0 Z60\n#5221=[#5221+5]\nG55\nG54\nX0\nM2\n"), Progress::kEnded);
  const auto moves = port.all<CartesianMove>();
  EXPECT_NEAR(moves.back().target.position_mm.x(), 5.0, 1e-12);
}

TEST_F(GcodeRunner, WaitsForTheOperatorAtTheEndOfTheMovesBefore) {
  wait_for_the_first_move("G1 F600 X0 Y0 Z60\nM0\nX10\nM2\n");
  EXPECT_EQ(port.sent.size(), 1U);
  port.is_done = true;
  EXPECT_EQ(run(*runner, port), Progress::kPaused);
  EXPECT_EQ(run(*runner, port), Progress::kEnded);
  EXPECT_EQ(port.sent.size(), 2U);
}

TEST_F(GcodeRunner, PausesAtABreakpointEachTimeAndWhenTheArmStands) {
  ASSERT_TRUE(port.breakpoints.add(3));
  wait_for_the_first_move("G1 F600 X0 Y0 Z60\no1 repeat [2]\nG91 X1\no1 endrepeat\nM2\n");
  port.is_done = true;
  for (std::size_t sent = 1; sent <= 2; ++sent) {
    EXPECT_EQ(run(*runner, port), Progress::kPaused);
    EXPECT_EQ(port.sent.size(), sent);
  }
  EXPECT_EQ(run(*runner, port), Progress::kEnded);
  EXPECT_EQ(port.sent.size(), 3U);
}

TEST_F(GcodeRunner, ABreakpointPausesOnceBeforeADrillingCycleAndNotOnceMoreBehindAPause) {
  ASSERT_TRUE(port.breakpoints.add(3));
  ASSERT_EQ(start("G0 X0 Y0 Z80\nM0\nG91 G83 X1 Z-30 R-5 Q1 L3 F600\nM2\n"), Progress::kPaused);
  EXPECT_EQ(run(*runner, port), Progress::kEnded);
  ASSERT_EQ(start("G0 X0 Y0 Z80\n\nG91 G83 X1 Z-30 R-5 Q1 L3 F600\nM2\n"), Progress::kPaused);
  EXPECT_EQ(run(*runner, port), Progress::kEnded);
}

TEST_F(GcodeRunner, ABreakpointBehindADrillingCycleWaitsForItsEnd) {
  ASSERT_TRUE(port.breakpoints.add(3));
  ASSERT_EQ(start("G0 X0 Y0 Z80\nG91 G83 X1 Z-30 R-5 Q1 L3 F600\nM2\n"), Progress::kPaused);
  const std::size_t before = port.sent.size();
  EXPECT_EQ(run(*runner, port), Progress::kEnded);
  EXPECT_EQ(port.sent.size(), before);
}

TEST_F(GcodeRunner, KnowsItsLines) {
  runner = std::make_unique<gcode::ProgramRunner>(cell.setup);
  for (const char* text : {"G0 X0\nM2", "G0 X0\nM2\n", "G0 X0\rM2\r", "G0 X0\r\nM2\r\n"}) {
    SCOPED_TRACE(text);
    runner->load({.text = text});
    EXPECT_FALSE(runner->has_line(0));
    EXPECT_TRUE(runner->has_line(1));
    EXPECT_TRUE(runner->has_line(2));
    EXPECT_FALSE(runner->has_line(3));
  }
}

// The number of moves that were sent at each pause of a run in single steps.
std::vector<std::size_t> moves_at_pauses(gcode::ProgramRunner& runner, KeepingPort& port) {
  std::vector<std::size_t> moves;
  runner.set_single_step(true);
  while (run(runner, port) == Progress::kPaused) moves.push_back(port.sent.size());
  return moves;
}

TEST_F(GcodeRunner, ASingleStepExecutesAWholeDrillingCycle) {
  begin("G0 X0 Y0 Z80\nG91 G81 X1 Z-30 R-5 L2 F600\nM2\n");
  const std::vector<std::size_t> moves = moves_at_pauses(*runner, port);
  ASSERT_EQ(moves.size(), 3U);
  EXPECT_EQ(moves[0], 1U);
  EXPECT_GT(moves[1], 6U);
  EXPECT_EQ(moves[2], moves[1]);
}

TEST_F(GcodeRunner, AStopIsOnePauseInSingleStepsAndTheStepBehindItExecutesALine) {
  begin("G1 F600 X0 Y0 Z60\nM0\nX5\nM2\n");
  EXPECT_EQ(moves_at_pauses(*runner, port), (std::vector<std::size_t>{1, 1, 2, 2}));
  port.sent.clear();
  runner->set_single_step(false);
  runner->start();
  ASSERT_EQ(run(*runner, port), Progress::kPaused);
  runner->set_single_step(true);
  ASSERT_EQ(run(*runner, port), Progress::kPaused);
  EXPECT_EQ(port.sent.size(), 2U);
}

TEST_F(GcodeRunner, ReadsAnInputWhenTheArmIsThere) {
  port.inputs[3] = true;
  ASSERT_EQ(start("G1 F600 X0 Y0 Z60\nM66 P2 L0\nX[10*#5399]\nM2\n"), Progress::kEnded);
  EXPECT_NEAR(port.all<CartesianMove>().back().target.position_mm.x(), 10.0, 1e-12);
}

TEST_F(GcodeRunner, GoesOnWithMinusOneWhenAnInputDoesNotComeInTime) {
  ASSERT_EQ(start("G1 F600 X0 Y0 Z60\nM66 P2 L3 Q0.5\nX[10*#5399]\nM2\n"), Progress::kWaiting);
  EXPECT_TRUE(runner->waits_for_time());
  port.time = Ticks{9'999};
  EXPECT_EQ(run(*runner, port), Progress::kWaiting);
  port.time = Ticks{10'000};
  EXPECT_EQ(run(*runner, port), Progress::kEnded);
  EXPECT_NEAR(port.all<CartesianMove>().back().target.position_mm.x(), -10.0, 1e-12);
}

TEST_F(GcodeRunner, WaitsForAnEdge) {
  port.inputs[1] = true;
  ASSERT_EQ(start("G1 F600 X0 Y0 Z60\nM66 P0 L1 Q10\nX5\nM2\n"), Progress::kWaiting);
  port.inputs[1] = false;
  EXPECT_EQ(run(*runner, port), Progress::kWaiting);
  port.inputs[1] = true;
  EXPECT_EQ(run(*runner, port), Progress::kEnded);
}

TEST_F(GcodeRunner, ShowsMessages) {
  ASSERT_EQ(start("(a remark)\n(MSG, part done)\n#1=2.5\n(DEBUG,width #1)\nM2\n"), Progress::kEnded);
  const auto messages = port.notes_of(ProgramNote::Kind::kMessage);
  ASSERT_EQ(messages.size(), 2U);
  EXPECT_EQ(messages[0].text.view(), "part done");
  EXPECT_EQ(messages[0].place, 2U);
  EXPECT_EQ(messages[1].text.view(), "width 2.500000");
}

TEST_F(GcodeRunner, DrillsWithFewCallsAtATime) {
  ASSERT_EQ(start("G0 X0 Y0 Z80\nG91 G83 X1 Z-30 R-5 Q0.1 L20 F600\nM2\n"), Progress::kEnded);
  EXPECT_GT(port.all<CartesianMove>().size(), 20U * 3U * 299U);
}

}  // namespace
}  // namespace armature::test
