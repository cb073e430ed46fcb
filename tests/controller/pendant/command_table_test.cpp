#include "controller/pendant/client/command_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>

#include "tests/controller/pendant/parts_bench.hpp"

namespace armature::pendant {
namespace {

// A strict bus: only an input is read from there.
class CommandTable : public testing::Test {
 protected:
  std::optional<Answer> execute(const Frame& command) {
    return execute_command(command, bench.parts, bench.bus, Cycles{100});
  }
  void expect(const Frame& command, Status status, std::int32_t payload = 0) {
    const std::optional<Answer> answer = execute(command);
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->status, status);
    EXPECT_EQ(answer->payload, payload);
  }

  test::PartsBench bench;
};

TEST_F(CommandTable, AnswersQueriesAtOnce) {
  expect({.opcode = Opcode::kHeartbeat}, Status::kOk);
  expect({.opcode = Opcode::kEcho, .payload = -12}, Status::kOk, -12);
  expect({.opcode = Opcode::kGetStatus}, Status::kOk, static_cast<std::int32_t>(State::kOff));
  EXPECT_CALL(bench.bus, read32).WillOnce(testing::Return(1u << 3));
  expect({.opcode = Opcode::kReadInput, .parameter = 4}, Status::kOk, 1);
}

TEST_F(CommandTable, DoesNotKnowWhatOnlyTheControllerSends) {
  expect({.opcode = Opcode::kEstop}, Status::kUnknown);
  expect({.opcode = Opcode::kProgramData}, Status::kUnknown);
}

TEST_F(CommandTable, AMotionIsThePendantsAndIsAnsweredByAnEvent) {
  EXPECT_FALSE(bench.parts.motion_is_ours);
  EXPECT_FALSE(execute({.opcode = Opcode::kJogIncrement, .parameter = 1, .payload = 100}));
  EXPECT_TRUE(bench.parts.motion_is_ours);
  EXPECT_TRUE(bench.given<JointMove>());
  EXPECT_FALSE(execute({.opcode = Opcode::kHome, .parameter = 3}));
  EXPECT_EQ(bench.given<Home>().value_or(Home{}).axes, 3);
}

TEST_F(CommandTable, AStagedMoveWithoutItsPointsIsRefusedAndIsNoMotion) {
  expect({.opcode = Opcode::kMoveLine}, Status::kCheckFail);
  expect({.opcode = Opcode::kTarget, .parameter = 6}, Status::kRange);
  EXPECT_FALSE(bench.parts.motion_is_ours);
}

TEST_F(CommandTable, AJogStopEndsAJogOnly) {
  expect({.opcode = Opcode::kJogStop}, Status::kOk);
  EXPECT_FALSE(bench.given<Jog>());
  expect({.opcode = Opcode::kJogContinuous, .parameter = 0, .payload = 10'000}, Status::kOk);
  EXPECT_GT(bench.given<Jog>().value_or(Jog{}).joint_rad_s[0], 0.0);
  bench.notify(JogStarted{});
  expect({.opcode = Opcode::kJogStop}, Status::kOk);
  const std::optional<Jog> stop = bench.given<Jog>();
  ASSERT_TRUE(stop);
  EXPECT_EQ(stop->joint_rad_s[0], 0.0);
}

TEST_F(CommandTable, TheDrivesAreSwitchedOffAtOnceAndOnAfterADelay) {
  bench.switch_on();
  expect({.opcode = Opcode::kServo, .parameter = 1}, Status::kOk);
  EXPECT_FALSE(execute({.opcode = Opcode::kServo, .parameter = 0}));
  EXPECT_TRUE(bench.given<SwitchOff>());
  bench.notify(Faulted{.cause = FaultCause::kDrivesOff});
  EXPECT_FALSE(execute({.opcode = Opcode::kServo, .parameter = 1}));
  EXPECT_TRUE(bench.parts.drives.requested());
}

TEST_F(CommandTable, AProgramThatRunsTakesTheMotionFromThePendant) {
  bench.parts.motion_is_ours = true;
  expect({.opcode = Opcode::kRun}, Status::kCheckFail);
  EXPECT_TRUE(bench.parts.motion_is_ours);
  bench.program.set(bench.waiting, std::nullopt);
  expect({.opcode = Opcode::kRun}, Status::kOk);
  EXPECT_FALSE(bench.parts.motion_is_ours);
  EXPECT_TRUE(bench.parts.program_ordered);
  EXPECT_TRUE(bench.parts.programs.runs());
  expect({.opcode = Opcode::kHold}, Status::kOk);
  EXPECT_FALSE(bench.parts.programs.runs());
  expect({.opcode = Opcode::kHold}, Status::kBusy);
}

TEST_F(CommandTable, AStopAlsoEndsTheProgram) {
  bench.program.set(bench.waiting, std::nullopt);
  EXPECT_TRUE(bench.program.run());
  expect({.opcode = Opcode::kStop}, Status::kOk);
  EXPECT_EQ(bench.given<Stop>().value_or(Stop{}).kind, Stop::Kind::kSoft);  // of the program
  EXPECT_EQ(bench.given<Stop>().value_or(Stop{}).kind, Stop::Kind::kQuick);
}

}  // namespace
}  // namespace armature::pendant
