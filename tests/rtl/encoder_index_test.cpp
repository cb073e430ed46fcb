// encoder_core: index latch and the check that successive indexes are a whole revolution apart.
#include "Vencoder_core.h"
#include "tests/rtl/encoder_fixture.hpp"

namespace armature::test {
namespace {

class EncoderIndex : public EncoderFixture<Vencoder_core> {
 protected:
  EncoderIndex() { dut_.index_check_enable_i = kAllAxes; }
};

TEST_F(EncoderIndex, LatchesThePositionOfTheRisingEdgeIncludingItsOwnStep) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    EXPECT_EQ(dut_.index_seen_axes_o >> axis, 0);
    turn(axis, 38 + 5);  // from 1 past the mark at 40 to 44
    EXPECT_EQ(index_position(axis), 39);
    EXPECT_EQ(dut_.index_seen_axes_o >> axis & 1, 1);
  }
}

TEST_F(EncoderIndex, WholeRevolutionsBothWaysAndTurningBackAreFine) {
  turn(0, 400);
  EXPECT_EQ(index_position(0), 399);
  turn(0, -400);
  turn(0, -400);
  EXPECT_EQ(index_position(0), -1 - 10 * 40 + 40);
  for (int i = 0; i < 5; ++i) {  // swings over one mark
    turn(0, 60);
    turn(0, -60);
  }
  turn(0, 3 * 40);
  EXPECT_EQ(index_flags_, 0);
}

// The edges of the mark are those of A or B. Their synchronisers may sample them a clock apart.
TEST_F(EncoderIndex, ASynchroniserThatIsAClockLateChangesNoLatch) {
  SplitMix random(7);
  for (const int time : {0, 1, 5, 10}) {
    set_debounce(time);
    restart();
    start_jitter(random.next());
    for (int i = 0; i < 400; ++i) {
      const auto axis = random.below(kAxes);
      const std::int64_t before = start_[axis] + index_position(axis);
      const std::int64_t from = discs_[axis].position;
      turn(axis, static_cast<int>(random.below(120)) - 60);
      const std::int64_t mark = start_[axis] + index_position(axis);
      EXPECT_EQ(illegal_flags_ | index_flags_, 0) << "time " << time << " axis " << axis + 1;
      EXPECT_TRUE(mark == before || mark % 40 == 0) << "time " << time << " from " << from << ": " << mark;
      if (HasFailure()) return;
    }
    snapshot();
    for (std::size_t i = 0; i < kAxes; ++i) EXPECT_EQ(position(i), discs_[i].position - start_[i]);
  }
}

// The mark is one count wide: here 12 cycles each, as 40 counts take 500. A filter of up to 12 cycles lets them pass.
TEST_F(EncoderIndex, EveryMarkIsSeenAtFourMegacountsPerSecondUpToTwelveCyclesOfDebounce) {
  constexpr int kRevolutions = 20;
  for (int time = 1; time <= 13; ++time) {
    for (const int direction : {1, -1}) {
      for (auto& disc : discs_) disc.position = 1;
      set_debounce(time);
      restart();
      for (int cycle = 1; cycle < kRevolutions * 40 * 25 / 2 + 30; ++cycle) {
        discs_[2].position = start_[2] + direction * (2 * cycle / 25);
        clock();
      }
      clock(time + 4);
      EXPECT_EQ(illegal_flags_, 0);
      EXPECT_EQ(dut_.index_seen_axes_o >> 2 & 1, time <= 12) << "time " << time;
      if (time > 12) continue;
      EXPECT_EQ(index_flags_, 0) << "time " << time << " direction " << direction;
      EXPECT_EQ(glitch_count(2), 0);
      EXPECT_EQ(index_position(2), direction * kRevolutions * 40 - 1) << "time " << time;
    }
  }
}

TEST_F(EncoderIndex, CountsLostBetweenTwoMarksAreReported) {
  for (const int lost : {4, -4, 8, 20}) {
    restart();
    turn(3, 80);
    turn(4, 80);
    EXPECT_EQ(index_flags_, 0);
    discs_[3].position += lost;  // four counts are one line: the levels stay the same, nobody sees it
    std::int64_t edge = 0;
    for (int i = 0; i < 60 && index_flags_ == 0; ++i) {
      turn(3, 1);
      edge = cycle_;
    }
    turn(4, 60);
    EXPECT_EQ(index_flags_, 1 << 3) << "lost " << lost;
    // The turn() that met the mark took 13 + debounce + 4 cycles. Its first edge sampled the mark, debounce + 3 edges
    // later the index was latched, and the event was in the cycle after.
    const auto sampling_edge = edge - 13 - debounce_ - 4 + 1;
    EXPECT_EQ(fault_time(1), static_cast<std::uint32_t>(sampling_edge + debounce_ + 3));
    EXPECT_EQ(illegal_flags_, 0);
  }
}

TEST_F(EncoderIndex, TheFirstIndexIsComparedWithZero) {
  constexpr int kFirst = 1 << 1 | 1 << 2;
  dut_.index_check_first_i = kFirst;
  for (const int off : {0, 1, 4, -7, 20, 40}) {
    for (const int direction : {1, -1}) {
      for (auto& disc : discs_) disc.position = off;
      restart();
      for (const std::size_t axis : {0U, 1U, 2U}) turn(axis, 60 * direction);
      EXPECT_EQ(dut_.index_seen_axes_o, 0b111);
      EXPECT_EQ(index_flags_, off % 40 == 0 ? 0 : kFirst) << "off " << off << " direction " << direction;
    }
  }
}

TEST_F(EncoderIndex, MissingMarkIsReported) {
  turn(0, 79);
  for (auto& disc : discs_) disc.counts_per_rev = 80;  // every second mark is gone
  turn(0, 80);
  EXPECT_EQ(index_flags_, 1);
}

TEST_F(EncoderIndex, ChecksOnlyTheEnabledAxes) {
  dut_.index_check_enable_i = kAllAxes & ~(1 << 2);
  for (const std::size_t axis : {1U, 2U}) {
    turn(axis, 80);
    discs_[axis].position += 4;
    turn(axis, 80);
  }
  EXPECT_EQ(index_flags_, 1 << 1);
  EXPECT_EQ(dut_.index_seen_axes_o, 1 << 1 | 1 << 2);
}

TEST_F(EncoderIndex, UsesTheRevolutionOfTheAxis) {
  set_counts_per_rev(10000);
  dut_.counts_per_rev_value_i[0] = (dut_.counts_per_rev_value_i[0] & 0xFF00'0000U) | 4000;  // axis 1
  discs_[0].counts_per_rev = 4000;
  turn(0, 8001, 8);
  turn(1, 20001, 8);
  EXPECT_EQ(index_flags_, 0);
  EXPECT_EQ(index_position(0), 7999);
  EXPECT_EQ(index_position(1), 19999);
}

TEST_F(EncoderIndex, GlitchOnTheIndexLineIsNoIndex) {
  noise_z_ = kAllAxes;
  clock(kDebounce - 1);
  noise_z_ = 0;
  clock(20);
  EXPECT_EQ(dut_.index_seen_axes_o, 0);
  EXPECT_EQ(glitch_count(0), 1);
  noise_z_ = 1;
  clock(kDebounce);
  noise_z_ = 0;
  clock(20);
  EXPECT_EQ(dut_.index_seen_axes_o, 1);
}

}  // namespace
}  // namespace armature::test
