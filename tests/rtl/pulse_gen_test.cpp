// pulse_gen: regular ticks, checked from the pins as a drive sees them.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "Vpulse_gen.h"
#include "Vpulse_gen_wrap.h"
#include "tests/rtl/pulse_gen_fixture.hpp"

namespace armature::test {
namespace {

using PulseGen = PulseGenBase<Vpulse_gen>;
using PulseGenWrap = PulseGenBase<Vpulse_gen_wrap>;

// Every edge lies in [ideal, ideal + 1) of an even spread over [start, kTickCycles).
void expect_even_spread(const std::vector<StepDirMonitor::Edge>& edges, std::int64_t trigger, int start, int count) {
  ASSERT_EQ(edges.size(), static_cast<std::size_t>(2 * std::abs(count)));
  const double half_period = static_cast<double>(kTickCycles - start) / (2.0 * std::abs(count));
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const double late = static_cast<double>(edges[i].time - trigger) - start - static_cast<double>(i + 1) * half_period;
    ASSERT_GE(late, -1e-9) << "edge " << i;
    ASSERT_LT(late, 1.0) << "edge " << i;
    ASSERT_EQ(edges[i].rising, i % 2 == 0);
  }
}

TEST_F(PulseGen, IsSilentAfterReset) {
  EXPECT_EQ(dut_.step_o, 0);
  EXPECT_EQ(dut_.dir_o, 0);
  EXPECT_EQ(emitted(), 0);
  EXPECT_EQ(unfinished(), 0);
  for (int i = 0; i < 2 * kTickCycles; ++i) step_clock();
  EXPECT_EQ(monitor_.rises, 0);
}

TEST_F(PulseGen, EmitsExactlyTheCommandedCountAfterEveryPreviousDirection) {
  for (const int previous : {kMaxCount, -kMaxCount, 1, -1, 0}) {
    for (int count = -kMaxCount; count <= kMaxCount; ++count) {
      SCOPED_TRACE(testing::Message() << "count " << count << " after " << previous);
      run_tick(previous);
      const bool dir_before = dut_.dir_o;
      begin_tick(count);  // its first edge ends the previous tick
      const std::int64_t rises_before = monitor_.rises;
      const std::int64_t position_before = monitor_.position;
      const int emitted_before = emitted();
      for (int i = 1; i < kTickCycles; ++i) step_clock();
      EXPECT_EQ(unfinished(), 0);
      EXPECT_EQ(emitted() - emitted_before, count);

      auto edges = monitor_.edges;
      const std::int64_t trigger = trigger_;
      begin_tick(0);
      if (count != 0) edges.push_back({cycle_, false});
      EXPECT_EQ(dut_.step_o, 0);
      EXPECT_EQ(monitor_.rises - rises_before, std::abs(count));
      EXPECT_EQ(monitor_.position - position_before, count);

      // A reversal after a pulse at the very end of the tick waits for hold, from rest for one cycle, then set-up.
      const bool reverses = count != 0 && (count > 0) != dir_before;
      const int start = reverses ? (previous != 0 ? kDirHold : 1) + kDirSetup : 0;
      expect_even_spread(edges, trigger, start, count);
      for (int i = 1; i < 2 * kDirHold; ++i) step_clock();
      if (HasFailure()) return;
    }
  }
  expect_legal_timing();
}

TEST_F(PulseGen, DistributesFourMegapulsesInHalfPeriodsOfSixAndSevenCycles) {
  run_tick(kMaxCount);
  run_tick(kMaxCount);
  std::vector<int> seen(16, 0);
  for (std::size_t i = 1; i < monitor_.edges.size(); ++i) {
    const auto width = monitor_.edges[i].time - monitor_.edges[i - 1].time;
    ASSERT_LT(width, 16);
    ++seen[static_cast<std::size_t>(width)];
  }
  EXPECT_EQ(seen[6] + seen[7], static_cast<int>(monitor_.edges.size()) - 1);
  EXPECT_EQ(monitor_.position, 2 * kMaxCount);
}

TEST_F(PulseGen, ZeroCountLeavesTheDirectionAlone) {
  for (const int previous : {7, -7}) {
    run_tick(previous);
    run_tick(0);
    run_tick(0);
    EXPECT_EQ(dut_.dir_o, previous > 0);
  }
}

TEST_F(PulseGen, KeepsDirectionSetupAndHoldAndReportsWhatDoesNotFit) {
  const int times[] = {0, 1, 2, 6, 25, 100, 250, 600, 1000, 1023};
  for (const int setup : times) {
    for (const int hold : times) {
      for (const int count : {1, 37, 163, 200}) {
        SCOPED_TRACE(testing::Message() << "setup " << setup << " hold " << hold << " count " << count);
        reset();
        monitor_ = {};
        dut_.dir_setup_i = static_cast<std::uint16_t>(setup);
        dut_.dir_hold_i = static_cast<std::uint16_t>(hold);
        run_tick(count);
        run_tick(count);  // no reversal: its last pulse ends with the tick
        const int forward = emitted();
        begin_tick(-count);
        const std::int64_t reversed_at = trigger_;
        for (int i = 1; i < kTickCycles; ++i) step_clock();
        const int window = kTickCycles - std::max(hold, 1) - setup;
        const int backward = forward - emitted();
        EXPECT_EQ(unfinished(), -(count - backward));
        EXPECT_EQ(monitor_.last_dir_change, reversed_at + std::max(hold, 1));
        if (2 * kMinWidth * count <= window) {
          EXPECT_EQ(backward, count);
        } else {
          // As many as the minimum widths allow; the last one may end in the next tick.
          EXPECT_LE(backward, std::min(count, window / (2 * kMinWidth) + 1));
          EXPECT_GE(backward, window / (2 * kMinWidth));
        }
        run_tick(0);
        EXPECT_EQ(monitor_.position, emitted());
        expect_legal_timing(setup, hold);
        if (HasFailure()) return;
      }
    }
  }
}

TEST_F(PulseGen, ReversesAfterTheLongestHoldTime) {
  for (const int hold : {511, 512, 513, 1023}) {
    SCOPED_TRACE(testing::Message() << "hold " << hold);
    dut_.dir_hold_i = static_cast<std::uint16_t>(hold);
    for (const int count : {1, -1, 5, -5}) {
      const int before = emitted();
      run_tick(count);
      EXPECT_EQ(emitted() - before, count);
      EXPECT_EQ(unfinished(), 0);
    }
  }
  run_tick(0);
  expect_legal_timing(kDirSetup, 511);
}

// A trigger while the hold or the set-up time runs: the direction changes, and the pulses begin, in the clock in which
// they would without it. Only the clock edge of the trigger itself changes no direction.
TEST_F(PulseGen, ATriggerDelaysNeitherHoldNorSetUpTime) {
  constexpr int kCount = 5;
  for (int length = 1; length <= kDirHold + kDirSetup + 10; ++length) {
    SCOPED_TRACE(testing::Message() << "trigger " << length << " cycles after that of the reversal");
    reset();
    monitor_ = {};
    run_tick(kCount);
    run_tick(-kCount, length);  // the pulse before falls on its trigger edge
    const std::int64_t reversal = trigger_ + kDirHold + (length == kDirHold ? 1 : 0);
    run_tick(-kCount);
    EXPECT_EQ(monitor_.last_dir_change, reversal);
    EXPECT_EQ(unfinished(), 0);
    const auto start = static_cast<int>(std::max<std::int64_t>(reversal + kDirSetup - trigger_, 0));
    auto edges = monitor_.edges;
    const std::int64_t trigger = trigger_;
    begin_tick(0);
    edges.push_back({cycle_, false});
    expect_even_spread(edges, trigger, start, kCount);
    if (HasFailure()) return;
  }
}

TEST_F(PulseGenWrap, EmittedCountWrapsAtThirtyTwoBits) {
  ASSERT_EQ(emitted(), 0x7FFF'FFF0);  // EmittedReset of this model
  run_tick(20);
  EXPECT_EQ(dut_.emitted_o, 0x8000'0004U);
  run_tick(-20);
  EXPECT_EQ(dut_.emitted_o, 0x7FFF'FFF0U);
  run_tick(0);
  EXPECT_EQ(monitor_.position, 0);
}

}  // namespace
}  // namespace armature::test
