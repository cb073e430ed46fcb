// Commands for the pins of the tool, through the whole controller.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

#include "tests/controller/support/controller_rig.hpp"

namespace armature {
namespace {

using test::ControllerRig;
using test::degrees;

constexpr std::int64_t kNever = -1;

struct ToolIoTest : testing::Test {
  explicit ToolIoTest(const RobotModel& robot = test::paper_robot()) : rig{robot} {}

  // Trigger after which the output was first seen high.
  std::int64_t watch(std::uint8_t pin) const {
    for (std::size_t trigger = 0; trigger < outputs.size(); ++trigger) {
      if ((static_cast<unsigned>(outputs[trigger]) >> (pin - 1) & 1u) != 0) return static_cast<std::int64_t>(trigger);
    }
    return kNever;
  }
  void run(std::int64_t triggers) {
    for (std::int64_t k = 0; k < triggers; ++k) {
      rig.at(k, [this] {
        outputs.push_back(rig.logic.tool_outputs());
        std::int64_t sum = 0;
        for (std::size_t axis = 0; axis < kAxes; ++axis) sum += std::abs(rig.logic.emitted(axis));
        emitted.push_back(sum);
      });
    }
    rig.run(triggers);
  }
  void input_at(std::int64_t trigger, int pin, bool level) {
    rig.at(trigger, [this, pin, level] { rig.logic.set_tool_input(pin, level); });
  }
  [[nodiscard]] std::vector<std::pair<std::uint32_t, Refusal>> refusals() const {
    std::vector<std::pair<std::uint32_t, Refusal>> list;
    for (const MoveRefused& refusal : rig.refusals) list.emplace_back(refusal.tag.number(), refusal.reason);
    return list;
  }
  using Refusals = std::vector<std::pair<std::uint32_t, Refusal>>;

