// pulse_train: underruns, watchdog, emergency stop and the rules of clearing them.
#include <algorithm>

#include "Vpulse_train.h"
#include "tests/rtl/pulse_train_fixture.hpp"

namespace armature::test {
namespace {

namespace reg = regs::pulse_train;

constexpr AxisCounts kFullSpeed = {200, 200, 200, 200, 200, 200};

class PulseTrainStop : public PulseTrainFixture<Vpulse_train> {
 protected:
  void start() {
    write(reg::kCtrlOffset, reg::kCtrlRunMask | kAllAxes);
    stage_and_commit(kFullSpeed, 1);
    run_to_trigger();
  }

  void expect_stopped(std::uint32_t latch) {
    EXPECT_EQ(dut_.servo_on_o, 0);
    EXPECT_EQ(status() & (reg::kStatusEstopMask | reg::kStatusWatchdogMask), latch);
    const std::int64_t before = rises();
    stage_and_commit(kFullSpeed, 99);
    EXPECT_EQ(status() & reg::kStatusPendingMask, 0U) << "a stop refuses commits";
    run_to_trigger();
    run_to_trigger();
    EXPECT_EQ(rises(), before);
    EXPECT_EQ(dut_.step_o, 0);
    EXPECT_NE(sequence(), 99U);
  }

  // The first set after the latch was cleared is emitted as ever.
  void expect_runs_again() {
    run_to_trigger();
    stage_and_commit({5, -5, 5, -5, 5, -5}, 2);
    EXPECT_EQ(dut_.servo_on_o, kAllAxes);
    run_to_trigger();
    const AxisCounts from = at_trigger_;
    stage_and_commit({}, 3);
    run_to_trigger();
    for (std::size_t i = 0; i < kAxes; ++i) EXPECT_EQ(at_trigger_[i] - from[i], i % 2 == 0 ? 5 : -5);
  }

  void expect_truthful_counts(const AxisCounts& committed) {
    run_to_trigger();
    for (int i = 0; i < kAxes; ++i) {
      const auto axis = static_cast<std::size_t>(i);
      EXPECT_EQ(read_axis(reg::kEmittedOffset, i), drives_[axis].position);
      EXPECT_EQ(read_axis(reg::kEmittedOffset, i) + read_axis(reg::kResidualOffset, i), committed[axis]);
    }
  }

