// pulse_width: edges, counts and the limits of sending a half period (Vo 2021, Figure 6).
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "Vpulse_width.h"
#include "Vpulse_width_wrap.h"
#include "tests/rtl/pulse_width_fixture.hpp"
#include "tests/support/split_mix.hpp"

namespace armature::test {
namespace {

namespace reg = regs::pulse_width;

using Widths = std::array<std::int32_t, kAxes>;

class PulseWidth : public PulseWidthFixture<Vpulse_width> {
 protected:
  // Pulses of one whole tick for every half period from 1 to `longest`, as a drive counts them; [0] is that of width 0.
  std::vector<int> counts_up_to(int longest) {
    std::vector<int> counts(static_cast<std::size_t>(longest) + 1);
    for (int first = 0; first <= longest; first += kAxes) {
      for (int i = 0; i < kAxes; ++i) write_width(static_cast<std::size_t>(i), first + i);
      run_to_trigger();
      const AxisCounts before = positions();
      run_to_trigger();
      for (std::size_t i = 0; i < kAxes; ++i) {
        const auto width = static_cast<std::size_t>(first) + i;
        if (width < counts.size()) counts[width] = positions()[i] - before[i];
      }
    }
    return counts;
  }
};
using PulseWidthWrap = PulseWidthFixture<Vpulse_width_wrap>;

TEST_F(PulseWidth, TogglesEveryWidthCyclesFromTheTriggerAndStartsAnewAtTheNext) {
  for (const Widths& widths : {Widths{6, 7, 8, -13, -25, 625}, Widths{1, -2, 3, 1249, -1250, 1251},
                               Widths{2499, -2498, 2500, -2501, 100000, -1}}) {
    restart();
    write_widths(widths);
    run_to_trigger();
    for (auto& drive : drives_) drive.edges.clear();
    const std::int64_t start = trigger_edge_;
    run_to_trigger();
    run_to_trigger();
    for (std::size_t i = 0; i < kAxes; ++i) {
      std::vector<std::pair<std::int64_t, bool>> expected, seen;
      for (int tick = 0; tick < 2; ++tick) {
        bool step = false;
        for (int at = 1; at <= kTickCycles; ++at) {
          const bool level = at < kTickCycles && at / std::abs(widths[i]) % 2 == 1;  // low on the trigger edge
          if (level != step) expected.emplace_back(start + tick * kTickCycles + at, level);
          step = level;
        }
      }
      for (const auto& edge : drives_[i].edges) seen.emplace_back(edge.time, edge.rising);
      EXPECT_EQ(seen, expected) << "width " << widths[i];
      EXPECT_EQ(dut_.dir_o >> i & 1, widths[i] > 0) << "width " << widths[i];
    }
  }
}

// Of the counts 1..200 a servo may be asked for in a tick, those for which some half period gives exactly that many.
TEST_F(PulseWidth, ReachesSixtyFourOfTwoHundredCounts) {
  const std::vector<int> counts = counts_up_to(kTickCycles + 20);
  EXPECT_EQ(counts[0], 0);
  EXPECT_EQ(counts[kTickCycles], 0) << "as long as the tick";
  EXPECT_EQ(counts[6], 208);
  std::set<int> reachable(counts.begin() + 1, counts.end());
  EXPECT_EQ(std::count_if(reachable.begin(), reachable.end(), [](int n) { return n >= 1 && n <= kMaxCount; }), 64);
  for (const int n : {1, 2, 5, 10, 25, 50, 125}) EXPECT_TRUE(reachable.contains(n)) << "1250/n is whole";
  for (const int n : {41, 44, 47, 49, 51, 199, 200}) EXPECT_FALSE(reachable.contains(n)) << n;

  struct Scheme {
    const char* name;
    double (*round)(double);
    int exact, lowest, highest;
  };
  const auto whole = [](double x) { return std::floor(x + 0.5); };
  // A rise that would fall on the next trigger edge is none: it moves one count of the first and last scheme.
  const Scheme schemes[] = {{"floor", [](double x) { return std::floor(x); }, 49, 0, 29},
                            {"round", whole, 64, -13, 15},
                            {"ceil", [](double x) { return std::ceil(x); }, 46, -22, 0}};
  for (const Scheme& scheme : schemes) {
    int exact = 0, lowest = 0, highest = 0, sum = 0;
    for (int n = 1; n <= kMaxCount; ++n) {
      const int error = counts[static_cast<std::size_t>(scheme.round(1250.0 / n))] - n;
      exact += error == 0;
      lowest = std::min(lowest, error);
      highest = std::max(highest, error);
      sum += std::abs(error);
    }
    EXPECT_EQ(exact, scheme.exact) << scheme.name;
    EXPECT_EQ(lowest, scheme.lowest) << scheme.name;
    EXPECT_EQ(highest, scheme.highest) << scheme.name;
    RecordProperty(std::string("mean_error_") + scheme.name, std::to_string(sum / 200.0));
  }
}

TEST_F(PulseWidth, TriggerCutsAPulseThatIsStillHigh) {
  write_width(0, 7);  // rises at 2499 = 357 x 7, and the tick ends at 2500
  run_to_trigger();
  run_to_trigger();
  clock(20);
  EXPECT_EQ(drives_[0].min_high, 1) << "20 ns: Vo's scheme has no guard against it";
  EXPECT_EQ(drives_[0].position, 179 + 1);
}

TEST_F(PulseWidth, NewWidthWaitsForTheTriggerAndStandsUntilTheNext) {
  write_width(2, 100);
  clock(1000);
  EXPECT_EQ(rises(), 0);
  run_to_trigger();
  clock(50);
  write_width(2, -25);
  run_to_trigger();
  EXPECT_EQ(drives_[2].position, 12);
  for (int tick = 0; tick < 5; ++tick) run_to_trigger();  // nobody writes
  EXPECT_EQ(drives_[2].position, 12 - 5 * 50);
  write_width(2, 0);
  run_to_trigger();
  const auto at_rest = drives_[2].position;
  run_to_trigger();
  EXPECT_EQ(drives_[2].position, at_rest);
  EXPECT_EQ(dut_.dir_o >> 2 & 1, 0) << "width 0 keeps the direction";
}

// There is no commit: a trigger between two writes mixes the sets.
TEST_F(PulseWidth, TriggerBetweenWritesMixesOldAndNewWidths) {
  write_widths({100, 100, 100, 100, 100, 100});
  run_to_trigger();
  for (std::size_t i = 0; i < 3; ++i) write_width(i, 25);
  run_to_trigger();
  const AxisCounts before = positions();
  for (std::size_t i = 3; i < kAxes; ++i) write_width(i, 25);
  run_to_trigger();
  for (std::size_t i = 0; i < kAxes; ++i) EXPECT_EQ(positions()[i] - before[i], i < 3 ? 50 : 12) << i;
}

TEST_F(PulseWidth, DirectionChangesWithTheTriggerWhileStepIsLow) {
  std::array<int, kAxes> positive{};
  for (int tick = 0; tick < 20; ++tick) {
    const std::array<std::int32_t, kAxes> widths{
        7, -7, tick % 2 ? 7 : -7, tick % 2 ? -13 : 11, tick % 3 - 1, tick % 2 ? 2499 : -2499};
    write_widths(widths);
    run_to_trigger();
    for (std::size_t i = 0; i < kAxes; ++i) {
      if (widths[i] != 0) positive[i] = widths[i] > 0;
      EXPECT_EQ(dut_.dir_o >> i & 1, positive[i]) << "axis " << i + 1 << ", width " << widths[i];
      EXPECT_TRUE(drives_[i].last_dir_change < 0 || (drives_[i].last_dir_change - trigger_edge_) % kTickCycles == 0);
      EXPECT_EQ(dut_.step_o >> i & 1, 0);
    }
  }
}

TEST_F(PulseWidth, EmittedIsWhatTheDrivesCountedAtTheTrigger) {
  constexpr std::uint64_t kSeed = 6;
  SplitMix random(kSeed);
  std::int64_t moved = 0;
  for (int tick = 0; tick < 120; ++tick) {
    if (random.below(12) == 0) {
      write(reg::kEstopOffset, reg::kEstopStopMask);
      clock(static_cast<int>(random.below(1000)));
      write(reg::kEstopOffset, reg::kEstopClearEstopMask);
    }
    for (std::size_t i = 0; i < kAxes; ++i) {
      const auto width = static_cast<std::int32_t>(1 + random.below(random.below(2) ? 40 : 3000));
      if (random.below(4) != 0) write_width(i, random.below(2) ? width : -width);
    }
    if (random.below(5) == 0) to_trigger_ = 1 + static_cast<int>(random.below(3000));  // early and late triggers
    run_to_trigger();
    for (int i = 0; i < kAxes; ++i) {
      ASSERT_EQ(emitted(i), at_trigger_[static_cast<std::size_t>(i)]) << "seed " << kSeed << " tick " << tick;
    }
    moved = rises();
  }
  EXPECT_GT(moved, 10000);
}

TEST_F(PulseWidthWrap, EmittedWrapsAtThirtyTwoBits) {
  write_widths({100, -100, 25, -25, 625, 0});
  run_to_trigger();
  run_to_trigger();
  run_to_trigger();
  for (int i = 0; i < kAxes; ++i) {
    const auto expected = static_cast<std::uint32_t>(2147483632 + at_trigger_[static_cast<std::size_t>(i)]);
    EXPECT_EQ(static_cast<std::uint32_t>(emitted(i)), expected) << i;
  }
}

TEST_F(PulseWidth, StopAllowsNoFurtherRiseAndEndsAHighPulseAtItsWidth) {
  for (const bool pin : {true, false}) {
    for (int phase = 0; phase < 50; ++phase) {
      restart();
      for (auto& drive : drives_) drive = StepDirMonitor();
      write(reg::kCtrlOffset, 0x3F);
      write_widths({6, -7, 25, -25, 400, 1});
      run_to_trigger();
      clock(800 + phase);
      EXPECT_EQ(dut_.servo_on_o, kAllAxes);
      if (pin) {
        dut_.estop_ni = 0;
        clock(2);  // both flops; a pulse may rise with the second edge
      } else {
        write(reg::kEstopOffset, reg::kEstopStopMask);
      }
      const std::int64_t before = rises();
      clock();
      dut_.estop_ni = 1;
      clock(3 * kTickCycles);
      EXPECT_EQ(rises(), before) << "phase " << phase;
      EXPECT_EQ(dut_.step_o, 0);
      EXPECT_EQ(dut_.servo_on_o, 0);
      constexpr std::array<int, 4> kNarrowest = {6, 7, 25, 25};
      for (std::size_t i = 0; i < kNarrowest.size(); ++i) EXPECT_GE(drives_[i].min_high, kNarrowest[i]);
      EXPECT_EQ(faults(), reg::kFaultEstopMask);
    }
  }
}

TEST_F(PulseWidth, OldWidthsDoNotStartTheArmAfterAStop) {
  write_widths({100, 100, 100, 100, 100, 100});
  EXPECT_EQ(status(), 0x3F00U) << "armed";
  run_to_trigger();
  clock(200);
  dut_.estop_ni = 0;
  clock(10);
  EXPECT_EQ(status(), reg::kStatusEstopMask | reg::kStatusEstopPinMask);
  write(reg::kEstopOffset, reg::kEstopClearEstopMask);
  EXPECT_EQ(status(), reg::kStatusEstopMask | reg::kStatusEstopPinMask) << "refused while the pin is low";
  write_width(0, 50);  // refused as well
  dut_.estop_ni = 1;
  clock(10);
  write(reg::kEstopOffset, reg::kEstopClearEstopMask);
  EXPECT_EQ(status(), 0U);
  EXPECT_EQ(read_axis(reg::kWidthOffset, 1), 100) << "still readable";
  const auto before = rises();
  for (int tick = 0; tick < 3; ++tick) run_to_trigger();
  EXPECT_EQ(rises(), before);
  write_width(3, 100);
  EXPECT_EQ(status(), 0x0800U);
  run_to_trigger();
  run_to_trigger();
  EXPECT_EQ(rises(), before + 12);
}

TEST_F(PulseWidth, StopHasATimeAndTheInputsShowPerAxis) {
  dut_.home_i = 0x01, dut_.limit_pos_i = 0x02, dut_.limit_neg_i = 0x04;
  dut_.drive_alarm_i = 0x08, dut_.in_position_i = 0x30;
  clock(3);
  EXPECT_EQ(read(reg::kSwitchesOffset), 0x04'02'01U);
  EXPECT_EQ(read(reg::kDrivesOffset), 0x30'08U);
  clock(20);
  dut_.estop_ni = 0;
  clock();
  const std::uint32_t sampled = time_of(cycle_);
  clock(20);
  EXPECT_EQ(read_axis(reg::kFaultTimeOffset, 0), static_cast<std::int32_t>(sampled + 2)) << "seen by the second flop";
  EXPECT_EQ(faults(), reg::kFaultEstopMask);
  write(reg::kFaultOffset, reg::kFaultEstopMask);
  EXPECT_EQ(faults(), 0U) << "an edge, not the level";
}

}  // namespace
}  // namespace armature::test
