// encoder_core: positions, snapshots, errors and time stamps from the pins.
#include <algorithm>
#include <array>
#include <deque>

#include "Vencoder_core.h"
#include "Vencoder_core_wrap.h"
#include "tests/rtl/encoder_fixture.hpp"
#include "tests/support/split_mix.hpp"

namespace armature::test {
namespace {

using Encoder = EncoderFixture<Vencoder_core>;
using EncoderWrap = EncoderFixture<Vencoder_core_wrap>;

TEST_F(Encoder, AdoptsTheLevelsItFindsAfterResetSilently) {
  for (const int time : {0, 1, 5, 24, 255}) {
    set_debounce(time);
    for (int rest = 0; rest < 4; ++rest) {
      for (std::size_t i = 0; i < kAxes; ++i) discs_[i].position = rest + (i < 3 ? 0 : 1);
      restart();
      snapshot();
      for (std::size_t i = 0; i < kAxes; ++i) {
        EXPECT_EQ(position(i), 0);
        EXPECT_EQ(illegal_count(i), 0);
        EXPECT_EQ(glitch_count(i), 0);
      }
      EXPECT_EQ(dut_.index_seen_axes_o, 0) << "a line that rests high is no index";
      turn(1, 3, std::max(13, 2 * time));
      turn(4, -2, std::max(13, 2 * time));
      clock(time);
      snapshot();
      EXPECT_EQ(position(1), 3);
      EXPECT_EQ(position(4), -2);
      EXPECT_EQ(position(0), 0);
    }
  }
}

TEST_F(Encoder, AxisIsKnownOnceBothItsLinesHaveSettled) {
  clock(1);
  EXPECT_EQ(dut_.known_axes_o, kAllAxes);
  dut_.rst_ni = 0;
  clock(kResetCycles);
  dut_.rst_ni = 1;
  cycle_ = 0;
  for (int cycle = 0; cycle < 100; ++cycle) {  // A of axis 2 and B of axis 4 never rest
    noise_a_ ^= 1 << 1;
    noise_b_ ^= 1 << 3;
    noise_z_ ^= 1 << 5;  // the index does not matter
    clock();
    EXPECT_EQ(dut_.known_axes_o, cycle < kDebounce + 2 ? 0 : kAllAxes & ~(1 << 1 | 1 << 3)) << cycle;
  }
  snapshot();
  EXPECT_EQ(position(1), 0);
  EXPECT_EQ(position(3), 0);
  EXPECT_EQ(illegal_flags_, 0) << "nothing else tells of them";
  noise_a_ = noise_b_ = 0;
  clock(kDebounce + 4);
  EXPECT_EQ(dut_.known_axes_o, kAllAxes);
}

TEST_F(Encoder, CountsEachAxisOnItsOwn) {
  const int turns[] = {1, -2, 41, -163, 4000, -4001};
  for (std::size_t i = 0; i < kAxes; ++i) turn(i, turns[i]);
  snapshot();
  for (std::size_t i = 0; i < kAxes; ++i) EXPECT_EQ(position(i), turns[i]);
  EXPECT_EQ(illegal_flags_, 0);
}

// 12.5 cycles per count; the other axes slower, both ways. History: disc positions by sampling edge.
TEST_F(Encoder, SnapshotsAreCoherentAtFourMegacountsPerSecond) {
  struct Sample {
    std::array<std::int64_t, kAxes> position;
    std::array<std::int64_t, kAxes> changed;  // edge that first sampled this position
  };
  for (const int time : {0, 1, 5, 10}) {
    set_debounce(time);
    restart();
    Sample now{start_, {}};
    std::deque<Sample> sampled;
    const int half_cycles_per_count[] = {25, 25, 27, 50, 101, 5000};
    // The position follows the sampling edge by debounce time + 2 edges; the snapshot is the state before its own.
    const int path = std::max(time, 1) + 2;
    const auto depth = static_cast<std::size_t>(path + 2);
    const std::int64_t offset = cycle_;
    int in_trigger_cycle = 0;
    for (int cycle = 1; cycle < 60000; ++cycle) {
      for (std::size_t i = 0; i < kAxes; ++i) {
        const int counts = 2 * cycle / half_cycles_per_count[i];
        discs_[i].position = start_[i] + (i % 2 == 0 ? counts : -counts);
        if (discs_[i].position != now.position[i]) now.changed[i] = offset + cycle;
        now.position[i] = discs_[i].position;
      }
      sampled.push_back(now);
      if (sampled.size() > depth) sampled.pop_front();
      if (cycle % 97 != 0 || sampled.size() < depth) {
        clock();
        continue;
      }
      snapshot();
      for (std::size_t i = 0; i < kAxes; ++i) {
        const Sample& shown = sampled.front();
        ASSERT_EQ(position(i), shown.position[i] - start_[i]) << "axis " << i + 1 << " cycle " << cycle;
        const std::int64_t edge_time = shown.changed[i] == 0 ? 0 : shown.changed[i] + path - 1;
        ASSERT_EQ(dut_.edge_time_cycles_o[i], edge_time) << "axis " << i + 1 << " cycle " << cycle;
        in_trigger_cycle += sampled[1].position[i] != shown.position[i];
      }
    }
    EXPECT_GT(in_trigger_cycle, 0) << "no count fell on the clock edge of a trigger";
    for (std::size_t i = 0; i < kAxes; ++i) EXPECT_EQ(illegal_count(i), 0);
  }
}

// 12.5 cycles per count and slower, both ways. Each edge of each line is sampled up to a clock late, at random.
TEST_F(Encoder, ASynchroniserThatIsAClockLateCostsNoCount) {
  SplitMix random(11);
  for (const int time : {0, 1, 5, 11}) {
    set_debounce(time);
    restart();
    start_jitter(random.next());
    const int half_cycles_per_count[] = {25, 25, 27, 50, 101, 5000};
    for (int cycle = 1; cycle <= 60000; ++cycle) {
      for (std::size_t i = 0; i < kAxes; ++i) {
        const int counts = 2 * std::min(cycle, 60000 - cycle) / half_cycles_per_count[i];  // there and back
        discs_[i].position = start_[i] + (i % 2 == 0 ? counts : -counts);
      }
      clock();
      if (cycle == 30000) {
        clock(40);
        snapshot();
        for (std::size_t i = 0; i < kAxes; ++i) {
          EXPECT_EQ(position(i), discs_[i].position - start_[i]) << "time " << time << " axis " << i + 1;
        }
      }
    }
    clock(40);
    snapshot();
    for (std::size_t i = 0; i < kAxes; ++i) {
      EXPECT_EQ(position(i), 0) << "time " << time << " axis " << i + 1;
      EXPECT_EQ(illegal_count(i), 0);
      EXPECT_EQ(glitch_count(i), 0);
    }
  }
}

TEST_F(Encoder, SnapshotHoldsBetweenTriggers) {
  turn(0, 10);
  snapshot();
  const auto time = dut_.trigger_time_cycles_o;
  EXPECT_EQ(time, static_cast<std::uint32_t>(cycle_ - 1));
  turn(0, 10);
  EXPECT_EQ(position(0), 10);
  EXPECT_EQ(dut_.trigger_time_cycles_o, time);
  snapshot();
  EXPECT_EQ(position(0), 20);
}

TEST_F(Encoder, StampsTheLastCountedEdge) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    clock(static_cast<int>(3 * axis));
    discs_[axis].position += 1;
    clock();  // sampled by this edge
    const std::int64_t sampling_edge = cycle_;
    clock(40);
    snapshot();
    EXPECT_EQ(dut_.edge_time_cycles_o[axis], static_cast<std::uint32_t>(sampling_edge + debounce_ + 1));
  }
  const auto before = dut_.edge_time_cycles_o[0];
  noise_a_ = 1;  // neither a glitch nor an illegal transition is a counted edge
  clock(2);
  noise_a_ = 0;
  clock(20);
  discs_[0].position += 2;
  clock(20);
  snapshot();
  EXPECT_EQ(dut_.edge_time_cycles_o[0], before);
}

