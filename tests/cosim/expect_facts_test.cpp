// RunFactsCollector: what is measured, on rows made by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cosim/report/measure/run_facts.hpp"

namespace armature::cosim {
namespace {

using testing::Each;

constexpr double kRadPerDeg = 3.14159265358979323846 / 180.0;

// One pulse is one count is 7.2e-4 deg; axis 2 turns against its motor, axis 3 has twice as many counts as pulses.
RobotSpec robot() {
  RobotSpec spec;
  spec.axes[1].gear_ratio = -50;
  spec.axes[2].encoder_lines = 5000;
  return spec;
}

struct RunFactsTest : testing::Test {
  // One tick in which axis `axis` has its reference at `reference` pulses and its encoder at `encoder` counts.
  void tick(std::int64_t reference, std::int64_t encoder, std::size_t axis = 0) {
    TraceRow row = next;
    row.telemetry.reference_pulses[axis] = Pulses{reference};
    row.telemetry.reference[axis] =
        Radians{static_cast<double>(axis == 1 ? -reference : reference) * 7.2e-4 * kRadPerDeg};
    row.telemetry.encoder[axis] = Counts{encoder};
    row.telemetry.actual[axis] =
        Radians{static_cast<double>(axis == 1 ? -encoder : encoder) * (axis == 2 ? 3.6e-4 : 7.2e-4) * kRadPerDeg};
    add(row);
  }
  void report(const Event& event, Cycles at = Cycles{0}) { collector.on_event(event, at); }
  void finish(std::int64_t taken) { report(MoveFinished{.taken = Ticks{taken}}); }
  void cut_short() { report(MoveFinished{.how = MoveFinished::How::kCutShort, .taken = Ticks{1}}); }
  void add(const TraceRow& row) {
    collector.add(row);
    next = row;
    ++next.tick;
    next.cycle += 2500;
  }

