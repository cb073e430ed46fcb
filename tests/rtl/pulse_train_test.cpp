// pulse_train: counts, commits, snapshots and faults through the AXI port.
#include "Vpulse_train.h"
#include "Vpulse_train_wrap.h"
#include "tests/rtl/pulse_train_fixture.hpp"
#include "tests/support/split_mix.hpp"

namespace armature::test {
namespace {

namespace reg = regs::pulse_train;

using PulseTrain = PulseTrainFixture<Vpulse_train>;
using PulseTrainWrap = PulseTrainFixture<Vpulse_train_wrap>;

AxisCounts difference(const AxisCounts& a, const AxisCounts& b) {
  AxisCounts result;
  for (std::size_t i = 0; i < kAxes; ++i) result[i] = a[i] - b[i];
  return result;
}

TEST_F(PulseTrain, StartsSilentWithItsDocumentedSettings) {
  EXPECT_EQ(read(reg::kIdOffset), 0x5054'0106U);
  EXPECT_EQ(read(reg::kTickCyclesOffset), 2500U);
  EXPECT_EQ(status(), 0U);
  EXPECT_EQ(faults(), 0U);
  for (int i = 0; i < kAxes; ++i) {
    EXPECT_EQ(read_axis(reg::kEmittedOffset, i), 0);
    EXPECT_EQ(read_axis(reg::kResidualOffset, i), 0);
  }
  run_to_trigger();
  run_to_trigger();
  EXPECT_EQ(rises(), 0);
  EXPECT_EQ(faults(), 0U) << "no underrun while CTRL.run is 0";
}

TEST_F(PulseTrain, AxesWithEqualCountsPulseOnTheSameEdges) {
  run_to_trigger();
  stage_and_commit({73, 73, 73, 73, 73, 73});
  run_to_trigger();
  for (auto& drive : drives_) drive.edges.clear();
  run_to_trigger();
  ASSERT_EQ(drives_[0].edges.size(), 146U);
  for (std::size_t axis = 1; axis < kAxes; ++axis) {
    for (std::size_t i = 0; i < drives_[0].edges.size(); ++i) {
      ASSERT_EQ(drives_[axis].edges.at(i).time, drives_[0].edges[i].time);
    }
  }
}

TEST_F(PulseTrain, EmitsEveryCommittedSetInTheTickAfterItsCommit) {
  SplitMix random(5);
  AxisCounts running{};
  for (std::uint16_t k = 1; k <= 40; ++k) {
    AxisCounts next;
    for (int& count : next) count = static_cast<int>(random.below(2 * kMaxCount + 1)) - kMaxCount;
    stage_and_commit(next, k);
    EXPECT_NE(status() & reg::kStatusPendingMask, 0U);
    const AxisCounts before = at_trigger_;
    run_to_trigger();
    EXPECT_EQ(difference(at_trigger_, before), running) << "tick " << k;
    EXPECT_EQ(sequence(), k);
    EXPECT_EQ(status() & reg::kStatusPendingMask, 0U);
    running = next;
  }
  EXPECT_EQ(faults(), 0U);
}

TEST_F(PulseTrain, StagedCountsNeverTearAcrossAxes) {
  // Set k is recognised by every one of its counts. Commits land around the trigger or well before it, and the next set
  // is being staged while the last one waits and becomes active.
  constexpr int kSets = 60;
  const auto set_of = [](int k) {
    AxisCounts counts;
    for (int i = 0; i < kAxes; ++i) counts[static_cast<std::size_t>(i)] = 1 + (k * 29 + i * 31) % kMaxCount;
    return counts;
  };
  SplitMix random(6);
  stage(set_of(1));
  for (int k = 1; k <= kSets; ++k) {
    const int distance = static_cast<int>((k % 2 == 0 ? 4 : 20) + random.below(16));
    while (to_trigger_ > distance) clock();
    commit(static_cast<std::uint16_t>(k));
    stage(set_of(k + 1));
    while (status() & reg::kStatusPendingMask) run_to_trigger();
    ASSERT_EQ(sequence(), static_cast<std::uint32_t>(k));
  }
  run_to_trigger();

  int next = 1;
  for (std::size_t tick = 1; tick < trigger_positions_.size(); ++tick) {
    const AxisCounts moved = difference(trigger_positions_[tick], trigger_positions_[tick - 1]);
    if (moved == AxisCounts{}) continue;
    ASSERT_EQ(moved, set_of(next)) << "tick " << tick << ", set " << next;
    ++next;
  }
  EXPECT_EQ(next, kSets + 1);
}

TEST_F(PulseTrain, EmittedIsASnapshotOfTheTriggerEdge) {
  // 11 cycles of the tick are missing, so the trigger falls into a pulse of most axes.
  period_ = 2489;
  for (int tick = 0; tick < 6; ++tick) {
    stage_and_commit({200, -200, 199, 150, -77, 1});
    run_to_trigger();
    const AxisCounts expected = at_trigger_;
    clock(700 + 13 * tick);
    for (int i = 0; i < kAxes; ++i) {
      EXPECT_EQ(read_axis(reg::kEmittedOffset, i), expected[static_cast<std::size_t>(i)]) << "axis " << i + 1;
    }
    EXPECT_NE(at_trigger_, positions());
  }

  // With the shortest distribution a pulse rises on the very next edge; it belongs to the next snapshot.
  period_ = 2500;
  write(reg::kTickCyclesOffset, 1);
  run_to_trigger();
  stage_and_commit({20, 20, 20, 20, 20, 20});
  run_to_trigger();
  const AxisCounts expected = at_trigger_;
  clock();
  EXPECT_EQ(positions()[0], expected[0] + 1);
  for (int i = 0; i < kAxes; ++i) {
    EXPECT_EQ(read_axis(reg::kEmittedOffset, i), expected[static_cast<std::size_t>(i)]) << "axis " << i + 1;
  }
}

TEST_F(PulseTrain, EmittedPlusResidualIsWhatWasCommitted) {
  write(reg::kDirSetupOffset, 700);
  write(reg::kDirHoldOffset, 500);
  AxisCounts committed{};
  for (int tick = 0; tick < 7; ++tick) {
    const int sign = tick % 2 == 0 ? 1 : -1;
    const AxisCounts counts = {200 * sign, 200, 150 * sign, -170 * sign, 0, 3 * sign};
    stage_and_commit(counts);
    run_to_trigger();
    for (std::size_t i = 0; i < kAxes; ++i) committed[i] += counts[i];
  }
  stage_and_commit({});
  EXPECT_EQ(faults() & ~reg::kFaultResidualMask, 0U);
  run_to_trigger();
  run_to_trigger();
  EXPECT_NE(faults() & reg::kFaultResidualMask, 0U);
  for (int i = 0; i < kAxes; ++i) {
    const int emitted = read_axis(reg::kEmittedOffset, i);
    EXPECT_EQ(emitted, drives_[static_cast<std::size_t>(i)].position);
    EXPECT_EQ(emitted + read_axis(reg::kResidualOffset, i), committed[static_cast<std::size_t>(i)]);
  }
  EXPECT_GT(read_axis(reg::kResidualOffset, 0), 0);  // seven reversals, the first of them to positive
  EXPECT_EQ(read_axis(reg::kResidualOffset, 4), 0);
  EXPECT_EQ(read_axis(reg::kResidualOffset, 5), 0);
}

TEST_F(PulseTrain, LimitsCountsOutsideTheRangeAndSaysSo) {
  run_to_trigger();
  stage_and_commit({200, -200, 0, 1, -1, 199});
  EXPECT_EQ(faults(), 0U);
  run_to_trigger();
  stage_and_commit({201, -201, 32767, -32768, 256, -512});
  EXPECT_EQ(faults(), reg::kFaultClippedMask);
  run_to_trigger();
  write(reg::kTickCyclesOffset, 2500);
  stage_and_commit({});
  const AxisCounts before = at_trigger_;
  run_to_trigger();
  EXPECT_EQ(difference(at_trigger_, before), (AxisCounts{200, -200, 200, -200, 200, -200}));
}

TEST_F(PulseTrain, ReplacingAWaitingSetIsReportedAndTheLastOneCounts) {
  run_to_trigger();
  stage_and_commit({1, 2, 3, 4, 5, 6}, 7);
  EXPECT_EQ(faults(), 0U);
  stage_and_commit({10, 20, 30, 40, 50, 60}, 8);
  EXPECT_EQ(faults(), reg::kFaultRecommitMask);
  run_to_trigger();
  EXPECT_EQ(sequence(), 8U);
  run_to_trigger();
  EXPECT_EQ(at_trigger_, (AxisCounts{10, 20, 30, 40, 50, 60}));
}

TEST_F(PulseTrain, FaultTimeIsThatOfTheFirstEventSinceTheFlagWasClear) {
  constexpr std::uint32_t kUnderrunTime = reg::kFaultTimeOffset + 4 * 2;
  write(reg::kWatchdogOffset, 255);
  write(reg::kCtrlOffset, reg::kCtrlRunMask);
  run_to_trigger();
  const auto first = time_of(trigger_edge_);
  run_to_trigger();
  EXPECT_EQ(faults(), reg::kFaultUnderrunMask);
  EXPECT_EQ(read(kUnderrunTime), first);
  write(reg::kFaultOffset, ~reg::kFaultUnderrunMask);
  EXPECT_EQ(faults(), reg::kFaultUnderrunMask) << "only ones clear";
  write(reg::kFaultOffset, reg::kFaultUnderrunMask);
  EXPECT_EQ(faults(), 0U);
  run_to_trigger();
  EXPECT_EQ(read(kUnderrunTime), time_of(trigger_edge_));
  EXPECT_EQ(read(reg::kUnderrunsOffset), 3U);
}

TEST_F(PulseTrain, ShowsEverySwitchAndDriveInput) {
  for (int bit = 0; bit < 30; ++bit) {
    const auto pins = [bit](int group) { return static_cast<std::uint8_t>(bit / 6 == group ? 1 << bit % 6 : 0); };
    dut_.home_i = pins(0);
    dut_.limit_pos_i = pins(1);
    dut_.limit_neg_i = pins(2);
    dut_.drive_alarm_i = pins(3);
    dut_.in_position_i = pins(4);
    clock(2);  // synchroniser
    const std::uint32_t set = 1U << (bit % 6);
    const int group = bit / 6;
    EXPECT_EQ(read(reg::kSwitchesOffset), group < 3 ? set << (8 * group) : 0U);
    EXPECT_EQ(read(reg::kDrivesOffset), group >= 3 ? set << (8 * (group - 3)) : 0U);
  }
}

TEST_F(PulseTrainWrap, EmittedWrapsAtThirtyTwoBits) {
  stage_and_commit({200, -200, 100, 17, 16, 0});  // EmittedReset is 2^31 - 16
  run_to_trigger();
  run_to_trigger();
  clock();
  const std::uint32_t start = 0x7FFF'FFF0U;
  EXPECT_EQ(static_cast<std::uint32_t>(read_axis(reg::kEmittedOffset, 0)), start + 200U);
  EXPECT_EQ(static_cast<std::uint32_t>(read_axis(reg::kEmittedOffset, 1)), start - 200U);
  EXPECT_EQ(static_cast<std::uint32_t>(read_axis(reg::kEmittedOffset, 4)), 0x8000'0000U);
  EXPECT_EQ(static_cast<std::uint32_t>(read_axis(reg::kEmittedOffset, 5)), start);
}

TEST_F(PulseTrainWrap, UnderrunsStayAtTheirLargestNumber) {
  EXPECT_EQ(read(reg::kUnderrunsOffset), 0xFFFF'FFFEU);  // UnderrunsReset of this model
  write(reg::kWatchdogOffset, 255);
  write(reg::kCtrlOffset, reg::kCtrlRunMask);
  for (int underruns = 1; underruns <= 3; ++underruns) {
    run_to_trigger();
    clock();
    EXPECT_EQ(read(reg::kUnderrunsOffset), 0xFFFF'FFFFU) << underruns << " underruns";
  }
}

}  // namespace
}  // namespace armature::test
