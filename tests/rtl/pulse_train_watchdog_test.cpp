// pulse_train: the watchdog's own count of clocks, and the heartbeat.
#include <algorithm>

#include "Vpulse_train.h"
#include "tests/rtl/pulse_train_fixture.hpp"

namespace armature::test {
namespace {

namespace reg = regs::pulse_train;

constexpr AxisCounts kSlow = {1, 1, 1, 1, 1, 1};
constexpr int kNoTrigger = 1'000'000'000;

class PulseTrainWatchdog : public PulseTrainFixture<Vpulse_train> {
 protected:
  void start() {
    write(reg::kCtrlOffset, reg::kCtrlRunMask | kAllAxes);
    stage_and_commit(kSlow, 1);
    run_to_trigger();
  }
  [[nodiscard]] std::uint32_t idle_ticks() {
    return regs::extract(read(reg::kWatchdogOffset), reg::kWatchdogIdleTicks);
  }
};
using PulseTrainHeartbeat = PulseTrainWatchdog;

TEST_F(PulseTrainWatchdog, LatchesWithoutTriggers) {
  for (const int limit : {0, 1, 4, 255}) {
    SCOPED_TRACE(testing::Message() << "limit " << limit);
    restart();
    write(reg::kWatchdogOffset, static_cast<std::uint32_t>(limit));
    start();
    const std::int64_t edge = trigger_edge_;
    to_trigger_ = kNoTrigger;  // the timer stops
    const int ticks = std::max(limit, 1) + 1;
    while (cycle_ < edge + 2500 * ticks) clock();
    EXPECT_EQ(dut_.servo_on_o, kAllAxes);
    clock(1);
    EXPECT_EQ(dut_.servo_on_o, 0);
    EXPECT_EQ(faults(), reg::kFaultWatchdogMask) << "there was no underrun";
    EXPECT_EQ(read(reg::kFaultTimeOffset + 4 * 1), time_of(edge + 2500 * ticks));
    EXPECT_EQ(read(reg::kUnderrunsOffset), 0U);
    if (HasFailure()) return;
  }
}

TEST_F(PulseTrainWatchdog, ATickOfItsOwnHasTickCycles) {
  write(reg::kTickCyclesOffset, 1000);
  write(reg::kWatchdogOffset, 2);
  start();
  const std::int64_t edge = trigger_edge_;
  to_trigger_ = kNoTrigger;
  while (cycle_ < edge + 1990) clock();
  EXPECT_EQ(idle_ticks(), 1U);
  while (cycle_ < edge + 3000) clock();
  EXPECT_EQ(dut_.servo_on_o, kAllAxes);
  clock(1);
  EXPECT_EQ(dut_.servo_on_o, 0);
}

// Triggers may be as late as the limit allows, as long as each finds a set.
TEST_F(PulseTrainWatchdog, SetsInTimeKeepItQuiet) {
  write(reg::kWatchdogOffset, 2);
  start();
  for (const int late : {2500, 4999, 7500, 2500, 7500}) {
    to_trigger_ = late;
    stage_and_commit(kSlow, 2);
    run_to_trigger();
  }
  EXPECT_EQ(dut_.servo_on_o, kAllAxes);
  EXPECT_EQ(faults() & reg::kFaultWatchdogMask, 0U);
  to_trigger_ = 7501;
  stage_and_commit(kSlow, 3);
  const std::int64_t edge = trigger_edge_;
  while (cycle_ < edge + 7501) clock();
  EXPECT_EQ(dut_.servo_on_o, 0);
}

TEST_F(PulseTrainWatchdog, StartsAgainAfterAStopAndWithRun) {
  to_trigger_ = kNoTrigger;
  write(reg::kWatchdogOffset, 1);
  clock(20'000);
  EXPECT_EQ(faults(), 0U) << "not running";
  write(reg::kCtrlOffset, reg::kCtrlRunMask | kAllAxes);
  clock(4'900);
  write(reg::kEstopOffset, reg::kEstopStopMask);
  EXPECT_EQ(idle_ticks(), 0U);
  clock(20'000);
  EXPECT_EQ(faults(), reg::kFaultEstopMask) << "a stop needs no watchdog";
  write(reg::kEstopOffset, reg::kEstopClearEstopMask);
  clock(4'900);
  EXPECT_EQ(faults(), reg::kFaultEstopMask);
  clock(200);
  EXPECT_EQ(faults(), reg::kFaultEstopMask | reg::kFaultWatchdogMask);
}

TEST_F(PulseTrainHeartbeat, InvertsWithEachSetThatBecomesActive) {
  start();
  bool level = dut_.heartbeat_o != 0;
  for (int i = 0; i < 5; ++i) {
    stage_and_commit(kSlow, 2);
    run_to_trigger();
    EXPECT_NE(dut_.heartbeat_o != 0, level);
    level = dut_.heartbeat_o != 0;
    run_to_trigger();  // an underrun
    EXPECT_EQ(dut_.heartbeat_o != 0, level);
  }
}

TEST_F(PulseTrainHeartbeat, StandsStillDuringAStop) {
  for (const bool by_pin : {false, true}) {
    restart();
    start();
    const int level = dut_.heartbeat_o;
    if (by_pin) {
      dut_.estop_ni = 0;
    } else {
      write(reg::kEstopOffset, reg::kEstopStopMask);
    }
    for (int i = 0; i < 4; ++i) {
      stage_and_commit(kSlow, 2);
      run_to_trigger();
      EXPECT_EQ(dut_.heartbeat_o, level);
    }
    dut_.estop_ni = 1;
    clock(4);
    write(reg::kEstopOffset, reg::kEstopClearEstopMask);
    stage_and_commit(kSlow, 3);
    run_to_trigger();
    EXPECT_NE(dut_.heartbeat_o, level);
  }
}

}  // namespace
}  // namespace armature::test
