// encoder_core at its full speed of 4 Mcount/s (12.5 cycles a count): which filter times lose nothing, in both modes,
// on clean lines and on lines with bad samples. The table of rtl/encoder/README.md is what these tests measure.
#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

#include "Vencoder_core.h"
#include "tests/rtl/encoder_fixture.hpp"

namespace armature::test {
namespace {

constexpr int kRestart = 0, kUpDown = 1;  // filter_mode_i
constexpr int kLongestTime = 255;
constexpr int kCleanLine = -1;  // no bad sample

class EncoderFilter : public EncoderFixture<Vencoder_core> {
 protected:
  struct Outcome {
    bool counts, index;
  };

  // A run of all axes at 4 Mcount/s, axes 2, 4 and 6 backwards, axes 3 and 4 half a cycle later. In every level of the
  // line named, one sample is inverted: the one `bad_sample` cycles after the edge (never beyond the level).
  Outcome run(int mode, int time, char line, int bad_sample) {
    constexpr int kCounts = 120;
    dut_.filter_mode_i = static_cast<std::uint8_t>(mode);
    set_debounce(time);
    for (auto& disc : discs_) disc.position = 1;
    restart();
    bool index_right = true;
    std::array<int, kAxes> level_age{};
    std::array<bool, kAxes> level{};
    for (int cycle = 1; cycle <= 25 * kCounts / 2; ++cycle) {
      int noise = 0;
      for (std::size_t i = 0; i < kAxes; ++i) {
        const int counts = (2 * cycle + (i / 2 == 1 ? 1 : 0)) / 25;
        discs_[i].position = start_[i] + (i % 2 == 0 ? counts : -counts);
        const bool now = line == 'a' ? discs_[i].a() : line == 'b' ? discs_[i].b() : discs_[i].z();
        level_age[i] = now == level[i] ? level_age[i] + 1 : 0;
        level[i] = now;
        if (level_age[i] == bad_sample) noise |= 1 << i;
      }
      (line == 'a' ? noise_a_ : line == 'b' ? noise_b_ : noise_z_) = noise;
      clock();
      for (std::size_t i = 0; i < kAxes; ++i) index_right = index_right && !index_off(i);
    }
    noise_a_ = noise_b_ = noise_z_ = 0;
    clock(2 * time + 8);
    snapshot();
    Outcome outcome{true, index_right && dut_.index_seen_axes_o == kAllAxes};
    for (std::size_t i = 0; i < kAxes; ++i) {
      outcome.counts = outcome.counts && position(i) == discs_[i].position - start_[i] && illegal_count(i) == 0;
    }
    return outcome;
  }

  // The position latched at the index is not that of a mark of the disc.
  [[nodiscard]] bool index_off(std::size_t axis) const {
    return (dut_.index_seen_axes_o >> axis & 1) != 0 &&
           (start_[axis] + index_position(axis)) % discs_[axis].counts_per_rev != 0;
  }

  enum class Judge { kCounts, kIndex };

  // All times that lose nothing, wherever in a level the bad sample lies: 0 up to `worst_sample` cycles after its edge.
  std::string legal_times(int mode, char line, Judge judge, int worst_sample) {
    int first = -1, last = -1;
    for (int time = 0; time <= kLongestTime; ++time) {
      bool legal = true;
      for (int bad = std::min(worst_sample, 0); bad <= worst_sample && legal; ++bad) {
        const Outcome outcome = run(mode, time, line, bad);
        legal = judge == Judge::kIndex ? outcome.index : outcome.counts;
      }
      if (!legal) continue;
      if (first < 0)
        first = time;
      else
        EXPECT_EQ(last, time - 1) << "legal again, mode " << mode;
      last = time;
    }
    return std::to_string(first) + ".." + std::to_string(last);
  }
};

TEST_F(EncoderFilter, CleanLinesAllowTheSameTimesInBothModes) {
  for (const int mode : {kRestart, kUpDown}) {
    EXPECT_EQ(legal_times(mode, 'a', Judge::kCounts, kCleanLine), "0..25") << "mode " << mode;
    EXPECT_EQ(legal_times(mode, 'z', Judge::kIndex, kCleanLine), "0..12") << "mode " << mode;
  }
}

// A bad sample later than the middle of a level costs no more than one before it.
TEST_F(EncoderFilter, OneBadSampleALevelTakesHalfTheRangeOfVosFilterAndTwoCyclesOfTheOther) {
  for (const char line : {'a', 'b'}) {
    EXPECT_EQ(legal_times(kRestart, line, Judge::kCounts, 12), "2..11") << line;
    EXPECT_EQ(legal_times(kUpDown, line, Judge::kCounts, 12), "2..23") << line;
  }
  EXPECT_EQ(legal_times(kRestart, 'z', Judge::kIndex, 6), "2..6");
  EXPECT_EQ(legal_times(kUpDown, 'z', Judge::kIndex, 6), "2..10");
}

}  // namespace
}  // namespace armature::test
