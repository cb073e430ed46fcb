// pulse_train: what happens when a write, the emergency-stop pin and the trigger meet in one cycle or miss each other
// by one. Every case is swept over the cycles around the meeting.
#include "Vpulse_train.h"
#include "tests/rtl/pulse_train_fixture.hpp"

namespace armature::test {
namespace {

namespace reg = regs::pulse_train;

// Cycles of a write counted from 1, the one in which address and data are accepted.
constexpr int kFlagCycle = 2;     // software clears a flag
constexpr int kCommandCycle = 3;  // commit, stop and clear reach the core
constexpr int kSweep = 8;

class PulseTrainPhase : public PulseTrainFixture<Vpulse_train> {
 protected:
  // Begins the write so that its cycle number `distance` is the trigger cycle; returns after the trigger.
  void write_at(int distance, std::uint32_t offset, std::uint32_t value) {
    while (to_trigger_ != distance) clock();
    const int before = ticks_;
    write(offset, value);
    while (ticks_ == before) clock();
  }

  // Stops the axes by the pin or the register, `distance` cycles from the trigger; returns after the trigger. True: the
  // stop acts in the trigger cycle.
  bool stop_at(int distance, bool by_pin) {
    if (!by_pin) {
      write_at(distance, reg::kEstopOffset, reg::kEstopStopMask);
      return distance >= kCommandCycle;
    }
    while (to_trigger_ != distance) clock();
    dut_.estop_ni = 0;
    run_to_trigger();
    return distance >= 3;  // the second flop has sampled the pin before
  }

  // The emergency-stop pin falls in this cycle of the write and stays low.
  void write_with_pin_low_from(int low_from, std::uint32_t offset, std::uint32_t value) {
    bus_->post_write(offset, value);
    for (int cycle = 1; cycle <= kSweep; ++cycle) {
      if (cycle == low_from) dut_.estop_ni = 0;
      bus_->step();
    }
    bus_->drain();
    bus_->write_answers.clear();
    clock(3);
  }

  // Underruns are counted, and one has been.
  void start_underrunning() {
    restart();
    write(reg::kWatchdogOffset, 255);
    write(reg::kCtrlOffset, reg::kCtrlRunMask);
    run_to_trigger();
    ASSERT_EQ(faults(), reg::kFaultUnderrunMask);
  }

  [[nodiscard]] AxisCounts moved_since(const AxisCounts& from) const {
    AxisCounts result;
    for (std::size_t i = 0; i < kAxes; ++i) result[i] = at_trigger_[i] - from[i];
    return result;
  }

