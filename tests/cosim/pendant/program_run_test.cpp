// Programs that the pendant sends and runs, through the serial line on the verilated logic.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "controller/pendant/parts/programs.hpp"
#include "cosim/kernel/scenario_soc.hpp"
#include "cosim/kernel/simulation.hpp"
#include "cosim/scenario/files/scenario_loader.hpp"
#include "tests/cosim/pendant/linked_pendant.hpp"
#include "tests/support/silent_listener.hpp"

namespace armature::cosim {
namespace {

using pendant::Content;
using pendant::Opcode;
using pendant::State;
using test::LinkedPendant;
using testing::Contains;
using Note = LinkedPendant::Note;

// C0 and C1 are near, C2 is far away. Line 11 is NOP.
std::string job(const std::string& instructions, const std::string& name = "TEST") {
  return "/JOB\n//NAME " + name +
         "\n//POS\n///NPOS 3,0,0,0,0,0\n///POSTYPE "
         "PULSE\n///PULSE\nC00000=0,0,0,0,0,0\nC00001=4000,0,0,0,0,0\nC00002=40000,0,0,0,0,0\n//INST\n"
         "NOP\n" +
         instructions + "END\n";
}

// Set-points of joint 1 in each tick, and the moves of the program.
class Axis1 final : public cosim::test::SilentListener {
 public:
  void on_row(TraceRow& row) override { pulses.push_back(row.telemetry.reference_pulses[0].value()); }
  void on_event(const Event& event, Cycles) override {
    if (const auto* move = std::get_if<MoveStarted>(&event)) moves += move->tag.source() == Source::kProgram ? 1 : 0;
    if (const auto* io = std::get_if<IoDone>(&event)) outputs.emplace_back(io->pin, io->level);
    if (const auto* axis = std::get_if<HomingEnded>(&event)) homed += axis->how == HomingEnd::kHomed ? 1 : 0;
  }
  [[nodiscard]] bool stood(std::size_t from_ms, std::size_t to_ms) const {
    const std::size_t first = 20 * from_ms, end = std::min(20 * to_ms, pulses.size());
    return std::ranges::count(std::span{pulses}.subspan(first, end - first), pulses.at(first)) ==
           static_cast<std::ptrdiff_t>(end - first);
  }
  std::vector<std::int64_t> pulses;
  std::vector<std::pair<int, bool>> outputs;
  int moves = 0, homed = 0;
};

struct PendantProgram : testing::Test {
  // `configured`: the controller has a program before the pendant sends one.
  void run(double duration_s, const std::string& profile = "strict", const std::string& robot_of = "pendant_moves",
           bool configured = false) {
    const std::filesystem::path scenarios = ARMATURE_SOURCE_DIR "/scenarios";
    const char* const name = configured ? "estop_during_program" : "pendant_moves";
    Scenario scenario = load_scenario(scenarios / name, {.search_path = scenarios, .overrides = {}});
    scenario.robot = load_scenario(scenarios / robot_of, {.search_path = scenarios, .overrides = {}}).robot;
    scenario.duration_s = duration_s;
    scenario.engine = Engine::kModel;
    scenario.pendant->profile = profile;
    if (settings) settings(scenario);
    const SimulationEnd end =
        cosim::test::run_to_end(Simulation{scenario, make_soc(scenario), arm, std::nullopt, &peer});
    EXPECT_EQ(end.reason, EndReason::kFinished) << end.failure;
  }
  void send(std::int64_t ms, Content kind, const std::string& text) {
    peer.at(ms, [=](OperatorLink& link) { EXPECT_TRUE(link.download(kind, "a", text)); });
  }