TEST_F(Encoder, BounceShorterThanTheFilterTimeIsCountedAsGlitchesOnly) {
  SplitMix random(3);
  std::array<int, kAxes> glitches{};
  for (int count = 0; count < 300; ++count) {
    const auto axis = random.below(kAxes);
    discs_[axis].position += count % 3 == 0 ? -1 : 1;
    clock(30);
    int& noisy_line = random.below(2) ? noise_a_ : noise_b_;
    const std::uint32_t bounces = random.below(4);
    for (std::uint32_t i = 0; i < bounces; ++i) {
      noisy_line = 1 << axis;
      clock(static_cast<int>(1 + random.below(kDebounce - 1)));
      noisy_line = 0;
      clock(static_cast<int>(1 + random.below(8)));
      ++glitches[axis];
    }
    clock(10);
  }
  snapshot();
  for (std::size_t i = 0; i < kAxes; ++i) {
    EXPECT_EQ(position(i), discs_[i].position - start_[i]);
    EXPECT_EQ(glitch_count(i), glitches[i]);
    EXPECT_EQ(illegal_count(i), 0);
  }
}

TEST_F(Encoder, GlitchesOnAllLinesOfAnAxisAreAddedAndSaturate) {
  set_debounce(2);
  for (int i = 0; i < 21847; ++i) {
    noise_a_ = noise_b_ = noise_z_ = 1 << 3;
    clock();
    noise_a_ = noise_b_ = noise_z_ = 0;
    clock();
    if (i == 100) {
      clock(5);
      EXPECT_EQ(glitch_count(3), 303);
    }
  }
  clock(5);
  EXPECT_EQ(glitch_count(3), 0xFFFF);
  EXPECT_EQ(glitch_count(2), 0);
  EXPECT_EQ(glitch_count(4), 0);
}

