#include "controller/language/job/state/step.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "tests/controller/language/job/machine_rig.hpp"

namespace armature::job {
namespace {

using testing::ElementsAre;
using Progress = Program::Progress;

constexpr ProgramPlace kPlace = 7;

struct StepTest : testing::Test {
  test::RecordingPort port;
  std::array<Record, 2> records{Record{.op = Op::kNop}, Record{.op = Op::kMsg}};
  Step step{port, records, 1, kPlace};
};

TEST_F(StepTest, WorksUntilItIsToldHowItEnds) {
  EXPECT_EQ(step.record().op, Op::kMsg);
  EXPECT_TRUE(step.check(Alarm::kNone));
  EXPECT_TRUE(step.wait_for_room());
  EXPECT_TRUE(step.wait_until_done());
  EXPECT_EQ(step.progress(), Progress::kWorking);
  EXPECT_EQ(step.alarm(), Alarm::kNone);
  EXPECT_FALSE(step.waits_for_time());
  EXPECT_FALSE(step.pauses_after());
}

TEST_F(StepTest, EndsWithAnAlarm) {
  EXPECT_FALSE(step.check(Alarm::kRange));
  EXPECT_EQ(step.progress(), Progress::kAlarm);
  EXPECT_EQ(step.alarm(), Alarm::kRange);
}

TEST_F(StepTest, WaitsForTheArmWithoutLookingInEachTick) {
  port.arrived = false;
  EXPECT_FALSE(step.wait_until_done());
  EXPECT_EQ(step.progress(), Progress::kWaiting);
  EXPECT_FALSE(step.waits_for_time());
}

TEST_F(StepTest, WaitsForRoom) {
  port.room = 0;
  EXPECT_FALSE(step.wait_for_room());
  EXPECT_EQ(step.progress(), Progress::kWaiting);
}

TEST_F(StepTest, WaitsForAnInputInEachTick) {
  EXPECT_FALSE(step.wait_in_each_tick());
  EXPECT_EQ(step.progress(), Progress::kWaiting);
  EXPECT_TRUE(step.waits_for_time());
}

TEST_F(StepTest, EndsTheProgram) {
  EXPECT_FALSE(step.end_program());
  EXPECT_EQ(step.progress(), Progress::kEnded);
}

TEST_F(StepTest, SendsAndNotesFromItsPlace) {
  step.send(Dwell{.duration = Ticks{5}});
  step.note(ProgramNote::Kind::kAlarm, "MSG", "why");
  step.note(ProgramNote::Kind::kAlarm, "MSG");
  step.note(ProgramNote::Kind::kLine, "MSG");
  ASSERT_EQ(port.sent.size(), 1U);
  EXPECT_EQ(port.sent[0].second, kPlace);
  EXPECT_THAT(port.alarms, ElementsAre("MSG: why", "MSG"));
  EXPECT_THAT(port.lines, ElementsAre(kPlace));
}

}  // namespace
}  // namespace armature::job
