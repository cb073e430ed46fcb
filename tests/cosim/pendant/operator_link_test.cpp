#include "cosim/pendant/operator_link.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

#include "tests/cosim/pendant/fake_controller.hpp"

namespace armature::cosim {
namespace {

using pendant::Content;
using pendant::Opcode;
using test::FakeController;
using testing::Contains;
using testing::HasSubstr;
using namespace std::chrono_literals;

struct OperatorLinkTest : testing::Test {
  void run(OperatorLink::Time duration) { controller.run(link, now, duration); }
  OperatorLink::Time now{};
  OperatorLink link{7};
  FakeController controller;
};

TEST_F(OperatorLinkTest, BeginsASessionAndAsksForTelemetry) {
  EXPECT_FALSE(link.connected());
  EXPECT_FALSE(link.press({.opcode = Opcode::kStop}));
  run(10ms);
  EXPECT_TRUE(link.connected());
  EXPECT_EQ(controller.count(Opcode::kSetTelemetry), 1u);
}

TEST_F(OperatorLinkTest, ShowsTheTelemetry) {
  run(10ms);
  EXPECT_EQ(link.state(), std::nullopt);
  controller.set_state(pendant::State::kReady, 4096 + 256);
  controller.put(
      {.kind = pendant::Kind::kTelemetry, .opcode = Opcode::kGetStatus, .parameter = 3, .payload = -111'667});
  run(2ms);
  EXPECT_EQ(link.state(), pendant::State::kReady);
  EXPECT_TRUE(link.drives_on());
  EXPECT_FALSE(link.extended());
  EXPECT_EQ(link.coordinates(), 1);
  EXPECT_EQ(link.page(pendant::Page::kJoint, 2), -111'667);
}

TEST_F(OperatorLinkTest, ReadsEachMessageOfTheProgramOnce) {
  run(100ms);
  EXPECT_EQ(controller.count(Opcode::kGetStatus), 0u) << "there is none";
  EXPECT_FALSE(link.program_message());
  controller.say(pendant::MessageKind::kMessage, 12, "part is ready");
  run(100ms);
  EXPECT_THAT(link.messages(), Contains("message: \"part is ready\""));
  EXPECT_EQ(controller.count(Opcode::kGetStatus), 2u + 1 + 5) << "page, line, five pages of text, page";
  ASSERT_TRUE(link.program_message());
  EXPECT_EQ(link.program_message()->place, 12);
  controller.say(pendant::MessageKind::kMessage, 14, "part is ready");
  run(100ms);
  EXPECT_EQ(std::ranges::count(link.messages(), "message: \"part is ready\""), 2) << "it was said again";
}

TEST_F(OperatorLinkTest, AJogGoesOnWhileAMessageIsRead) {
  run(10ms);
  link.jog(2, -10'000, now + 200ms);
  run(100ms);
  controller.say(pendant::MessageKind::kMessage, 12, std::string(64, 'x'));
  run(100ms);
  EXPECT_NEAR(static_cast<double>(controller.count(Opcode::kJogContinuous)), 8, 1);  // every 25 ms
  EXPECT_TRUE(link.program_message());
}

TEST_F(OperatorLinkTest, ExecutesEachPressedCommandOnceAndInOrder) {
  run(10ms);
  for (std::uint8_t pin = 1; pin <= 5; ++pin) {
    EXPECT_TRUE(link.press({.opcode = Opcode::kSetOutput, .parameter = pin, .payload = 1}));
  }
  run(50ms);
  std::uint8_t pin = 0;
  for (const pendant::Frame& frame : controller.executed) {
    if (frame.opcode != Opcode::kSetOutput) continue;
    EXPECT_EQ(frame.parameter, ++pin);
  }
  EXPECT_EQ(pin, 5);
}

TEST_F(OperatorLinkTest, RepeatsAJogUntilItsTimeIsOver) {
  run(10ms);
  link.jog(2, -10'000, now + 200ms);
  run(400ms);
  EXPECT_NEAR(static_cast<double>(controller.count(Opcode::kJogContinuous)), 8, 1);  // every 25 ms
  EXPECT_EQ(controller.count(Opcode::kJogStop), 1u);
}

TEST_F(OperatorLinkTest, EndsAJogAtOnceWhenItIsReleased) {
  run(10ms);
  link.jog(2, -10'000, now + 10s);
  run(100ms);
  link.release_jog();
  const std::size_t jogs = controller.count(Opcode::kJogContinuous);
  run(100ms);
  EXPECT_EQ(controller.count(Opcode::kJogContinuous), jogs);
  EXPECT_EQ(controller.count(Opcode::kJogStop), 1u);
}

TEST_F(OperatorLinkTest, ARefusedJogIsNotRepeated) {
  run(10ms);
  controller.status = pendant::Status::kAlarm;
  link.jog(0, 10'000, now + 10s);
  run(200ms);
  EXPECT_EQ(controller.count(Opcode::kJogContinuous), 1u);
  EXPECT_THAT(link.messages(), Contains("jog_continuous: alarm"));
}

TEST_F(OperatorLinkTest, SendsTheEmergencyStopUntilTheControllerReportsIt) {
  run(10ms);
  controller.deaf = true;
  link.press_estop();
  run(200ms);
  EXPECT_TRUE(link.estop_pressed());
  controller.deaf = false;
  run(60ms);
  EXPECT_EQ(controller.estops, 1);
  EXPECT_FALSE(link.estop_pressed());
  EXPECT_EQ(link.state(), pendant::State::kEstop);
}

TEST_F(OperatorLinkTest, SendsTheEmergencyStopWithoutASession) {
  link.press_estop();
  run(60ms);
  EXPECT_EQ(controller.estops, 1);
}

TEST_F(OperatorLinkTest, SendsAProgramAndCommitsItsCheckValue) {
  run(10ms);
  const std::string text(1000, 'x');
  EXPECT_TRUE(link.download(Content::kGcode, "part.ngc", text));
  EXPECT_FALSE(link.download(Content::kGcode, "part.ngc", text)) << "one at a time";
  run(3s);
  EXPECT_FALSE(link.downloading());
  EXPECT_TRUE(controller.bulk.complete());
  EXPECT_TRUE(std::ranges::equal(controller.bulk.text(), text));
  ASSERT_EQ(controller.count(Opcode::kProgramCommit), 1u);
  EXPECT_EQ(std::ranges::find(controller.executed, Opcode::kProgramCommit, &pendant::Frame::opcode)->payload,
            controller.bulk.check());
  EXPECT_THAT(link.messages(), Contains("program_commit: ok"));
  EXPECT_EQ(link.job_of("part.ngc"), 0u);
  EXPECT_EQ(link.job_of("other.ngc"), std::nullopt);
}

TEST_F(OperatorLinkTest, ConnectsAgainAfterTheControllerWasSilent) {
  run(10ms);
  controller.deaf = true;
  run(2s);
  EXPECT_FALSE(link.connected());
  EXPECT_THAT(link.messages(), Contains(HasSubstr("does not answer")));
  controller.deaf = false;
  run(2s);
  EXPECT_TRUE(link.connected());
  EXPECT_EQ(controller.count(Opcode::kSetTelemetry), 2u);
}

}  // namespace
}  // namespace armature::cosim
