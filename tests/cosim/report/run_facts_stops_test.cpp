// What RunFactsCollector says about faults and stops.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cosim/report/format/injection_text.hpp"
#include "tests/cosim/support/run_facts_rows.hpp"

namespace armature::cosim {
namespace {

using RunFactsStops = test::RunFactsRows;

TEST_F(RunFactsStops, NamesWhatDroppedTheServoEnables) {
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
  EXPECT_EQ(facts.faults[0].where.at, Cycles{123});
}

TEST_F(RunFactsStops, TheLastStopIsTheOneThatCounts) {
  next.stopped = true;
  next.telemetry.state = MotionState::kFault;
  next.telemetry.fault = FaultCause::kEstop;
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

// Only the first of them has dropped the servo enables.
TEST_F(RunFactsStops, AFaultThatIsReportedInFaultStopsNothing) {
  next.stopped = true;
  next.telemetry.state = MotionState::kFault;
  report(Faulted{.cause = FaultCause::kFollowingError}, Cycles{1});
  report(Faulted{.cause = FaultCause::kCodeChanged}, Cycles{2});
  next.telemetry.fault = FaultCause::kCodeChanged;
  tick(0, 0);
  EXPECT_EQ(collector.facts().stopped_by, "following_error");
  EXPECT_EQ(collector.facts().outcome(), "fault:code_changed");
  report(FaultCleared{}, Cycles{3});
  report(Faulted{.cause = FaultCause::kEstop}, Cycles{4});
  EXPECT_EQ(collector.facts().stopped_by, "estop");
}

// No row shows the stop when the triggers or the clock have stopped.
TEST_F(RunFactsStops, EnablesThatDropAfterTheLastRowAreAStop) {
  collector.add_servo_enables(0x3F, Cycles{10});
  tick(0, 0);
  EXPECT_EQ(collector.facts().outcome(), "completed");
  collector.add_servo_enables(0, Cycles{20});
  EXPECT_EQ(collector.facts().stopped_by, "controller_silent");
  EXPECT_EQ(collector.facts().outcome(), "fault:controller_silent");
}

TEST_F(RunFactsStops, KeepsTheAccessesThatStoppedACoreWithTheirPlace) {
  EXPECT_EQ(collector.facts().bus_error(), "none");
  tick(0, 0);
  collector.add(BusAbortEvent{.core = 1,
                              .write = true,
                              .address = 0x4120'0000,
                              .error = BusError::kTimeout,
                              .where = {.tick = 1, .at = Cycles{77}}});
  collector.add(BusAbortEvent{.core = 0,
                              .write = false,
                              .address = 0x43C2'0010,
                              .error = BusError::kSlaveError,
                              .where = {.tick = 1, .at = Cycles{99}}});
  const RunFacts facts = collector.facts();
  EXPECT_EQ(facts.bus_error(), "TIMEOUT");
  ASSERT_EQ(facts.bus_aborts.size(), 2u);
  EXPECT_EQ(facts.bus_aborts[0].where.at, Cycles{77});
  EXPECT_EQ(facts.bus_aborts[1].where.tick, 1);
  EXPECT_EQ(abort_text(facts.bus_aborts[0]), "core 1 stopped: write of 0x41200000 answered TIMEOUT");
}

TEST_F(RunFactsStops, AnAccessThatStopsACoreAnswersAFault) {
  collector.add_servo_enables(0x3F, Cycles{10});
  collector.add(FaultSpec{.at_s = 0, .kind = BlockHang{}}, {.at = Cycles{20}});
  EXPECT_EQ(collector.facts().unanswered_faults(), 1);
  collector.add(BusAbortEvent{.where = {.at = Cycles{30}}});
  EXPECT_EQ(collector.facts().unanswered_faults(), 0);
}

TEST_F(RunFactsStops, CountsTheTriggersThatTheTimeHasRoomFor) {
  tick(0, 0);
  tick(0, 0);
  RunFacts facts = collector.facts();
  const Cycles last = facts.last_trigger_at->at;
  EXPECT_EQ(last - facts.first_trigger_at->at, Cycles{2'500});
  facts.cycles = last + Cycles{2'499};
  EXPECT_EQ(facts.missing_ticks(), 0);
  facts.cycles = last + Cycles{2'500};
  EXPECT_EQ(facts.missing_ticks(), 1);
}

TEST_F(RunFactsStops, AFaultWithoutAStopIsNoStop) {
  next.telemetry.fault = FaultCause::kFollowingError;
  report(Faulted{.cause = next.telemetry.fault}, Cycles{1});
  tick(0, 0);
  EXPECT_EQ(collector.facts().stopped_by, "");
}

}  // namespace
}  // namespace armature::cosim
