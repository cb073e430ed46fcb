// What RunFactsCollector measures on the axes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cosim/support/run_facts_rows.hpp"

namespace armature::cosim {
namespace {

using RunFactsTest = test::RunFactsRows;

TEST_F(RunFactsTest, FinalAnglesComeFromTheEncoderWithItsGear) {
  tick(10, 10, 0);
  tick(10, 10, 1);
  tick(10, 19, 2);
  const RunFacts facts = collector.facts();
  EXPECT_DOUBLE_EQ(facts.final_joint_deg[0], 7.2e-3);
  EXPECT_DOUBLE_EQ(facts.final_joint_deg[1], -7.2e-3);
  EXPECT_DOUBLE_EQ(facts.final_joint_deg[2], 19 * 3.6e-4);
  EXPECT_EQ(facts.final_error_counts[0], 0);
  EXPECT_EQ(facts.final_error_counts[2], 1);  // 10 pulses are 20 counts
  EXPECT_EQ(facts.ticks, 3);
}

TEST_F(RunFactsTest, InstructionsAreThoseOfTheBusiestTickInEachState) {
  const auto tick_of = [this](MotionState state, std::int64_t instructions) {
    next.telemetry.state = state;
    next.load[0].instructions = instructions;
    next.load[1].instructions = 99'999;
    tick(0, 0);
  };
  tick_of(MotionState::kIdle, 90'000);  // tick 0: the start-up
  EXPECT_FALSE(collector.facts().counts_instructions());
  tick_of(MotionState::kIdle, 3'000);
  tick_of(MotionState::kMoving, 9'000);
  tick_of(MotionState::kMoving, 8'000);
  tick_of(MotionState::kIdle, 3'100);
  const RunFacts facts = collector.facts();
  EXPECT_THAT(facts.most_instructions, testing::ElementsAre(3'100, 9'000, 0, 0, 0));
  ASSERT_TRUE(facts.most_instructions_at);
  EXPECT_EQ(facts.most_instructions_at->tick, 2);
}

TEST_F(RunFactsTest, PeakSpeedIsTheLargestStepOfTheReference) {
  for (const std::int64_t reference : {0, 1, 4, 2, 3}) tick(reference, 0);
  EXPECT_NEAR(collector.facts().peak_speed_deg_s[0], 3 * 7.2e-4 * 20000, 1e-9);
  EXPECT_EQ(collector.facts().peak_speed_deg_s[1], 0);
}

TEST_F(RunFactsTest, AJumpOfTheReferenceAroundFaultIsNoSpeedAndNoFollowingError) {
  tick(0, 0);
  next.telemetry.state = MotionState::kFault;
  next.telemetry.fault = FaultCause::kWatchdog;  // the cause of the last fault stays in the telemetry
  tick(0, 900);
  tick(900, 900);
  EXPECT_EQ(collector.facts().outcome(), "fault:watchdog");
  next.telemetry.state = MotionState::kIdle;
  tick(905, 905);
  EXPECT_EQ(collector.facts().peak_speed_deg_s[0], 0);
  EXPECT_EQ(collector.facts().worst_following_error_deg[0], 0);
  EXPECT_EQ(collector.facts().outcome(), "completed");
  tick(906, 905);
  EXPECT_NEAR(collector.facts().peak_speed_deg_s[0], 7.2e-4 * 20000, 1e-9);
  EXPECT_NEAR(collector.facts().worst_following_error_deg[0], 7.2e-4, 1e-12);
}

TEST_F(RunFactsTest, ElasticGearsHaveATrueAngleAndALostMotion) {
  tick(0, 0);
  EXPECT_FALSE(collector.facts().final_load_deg);
  EXPECT_FALSE(collector.facts().lost_motion_deg);
  for (const double lead_deg : {0.03, -0.05, 0.01}) {
    next.load_lead_deg = PerAxis<double>{lead_deg, 0, 0, 0, 0, 0};
    next.motor_counts[0] = 1000;
    tick(0, 0);
  }
  EXPECT_NEAR(collector.facts().final_load_deg.value()[0], 1000 * 7.2e-4 + 0.01, 1e-12);
  EXPECT_NEAR(collector.facts().lost_motion_deg.value()[0], 0.08, 1e-12);
  EXPECT_EQ(collector.facts().lost_motion_deg.value()[1], 0);
}

TEST_F(RunFactsTest, AJumpOfTheReferenceAtTheEndOfHomingIsNoSpeed) {
  next.telemetry.referenced = 0;
  tick(0, 0);
  tick(1, 0);
  next.telemetry.referenced = 1;
  tick(90'000, 90'000);
  EXPECT_NEAR(collector.facts().peak_speed_deg_s[0], 7.2e-4 * 20000, 1e-9);
  tick(90'002, 90'000);
  EXPECT_NEAR(collector.facts().peak_speed_deg_s[0], 2 * 7.2e-4 * 20000, 1e-9);
}

TEST_F(RunFactsTest, KeepsTheHomingOfEachAxisInTheOrderOfItsEnd) {
  const auto happens = [&](const Event& event) { collector.on_event(event, Cycles{}); };
  happens(HomingStarted{.axis = 1, .tick = Ticks{5}});
  happens(HomingStarted{.axis = 2, .tick = Ticks{5}});
  happens(HomingEnded{.axis = 2, .how = HomingEnd::kNoSwitch, .tick = Ticks{7}});
  happens(HomingEnded{.axis = 1, .how = HomingEnd::kStop, .tick = Ticks{8}});
  happens(HomingStarted{.axis = 1, .tick = Ticks{9}});
  const RunFacts facts = collector.facts();
  ASSERT_EQ(facts.homings.size(), 3u);
  EXPECT_EQ(facts.homings[0].ended->how, HomingEnd::kStop);
  EXPECT_EQ(facts.homings[1].ended->how, HomingEnd::kNoSwitch);
  EXPECT_FALSE(facts.homings[2].ended);
}

TEST_F(RunFactsTest, SettlesWhenEveryEncoderStaysInTheBandAfterTheLastChange) {
  tick(0, 0);
  tick(10, 0);
  tick(20, 5);   // the reference stops in tick 2
  tick(20, 19);  // inside, but not for good
  tick(20, 22);
  tick(20, 18);
  EXPECT_EQ(collector.facts().settle_s, std::nullopt);
  tick(20, 21);  // tick 6
  EXPECT_DOUBLE_EQ(collector.facts().settle_s.value(), 4 * 50e-6);
  tick(20, 20);
  EXPECT_DOUBLE_EQ(collector.facts().settle_s.value(), 4 * 50e-6);
}

TEST_F(RunFactsTest, AnArmThatNeverMovesHasNothingToSettle) {
  for (int i = 0; i < 3; ++i) tick(0, 0);
  EXPECT_FALSE(collector.facts().moved);
  EXPECT_EQ(collector.facts().settle_s, std::nullopt);
}

TEST_F(RunFactsTest, AnEncoderThatFollowsAtOnceSettlesWithTheReference) {
  for (const std::int64_t place : {0, 10, 20, 20}) tick(place, place);
  EXPECT_EQ(collector.facts().settle_s, 0.0);
}

TEST_F(RunFactsTest, OvershootIsBeyondTheFinalReferenceInTheDirectionOfMotion) {
  tick(0, 0);
  tick(100, 0);
  tick(100, 103);
  tick(100, 100);
  EXPECT_EQ(collector.facts().overshoot_counts[0], 3);
  // Back: what was ahead on the way out does not count, passing the target on the way back does.
  tick(50, 101);
  tick(40, 60);
  tick(40, 38);
  tick(40, 41);
  EXPECT_EQ(collector.facts().overshoot_counts[0], 2);
}

TEST_F(RunFactsTest, OvershootKnowsWhichWayTheMotorTurns) {
  tick(0, 0, 1);
  tick(100, 0, 1);
  tick(100, 104, 1);
  tick(100, 100, 1);
  EXPECT_EQ(collector.facts().overshoot_counts[1], 4);
  EXPECT_EQ(collector.facts().overshoot_counts[0], 0);
}

TEST_F(RunFactsTest, LagIsNoOvershoot) {
  tick(0, 0);
  tick(-100, 0);
  tick(-100, -60);
  tick(-100, -100);
  EXPECT_EQ(collector.facts().overshoot_counts[0], 0);
}

TEST_F(RunFactsTest, PulsesAreThoseOnThePins) {
  next.pin_pulses[4] = -3;
  tick(0, 0);
  next.pin_pulses[4] = -11;
  tick(0, 0);
  next.pin_pulses[4] = -6;
  tick(0, 0);
  EXPECT_EQ(collector.facts().peak_pulses_per_tick, 8);
  EXPECT_EQ(collector.facts().total_pulses[4], -6);
}

TEST_F(RunFactsTest, WhatATickOwesIsWhatWasMeantForItLessWhatCame) {
  const auto emit = [&](std::int64_t commanded, std::int64_t pins, MotionState state = MotionState::kMoving) {
    TraceRow row = next;
    row.telemetry.state = state;
    row.telemetry.commanded[2] = Pulses{commanded};
    row.pin_pulses[2] = pins;
    add(row);
  };
  emit(41, 0);    // meant for the tick that follows
  emit(82, 40);   // one short
  emit(120, 85);  // three beyond 82
  emit(120, 120);
  EXPECT_EQ(collector.facts().inexact_ticks, (PerAxis<std::int64_t>{0, 0, 2, 0, 0, 0}));
  EXPECT_EQ(collector.facts().max_residual_pulses, 3);
  emit(170, 120, MotionState::kFault);  // a stop takes what it takes
  emit(120, 120, MotionState::kFault);
  emit(120, 120);
  emit(121, 120);
  EXPECT_EQ(collector.facts().inexact_ticks[2], 2);
  EXPECT_EQ(collector.facts().max_residual_pulses, 3);
}

TEST_F(RunFactsTest, LostCountsAreWhatTheMotorHasAndTheControllerHasNot) {
  next.motor_counts = {100, -100, 7, 0, 0, 0};
  tick(100, 40, 0);
  tick(0, -100, 1);
  EXPECT_EQ(collector.facts().lost_counts, (PerAxis<std::int64_t>{60, 0, 7, 0, 0, 0}));
}

TEST_F(RunFactsTest, TheLargestCorrectionCountsOnEitherSide) {
  next.telemetry.correction[3] = Pulses{4};
  tick(0, 0);
  next.telemetry.correction[3] = Pulses{-7};
  tick(0, 0);
  next.telemetry.correction[3] = Pulses{0};
  tick(0, 0);
  EXPECT_EQ(collector.facts().max_correction_pulses, 7);
}

// Rows 0..5; tick `tick` ends at cycle 2500 * `tick`.
TEST_F(RunFactsTest, RemembersWhereEachLargestValueWasFirst) {
  const auto expect_at = [](const std::optional<RunPlace>& place, std::int64_t tick, int axis) {
    ASSERT_TRUE(place);
    EXPECT_EQ(place->tick, tick);
    EXPECT_EQ(place->at, Cycles{tick * 2500});
    EXPECT_EQ(place->axis, axis);
  };
  tick(0, 0);
  EXPECT_FALSE(collector.facts().peak_pulses_at || collector.facts().max_correction_at ||
               collector.facts().first_underrun_at || collector.facts().last_outside_at);
  next.pin_pulses[0] = 5;
  tick(10, 0);
  next.pin_pulses[0] = 14;
  next.telemetry.correction[4] = Pulses{-3};
  tick(30, 12);
  next.pin_pulses[0] = 23;  // as many as before: the first time counts
  next.telemetry.underruns = 1;
  tick(40, 44);
  next.telemetry.underruns = 2;
  tick(40, 43);
  tick(40, 40);
  const RunFacts facts = collector.facts();
  EXPECT_EQ(facts.peak_pulses_per_tick, 9);
  expect_at(facts.peak_pulses_at, 2, 1);
  expect_at(facts.max_correction_at, 2, 5);
  expect_at(facts.peak_speed_at[0], 2, 1);
  EXPECT_FALSE(facts.peak_speed_at[1]);
  expect_at(facts.worst_following_error_at[0], 2, 1);
  expect_at(facts.first_underrun_at, 3, 0);
  EXPECT_EQ(facts.overshoot_counts[0], 4);
  expect_at(facts.overshoot_at[0], 3, 1);
  EXPECT_FALSE(facts.overshoot_at[1]);
  expect_at(facts.last_outside_at, 4, 1);
}

}  // namespace
}  // namespace armature::cosim
