#include "controller/language/program/sent_commands.hpp"

#include <gtest/gtest.h>

#include <optional>

namespace armature {
namespace {

using How = MoveFinished::How;

Tag line(ProgramPlace place) {
  return {Source::kProgram, place};
}

struct SentCommandsTest : testing::Test {
  void start(Tag tag) { commands.on_event(MoveStarted{.tag = tag}); }
  void finish(Tag tag, How how = How::kReachedEnd) { commands.on_event(MoveFinished{.tag = tag, .how = how}); }
  void refuse(Tag tag) { commands.on_event(MoveRefused{.tag = tag}); }
  SentCommands commands;
};

TEST_F(SentCommandsTest, AreOverWhenEachIsFinishedRefusedOrSwitched) {
  EXPECT_TRUE(commands.over());
  for (const ProgramPlace place : {1u, 2u, 3u}) commands.send(place);
  finish(line(1));
  commands.on_event(IoDone{.tag = line(2)});
  EXPECT_FALSE(commands.over());
  refuse(line(3));
  EXPECT_TRUE(commands.over());
}

TEST_F(SentCommandsTest, ThoseOfOtherSourcesDoNotCount) {
  commands.send(1);
  start(Tag{9});
  finish(Tag{9}, How::kCutShort);
  refuse({Source::kPendant, 1});
  EXPECT_FALSE(commands.over());
  EXPECT_EQ(commands.place(), 1u);
  EXPECT_EQ(commands.failed(), std::nullopt);
}

TEST_F(SentCommandsTest, ThePlaceIsThatOfTheFirstOneUntilAnotherStarts) {
  commands.send(4);
  commands.send(5);
  EXPECT_EQ(commands.place(), 4u);
  start(line(5));
  EXPECT_EQ(commands.place(), 5u);
}

TEST_F(SentCommandsTest, RememberTheFirstFailureUntilItIsForgotten) {
  for (const ProgramPlace place : {1u, 2u, 3u}) commands.send(place);
  finish(line(1));
  finish(line(2), How::kCutShort);
  refuse(line(3));
  EXPECT_EQ(commands.failed(), std::optional{2u});
  commands.forget_failure();
  EXPECT_EQ(commands.failed(), std::nullopt);
}

TEST_F(SentCommandsTest, AStopOfTheProgramIsNoFailureForWhatWasSentBefore) {
  commands.send(1);
  commands.send(2);
  commands.set_stopped(true);
  finish(line(1), How::kCutShort);
  refuse(line(2));
  EXPECT_EQ(commands.failed(), std::nullopt);
  commands.send(3);
  refuse(line(3));
  EXPECT_EQ(commands.failed(), std::optional{3u});
}

}  // namespace
}  // namespace armature
