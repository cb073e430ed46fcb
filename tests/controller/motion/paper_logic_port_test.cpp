// The port to the logic of Vo 2021: nothing that it emits too many or too few, too late or to the wrong side is lost.
#include "controller/motion/paper_logic_port.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "controller/regs/encoder_regs.hpp"
#include "tests/controller/support/paper_model_logic.hpp"
#include "tests/controller/support/robots.hpp"
#include "tests/support/split_mix.hpp"

namespace armature {
namespace {

constexpr PerAxis<Pulses> on_all_axes(std::int64_t count) {
  PerAxis<Pulses> counts;
  counts.fill(Pulses{count});
  return counts;
}

class PaperPort : public testing::Test {
 protected:
  explicit PaperPort(const PaperEncoders& encoders = {}) : port{logic, encoders} {}
  void TearDown() override { EXPECT_THAT(logic.breaches, testing::IsEmpty()); }

  void start() {
    ASSERT_TRUE(port.identified());
    port.start(test::paper_robot());
    committed = {};
  }
  const LogicInput& sample() {
    const LogicInput& input = port.sample();
    for (std::size_t axis = 0; axis < kAxes; ++axis) committed[axis] -= input.not_emitted[axis].value();
    return input;
  }
  void commit(const PerAxis<Pulses>& counts) {
    port.commit(counts);
    for (std::size_t axis = 0; axis < kAxes; ++axis) committed[axis] += counts[axis].value();
  }
  // One tick of a core that is in time.
  const LogicInput& tick(const PerAxis<Pulses>& counts) {
    logic.pass_to_trigger();
    const LogicInput& input = sample();
    commit(counts);
    return input;
  }
  void settle() {
    for (int i = 0; i < 4; ++i) tick({});
  }
  void expect_nothing_lost() {
    for (std::size_t axis = 0; axis < kAxes; ++axis) EXPECT_EQ(committed[axis], logic.emitted(axis)) << axis + 1;
  }

