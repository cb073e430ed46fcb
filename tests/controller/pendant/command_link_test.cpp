#include "controller/pendant/protocol/command_link.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <initializer_list>
#include <optional>

namespace armature::pendant {
namespace {

Frame session(std::uint8_t sequence, std::int32_t number) {
  return {.sequence = sequence, .opcode = Opcode::kHeartbeat, .parameter = kBeginSession, .payload = number};
}
Frame jog(std::uint8_t sequence, std::int32_t distance = 100) {
  return {.sequence = sequence, .opcode = Opcode::kJogIncrement, .payload = distance};
}

class CommandLinkTest : public testing::Test {
 protected:
  void begin(std::uint8_t sequence = 4) {
    const CommandLink::Decision decision = link_.on_command(session(sequence, 77));
    ASSERT_FALSE(decision.execute);
    ASSERT_TRUE(decision.reply);
    ASSERT_EQ(decision.reply->status(), Status::kOk);
  }
  void expect_bad_sequence(const Frame& command, std::int32_t expected) {
    const CommandLink::Decision decision = link_.on_command(command);
    EXPECT_FALSE(decision.execute);
    ASSERT_TRUE(decision.reply);
    EXPECT_EQ(decision.reply->status(), Status::kBadSequence);
    EXPECT_EQ(decision.reply->payload, expected);
    EXPECT_EQ(decision.reply->sequence, command.sequence);
    EXPECT_EQ(decision.reply->opcode, command.opcode);
  }

  CommandLink link_;
};

TEST_F(CommandLinkTest, ExecutesNothingBeforeTheFirstSession) {
  expect_bad_sequence(jog(0), -1);
}

TEST_F(CommandLinkTest, ExecutesCommandsInSequenceAndRepliesToThem) {
  begin(14);
  for (const std::uint8_t sequence : std::initializer_list<std::uint8_t>{15, 0, 1}) {
    const CommandLink::Decision decision = link_.on_command(jog(sequence));
    EXPECT_TRUE(decision.execute);
    EXPECT_FALSE(decision.reply);
    const std::optional<Frame> reply = link_.answer(Status::kRange, 5);
    EXPECT_EQ(reply, (Frame{.kind = Kind::kReply,
                            .sequence = sequence,
                            .opcode = Opcode::kJogIncrement,
                            .parameter = static_cast<std::uint8_t>(Status::kRange),
                            .payload = 5}));
  }
}

TEST_F(CommandLinkTest, RepeatsTheReplyToARepeatedCommandAndExecutesItOnce) {
  begin();
  ASSERT_TRUE(link_.on_command(jog(5)).execute);
  const std::optional<Frame> reply = link_.answer(Status::kOk, 3);
  for (int again = 0; again < 3; ++again) {
    const CommandLink::Decision decision = link_.on_command(jog(5));
    EXPECT_FALSE(decision.execute);
    EXPECT_EQ(decision.reply, reply);
  }
}

TEST_F(CommandLinkTest, SaysNothingToARepetitionBeforeTheAnswer) {
  begin();
  ASSERT_TRUE(link_.on_command(jog(5)).execute);
  EXPECT_TRUE(link_.outstanding());
  const CommandLink::Decision decision = link_.on_command(jog(5));
  EXPECT_FALSE(decision.execute);
  EXPECT_FALSE(decision.reply);
}

TEST_F(CommandLinkTest, RefusesAnotherCommandBeforeTheAnswerAndExecutesItLater) {
  begin();
  ASSERT_TRUE(link_.on_command(jog(5)).execute);
  expect_bad_sequence(jog(6), 6);
  static_cast<void>(link_.answer(Status::kOk));
  EXPECT_TRUE(link_.on_command(jog(6)).execute);
}

TEST_F(CommandLinkTest, RefusesAWrongNumberAndSaysTheExpectedOne) {
  begin();
  expect_bad_sequence(jog(6), 5);
  expect_bad_sequence(jog(4), 5);
  EXPECT_TRUE(link_.on_command(jog(5)).execute);
}

TEST_F(CommandLinkTest, TakesAnotherCommandWithTheLastNumberForAWrongNumber) {
  begin();
  ASSERT_TRUE(link_.on_command(jog(5)).execute);
  static_cast<void>(link_.answer(Status::kOk));
  expect_bad_sequence(jog(5, 101), 6);
}

TEST_F(CommandLinkTest, ALateRepetitionOfTheBeginningMakesNoOldCommandValid) {
  begin();
  ASSERT_TRUE(link_.on_command(jog(5)).execute);
  static_cast<void>(link_.answer(Status::kOk));
  const CommandLink::Decision again = link_.on_command(session(4, 77));
  ASSERT_TRUE(again.reply);
  EXPECT_EQ(again.reply->status(), Status::kOk);
  EXPECT_FALSE(link_.on_command(jog(5)).execute);
  EXPECT_TRUE(link_.on_command(jog(6)).execute);
}

TEST_F(CommandLinkTest, ANewSessionDropsTheAnswerThatNobodyWaitsFor) {
  begin();
  ASSERT_TRUE(link_.on_command(jog(5)).execute);
  const CommandLink::Decision decision = link_.on_command(session(9, 78));
  ASSERT_TRUE(decision.reply);
  EXPECT_EQ(decision.reply->status(), Status::kOk);
  expect_bad_sequence(jog(10), 10);  // the first command is still being executed
  EXPECT_EQ(link_.answer(Status::kOk), std::nullopt);
  EXPECT_TRUE(link_.on_command(jog(10)).execute);
}

}  // namespace
}  // namespace armature::pendant