  std::function<void(Scenario&)> settings;
  LinkedPendant peer;
  Axis1 arm;
};

TEST_F(PendantProgram, AJobIsSentAndRun) {
  send(70, Content::kJob, job("MOVJ C00001 VJ=20.00\n"));
  peer.note_at(200);
  peer.at(201, Opcode::kRun);
  peer.note_at(260);
  peer.note_at(780);
  run(0.8);
  EXPECT_TRUE(peer.said("program_commit: ok"));
  EXPECT_TRUE(peer.said("run: ok"));
  ASSERT_EQ(peer.notes.size(), 3U);
  EXPECT_EQ(peer.notes[0], (Note{State::kReady, 0, "ready"}));
  EXPECT_EQ(peer.notes[1], (Note{State::kRun, 12, "runs"}));
  EXPECT_EQ(peer.notes[2], (Note{State::kReady, 13, "ended"}));
  EXPECT_EQ(arm.pulses.back(), 4'000);
}

TEST_F(PendantProgram, AJobCallsTheJobsThatWereSentBefore) {
  send(70, Content::kJob, job("MOVJ C00001 VJ=50.00\n", "SUB"));
  send(200, Content::kFurtherJob, job("CALL JOB:SUB\nCALL JOB:SUB\n", "MAIN"));
  peer.at(350, Opcode::kRun);
  run(0.8);
  EXPECT_TRUE(peer.said("program_commit: ok (1)"));
  EXPECT_EQ(arm.moves, 2);
  EXPECT_EQ(arm.pulses.back(), 4'000);
}

TEST_F(PendantProgram, ASelectedJobAndLineBeginTheProgram) {
  send(70, Content::kJob, job("MOVJ C00001\nMOVJ C00000\nMOVJ C00001\n", "FIRST"));
  send(220, Content::kFurtherJob, job("PAUSE\n", "SECOND"));
  peer.at(350, Opcode::kProgramSelect, 2);
  peer.at(360, Opcode::kProgramSelect, 0);
  peer.at(370, Opcode::kRun, 0, 14);
  run(0.8);
  EXPECT_TRUE(peer.said("program_select: range"));
  EXPECT_TRUE(peer.said("run: ok"));
  EXPECT_EQ(arm.moves, 1);
}

TEST_F(PendantProgram, WhatIsWrongWithAProgramIsReplied) {
  peer.at(70, Opcode::kRun);
  peer.at(80, Opcode::kProgramBegin, 0, static_cast<std::int32_t>(pendant::Programs::kMaxCharacters) + 1);
  peer.at(90, Opcode::kProgramBegin, 0, 12);
  peer.at(100, Opcode::kProgramCommit);
  send(120, Content::kJob, job("MOVJ C00001\nMOVE C00001\n"));
  peer.at(300, Opcode::kRun);
  send(320, Content::kJob, job("CALL JOB:MISSING\n"));
  run(0.5);
  EXPECT_THAT(peer.link.messages(),
              testing::ElementsAre("connected", "servo: ok", "run: check_fail", "program_begin: store_full (262144)",
                                   "program_begin: ok", "program_commit: check_fail", "program_begin: ok",
                                   "program_commit: parse_error (13)", "run: check_fail", "program_begin: ok",
                                   "program_commit: parse_error (12)"));
}

TEST_F(PendantProgram, ARunningProgramOfTheStrictProfileObeysTheEmergencyStopOnly) {
  send(70, Content::kJob, job("MOVJ C00002 VJ=2.00\n"));
  peer.at(200, Opcode::kRun);
  peer.at(260, Opcode::kHold);
  peer.at(270, Opcode::kAbort);
  peer.at(280, Opcode::kStop);
  peer.at(290, Opcode::kJogContinuous, 1, 1'000);
  peer.at(300, Opcode::kSpeedOverride, 0, 1'000);
  peer.note_at(350);
  peer.at(360, [](OperatorLink& link) { link.press_estop(); });
  peer.at(500, Opcode::kEstopReset, 0x5A, 0x0E5709);
  peer.at(510, Opcode::kResetAlarm);
  peer.at(580, Opcode::kServo, 1);
  peer.note_at(790);
  run(0.8);
  for (const char* refused :
       {"hold: busy", "abort: busy", "stop: busy", "jog_continuous: busy", "speed_override: busy"})
    EXPECT_TRUE(peer.said(refused)) << refused;
  EXPECT_EQ(peer.notes[0].state, State::kRun);
  EXPECT_EQ(peer.notes[1].state, State::kReady);
  EXPECT_EQ(peer.notes[1].program, "failed");
  EXPECT_TRUE(arm.stood(365, 500));
  EXPECT_TRUE(arm.stood(700, 800));
  EXPECT_LT(arm.pulses.back(), 4'000);
}

TEST_F(PendantProgram, TheExtendedProfileHoldsResumesAndAborts) {
  send(70, Content::kJob, job("MOVJ C00002 VJ=2.00\n"));
  peer.at(200, Opcode::kRun);
  peer.at(260, Opcode::kHold);
  peer.note_at(400);
  peer.at(401, Opcode::kResume);
  peer.note_at(500);
  peer.at(501, Opcode::kAbort);
  peer.note_at(600);
  run(0.7, "extended");
  EXPECT_EQ(peer.notes[0], (Note{State::kHold, 12, "held"}));
  EXPECT_EQ(peer.notes[1], (Note{State::kRun, 12, "runs"}));
  EXPECT_EQ(peer.notes[2].state, State::kReady);
  EXPECT_EQ(peer.notes[2].program, "aborted");
  EXPECT_TRUE(arm.stood(300, 400));
  EXPECT_FALSE(arm.stood(420, 500));
  EXPECT_TRUE(arm.stood(550, 700));
}

TEST_F(PendantProgram, AProgramIsExecutedLineByLine) {
  send(70, Content::kJob, job("MOVJ C00001 VJ=50.00\nMOVJ C00000 VJ=50.00\n"));
  peer.at(200, Opcode::kRun, 1);
  peer.at(220, Opcode::kStep);  // after NOP
  peer.note_at(500);
  peer.at(501, Opcode::kStep);
  peer.note_at(790);
  run(0.8);
  EXPECT_EQ(peer.notes[0], (Note{State::kHold, 12, "paused"}));
  EXPECT_EQ(peer.notes[1], (Note{State::kHold, 13, "paused"}));
  EXPECT_EQ(arm.moves, 2);
  EXPECT_EQ(arm.pulses.back(), 0);
}

TEST_F(PendantProgram, AProgramPausesAtItsBreakpoints) {
  peer.at(70, Opcode::kSetBreakpoint, 1, 13);  // there is no program
  send(80, Content::kJob, job("MOVJ C00001 VJ=50.00\nMOVJ C00000 VJ=50.00\nMOVJ C00001 VJ=50.00\n"));
  peer.at(200, Opcode::kSetBreakpoint, 1, 14);
  peer.at(210, Opcode::kSetBreakpoint, 1, 13);
  peer.at(220, Opcode::kSetBreakpoint, 0, 14);
  peer.at(230, Opcode::kSetBreakpoint, 1, 10);  // no instruction
  peer.at(240, Opcode::kRun);
  peer.note_at(500);
  peer.at(501, Opcode::kResume);
  peer.note_at(990);
  run(1.0);
  EXPECT_TRUE(peer.said("set_breakpoint: check_fail"));
  EXPECT_TRUE(peer.said("set_breakpoint: ok (2)"));
  EXPECT_EQ(std::ranges::count(peer.link.messages(), "set_breakpoint: ok (1)"), 2);
  EXPECT_TRUE(peer.said("set_breakpoint: range"));
  EXPECT_EQ(peer.notes[0], (Note{State::kHold, 13, "paused"}));
  EXPECT_EQ(peer.notes[1], (Note{State::kReady, 15, "ended"}));
  EXPECT_TRUE(arm.stood(480, 500));
  EXPECT_EQ(arm.pulses.at(20 * 490), 4'000);
  EXPECT_EQ(arm.moves, 3);
}

TEST_F(PendantProgram, ATransferRemovesTheBreakpointsOfTheProgramBefore) {
  send(70, Content::kJob, job("MOVJ C00001 VJ=50.00\n"));
  peer.at(190, Opcode::kSetBreakpoint, 1, 12);
  send(200, Content::kJob, job("MOVJ C00001 VJ=50.00\n"));
  peer.at(320, Opcode::kRun);
  run(0.8);
  EXPECT_TRUE(peer.said("set_breakpoint: ok (1)"));
  EXPECT_EQ(arm.pulses.back(), 4'000);
}

TEST_F(PendantProgram, AJobThatIsAddedRemovesTheBreakpoints) {
  send(70, Content::kJob, job("MOVJ C00001 VJ=50.00\n", "SUB"));
  peer.at(190, Opcode::kSetBreakpoint, 1, 12);
  send(200, Content::kFurtherJob, job("CALL JOB:SUB\n", "MAIN"));
  peer.at(350, Opcode::kRun);
  run(0.8);
  EXPECT_TRUE(peer.said("set_breakpoint: ok (1)"));
  EXPECT_EQ(arm.pulses.back(), 4'000);
}

TEST_F(PendantProgram, TheNextTransferRemovesTheBreakpointsOfAGcodeProgram) {
  send(70, Content::kGcode, "G21 G91 F6000\nG1 Z-5\nM2\n");
  peer.at(150, Opcode::kSetBreakpoint, 1, 2);
  peer.at(160, Opcode::kProgramBegin, 0, 100);
  peer.at(170, Opcode::kSetBreakpoint, 1, 2);
  run(0.2);
  EXPECT_TRUE(peer.said("set_breakpoint: ok (1)"));
  EXPECT_TRUE(peer.said("set_breakpoint: check_fail"));
}

TEST_F(PendantProgram, OfTheExtendedProfileABreakpointIsSetWhileTheProgramRuns) {
  send(70, Content::kJob, job("MOVJ C00001 VJ=10.00\nWAIT IN#(1)=ON T=0.10\nMOVJ C00000 VJ=50.00\n"));
  peer.at(200, Opcode::kRun);
  peer.at(250, Opcode::kSetBreakpoint, 1, 14);
  peer.note_at(990);
  run(1.0, "extended");
  EXPECT_TRUE(peer.said("set_breakpoint: ok (1)"));
  EXPECT_EQ(peer.notes[0], (Note{State::kHold, 14, "paused"}));
  EXPECT_EQ(arm.pulses.back(), 4'000);
}

TEST_F(PendantProgram, ABreakpointPausesEachRoundOfAProgramThatRunsAgainAndAgain) {
  send(70, Content::kJob, job("INC B000\n"));
  peer.at(190, Opcode::kSetBreakpoint, 1, 11);  // NOP, the first line
  peer.at(200, Opcode::kRun, 2);
  for (const std::int64_t ms : {240, 280, 320}) {
    peer.note_at(ms);
    peer.at(ms + 1, Opcode::kResume);
  }
  run(0.33);
  ASSERT_EQ(peer.notes.size(), 3U);
  for (const Note& note : peer.notes) EXPECT_EQ(note, (Note{State::kHold, 11, "paused"}));
  EXPECT_EQ(std::ranges::count(peer.link.messages(), "resume: ok"), 3);
}

TEST_F(PendantProgram, AnErrorOfTheFirstTransferLeavesNoProgram) {
  send(70, Content::kJob, job("MOVE C00001\n"));
  peer.at(200, Opcode::kRun);
  run(0.22, "strict", "pendant_moves", true);
  EXPECT_TRUE(peer.said("program_commit: parse_error (12)"));
  EXPECT_TRUE(peer.said("run: check_fail"));
}

TEST_F(PendantProgram, AGcodeProgramNeedsItsUserFrame) {
  send(70, Content::kGcode, "G21 G91 F6000\nG1 Z-5\nM2\n");
  peer.at(140, Opcode::kSetCoordinates, 3);
  peer.at(150, Opcode::kRun);  // user frame 1 is not defined
  peer.at(160, Opcode::kSetCoordinates, 1);
  peer.at(170, Opcode::kRun, 0, 1);
  run(0.6);
  EXPECT_TRUE(peer.said("run: range"));
  EXPECT_TRUE(peer.said("run: ok"));
  EXPECT_EQ(arm.moves, 1);
}

TEST_F(PendantProgram, ALineBehindTheLastOneIsOutOfRange) {
  send(70, Content::kJob, job("MOVJ C00001 VJ=50.00\n"));  // line 13 is END
  peer.at(200, Opcode::kRun, 0, 14);
  peer.at(210, Opcode::kRun, 0, 13);
  run(0.3);
  EXPECT_THAT(peer.link.messages(), testing::ElementsAre("connected", "servo: ok", "program_begin: ok",
                                                         "program_commit: ok", "run: range", "run: ok"));
  EXPECT_EQ(arm.moves, 0);
}

TEST_F(PendantProgram, ItsMessagesAndItsAlarmReachThePendantWithTheirLine) {
  const std::string text = "turn the part, then press START.";
  send(70, Content::kJob, job("MSG \"" + text + "\"\nTIMER T=0.20\nABORT\n"));
  peer.at(230, Opcode::kRun);
  std::optional<PendantMessage> first, last;
  peer.at(390, [&](OperatorLink& link) { first = link.program_message(); });
  peer.at(590, [&](OperatorLink& link) { last = link.program_message(); });
  run(0.6);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->header.kind, pendant::MessageKind::kMessage);
  EXPECT_EQ(first->text, text);
  EXPECT_EQ(first->place, 12);
  ASSERT_TRUE(last);
  EXPECT_EQ(last->header.kind, pendant::MessageKind::kAlarm);
  EXPECT_EQ(last->header.number, first->header.number + 1);
  EXPECT_EQ(last->place, 14);
  EXPECT_TRUE(peer.said("message: \"" + text + "\""));
}

TEST_F(PendantProgram, GcodeOfALivePendantHasTheSettingsOfTheScenario) {
  settings = [](Scenario& scenario) {
    scenario.gcode.spindle_pin = 3;
    scenario.gcode.tools = {7};
  };
  send(70, Content::kGcode, "G21\nT7 M6\nM3\n(MSG, turns)\nM0\nM2\n");
  peer.at(150, Opcode::kRun);
  run(0.3);
  ASSERT_FALSE(arm.outputs.empty());
  EXPECT_EQ(arm.outputs.back(), (std::pair{3, true})) << "the spindle";
  EXPECT_TRUE(peer.said("message: \"turns\"")) << "T7 is no alarm";
}

TEST_F(PendantProgram, HasRoomForSixteenBreakpoints) {
  send(70, Content::kGcode, "G21 G91 F6000\n" + std::string(20, '\n') + "G1 Z-5\nM2\n");
  for (std::int32_t line = 1; line <= 17; ++line) peer.at(150 + 5 * line, Opcode::kSetBreakpoint, 1, line);
  peer.at(250, Opcode::kSetBreakpoint, 2);
  peer.at(260, Opcode::kSetBreakpoint, 1, 22);
  peer.at(270, Opcode::kRun);
  peer.note_at(390);
  run(0.4);
  EXPECT_TRUE(peer.said("set_breakpoint: ok (16)"));
  EXPECT_TRUE(peer.said("set_breakpoint: store_full (16)"));
  EXPECT_TRUE(peer.said("set_breakpoint: ok"));
  EXPECT_EQ(peer.notes[0].program, "paused");
  EXPECT_EQ(arm.moves, 0);
}

struct SilentPendant : PendantProgram, testing::WithParamInterface<const char*> {};

TEST_P(SilentPendant, HoldsARunningProgramWithTheExtendedProfileOnly) {
  send(70, Content::kJob, job("MOVJ C00002 VJ=2.00\n"));
  peer.at(200, Opcode::kRun);
  peer.at(260, [this](OperatorLink&) { peer.silent = true; });
  run(1.0, GetParam());
  EXPECT_FALSE(arm.stood(700, 750));
  EXPECT_EQ(arm.stood(800, 1'000), GetParam() == std::string_view{"extended"});
}
INSTANTIATE_TEST_SUITE_P(Profiles, SilentPendant, testing::Values("strict", "extended"));

TEST_F(PendantProgram, AGcodeProgramIsSentAndRun) {
  send(70, Content::kGcode, "G21 G91 F6000\nG1 Z-5\nM2\n");
  peer.at(150, Opcode::kRun);
  run(0.6);
  EXPECT_TRUE(peer.said("program_commit: ok"));
  EXPECT_EQ(arm.moves, 1);
}

TEST_F(PendantProgram, ANewTransferReplacesAGcodeProgram) {
  send(70, Content::kGcode, "G21 G91 F6000\nG1 Z-5\nM2\n");
  peer.at(150, Opcode::kProgramBegin, 0, 100);
  peer.at(160, Opcode::kRun);
  run(0.3);
  EXPECT_TRUE(peer.said("run: check_fail"));
  EXPECT_EQ(arm.moves, 0);
}

TEST_F(PendantProgram, TheArmIsHomed) {
  peer.at(70, Opcode::kHome, 1);
  peer.at(110, Opcode::kJogIncrement, 1, 100);
  peer.note_at(160);
  run(0.17, "strict", "homing_six_axes");
  EXPECT_TRUE(peer.said("home: ok"));
  EXPECT_EQ(peer.notes[0].state, State::kMove);
  EXPECT_TRUE(peer.said("jog_increment: busy"));
}

TEST_F(PendantProgram, AStopEndsTheHomingOfAllAxes) {
  peer.at(70, Opcode::kHome, 3);  // axes 1 and 2
  peer.at(110, Opcode::kStop);
  peer.note_at(245);
  run(0.25, "strict", "homing_six_axes");
  EXPECT_TRUE(peer.said("home: ok"));
  EXPECT_EQ(peer.notes[0].state, State::kReady);
}

}  // namespace
}  // namespace armature::cosim