  test::PaperModelLogic logic;
  PaperLogicPort port;
  PerAxis<std::int64_t> committed{};  // as the motion loop counts: commits, less what was not emitted
};

TEST_F(PaperPort, KnowsTheBlocksOfTheVariant) {
  EXPECT_TRUE(port.identified());
  for (const RegAddr id :
       {test::PaperModelLogic::kPulses, test::PaperModelLogic::kSwitch, test::PaperModelLogic::kEncoder}) {
    logic.planted.plant(id, logic.read32(id) ^ 0x0001'0000u);
    EXPECT_FALSE(port.identified());
    logic.planted.remove(id);
  }
}

TEST_F(PaperPort, StartsStandingWithTheDrivesOn) {
  start();
  EXPECT_EQ(logic.servo_on(), 0x3Fu);
  EXPECT_EQ(port.uncounted_axes(), 0);
  settle();
  EXPECT_EQ(logic.emitted(), PerAxis<std::int64_t>{});
}

TEST_F(PaperPort, StaysOffWithABlindDecoder) {
  const RegAddr known = test::PaperModelLogic::kEncoder + regs::encoder::kKnownOffset;
  logic.planted.plant(known, 0);
  port.start(test::paper_robot());
  EXPECT_EQ(port.uncounted_axes(), 0b000001);
  EXPECT_EQ(logic.servo_on(), 0u);
  logic.planted.remove(known);
  port.clear_faults();
  EXPECT_EQ(port.uncounted_axes(), 0);
}

TEST_F(PaperPort, EmitsTheNearestCountAndReportsTheRest) {
  start();
  tick({Pulses{1}, Pulses{-1}, Pulses{1}, Pulses{1}, Pulses{-1}, Pulses{1}});  // sets the directions
  tick({Pulses{41}, Pulses{-41}, Pulses{40}, Pulses{0}, Pulses{-7}, Pulses{115}});
  const PerAxis<Pulses> not_emitted = tick({}).not_emitted;
  const PerAxis<Pulses> expected{Pulses{1}, Pulses{-1}, Pulses{0}, Pulses{0}, Pulses{0}, Pulses{-10}};
  EXPECT_EQ(not_emitted, expected);
  tick({});
  EXPECT_EQ(logic.last_tick(0), 40);
  EXPECT_EQ(logic.last_tick(1), -40);
  EXPECT_EQ(logic.last_tick(2), 40);
  EXPECT_EQ(logic.last_tick(5), 125);
  settle();
  expect_nothing_lost();
}

// The rest of a tick is sent with the next one, so the sum is right whenever the count asked for exists.
TEST_F(PaperPort, AQuantizerThatCarriesTheRestArrivesExactly) {
  start();
  constexpr std::int64_t kTicks = 200, kPerTick = 47;  // 46 and 48 exist
  std::int64_t target = 0;
  for (std::int64_t i = 0; i < kTicks; ++i) {
    logic.pass_to_trigger();
    (void)sample();
    target += kPerTick;
    commit(on_all_axes(target - committed[0]));
  }
  tick({});
  tick(on_all_axes(target - committed[0]));
  settle();
  for (std::size_t axis = 0; axis < kAxes; ++axis) EXPECT_LE(std::abs(logic.emitted(axis) - target), 1) << axis + 1;
  expect_nothing_lost();
}

TEST_F(PaperPort, LosesNothingHoweverLateTheCoreIsAndWhereverItTurns) {
  constexpr std::uint64_t kSeed = 20'210'417;
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  test::SplitMix random{kSeed};
  logic.has_encoders = false;  // edges that nothing here looks at
  start();
  for (int i = 0; i < 4'000; ++i) {
    logic.pass_to_trigger();
    if (random.below(5) == 0) logic.pass(static_cast<std::int64_t>(random.below(3 * 2'500)));
    if (sample().status.pending) continue;
    if (random.below(10) == 0) logic.pass(logic.cycles_to_trigger() - static_cast<std::int64_t>(random.below(200)));
    PerAxis<Pulses> counts;
    for (Pulses& count : counts) count = Pulses{static_cast<std::int64_t>(random.below(401)) - 200};
    commit(counts);
  }
  settle();
  expect_nothing_lost();
}

TEST_F(PaperPort, AWidthStandsUntilItIsReplacedAndTheExcessIsReported) {
  start();
  tick(on_all_axes(30));
  tick(on_all_axes(30));
  logic.pass(3 * 2'500);  // the core sleeps through three triggers
  logic.pass_to_trigger();
  EXPECT_EQ(logic.emitted(0), 4 * 30);
  const LogicInput& input = sample();
  EXPECT_EQ(input.not_emitted[0], Pulses{-3 * 30});  // two had been committed
  EXPECT_EQ(input.new_underruns, 0u);
  settle();
  expect_nothing_lost();
}

TEST_F(PaperPort, WidthsWrittenAfterTheTriggerArePending) {
  start();
  tick(on_all_axes(10));
  EXPECT_FALSE(tick(on_all_axes(20)).status.pending);
  const std::uint16_t sequence = port.sequence();
  logic.pass_to_trigger();
  EXPECT_EQ(sample().status.sequence, sequence);
  logic.pass(2'500);  // the tick's computation takes that long: the next trigger starts the old widths once more
  commit(on_all_axes(5));
  const LogicInput& late = sample();
  EXPECT_TRUE(late.status.pending);
  EXPECT_EQ(late.status.sequence, sequence);
  EXPECT_EQ(late.not_emitted[0], Pulses{-20});
  logic.pass_to_trigger();
  EXPECT_FALSE(sample().status.pending);
  EXPECT_EQ(port.last().status.sequence, sequence + 1);
  EXPECT_EQ(logic.last_tick(0), 20);
  commit({});
  logic.pass_to_trigger();
  (void)sample();
  EXPECT_EQ(logic.last_tick(0), 5);
  commit({});
  settle();
  expect_nothing_lost();
}

TEST_F(PaperPort, ATriggerBetweenTheWritesIsMadeGood) {
  start();
  tick(on_all_axes(25));
  tick(on_all_axes(25));
  logic.pass_to_trigger();
  (void)sample();
  logic.pass(logic.cycles_to_trigger() - 3 * test::PaperModelLogic::kAccessCycles - 2);
  commit(on_all_axes(50));
  logic.pass_to_trigger();
  (void)sample();
  EXPECT_EQ(logic.last_tick(0), 50);
  EXPECT_EQ(logic.last_tick(5), 25);
  commit({});
  settle();
  expect_nothing_lost();
}

TEST_F(PaperPort, TurnsRoundAfterTheHoldTimeAndWithTheSetUpTime) {
  start();
  tick(on_all_axes(125));  // its last pulse is cut by the trigger
  tick(on_all_axes(-200));
  EXPECT_EQ(logic.width(0), 0) << "pauses for a tick";
  tick(on_all_axes(-200));
  EXPECT_EQ(logic.width(0), -25) << "as fast as the set-up time lets it";
  tick(on_all_axes(-200));
  EXPECT_EQ(logic.width(0), -8);
  settle();
  tick(on_all_axes(3));
  tick(on_all_axes(-3));
  EXPECT_LT(logic.width(0), 0) << "slow pulses end early enough";
  settle();
  expect_nothing_lost();
}

// The motion loop takes what is emitted for what it has committed; what the standing widths still emit comes on top.
TEST_F(PaperPort, PulsesUnderWayWhenTheCountersAreTakenOverAreReported) {
  start();
  tick(on_all_axes(30));
  tick(on_all_axes(30));
  logic.pass_to_trigger();
  (void)sample();
  const PerAxis<Pulses>& emitted = port.emitted();
  for (std::size_t axis = 0; axis < kAxes; ++axis) committed[axis] = emitted[axis].value();
  commit({});
  settle();
  EXPECT_EQ(logic.emitted(0), 2 * 30);
  expect_nothing_lost();
}

TEST_F(PaperPort, AStopIsReportedAndAfterItTheCountersAreTakenOver) {
  start();
  tick(on_all_axes(50));
  tick(on_all_axes(50));
  tick(on_all_axes(50));
  logic.estop_pin = true;
  EXPECT_TRUE(tick({}).status.estop);
  EXPECT_TRUE(port.last().status.estop_pin);
  port.clear_faults();
  EXPECT_TRUE(tick({}).status.estop) << "the pin is active";
  logic.estop_pin = false;
  port.clear_faults();
  const LogicInput& input = tick({});
  EXPECT_FALSE(input.status.estop);
  const PerAxis<Pulses>& emitted = port.emitted();
  for (std::size_t axis = 0; axis < kAxes; ++axis) committed[axis] = emitted[axis].value();
  expect_nothing_lost();
  EXPECT_GT(logic.emitted(0), 50);
  EXPECT_LT(logic.emitted(0), 150) << "stopped within a tick";
  tick(on_all_axes(-10));
  settle();
  expect_nothing_lost();
}

class PaperPortFixedAxis : public PaperPort {
 protected:
  PaperPortFixedAxis() : PaperPort{{.axis = 3, .switch_every = {}}} {}
};

TEST_F(PaperPortFixedAxis, SeesThatEncoderOnly) {
  start();
  EXPECT_EQ(logic.selected(), 3u);
  for (int i = 0; i < 50; ++i) tick(on_all_axes(-10));
  settle();
  EXPECT_EQ(port.last().always_counted, 0b001000);
  EXPECT_EQ(port.last().encoder[3], Counts{-500});
  EXPECT_EQ(port.last().encoder[2], Counts{0});
}

TEST_F(PaperPortFixedAxis, AnIllegalTransitionIsAFaultOfThatAxis) {
  start();
  EXPECT_FALSE(tick({}).encoder_faults.any());
  logic.offsets[3] += 2;
  EXPECT_EQ(tick({}).encoder_faults.illegal, 0b001000);
  port.clear_faults();
  EXPECT_FALSE(tick({}).encoder_faults.any());
}

TEST_F(PaperPortFixedAxis, WhatTheFirstSelectionIsDecodedAsIsNoCount) {
  logic.offsets[3] = -1;
  logic.pass(100);
  start();
  settle();
  EXPECT_EQ(port.last().encoder[3], Counts{0});
}

class PaperPortInTurn : public PaperPort {
 protected:
  static constexpr std::int64_t kEvery = 5;
  PaperPortInTurn() : PaperPort{{.axis = 0, .switch_every = Ticks{kEvery}}} {}
};

TEST_F(PaperPortInTurn, EachAxisIsSeenInAllTicksButTheFirstOfItsTurn) {
  start();
  // Trigger t ends a tick of 2 pulses for t >= 2. The commit of handler h (the first, 0, is that of start()) switches
  // when h + 1 is a multiple of kEvery; the snapshot after it is the first to be trusted.
  constexpr std::int64_t kRounds = 4;
  for (std::int64_t i = 0; i < kRounds * 6 * kEvery; ++i) tick(on_all_axes(2));
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    // Axis 1 began while the arm stood: its first turn misses what had not begun.
    const std::int64_t full = kRounds * (kEvery - 1) * 2;
    const std::int64_t seen = port.last().encoder[axis].value();
    EXPECT_LE(seen, full) << axis + 1;
    EXPECT_GE(seen, full - 2 * (kEvery - 1)) << axis + 1;
    EXPECT_EQ(seen % 2, 0) << "an artefact of the switch was counted on axis " << axis + 1;
  }
  EXPECT_EQ(port.last().always_counted, 0);
}

TEST_F(PaperPortInTurn, TheSwitchItselfIsNoFault) {
  logic.offsets[1] = 2;
  logic.pass(100);
  start();
  for (std::int64_t i = 0; i < kEvery + 1; ++i) EXPECT_FALSE(tick({}).encoder_faults.any());
  EXPECT_NE(logic.read32(test::PaperModelLogic::kEncoder + regs::encoder::kFaultOffset), 0u) << "both lines differ";
}

TEST_F(PaperPortInTurn, GoesRoundTheAxesThatTheRobotHas) {
  RobotModel robot = test::paper_robot();
  robot.axis_count = 5;
  port.start(robot);
  std::uint32_t visited = 0;
  for (std::int64_t i = 0; i < 7 * kEvery; ++i) {
    tick({});
    visited |= 1u << logic.selected();
  }
  EXPECT_EQ(visited, 0b011111u);
}

}  // namespace
}  // namespace armature