TEST_F(Encoder, IllegalTransitionIsCountedAndMovesNothing) {
  turn(2, 7);
  EXPECT_EQ(illegal_flags_, 0);
  const std::int64_t edge = cycle_ + 1;  // samples both changes
  discs_[2].position += 2;
  clock(20);
  EXPECT_EQ(illegal_flags_, 1 << 2);
  EXPECT_EQ(fault_time(0), static_cast<std::uint32_t>(edge + debounce_ + 1));
  discs_[5].position -= 2;
  clock(20);
  EXPECT_EQ(illegal_flags_, 1 << 2 | 1 << 5);
  EXPECT_EQ(fault_time(0), static_cast<std::uint32_t>(edge + debounce_ + 1)) << "the first event keeps its time";
  snapshot();
  EXPECT_EQ(position(2), 7);
  EXPECT_EQ(position(5), 0);
  EXPECT_EQ(illegal_count(2), 1);
  EXPECT_EQ(illegal_count(5), 1);

  illegal_flags_ = 0;  // software clears the flags
  clock(3);
  const std::int64_t next = cycle_ + 1;
  discs_[0].position += 2;
  clock(20);
  EXPECT_EQ(fault_time(0), static_cast<std::uint32_t>(next + debounce_ + 1));
}

TEST_F(Encoder, IllegalCountSaturates) {
  set_debounce(0);
  for (int i = 0; i < 0xFFFF + 5; ++i) {
    discs_[1].position += 2;
    clock();
  }
  clock(5);
  EXPECT_EQ(illegal_count(1), 0xFFFF);
  EXPECT_EQ(illegal_count(0), 0);
  EXPECT_EQ(illegal_count(2), 0);
}

TEST_F(EncoderWrap, PositionWrapsAtThirtyTwoBits) {
  // PositionReset of this model is 2^31 - 3; the index mark lies beyond the wrap.
  dut_.index_check_enable_i = kAllAxes;
  snapshot();
  EXPECT_EQ(position(0), 0x7FFF'FFFD);
  turn(0, 5);
  turn(1, 2);
  turn(2, 3);
  snapshot();
  EXPECT_EQ(static_cast<std::uint32_t>(position(0)), 0x8000'0002U);
  EXPECT_EQ(position(1), 0x7FFF'FFFF);
  EXPECT_EQ(static_cast<std::uint32_t>(position(2)), 0x8000'0000U);
  turn(0, -5);
  snapshot();
  EXPECT_EQ(position(0), 0x7FFF'FFFD);
  turn(0, -1);  // onto the mark, before the wrap
  turn(0, 40);  // onto the next one, beyond it
  EXPECT_EQ(dut_.index_seen_axes_o, 1);
  EXPECT_EQ(static_cast<std::uint32_t>(index_position(0)), 0x7FFF'FFFCU + 40U);
  EXPECT_EQ(index_flags_, 0);
}

}  // namespace
}  // namespace armature::test