  [[nodiscard]] std::uint32_t in_a_row() { return regs::extract(read(reg::kWatchdogOffset), reg::kWatchdogInARow); }
};

TEST_F(PulseTrainStop, UnderrunEmitsNothingAndIsCounted) {
  start();
  run_to_trigger();  // no set for this tick
  const std::int64_t before = rises();
  EXPECT_EQ(faults(), reg::kFaultUnderrunMask);
  EXPECT_EQ(read(reg::kUnderrunsOffset), 1U);
  EXPECT_EQ(in_a_row(), 1U);
  stage_and_commit({1, 1, 1, 1, 1, 1}, 2);
  run_to_trigger();
  EXPECT_EQ(rises(), before);
  EXPECT_EQ(in_a_row(), 0U);
  EXPECT_EQ(read(reg::kUnderrunsOffset), 1U);
}

TEST_F(PulseTrainStop, ServoOnNeedsItsRequestPerAxis) {
  for (const std::uint32_t axes : {0x00U, 0x01U, 0x2AU, 0x3FU}) {
    write(reg::kCtrlOffset, axes);
    clock(2);
    EXPECT_EQ(dut_.servo_on_o, axes);
  }
}

TEST_F(PulseTrainStop, WatchdogLatchesAfterItsLimitOfUnderrunsInARow) {
  for (const int limit : {0, 1, 2, 4, 7, 255}) {
    SCOPED_TRACE(testing::Message() << "limit " << limit);
    restart();
    write(reg::kWatchdogOffset, static_cast<std::uint32_t>(limit));
    start();
    period_ = 100;  // the rest is about counting ticks
    const int needed = std::max(limit, 1);
    if (needed > 1) {
      for (int i = 0; i < needed - 1; ++i) run_to_trigger();
      to_trigger_ = 2500;  // one set in time restarts the run
      stage_and_commit(kFullSpeed, 2);
      run_to_trigger();
    }
    for (int i = 0; i < needed - 1; ++i) {
      run_to_trigger();
      ASSERT_EQ(dut_.servo_on_o, kAllAxes) << "after underrun " << i + 1;
    }
    EXPECT_EQ(status() & reg::kStatusWatchdogMask, 0U);
    period_ = 2500;
    run_to_trigger();
    const std::int64_t edge = trigger_edge_;
    clock(2);
    EXPECT_EQ(dut_.servo_on_o, 0);
    EXPECT_NE(faults() & reg::kFaultWatchdogMask, 0U);
    EXPECT_EQ(read(reg::kFaultTimeOffset + 4 * 1), time_of(edge));
    const std::uint32_t underruns = read(reg::kUnderrunsOffset);
    expect_stopped(reg::kStatusWatchdogMask);
    EXPECT_EQ(read(reg::kUnderrunsOffset), underruns) << "nothing is expected while stopped";
    write(reg::kEstopOffset, reg::kEstopClearEstopMask);
    expect_stopped(reg::kStatusWatchdogMask);
    write(reg::kWatchdogOffset, 4);
    write(reg::kEstopOffset, reg::kEstopClearWatchdogMask);
    EXPECT_EQ(in_a_row(), 0U);
    expect_runs_again();
    if (HasFailure()) return;
  }
}

TEST_F(PulseTrainStop, PinStopsAllPulsesTwoCyclesAfterItIsSampledLow) {
  start();
  for (int phase = 0; phase < 40; ++phase) {
    stage_and_commit(kFullSpeed, 1);
    run_to_trigger();
    clock(300 + phase);
    dut_.estop_ni = 0;
    const int low = 1 + phase % 3;  // also a pin that is low for a single cycle
    clock();
    if (low == 1) dut_.estop_ni = 1;
    clock();  // the second flop; a pulse may still rise on this very edge
    const std::int64_t allowed = rises();
    if (low > 1) clock(low - 1);
    dut_.estop_ni = 1;
    clock(200);
    ASSERT_EQ(rises(), allowed) << "phase " << phase;
    ASSERT_EQ(dut_.step_o, 0);
    ASSERT_EQ(dut_.servo_on_o, 0);
    write(reg::kEstopOffset, reg::kEstopClearEstopMask);
    run_to_trigger();
  }
  for (const auto& drive : drives_) EXPECT_GE(drive.min_high, 6);
}

TEST_F(PulseTrainStop, SingleCycleOnThePinLatches) {
  start();
  clock(100);
  dut_.estop_ni = 0;
  clock();
  dut_.estop_ni = 1;
  clock();
  const std::int64_t allowed = rises();
  clock(100);
  EXPECT_EQ(rises(), allowed);
  EXPECT_EQ(faults(), reg::kFaultEstopMask);
  expect_stopped(reg::kStatusEstopMask);
  expect_truthful_counts(kFullSpeed);
  write(reg::kEstopOffset, reg::kEstopClearEstopMask);
  expect_runs_again();
}

TEST_F(PulseTrainStop, RegisterStopsAndLatches) {
  start();
  clock(1000);
  write(reg::kEstopOffset, reg::kEstopStopMask);
  const std::int64_t allowed = rises();
  clock(20);
  EXPECT_EQ(rises(), allowed);
  EXPECT_EQ(faults(), reg::kFaultEstopMask);
  expect_stopped(reg::kStatusEstopMask);
  expect_truthful_counts(kFullSpeed);
  write(reg::kFaultOffset, reg::kFaultEstopMask);
  expect_stopped(reg::kStatusEstopMask);  // clearing the flag is not clearing the stop
  write(reg::kEstopOffset, reg::kEstopClearWatchdogMask);
  expect_stopped(reg::kStatusEstopMask);
  write(reg::kEstopOffset, reg::kEstopClearEstopMask);
  expect_runs_again();
}

TEST_F(PulseTrainStop, StopWinsOverClearInTheSameWrite) {
  start();
  write(reg::kEstopOffset, reg::kEstopStopMask | reg::kEstopClearEstopMask);
  expect_stopped(reg::kStatusEstopMask);
}

TEST_F(PulseTrainStop, ClearIsRefusedWhileThePinIsLow) {
  write(reg::kWatchdogOffset, 0);
  start();
  run_to_trigger();  // latches the watchdog
  dut_.estop_ni = 0;
  clock(5);
  constexpr std::uint32_t kBoth = reg::kStatusEstopMask | reg::kStatusWatchdogMask;
  EXPECT_EQ(status() & (kBoth | reg::kStatusEstopPinMask), kBoth | reg::kStatusEstopPinMask);
  write(reg::kEstopOffset, reg::kEstopClearEstopMask | reg::kEstopClearWatchdogMask);
  expect_stopped(kBoth);
  dut_.estop_ni = 1;
  clock(5);
  EXPECT_EQ(status() & (kBoth | reg::kStatusEstopPinMask), kBoth) << "a released pin clears nothing";
  write(reg::kWatchdogOffset, 4);
  write(reg::kEstopOffset, reg::kEstopClearEstopMask | reg::kEstopClearWatchdogMask);
  EXPECT_EQ(status() & kBoth, 0U);
  expect_runs_again();
}

TEST_F(PulseTrainStop, DiscardsTheWaitingSet) {
  start();
  stage_and_commit({9, 9, 9, 9, 9, 9}, 50);
  write(reg::kEstopOffset, reg::kEstopStopMask);
  write(reg::kEstopOffset, reg::kEstopClearEstopMask);
  EXPECT_EQ(status() & reg::kStatusPendingMask, 0U);
  const std::int64_t before = rises();
  run_to_trigger();
  run_to_trigger();
  EXPECT_EQ(rises(), before);
  EXPECT_EQ(sequence(), 1U);
}

TEST_F(PulseTrainStop, FaultTimeOfThePinIsThatOfTheSynchronisedEdge) {
  start();
  clock(123);
  dut_.estop_ni = 0;
  clock(3);  // two flops, then the event
  const std::int64_t edge = cycle_;
  clock(50);
  EXPECT_EQ(read(reg::kFaultTimeOffset), time_of(edge));
}

}  // namespace
}  // namespace armature::test