  ControllerRig rig;
  std::vector<std::uint32_t> outputs;  // at each trigger, before core 1 is served
  std::vector<std::int64_t> emitted;   // pulses of all axes until then
};

TEST_F(ToolIoTest, WithoutACommandForAPinTheBlockIsNeverTouched) {
  input_at(100, 1, true);
  rig.move_at(5, {10, 0, 0, 0, 0, 0});
  run(10'000);
  EXPECT_EQ(rig.moves_finished(), 1);
  EXPECT_EQ(rig.core1_reads + rig.core1_writes, 0);
}

TEST_F(ToolIoTest, AnOutputIsSwitchedAtOnceWhereTheArmStands) {
  rig.submit_at(50, SetOutput{.pin = 16, .level = true, .tag = 7});
  run(100);
  EXPECT_EQ(watch(16), 51);
  ASSERT_EQ(rig.io.size(), 1u);
  EXPECT_EQ(rig.io[0].second.tag, 7u);
  EXPECT_EQ(rig.io[0].second.pin, 16);
  EXPECT_TRUE(rig.io[0].second.level);
  EXPECT_TRUE(rig.refusals.empty());
}

TEST_F(ToolIoTest, AnOutputKeepsTheOthers) {
  for (const std::uint8_t pin : std::array<std::uint8_t, 3>{1, 2, 16})
    rig.submit_at(10, SetOutput{.pin = pin, .level = true});
  rig.submit_at(20, SetOutput{.pin = 2, .level = false});
  run(30);
  EXPECT_EQ(outputs[15], 0x8003u);
  EXPECT_EQ(rig.logic.tool_outputs(), 0x8001u);
}

// Brakes within two ticks, so that pulses come out to the very end of a move.
RobotModel hard_braking_robot() {
  RobotModel robot = test::paper_robot();
  robot.axes[0].max_accel_rad_s2 = 1e6 * test::kDeg;
  robot.axes[0].following_error_limit_rad = 10 * test::kDeg;
  return robot;
}

struct HardBrakingToolIoTest : ToolIoTest {
  HardBrakingToolIoTest() : ToolIoTest{hard_braking_robot()} {}
};

// The oracle is the stand-in's own count of pulses.
TEST_F(HardBrakingToolIoTest, AnOutputIsSwitchedRightAfterTheLastPulseOfTheMoveBeforeIt) {
  rig.move_at(5, {10, 0, 0, 0, 0, 0});
  rig.submit_at(5, SetOutput{.pin = 3, .level = true});
  run(3'000);
  const auto out = std::find(emitted.begin(), emitted.end(), emitted.back()) - emitted.begin();
  ASSERT_GT(out, 1'000);
  // Core 0 tells it in the tick that this trigger begins; core 1 is served at the next trigger, seen at the one after.
  EXPECT_EQ(watch(3), out + 2);
}

TEST_F(HardBrakingToolIoTest, AnOutputBehindAStopWaitsForItsLastPulse) {
  rig.move_at(5, {50, 0, 0, 0, 0, 0});
  rig.submit_at(1'000, Stop{});
  rig.submit_at(1'000, SetOutput{.pin = 3, .level = true});
  run(3'000);
  const auto out = std::find(emitted.begin(), emitted.end(), emitted.back()) - emitted.begin();
  ASSERT_GT(out, 1'000);
  ASSERT_LT(out, 1'100);
  EXPECT_GT(watch(3), out);
  EXPECT_LE(watch(3), out + 4);
}

TEST_F(ToolIoTest, TheMoveBehindAnOutputBeginsAfterIt) {
  rig.move_at(5, {10, 0, 0, 0, 0, 0});
  rig.submit_at(5, SetOutput{.pin = 3, .level = true});
  rig.move_at(5, {0, 0, 0, 0, 0, 0});
  run(16'000);
  ASSERT_EQ(rig.moves.size(), 2u);
  EXPECT_GE(rig.moves[1].start_tick.value(), watch(3) - 1);
  EXPECT_LE(rig.moves[1].start_tick.value(), watch(3) + 2);
  EXPECT_EQ(rig.moves_finished(), 2);
}

TEST_F(ToolIoTest, AMoveOfNoLengthHoldsBackNoOutput) {
  rig.move_at(5, {0, 0, 0, 0, 0, 0});
  rig.submit_at(5, SetOutput{.pin = 1, .level = true});
  run(100);
  EXPECT_LE(watch(1), 12);
  EXPECT_NE(watch(1), kNever);
}

TEST_F(ToolIoTest, AnInputThatHasItsLevelHoldsBackNothing) {
  input_at(3, 4, true);
  rig.submit_at(10, WaitInput{.pin = 4, .level = true, .tag = 1});
  rig.submit_at(10, WaitInput{.pin = 5, .level = false, .tag = 2});
  rig.submit_at(10, SetOutput{.pin = 1, .level = true, .tag = 3});
  run(20);
  EXPECT_EQ(watch(1), 11);
  EXPECT_EQ(rig.io.size(), 3u);
}

TEST_F(ToolIoTest, AMoveWaitsForItsInput) {
  rig.submit_at(10, WaitInput{.pin = 4, .level = true, .tag = 1});
  rig.move_at(10, {10, 0, 0, 0, 0, 0});
  input_at(500, 5, true);  // another one
  input_at(1'000, 4, true);
  input_at(2'000, 4, false);
  run(9'000);
  ASSERT_EQ(rig.moves.size(), 1u);
  EXPECT_GE(rig.moves[0].start_tick.value(), 1'000);
  EXPECT_LE(rig.moves[0].start_tick.value(), 1'002);
  EXPECT_TRUE(rig.refusals.empty());
}

TEST_F(ToolIoTest, OneWaitAfterTheOtherSeesEachEdge) {
  for (int i = 0; i < 4; ++i) {
    rig.submit_at(10, WaitInput{.pin = 4, .level = i % 2 == 0, .tag = static_cast<std::uint32_t>(i)});
    input_at(100 + 100 * i, 4, i % 2 == 0);
  }
  run(1'000);
  ASSERT_EQ(rig.io.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(rig.io[i].first, 101 + 100 * static_cast<std::int64_t>(i));
}

// It reads when it begins and when an input changes, never in between, although the time-out wakes it in each tick.
TEST_F(ToolIoTest, AWaitReadsOnlyWhenAnInputChanged) {
  rig.submit_at(10, WaitInput{.pin = 4, .level = true, .timeout = Ticks{10'000}});
  run(2'000);
  EXPECT_LE(rig.core1_reads, 2);
  EXPECT_TRUE(rig.io.empty());
}

TEST_F(ToolIoTest, ATimeOutRefusesTheWaitAndAllBehindItAndNothingLater) {
  rig.submit_at(10, WaitInput{.pin = 4, .level = true, .timeout = Ticks{200}, .tag = 1});
  rig.submit_at(10, JointMove{.target = degrees({10, 0, 0, 0, 0, 0}), .tag = 2});
  rig.submit_at(10, SetOutput{.pin = 1, .level = true, .tag = 3});
  std::int64_t before = 0;
  std::int64_t after = 0;
  rig.at(209, [&] { before = static_cast<std::int64_t>(rig.refusals.size()); });
  rig.at(213, [&] { after = static_cast<std::int64_t>(rig.refusals.size()); });
  rig.submit_at(400, SetOutput{.pin = 2, .level = true, .tag = 4});
  run(1'000);
  EXPECT_EQ(before, 0);
  EXPECT_EQ(after, 3);
  EXPECT_EQ(refusals(),
            (Refusals{{1, Refusal::kInputTimeout}, {2, Refusal::kInputTimeout}, {3, Refusal::kInputTimeout}}));
  EXPECT_EQ(rig.logic.tool_outputs(), 2u);
  EXPECT_TRUE(rig.moves.empty());
}

TEST_F(ToolIoTest, TheTimeOutCountsFromTheEndOfTheMoveBefore) {
  rig.move_at(5, {10, 0, 0, 0, 0, 0});  // takes longer than the time-out
  rig.submit_at(5, SetOutput{.pin = 1, .level = true});
  rig.submit_at(5, WaitInput{.pin = 4, .level = true, .timeout = Ticks{400}});
  rig.submit_at(5, SetOutput{.pin = 2, .level = true});
  input_at(5'400, 4, true);
  run(8'000);
  ASSERT_GT(watch(1), 5'100);
  ASSERT_LT(watch(1), 5'300);
  EXPECT_TRUE(rig.refusals.empty());
  EXPECT_EQ(watch(2), 5'401);
}

TEST_F(ToolIoTest, AnInputJustInTimeIsSeen) {
  rig.submit_at(10, WaitInput{.pin = 4, .level = true, .timeout = Ticks{200}, .tag = 1});
  input_at(209, 4, true);
  run(400);
  EXPECT_TRUE(rig.refusals.empty());
  EXPECT_EQ(rig.io.size(), 1u);
}

TEST_F(ToolIoTest, AStopDropsThemAndLeavesTheOutputs) {
  rig.submit_at(5, SetOutput{.pin = 1, .level = true, .tag = 1});
  rig.submit_at(6, JointMove{.target = degrees({10, 0, 0, 0, 0, 0}), .tag = 2});
  rig.submit_at(6, SetOutput{.pin = 1, .level = false, .tag = 3});
  rig.submit_at(6, WaitInput{.pin = 1, .level = true, .tag = 4});
  rig.submit_at(1'000, Stop{});
  rig.submit_at(5'000, SetOutput{.pin = 2, .level = true, .tag = 5});  // the stop has lost no plan
  run(6'000);
  EXPECT_EQ(refusals(), (Refusals{{3, Refusal::kNotReady}, {4, Refusal::kNotReady}}));
  EXPECT_EQ(rig.logic.tool_outputs(), 3u);
  EXPECT_EQ(watch(2), 5'001);
}

TEST_F(ToolIoTest, AStopEndsAWait) {
  rig.submit_at(6, WaitInput{.pin = 1, .level = true, .timeout = Ticks{3'000}, .tag = 4});
  rig.submit_at(1'000, Stop{});
  input_at(2'000, 1, true);
  rig.submit_at(2'500, SetOutput{.pin = 2, .level = true, .tag = 5});
  run(4'000);
  EXPECT_EQ(refusals(), (Refusals{{4, Refusal::kNotReady}}));
  ASSERT_EQ(rig.io.size(), 1u);
  EXPECT_EQ(rig.io[0].second.tag, 5u);
}

TEST_F(ToolIoTest, AWaitAfterAStoppedOneIsItsOwn) {
  rig.submit_at(6, WaitInput{.pin = 1, .level = true, .tag = 1});
  rig.submit_at(1'000, Stop{});
  rig.submit_at(2'000, WaitInput{.pin = 2, .level = true, .tag = 2});
  input_at(2'500, 1, true);
  input_at(3'000, 2, true);
  run(4'000);
  ASSERT_EQ(rig.io.size(), 1u);
  EXPECT_EQ(rig.io[0].second.tag, 2u);
  EXPECT_EQ(rig.io[0].first, 3'001);
}

TEST_F(ToolIoTest, AFaultDropsThemAndTheyWorkAgainAfterIt) {
  rig.submit_at(5, SetOutput{.pin = 1, .level = true, .tag = 1});
  rig.submit_at(6, JointMove{.target = degrees({10, 0, 0, 0, 0, 0}), .tag = 2});
  rig.submit_at(6, JointMove{.target = degrees({0, 0, 0, 0, 0, 0}), .tag = 3});
  rig.submit_at(6, SetOutput{.pin = 1, .level = false, .tag = 4});
  rig.at(1'000, [this] { rig.logic.pins.estop_n = false; });
  rig.submit_at(1'100, SetOutput{.pin = 2, .level = true, .tag = 5});
  rig.at(2'000, [this] { rig.logic.pins.estop_n = true; });
  rig.submit_at(6'000, ClearFault{});
  rig.submit_at(7'000, SetOutput{.pin = 3, .level = true, .tag = 6});
  run(8'000);
  Refusals sorted = refusals();
  std::sort(sorted.begin(), sorted.end());
  EXPECT_EQ(sorted, (Refusals{{3, Refusal::kNotReady}, {4, Refusal::kNotReady}, {5, Refusal::kNotReady}}));
  EXPECT_EQ(rig.logic.tool_outputs(), 5u);
  EXPECT_EQ(watch(3), 7'001);
}

TEST_F(ToolIoTest, NothingIsSwitchedDuringAHold) {
  rig.submit_at(5, Hold{});
  rig.submit_at(6, SetOutput{.pin = 1, .level = true});
  rig.submit_at(500, Resume{});
  run(600);
  EXPECT_EQ(watch(1), 501);
}

TEST_F(ToolIoTest, AHoldInTheMoveBeforeDelaysTheOutput) {
  rig.move_at(5, {10, 0, 0, 0, 0, 0});
  rig.submit_at(5, SetOutput{.pin = 1, .level = true});
  rig.submit_at(500, Hold{});
  rig.submit_at(9'000, Resume{});
  run(16'000);
  EXPECT_GT(watch(1), 9'000);
  EXPECT_EQ(emitted[static_cast<std::size_t>(watch(1))], emitted.back());
}

TEST_F(ToolIoTest, PinsAndTimesOutOfRangeAreRefusedAtOnce) {
  for (const std::uint8_t pin : std::array<std::uint8_t, 3>{0, 17, 255}) {
    rig.submit_at(5, SetOutput{.pin = pin, .level = true});
    rig.submit_at(5, WaitInput{.pin = pin, .level = false});
  }
  rig.submit_at(5, WaitInput{.pin = 1, .level = false, .timeout = Ticks{-1}});
  rig.submit_at(5, WaitInput{.pin = 1, .level = false, .timeout = Ticks{86'400 * 20'000ll + 1}});
  run(20);
  ASSERT_EQ(rig.refusals.size(), 8u);
  for (const MoveRefused& refusal : rig.refusals) EXPECT_EQ(refusal.reason, Refusal::kInvalidTarget);
  EXPECT_EQ(rig.core1_reads + rig.core1_writes, 0);
}

}  // namespace
}  // namespace armature