  RunFactsCollector collector{robot(), 1};
  TraceRow next;
};

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

TEST_F(RunFactsTest, AMoveIsWaitingUnderWayAndThenEndedOrCutShort) {
  const auto given = [&](MoveType type, std::uint32_t index) {
    MoveSpec move;
    move.type = type;
    move.index = index;
    collector.add(move);
  };
  const auto expect_open = [&](std::int64_t waiting, std::int64_t under_way) {
    EXPECT_EQ(collector.facts().moves_waiting, waiting);
    EXPECT_EQ(collector.facts().moves_under_way, under_way);
  };
  for (std::uint32_t i = 0; i < 4; ++i) given(MoveType::kLine, i);
  given(MoveType::kStop, 4);
  expect_open(4, 0);
  report(MoveStarted{.tag = 0});
  expect_open(3, 1);
  report(MoveStarted{.tag = 1});
  expect_open(2, 2);
  finish(9);
  expect_open(2, 1);
  cut_short();
  expect_open(2, 0);
  report(MoveRefused{.tag = 2});
  expect_open(1, 0);
  report(MoveStarted{.tag = 3});
  expect_open(0, 1);
  finish(9);
  expect_open(0, 0);
}

TEST_F(RunFactsTest, AMoveTookTheTicksThatItsEndReports) {
  for (std::uint32_t tag = 0; tag < 5; ++tag) report(MoveStarted{.tag = tag});
  EXPECT_THAT(collector.facts().taken_ticks, Each(std::nullopt));
  finish(8);
  finish(0);  // nothing to drive
  cut_short();
  finish(9);
  const std::vector<std::optional<std::int64_t>> taken = {8, 0, std::nullopt, 9, std::nullopt};
  EXPECT_EQ(collector.facts().taken_ticks, taken);
  EXPECT_EQ(collector.facts().moves.size(), 5u);
  EXPECT_EQ(collector.facts().moves_finished, 3);
}

TEST_F(RunFactsTest, AMoveWasBlendedOrStoppedAtItsEndOnlyIfItGotThere) {
  const auto begin = [&](std::uint32_t tag, double blend_mm, bool continues) {
    MoveSpec given;
    given.type = MoveType::kLine;
    given.index = tag;
    given.blend_mm = blend_mm;
    collector.add(given);
    report(MoveStarted{.kind = MoveKind::kLine, .tag = tag, .duration = Ticks{9}, .continues = continues});
  };
  const auto expect_blended = [&](std::vector<std::optional<bool>> expected) {
    const RunFacts facts = collector.facts();
    std::vector<std::optional<bool>> got;
    for (std::size_t i = 0; i < facts.moves.size(); ++i) got.push_back(facts.blended_with_next(i));
    EXPECT_EQ(got, expected);
  };
  begin(0, 1, false);
  expect_blended({std::nullopt});  // still under way
  begin(1, 0, true);               // in the corner
  expect_blended({true, std::nullopt});
  finish(9);
  finish(9);
  expect_blended({true, std::nullopt});  // of the second one no blend was asked for
  begin(2, 1, false);
  finish(9);
  expect_blended({true, std::nullopt, false});
  begin(3, 1, false);
  cut_short();
  begin(4, 1, false);
  expect_blended({true, std::nullopt, false, std::nullopt, std::nullopt});
}

TEST_F(RunFactsTest, AHoldCountsWhileTheSetPointsStand) {
  next.telemetry.state = MotionState::kHolding;
  next.telemetry.rate = 0.5;
  tick(0, 0);
  next.telemetry.rate = 0;
  tick(0, 0);
  tick(0, 0);
  next.telemetry.state = MotionState::kIdle;
  tick(0, 0);
  EXPECT_DOUBLE_EQ(collector.facts().held_s, 1e-4);
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

TEST_F(RunFactsTest, NamesWhatDroppedTheServoEnables) {
  EXPECT_EQ(collector.facts().stopped_by, "");
  next.stopped = true;
  tick(0, 0);
  EXPECT_EQ(collector.facts().stopped_by, "controller_silent");
  EXPECT_EQ(collector.facts().outcome(), "fault:controller_silent");
  next.telemetry.fault = FaultCause::kWatchdog;
  next.telemetry.state = MotionState::kFault;
  next.telemetry.underruns = 5;
  report(Faulted{.cause = next.telemetry.fault}, Cycles{123});
  tick(0, 0);
  const RunFacts facts = collector.facts();
  EXPECT_EQ(facts.stopped_by, "watchdog");
  EXPECT_EQ(facts.outcome(), "fault:watchdog");
  EXPECT_EQ(facts.underruns, 5);
  ASSERT_EQ(facts.faults.size(), 1u);
  EXPECT_EQ(facts.faults[0].at, Cycles{123});
}

TEST_F(RunFactsTest, TheLastStopIsTheOneThatCounts) {
  next.stopped = true;
  next.telemetry.state = MotionState::kFault;
  next.telemetry.fault = FaultCause::kEmergencyStop;
  report(Faulted{.cause = next.telemetry.fault}, Cycles{1});
  tick(0, 0);
  EXPECT_EQ(collector.facts().stopped_by, "estop");
  EXPECT_EQ(collector.facts().outcome(), "fault:estop");
  next.stopped = false;
  next.telemetry.state = MotionState::kIdle;
  tick(0, 0);
  EXPECT_EQ(collector.facts().stopped_by, "estop");
  EXPECT_EQ(collector.facts().outcome(), "completed");
  // The logic stops the arm again, and this time the controller does not notice.
  next.stopped = true;
  next.telemetry.state = MotionState::kMoving;
  tick(0, 0);
  EXPECT_EQ(collector.facts().stopped_by, "controller_silent");
  EXPECT_EQ(collector.facts().outcome(), "fault:controller_silent");
}

TEST_F(RunFactsTest, AFaultWithoutAStopIsNoStop) {
  next.telemetry.fault = FaultCause::kFollowingError;
  report(Faulted{.cause = next.telemetry.fault}, Cycles{1});
  tick(0, 0);
  EXPECT_EQ(collector.facts().stopped_by, "");
}

// Rows 0..5; tick `tick` ends at cycle 2500 * `tick`.
TEST_F(RunFactsTest, RemembersWhereEachLargestValueWasFirst) {
  const auto expect_at = [](const std::optional<FactPlace>& place, std::int64_t tick, int axis) {
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
