#include "controller/pendant/protocol/admission.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <set>

namespace armature::pendant {
namespace {

constexpr std::size_t kStates = kStateNames.size();

// A command with the least valid payload.
Frame command_of(const OpcodeRule& rule) {
  return {.opcode = rule.opcode, .parameter = rule.parameter.min, .payload = rule.payload.min};
}

std::set<Opcode> admitted(State state, Profile profile) {
  std::set<Opcode> opcodes;
  for (const OpcodeRule& rule : kOpcodeRules) {
    if (admission(command_of(rule), state, profile) == Status::kOk) opcodes.insert(rule.opcode);
  }
  return opcodes;
}

// What changes nothing of the arm.
const std::set<Opcode> kQueries{Opcode::kHeartbeat, Opcode::kGetStatus,     Opcode::kSetTelemetry,
                                Opcode::kReadInput, Opcode::kProgramCancel, Opcode::kEcho};

std::set<Opcode> with_queries(std::set<Opcode> opcodes) {
  opcodes.insert(kQueries.begin(), kQueries.end());
  return opcodes;
}

TEST(Admission, OfVoRunsAProgramWithoutAnyOtherCommand) {
  EXPECT_EQ(admitted(State::kRun, Profile::kStrict), kQueries);
}

TEST(Admission, ExtendedAlsoHoldsEndsAndSlowsAProgram) {
  EXPECT_EQ(
      admitted(State::kRun, Profile::kExtended),
      with_queries({Opcode::kStop, Opcode::kSpeedOverride, Opcode::kHold, Opcode::kAbort, Opcode::kSetBreakpoint}));
}

TEST(Admission, AnEmergencyStopIsLeftByItsResetOnly) {
  for (const Profile profile : {Profile::kStrict, Profile::kExtended}) {
    EXPECT_EQ(admitted(State::kEstop, profile), with_queries({Opcode::kEstopReset}));
    EXPECT_EQ(admitted(State::kAlarm, profile), with_queries({Opcode::kResetAlarm}));
    EXPECT_EQ(admitted(State::kOff, profile), kQueries);
  }
}

TEST(Admission, WithoutDrivesNothingMovesTheArm) {
  EXPECT_EQ(
      admitted(State::kIdle, Profile::kExtended),
      with_queries({Opcode::kResetAlarm, Opcode::kServo, Opcode::kStop, Opcode::kSetCoordinates, Opcode::kSetUserFrame,
                    Opcode::kSpeedOverride, Opcode::kJogLimit, Opcode::kTarget, Opcode::kTargetOption,
                    Opcode::kProgramBegin, Opcode::kProgramCommit, Opcode::kProgramSelect, Opcode::kSetBreakpoint}));
}

TEST(Admission, AJogAdmitsJogsAndStops) {
  EXPECT_EQ(admitted(State::kJog, Profile::kStrict),
            with_queries({Opcode::kJogContinuous, Opcode::kJogStop, Opcode::kStop}));
  EXPECT_EQ(admitted(State::kMove, Profile::kStrict), with_queries({Opcode::kSpeedOverride, Opcode::kStop}));
}

TEST(Admission, AHeldProgramContinuesOrEnds) {
  EXPECT_EQ(admitted(State::kHold, Profile::kStrict),
            with_queries({Opcode::kResume, Opcode::kStep, Opcode::kAbort, Opcode::kStop, Opcode::kSetBreakpoint}));
}

TEST(Admission, EachStateRefusesWithItsReason) {
  const Frame move{.opcode = Opcode::kMoveJoints};
  constexpr Status kReasons[kStates]{Status::kNotReady, Status::kNotReady, Status::kOk,
                                     Status::kBusy,     Status::kBusy,     Status::kBusy,
                                     Status::kBusy,     Status::kAlarm,    Status::kEstopLatched};
  for (std::size_t state = 0; state < kStates; ++state) {
    EXPECT_EQ(admission(move, static_cast<State>(state), Profile::kStrict), kReasons[state]) << kStateNames[state];
  }
  const Frame resume{.opcode = Opcode::kResume};
  EXPECT_EQ(admission(resume, State::kIdle, Profile::kStrict), Status::kMode);
  EXPECT_EQ(admission(resume, State::kReady, Profile::kStrict), Status::kMode);
}

TEST(Admission, RefusesAPayloadOutOfItsRangeInEveryState) {
  Frame jog{.opcode = Opcode::kJogContinuous, .payload = 10'000};
  EXPECT_EQ(admission(jog, State::kReady, Profile::kStrict), Status::kOk);
  jog.payload = 10'001;
  EXPECT_EQ(admission(jog, State::kReady, Profile::kStrict), Status::kRange);
  jog.payload = -10'001;
  EXPECT_EQ(admission(jog, State::kReady, Profile::kStrict), Status::kRange);
  const Frame reset{.opcode = Opcode::kEstopReset, .parameter = 0x5A, .payload = 1};
  EXPECT_EQ(admission(reset, State::kEstop, Profile::kStrict), Status::kRange);
}

}  // namespace
}  // namespace armature::pendant
