// The operator's orders to a program, and what ends it, on the whole controller.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/controller/app/job_rig.hpp"

namespace armature {
namespace {

using test::axis1_job;
using test::kLineOfNop;
using testing::ElementsAre;

struct ProgramOrders : test::JobRig {
  // True when the arm did not move between the ticks.
  [[nodiscard]] bool stood(std::int64_t from, std::int64_t to) const {
    return rig->row(from).reference == rig->row(to).reference;
  }
};

TEST_F(ProgramOrders, AHoldBrakesOnThePathAndResumeGoesOn) {
  start(axis1_job("MOVJ C00003 VJ=10.00\nMOVJ C00001 VJ=10.00\n"));
  at(3'000, [](ProgramClient& program) {
    EXPECT_TRUE(program.hold());
    EXPECT_FALSE(program.hold());
    EXPECT_EQ(program.state(), State::kHeld);
  });
  at(9'000, [](ProgramClient& program) {
    EXPECT_TRUE(program.resume());
    EXPECT_FALSE(program.resume());
  });
  rig->run(40'000);
  EXPECT_TRUE(stood(5'000, 8'999));
  EXPECT_NE(rig->row(5'000).reference_pulses[0], Pulses{0});
  EXPECT_THAT(lines(), ElementsAre(1, 2));
  EXPECT_EQ(pulses(), 10'000);
  EXPECT_EQ(state(), State::kEnded);
  rig->expect_pulses_conserved();
}

TEST_F(ProgramOrders, APauseEndsByItselfAfterItsTime) {
  start(axis1_job("PAUSE\nMOVJ C00001 VJ=50.00\n"));
  at(1, [](ProgramClient& program) { program.resume_pauses_after(Ticks{3'000}); });
  at(2'900, [](ProgramClient& program) { EXPECT_EQ(program.state(), State::kPaused); });
  rig->run(20'000);
  EXPECT_EQ(state(), State::kEnded);
  EXPECT_EQ(pulses(), 10'000);
  EXPECT_GE(rig->moves.at(0).start_tick, Ticks{3'000});
}

TEST_F(ProgramOrders, ARunFromALineBehindTheLastOneIsRefused) {
  start(axis1_job("MOVJ C00001 VJ=50.00\n"), std::nullopt);
  at(100, [](ProgramClient& program) {
    EXPECT_FALSE(program.run(ProgramClient::Mode::kOnce, kLineOfNop + 3));
    EXPECT_FALSE(program.run(ProgramClient::Mode::kOnce, 1'000'000));
    EXPECT_EQ(program.state(), State::kReady);
    EXPECT_TRUE(program.run(ProgramClient::Mode::kOnce, kLineOfNop + 2));  // END
  });
  rig->run(2'000);
  EXPECT_EQ(state(), State::kEnded);
  EXPECT_TRUE(rig->moves.empty());
}

TEST_F(ProgramOrders, AnAbortEndsTheProgramForGood) {
  start(axis1_job("MOVJ C00003 VJ=10.00\nMOVJ C00001 VJ=10.00\n"));
  at(3'000, [](ProgramClient& program) { EXPECT_TRUE(program.abort()); });
  at(6'000, [](ProgramClient& program) {
    EXPECT_EQ(program.state(), State::kAborted);
    EXPECT_FALSE(program.resume());
    EXPECT_FALSE(program.abort());
  });
  rig->run(20'000);
  EXPECT_TRUE(stood(6'000, 19'998));
  EXPECT_EQ(rig->moves.size(), 1U);
  EXPECT_LT(pulses(), 30'000);
}

TEST_F(ProgramOrders, AHeldProgramCanBeAbortedAndRunAgain) {
  start(axis1_job("MOVJ C00003 VJ=10.00\nMOVJ C00001 VJ=10.00\n"));
  at(3'000, [](ProgramClient& program) { EXPECT_TRUE(program.hold()); });
  at(5'000, [](ProgramClient& program) { EXPECT_TRUE(program.abort()); });
  at(7'000, [](ProgramClient& program) {
    EXPECT_EQ(program.state(), State::kAborted);
    EXPECT_TRUE(program.run());
    EXPECT_FALSE(program.run());
  });
  rig->run(60'000);
  EXPECT_TRUE(stood(5'000, 6'999));
  EXPECT_THAT(lines(), ElementsAre(1, 1, 2));
  EXPECT_EQ(pulses(), 10'000);
  EXPECT_EQ(state(), State::kEnded);
}

TEST_F(ProgramOrders, SingleStepsExecuteOneLineEach) {
  start(axis1_job("MOVJ C00001 VJ=50.00\nMOVJ C00002 VJ=50.00\n"), std::nullopt);
  at(100, [](ProgramClient& program) {
    EXPECT_EQ(program.state(), State::kReady);
    EXPECT_TRUE(program.run(ProgramClient::Mode::kSingleSteps));
  });
  std::vector<std::int64_t> places;
  for (int i = 1; i <= 3; ++i) {
    at(i * 8'000, [&, i](ProgramClient& program) {
      places.push_back(pulses());
      EXPECT_EQ(program.state(), State::kPaused);
      EXPECT_TRUE(i % 2 == 0 ? program.step() : program.resume());
    });
  }
  rig->run(40'000);
  EXPECT_THAT(places, ElementsAre(0, 10'000, 20'000));  // NOP and both moves
  EXPECT_EQ(state(), State::kEnded);
}

TEST_F(ProgramOrders, AStepFromAPauseExecutesOneLine) {
  start(axis1_job("PAUSE\nMOVJ C00001\nMOVJ C00002\nMOVJ C00003\n"));
  at(2'000, [](ProgramClient& program) { EXPECT_TRUE(program.step()); });
  std::int64_t before = 0;
  at(12'000, [&](ProgramClient& program) {
    before = pulses();
    EXPECT_EQ(program.state(), State::kPaused);
    EXPECT_TRUE(program.resume());
  });
  rig->run(40'000);
  EXPECT_EQ(before, 10'000);
  EXPECT_EQ(pulses(), 30'000);
}

TEST_F(ProgramOrders, ARunBeginsAtALine) {
  start(axis1_job("MOVJ C00003\nMOVJ C00002\nMOVJ C00001\n"), std::nullopt);
  at(100, [](ProgramClient& program) { EXPECT_TRUE(program.run(ProgramClient::Mode::kOnce, kLineOfNop + 2)); });
  rig->run(30'000);
  EXPECT_THAT(lines(), ElementsAre(2, 3));
}

TEST_F(ProgramOrders, AProgramRunsAgainAndAgainUntilItIsAborted) {
  start(axis1_job("MOVJ C00001 VJ=100.00\nMOVJ C00000 VJ=100.00\n"), std::nullopt);
  at(100, [](ProgramClient& program) { EXPECT_TRUE(program.run(ProgramClient::Mode::kAgain)); });
  at(20'000, [](ProgramClient& program) { EXPECT_TRUE(program.abort()); });
  rig->run(30'000);
  EXPECT_GT(rig->moves.size(), 6U);
  EXPECT_EQ(lines()[2], 1U);
  EXPECT_EQ(state(), State::kAborted);
  EXPECT_TRUE(stood(25'000, 29'998));
}

TEST_F(ProgramOrders, ABreakpointPausesBeforeItsLine) {
  start(axis1_job("MOVJ C00001\nMOVJ C00002\nMOVJ C00003\n"), std::nullopt);
  at(100, [](ProgramClient& program) {
    EXPECT_TRUE(program.breakpoints().add(job::Machine::place_of(0, kLineOfNop + 2)));
    EXPECT_TRUE(program.run());
  });
  std::int64_t before = 0;
  at(15'000, [&](ProgramClient& program) {
    before = pulses();
    EXPECT_EQ(program.state(), State::kPaused);
    EXPECT_TRUE(program.resume());
  });
  rig->run(40'000);
  EXPECT_EQ(before, 10'000);
  EXPECT_EQ(pulses(), 30'000);
}

TEST_F(ProgramOrders, AStopFromElsewhereEndsTheProgram) {
  // The second line waits for the first move, so no other command of the program is refused.
  start(axis1_job("MOVJ C00003 VJ=10.00\nDIN B000 IN#(1)\nMOVJ C00001\n"));
  rig->submit_at(3'000, Stop{});
  rig->run(20'000);
  EXPECT_EQ(state(), State::kFailed);
  EXPECT_EQ(rig->moves.size(), 1U);
}

TEST_F(ProgramOrders, ARefusedMoveEndsTheProgramAndStopsTheArm) {
  std::string text = axis1_job("MOVJ C00001\nMOVJ C00003\nMOVJ C00002\n");
  text.replace(text.find("30000"), 5, "999999");  // outside the soft limits
  start(text);
  rig->run(20'000);
  EXPECT_EQ(state(), State::kFailed);
  ASSERT_EQ(rig->refusals.size(), 2U);  // the moves behind it, too
  EXPECT_EQ(rig->refusals[0].reason, Refusal::kOutsideLimits);
  EXPECT_LE(pulses(), 10'000);
}

struct ProgramInFault : ProgramOrders, testing::WithParamInterface<const char*> {};

TEST_P(ProgramInFault, NothingOfItContinuesAfterTheFaultIsCleared) {
  const std::string what = GetParam();
  start(axis1_job((what == "pause"  ? "PAUSE\n"
                   : what == "wait" ? "WAIT IN#(1)=ON\n"
                                    : "") +
                  std::string{"MOVJ C00003 VJ=10.00\nMOVJ C00001 VJ=10.00\n"}));
  if (what == "hold") at(2'000, [](ProgramClient& program) { EXPECT_TRUE(program.hold()); });
  rig->at(5'000, [this] { rig->logic.pins.estop_n = false; });
  rig->at(6'000, [this] { rig->logic.pins.estop_n = true; });
  rig->submit_at(8'000, ClearFault{});
  rig->at(9'000, [this] { rig->logic.set_tool_input(1, true); });
  State after{};
  at(15'000, [&after](ProgramClient& program) {
    after = program.state();
    EXPECT_FALSE(program.resume());
    EXPECT_FALSE(program.step());
    EXPECT_TRUE(program.run());
  });
  rig->run(20'000);
  EXPECT_EQ(after, State::kFailed);
  EXPECT_TRUE(stood(8'100, 14'999));
  EXPECT_EQ(stood(15'000, 19'998), what == "pause");  // run() begins it again
}
INSTANTIATE_TEST_SUITE_P(Cases, ProgramInFault, testing::Values("move", "hold", "pause", "wait"),
                         [](const auto& test) { return std::string{test.param}; });

}  // namespace
}  // namespace armature
