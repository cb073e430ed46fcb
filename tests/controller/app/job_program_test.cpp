// Jobs of the robot language through the whole controller.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/controller/app/job_rig.hpp"

namespace armature {
namespace {

using test::axis1_job;
using testing::ElementsAre;
using testing::IsEmpty;
using State = ProgramClient::State;

struct JobProgram : test::JobRig {};

TEST_F(JobProgram, MovesToItsPositionsAndNamesTheLines) {
  start(axis1_job("MOVJ C00002 VJ=100.00\nMOVJ C00001 VJ=50.00\nMOVJ C00003 VJ=100.00\n"));
  rig->run(20'000);
  EXPECT_THAT(lines(), ElementsAre(1, 2, 3));
  EXPECT_EQ(rig->moves_finished(), 3);
  EXPECT_EQ(pulses(), 30'000);
  EXPECT_EQ(state(), State::kEnded);
  rig->expect_pulses_conserved();
}

TEST_F(JobProgram, SwitchesAnOutputWhenTheArmIsThere) {
  start(axis1_job("MOVJ C00001\nDOUT OT#(3) ON\nMOVJ C00002\n"));
  watch(3);
  rig->run(30'000);
  ASSERT_EQ(rig->moves.size(), 2U);
  ASSERT_EQ(rig->finished.size(), 2U);
  EXPECT_GT(first_on(), rig->finished[0].tick.value());
  EXPECT_LE(first_on(), rig->moves[1].start_tick.value());
  EXPECT_EQ(pulses(), 20'000);
}

TEST_F(JobProgram, WaitsForAnInputAndForTime) {
  start(axis1_job("WAIT IN#(2)=ON\nMOVJ C00001\nTIMER T=0.10\nMOVJ C00002\n"));
  rig->at(4'000, [this] { rig->logic.set_tool_input(2, true); });
  rig->run(30'000);
  ASSERT_EQ(rig->moves.size(), 3U);  // the time is one
  EXPECT_GE(rig->moves[0].start_tick, Ticks{4'000});
  EXPECT_LE(rig->moves[0].start_tick, Ticks{4'004});
  EXPECT_EQ(rig->moves[2].start_tick - rig->finished[0].tick, Ticks{2'001});
  EXPECT_EQ(state(), State::kEnded);
}

TEST_F(JobProgram, CallsAnotherJobWithAnArgument) {
  start({axis1_job("CALL JOB:SUB ARGF3\nMOVJ C00001\n"),
         axis1_job("GETARG B000 IARG#(1)\nIFTHENEXP B000=3\nMOVJ C00003\nENDIF\n", "SUB")});
  rig->run(40'000);
  EXPECT_THAT(lines(), ElementsAre(3, 2));
  EXPECT_EQ(pulses(), 10'000);
  EXPECT_EQ(state(), State::kEnded);
}

TEST_F(JobProgram, EndsWithAnAlarmAndExecutesNothingBehindIt) {
  start(axis1_job("MOVJ C00001\nSETUALM 8000 \"no part\" 1\nMOVJ C00002\n"));
  rig->run(20'000);
  EXPECT_EQ(state(), State::kFailed);
  EXPECT_EQ(rig->program().last_note().kind, ProgramNote::Kind::kAlarm);
  EXPECT_EQ(rig->program().last_note().text.view(), "SETUALM 8000: no part");
  EXPECT_EQ(pulses(), 10'000);
}

TEST_F(JobProgram, PausesAndGoesOn) {
  start(axis1_job("MOVJ C00001\nPAUSE\nMOVJ C00002\n"));
  std::int64_t before = 0;
  State paused{};
  at(15'000, [&](ProgramClient& program) {
    before = pulses();
    paused = program.state();
    EXPECT_TRUE(program.resume());
  });
  rig->run(30'000);
  EXPECT_EQ(paused, State::kPaused);
  EXPECT_EQ(before, 10'000);
  EXPECT_EQ(pulses(), 20'000);
  EXPECT_EQ(state(), State::kEnded);
}

TEST_F(JobProgram, AnInputEndsAMoveEarlyAndTheProgramGoesOn) {
  start(axis1_job("MOVJ C00003 VJ=10.00 UNTIL IN#(2)=ON\nDOUT OT#(1) ON\nMOVJ C00001\n"));
  rig->at(3'000, [this] { rig->logic.set_tool_input(2, true); });
  watch(1);
  rig->run(20'000);
  EXPECT_EQ(state(), State::kEnded);
  ASSERT_EQ(rig->finished.size(), 2U);
  EXPECT_EQ(rig->finished[0].how, MoveFinished::How::kCutShort);
  EXPECT_LT(rig->finished[0].tick, Ticks{3'400});
  EXPECT_GE(first_on(), rig->finished[0].tick.value());
  EXPECT_EQ(pulses(), 10'000);
  rig->expect_pulses_conserved();
}

// The time of a pulse passes whatever the program does.
struct JobPulse : test::JobRig, testing::WithParamInterface<const char*> {};

TEST_P(JobPulse, EndsInTimeWhateverBecomesOfTheProgram) {
  const std::string what = GetParam();
  const std::string next = what == "pause"   ? "PAUSE\n"
                           : what == "alarm" ? "SETUALM 8000 \"a\" 1\n"
                           : what == "end"   ? ""
                           : what == "stop"  ? "MOVJ C00003 VJ=1.00\n"
                                             : "WAIT IN#(1)=ON\n";
  start(axis1_job("PULSE OT#(4) T=0.20\n" + next));
  watch(4);
  if (what == "hold") at(1'000, [](ProgramClient& program) { EXPECT_TRUE(program.hold()); });
  if (what == "abort") at(1'000, [](ProgramClient& program) { EXPECT_TRUE(program.abort()); });
  if (what == "fault") rig->at(1'000, [this] { rig->logic.pins.estop_n = false; });
  if (what == "stop") rig->submit_at(1'000, Stop{});
  rig->run(6'000);
  EXPECT_EQ(state(), what == "pause"   ? State::kPaused
                     : what == "hold"  ? State::kHeld
                     : what == "abort" ? State::kAborted
                     : what == "end"   ? State::kEnded
                                       : State::kFailed);
  EXPECT_NEAR(static_cast<double>(ticks_on()), 4'000, 1);
  EXPECT_FALSE(levels.back());
}
INSTANTIATE_TEST_SUITE_P(Cases, JobPulse, testing::Values("end", "pause", "alarm", "hold", "abort", "fault", "stop"),
                         [](const auto& test) { return std::string{test.param}; });

}  // namespace
}  // namespace armature
