#include "controller/pendant/parts/arm_commands.hpp"

#include <gtest/gtest.h>

#include <optional>

#include "tests/controller/pendant/parts_bench.hpp"

namespace armature::pendant {
namespace {

class ArmCommandsTest : public testing::Test {
 protected:
  // Gives a command for `opcode`, which waits for its answer.
  Tag give(Opcode opcode, const Command& command = Home{}) {
    EXPECT_FALSE(commands.give(command));
    commands.await(opcode);
    return bench.given<Home>().value_or(Home{}).tag;
  }
  void expect_answer(Status status, std::int32_t payload = 0) {
    const std::optional<Answer> answer = commands.take_answer();
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->status, status);
    EXPECT_EQ(answer->payload, payload);
    EXPECT_FALSE(commands.take_answer());
  }

  test::PartsBench bench;
  ArmCommands& commands = bench.parts.commands;
};

TEST_F(ArmCommandsTest, EachCommandHasATagOfItsOwnBehindThoseOfScenarios) {
  const Tag first = give(Opcode::kHome), second = give(Opcode::kHome);
  EXPECT_NE(first, second);
  EXPECT_EQ(first.source(), Source::kPendant);
  EXPECT_GT(first.number(), 0x00C0'0000u);
}

TEST_F(ArmCommandsTest, AreBusyWhenTheInboxIsFull) {
  for (std::size_t i = 0; i < kInboxCommands; ++i) EXPECT_FALSE(commands.give(Stop{}));
  EXPECT_TRUE(commands.take_given());
  EXPECT_FALSE(commands.take_given());
  EXPECT_EQ(commands.give(Stop{}).value_or(Answer{}).status, Status::kBusy);
  EXPECT_FALSE(commands.take_given());
}

TEST_F(ArmCommandsTest, AStartIsTheAnswerToTheAwaitedCommandOnly) {
  const Tag tag = give(Opcode::kHome);
  EXPECT_FALSE(commands.give(Stop{}));  // not awaited, so its tag does not matter
  bench.notify(MoveStarted{.tag = Tag{tag.number()}});
  EXPECT_FALSE(commands.take_answer());
  bench.notify(MoveStarted{.tag = tag});
  expect_answer(Status::kOk);
  bench.notify(HomingStarted{.tag = tag, .axis = 1});
  expect_answer(Status::kOk);
  bench.notify(IoDone{.tag = tag});
  expect_answer(Status::kOk);
  commands.end_waiting();
  bench.notify(MoveStarted{.tag = tag});
  EXPECT_FALSE(commands.take_answer());
}

TEST_F(ArmCommandsTest, ARefusalIsTheAnswerWithItsAxis) {
  bench.switch_on();
  const Tag tag = give(Opcode::kMoveJoints);
  bench.notify(MoveRefused{.reason = Refusal::kOutsideLimits, .axis = 2, .tag = tag});
  expect_answer(Status::kSoftLimit, 2);
}

TEST_F(ArmCommandsTest, WhatAScenarioHasSentIsNoAnswerBeforeTheFirstCommand) {
  bench.notify(Faulted{.cause = FaultCause::kDrivesOff});
  commands.await(Opcode::kServo);
  bench.notify(MoveRefused{.reason = Refusal::kNotReady, .tag = Tag{}});
  EXPECT_FALSE(commands.take_answer());
}

TEST_F(ArmCommandsTest, SwitchingOnIsAnsweredByItsEffectOrByAnAlarm) {
  bench.notify(Faulted{.cause = FaultCause::kDrivesOff});
  const Tag tag = give(Opcode::kServo);
  bench.notify(MoveRefused{.reason = Refusal::kNotReady, .tag = tag});
  expect_answer(Status::kAlarm);
  bench.notify(FaultCleared{});
  expect_answer(Status::kOk);
}

TEST_F(ArmCommandsTest, SwitchingOffIsAnsweredByItsEffectAndARefusalByItsReason) {
  bench.switch_on();
  const Tag tag = give(Opcode::kServo);
  bench.notify(MoveRefused{.reason = Refusal::kNotReady, .tag = tag});
  expect_answer(Status::kBusy);
  bench.notify(Faulted{.cause = FaultCause::kDriveAlarm});
  EXPECT_FALSE(commands.take_answer());
  bench.notify(Faulted{.cause = FaultCause::kDrivesOff});
  expect_answer(Status::kOk);
}

}  // namespace
}  // namespace armature::pendant