  [[nodiscard]] bool pending() { return (status() & reg::kStatusPendingMask) != 0; }
  [[nodiscard]] std::uint32_t in_a_row() { return regs::extract(read(reg::kWatchdogOffset), reg::kWatchdogInARow); }
};

TEST_F(PulseTrainPhase, CommitInTheTriggerCycleIsForTheTickAfter) {
  constexpr AxisCounts kOld = {10, 20, 30, 40, 50, 60};
  constexpr AxisCounts kNew = {101, -102, 103, -104, 105, -106};
  for (const bool waiting : {false, true}) {
    for (int distance = 1; distance <= kSweep; ++distance) {
      SCOPED_TRACE(testing::Message() << "waiting set " << waiting << ", distance " << distance);
      restart();
      run_to_trigger();
      if (waiting) stage_and_commit(kOld, 7);
      stage(kNew);
      write_at(distance, reg::kCommitOffset, 8);

      const bool in_time = distance > kCommandCycle;
      const std::uint32_t fault = in_time && waiting ? reg::kFaultRecommitMask : 0;
      EXPECT_EQ(pending(), !in_time);
      EXPECT_EQ(sequence(), in_time ? 8U : waiting ? 7U : 0U);
      EXPECT_EQ(faults(), fault);
      AxisCounts from = at_trigger_;
      run_to_trigger();
      EXPECT_EQ(moved_since(from), in_time ? kNew : waiting ? kOld : AxisCounts{});
      EXPECT_FALSE(pending());
      EXPECT_EQ(sequence(), 8U);
      from = at_trigger_;
      run_to_trigger();
      EXPECT_EQ(moved_since(from), in_time ? AxisCounts{} : kNew);
      EXPECT_EQ(faults(), fault);
      if (HasFailure()) return;
    }
  }
}

TEST_F(PulseTrainPhase, NoUnderrunInTheCycleOfAStop) {
  for (const bool by_pin : {false, true}) {
    for (int distance = 1; distance <= kSweep; ++distance) {
      SCOPED_TRACE(testing::Message() << (by_pin ? "pin" : "register") << ", distance " << distance);
      start_underrunning();
      write(reg::kFaultOffset, reg::kFaultUnderrunMask);
      const bool stopped = stop_at(distance, by_pin);
      clock(5);
      EXPECT_EQ(faults(), reg::kFaultEstopMask | (stopped ? 0U : reg::kFaultUnderrunMask));
      EXPECT_EQ(read(reg::kUnderrunsOffset), stopped ? 1U : 2U);
      EXPECT_EQ(in_a_row(), 0U) << "a stop ends the run";
      if (HasFailure()) return;
    }
  }
}

// A set that meets the stop in its own tick is discarded: it neither becomes active nor is it owed.
TEST_F(PulseTrainPhase, TriggerInTheCycleOfAStopTakesNoSet) {
  constexpr AxisCounts kSet = {100, -100, 90, -90, 80, -80};
  for (const bool by_pin : {false, true}) {
    for (int distance = 1; distance <= kSweep; ++distance) {
      SCOPED_TRACE(testing::Message() << (by_pin ? "pin" : "register") << ", distance " << distance);
      restart();
      run_to_trigger();
      stage_and_commit(kSet, 7);
      const bool stopped = stop_at(distance, by_pin);
      clock(5);
      EXPECT_EQ(sequence(), stopped ? 0U : 7U);
      EXPECT_FALSE(pending());
      run_to_trigger();
      clock();
      EXPECT_EQ(faults(), reg::kFaultEstopMask | (stopped ? 0U : reg::kFaultResidualMask));
      for (std::size_t i = 0; i < kAxes; ++i) {
        EXPECT_EQ(read_axis(reg::kEmittedOffset, static_cast<int>(i)), 0);
        EXPECT_EQ(read_axis(reg::kResidualOffset, static_cast<int>(i)), stopped ? 0 : kSet[i]);
      }
      if (HasFailure()) return;
    }
  }
}

TEST_F(PulseTrainPhase, CommitInTheCycleOfAStopIsRefused) {
  for (int low_from = 1; low_from <= kSweep; ++low_from) {
    SCOPED_TRACE(testing::Message() << "pin low from cycle " << low_from << " of the write");
    restart();
    stage({201, 0, 0, 0, 0, 0});  // an accepted commit reports that it was limited
    write_with_pin_low_from(low_from, reg::kCommitOffset, 1);
    const bool stopped = low_from <= kCommandCycle - 2;  // the pin stops from its third cycle on
    EXPECT_EQ(faults(), reg::kFaultEstopMask | (stopped ? 0U : reg::kFaultClippedMask));
    EXPECT_FALSE(pending());
  }
}

TEST_F(PulseTrainPhase, ClearIsRefusedFromTheSecondFlopOn) {
  for (int low_from = 1; low_from <= kSweep; ++low_from) {
    SCOPED_TRACE(testing::Message() << "pin low from cycle " << low_from << " of the write");
    restart();
    write(reg::kWatchdogOffset, 0);
    write(reg::kCtrlOffset, reg::kCtrlRunMask);
    run_to_trigger();
    clock();
    ASSERT_EQ(status() & (reg::kStatusEstopMask | reg::kStatusWatchdogMask), reg::kStatusWatchdogMask);
    write_with_pin_low_from(low_from, reg::kEstopOffset, reg::kEstopClearWatchdogMask | reg::kEstopClearEstopMask);
    const std::uint32_t watchdog = low_from < kCommandCycle - 1 ? reg::kStatusWatchdogMask : 0;
    EXPECT_EQ(status() & reg::kStatusWatchdogMask, watchdog);
    EXPECT_NE(status() & reg::kStatusEstopMask, 0U);
  }
}

TEST_F(PulseTrainPhase, EventInTheCycleOfItsOwnClearKeepsFlagAndTime) {
  constexpr std::uint32_t kUnderrunTime = reg::kFaultTimeOffset + 4 * 2;
  for (int distance = 1; distance <= kSweep; ++distance) {
    SCOPED_TRACE(testing::Message() << "distance " << distance);
    start_underrunning();
    const std::uint32_t first = time_of(trigger_edge_);
    write_at(distance, reg::kFaultOffset, reg::kFaultUnderrunMask);
    clock(2);
    EXPECT_EQ(faults(), distance < kFlagCycle ? 0U : reg::kFaultUnderrunMask);
    EXPECT_EQ(read(kUnderrunTime), distance > kFlagCycle ? time_of(trigger_edge_) : first);
    EXPECT_EQ(read(reg::kUnderrunsOffset), 2U);
  }
}

TEST_F(PulseTrainPhase, StopEndsARunOfUnderruns) {
  write(reg::kWatchdogOffset, 3);
  write(reg::kCtrlOffset, reg::kCtrlRunMask);
  for (int stop = 0; stop < 3; ++stop) {
    run_to_trigger();
    run_to_trigger();
    clock();
    EXPECT_EQ(in_a_row(), 2U);
    write(reg::kEstopOffset, reg::kEstopStopMask);
    EXPECT_EQ(in_a_row(), 0U);
    write(reg::kEstopOffset, reg::kEstopClearEstopMask);
  }
  EXPECT_EQ(status() & reg::kStatusWatchdogMask, 0U);
}

TEST_F(PulseTrainPhase, ClearOfAnUnlatchedWatchdogDoesNotEndARun) {
  start_underrunning();
  run_to_trigger();
  clock();
  write(reg::kEstopOffset, reg::kEstopClearWatchdogMask);
  EXPECT_EQ(in_a_row(), 2U);
}

TEST_F(PulseTrainPhase, TriggerWhileNotRunningEndsARun) {
  start_underrunning();
  run_to_trigger();
  clock();
  write(reg::kCtrlOffset, 0);
  EXPECT_EQ(in_a_row(), 2U);
  run_to_trigger();
  clock();
  EXPECT_EQ(in_a_row(), 0U);
  EXPECT_EQ(read(reg::kUnderrunsOffset), 2U);
}

TEST_F(PulseTrainPhase, FlagOfAPinThatStaysLowCanBeCleared) {
  dut_.estop_ni = 0;
  clock(10);
  EXPECT_EQ(faults(), reg::kFaultEstopMask);
  write(reg::kFaultOffset, reg::kFaultEstopMask);
  clock(10);
  EXPECT_EQ(faults(), 0U) << "the fall of the pin is the event";
  EXPECT_NE(status() & reg::kStatusEstopMask, 0U);
  dut_.estop_ni = 1;
  clock(10);
  EXPECT_EQ(faults(), 0U);
  dut_.estop_ni = 0;
  clock(10);
  EXPECT_EQ(faults(), reg::kFaultEstopMask);
}

TEST_F(PulseTrainPhase, RefusedCommitIsNotReportedAsClipped) {
  write(reg::kEstopOffset, reg::kEstopStopMask);
  stage_and_commit({201, -201, 500, 0, 0, -32768});
  EXPECT_EQ(faults(), reg::kFaultEstopMask);
}

TEST_F(PulseTrainPhase, ResidualOfEachAxisRaisesTheFlag) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    SCOPED_TRACE(testing::Message() << "axis " << axis + 1);
    restart();
    period_ = 1000;  // of 2500 cycles
    AxisCounts counts{};
    counts[axis] = axis % 2 == 0 ? 200 : -200;
    stage_and_commit(counts);
    run_to_trigger();
    EXPECT_EQ(faults(), 0U);
    run_to_trigger();
    clock();
    EXPECT_EQ(faults(), reg::kFaultResidualMask);
    for (std::size_t i = 0; i < kAxes; ++i) {
      const int residual = read_axis(reg::kResidualOffset, static_cast<int>(i));
      EXPECT_EQ(residual != 0, i == axis);
      EXPECT_EQ(read_axis(reg::kEmittedOffset, static_cast<int>(i)) + residual, counts[i]);
    }
  }
}

}  // namespace
}  // namespace armature::test
