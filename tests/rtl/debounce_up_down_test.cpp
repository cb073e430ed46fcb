// debounce in up/down mode: bounded delay under chatter, and the same answer as a saturating counter a line.
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "tests/rtl/debounce_fixture.hpp"
#include "tests/support/split_mix.hpp"

namespace armature::test {
namespace {

// One line as the textbook has it: a counter from 0 to `depth` that goes up at 1 and down at 0, and an output that
// moves at its ends only.
class SaturatingCounter {
 public:
  SaturatingCounter(int depth, bool level) : level_(level), depth_(depth), count_(level ? depth : 0) {}

  void sample(bool in) {
    count_ = std::clamp(count_ + (in ? 1 : -1), 0, depth_);
    if (count_ == 0) level_ = false;
    if (count_ == depth_) level_ = true;
  }

  [[nodiscard]] bool level() const { return level_; }
  [[nodiscard]] bool at_rest() const { return count_ == (level_ ? depth_ : 0); }

 private:
  bool level_;
  int depth_, count_;
};

struct DebounceUpDown : DebounceFixture {
  DebounceUpDown() : DebounceFixture{kUpDown} {}
};

TEST_F(DebounceUpDown, DelaysCleanLevelsByTheTimeAsTheOtherModeDoes) {
  for (int time = 0; time < 256; ++time) {
    dut_.time_i = static_cast<std::uint8_t>(time);
    settle(0);
    for (const std::uint32_t level : {kAllLines, 0U}) {
      EXPECT_EQ(hold(level, std::max(time, 1) - 1), 0);
      ASSERT_EQ(dut_.level_o, level ^ kAllLines) << "too early, time " << time;
      tick();
      ASSERT_EQ(dut_.level_o, level) << "too late, time " << time;
    }
  }
}

// `time` - 1 samples for the level, one against it, for ever: the restarting filter never sees `time` in a row.
TEST_F(DebounceUpDown, ChatterDelaysVosFilterWithoutBoundAndThisOneByTwiceItsSamples) {
  constexpr int kRounds = 2000;
  for (const int time : {4, 5, 10, 24, 100, 255}) {
    for (const int mode : {kRestart, kUpDown}) {
      dut_.mode_i = static_cast<std::uint8_t>(mode);
      dut_.time_i = static_cast<std::uint8_t>(time);
      settle(0);
      int accepted_after = 0;
      for (int cycle = 1; cycle <= kRounds * time && accepted_after == 0; ++cycle) {
        hold(cycle % time != 0, 1);
        if (dut_.level_o & 1U) accepted_after = cycle;
      }
      if (mode == kRestart) {
        EXPECT_EQ(accepted_after, 0) << "time " << time;
      } else {
        EXPECT_EQ(accepted_after, time + 2) << "one sample against the level came before its end";
      }
    }
  }
}

TEST_F(DebounceUpDown, EachSampleAgainstALevelDelaysItByTwoCyclesAtMost) {
  constexpr std::uint64_t kSeed = 41;
  SplitMix random(kSeed);
  int latest = 0;
  for (int run = 0; run < 400; ++run) {
    const int time = 1 + static_cast<int>(random.below(60));
    dut_.time_i = static_cast<std::uint8_t>(time);
    settle(0);
    const std::uint32_t rarity = 3 + random.below(10);  // one sample in `rarity` is against the level
    int against = 0;
    for (int cycle = 1; !(dut_.level_o & 1U); ++cycle) {
      const bool bad = random.below(rarity) == 0;
      against += bad;
      hold(bad ? 0 : 1, 1);
      ASSERT_LE(cycle, time + 2 * against) << "seed " << kSeed << " run " << run << " time " << time;
      latest = std::max(latest, cycle - time);
    }
  }
  EXPECT_GT(latest, 40) << "no run had much chatter";
}

TEST_F(DebounceUpDown, NoiseOnARestingLineMovesNothingAndCountsOneGlitchAVisit) {
  dut_.time_i = 10;
  settle(0);
  EXPECT_EQ(hold(1, 9), 0);
  EXPECT_EQ(hold(0, 8), 0) << "the count is still on its way back";
  EXPECT_EQ(hold(1, 4), 0);
  EXPECT_EQ(hold(0, 4), 0);
  EXPECT_EQ(hold(0, 1), 1) << "back at 0";
  EXPECT_EQ(hold(0, 20), 0);
  EXPECT_EQ(dut_.level_o, 0U);
}

TEST_F(DebounceUpDown, AdoptsTheMajorityLevelSilently) {
  dut_.time_i = 10;
  for (const std::uint32_t level : {0U, 1U, kAllLines, 0x2AAAAU}) {
    dut_.level_i = ~level & kAllLines;
    reset();
    tick(3);  // less than the time
    int needed = 0, against = 0;
    while (dut_.known_o != kAllLines) {
      ASSERT_LT(needed, 100);
      const bool bad = needed % 5 == 4;
      const std::uint32_t known = dut_.known_o;
      dut_.level_i = bad ? ~level & kAllLines : level;
      tick();
      ++needed;
      against += bad;
      EXPECT_EQ(dut_.glitch_o & ~known, 0U) << "an unknown line reports nothing";
    }
    EXPECT_EQ(dut_.level_o, level);
    EXPECT_GT(against, 1);
    EXPECT_LE(needed, 3 + 1 + 10 + 2 * against) << "back from the wrong candidate, the change, the time, the samples";
    hold(level, 30);
    EXPECT_EQ(dut_.level_o, level);
  }
}

TEST_F(DebounceUpDown, ModeChangeKeepsTheCountUnderWay) {
  dut_.time_i = 10;
  settle(0);
  hold(1, 6);
  dut_.mode_i = kRestart;
  hold(1, 3);
  EXPECT_EQ(dut_.level_o, 0U);
  hold(1, 1);
  EXPECT_EQ(dut_.level_o, 1U);
  hold(0, 6);
  dut_.mode_i = kUpDown;
  hold(1, 2);
  hold(0, 5);
  EXPECT_EQ(dut_.level_o, 1U);
  hold(0, 1);
  EXPECT_EQ(dut_.level_o, 0U);
}

TEST_F(DebounceUpDown, TreatsEveryLineAsASaturatingCounterDoes) {
  constexpr std::uint64_t kSeed = 12;
  SplitMix random(kSeed);
  for (int run = 0; run < 60; ++run) {
    const int time = static_cast<int>(run < 30 ? random.below(12) : random.below(256));
    dut_.time_i = static_cast<std::uint8_t>(time);
    settle(0);
    std::vector<SaturatingCounter> reference(kLines, SaturatingCounter(std::max(time, 1), false));
    std::array<bool, kLines> target{};
    int changes = 0;
    for (int cycle = 0; cycle < 3000; ++cycle) {
      std::uint32_t glitch = 0, level = 0;
      dut_.level_i = 0;
      for (std::size_t line = 0; line < kLines; ++line) {
        if (random.below(static_cast<std::uint32_t>(4 * time) + 2) == 0) target[line] = !target[line];
        const bool in = target[line] != (random.below(4) == 0);
        dut_.level_i |= static_cast<std::uint32_t>(in) << line;
        const bool before = reference[line].level(), counted = !reference[line].at_rest();
        reference[line].sample(in);
        changes += reference[line].level() != before;
        if (counted && reference[line].at_rest() && reference[line].level() == before) glitch |= 1U << line;
        if (reference[line].level()) level |= 1U << line;
      }
      tick();
      ASSERT_EQ(dut_.level_o, level) << "seed " << kSeed << " run " << run << " cycle " << cycle;
      ASSERT_EQ(dut_.glitch_o, glitch) << "seed " << kSeed << " run " << run << " cycle " << cycle;
    }
    EXPECT_GT(changes, 0) << "run " << run;
  }
}

}  // namespace
}  // namespace armature::test
