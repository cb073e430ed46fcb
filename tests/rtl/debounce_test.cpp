// debounce in restart mode: the filter of Vo 2021, Figure 4, against a line-by-line reference.
#include <algorithm>
#include <array>
#include <cstdint>

#include "tests/rtl/debounce_fixture.hpp"
#include "tests/support/split_mix.hpp"

namespace armature::test {
namespace {

// One line on its own, counted in plain integers.
class Line {
 public:
  // Returns true for a change that did not last.
  bool sample(bool in, int time) {
    const int needed = std::max(time, 1);
    if (!known) {
      run_ = in == level ? run_ + 1 : 0;
      level = in;
      known = run_ >= needed;
      if (known) run_ = 0;
      return false;
    }
    const bool glitch = in == level && run_ > 0;
    run_ = in == level ? 0 : run_ + 1;
    if (run_ >= needed) {
      level = in;
      run_ = 0;
    }
    return glitch;
  }

  bool level = false;
  bool known = false;

 private:
  int run_ = 0;  // samples in favour of the change that is under way
};

struct Debounce : DebounceFixture {
  Debounce() : DebounceFixture{kRestart} {}
};

TEST_F(Debounce, AcceptsALevelThatIsStableForTheTime) {
  for (int time = 0; time < 256; ++time) {
    dut_.time_i = static_cast<std::uint8_t>(time);
    settle(0);
    for (const std::uint32_t level : {kAllLines, 0U}) {
      const int needed = std::max(time, 1);
      EXPECT_EQ(hold(level, needed - 1), 0);
      ASSERT_EQ(dut_.level_o, level ^ kAllLines) << "too early, time " << time;
      tick();
      ASSERT_EQ(dut_.level_o, level) << "too late, time " << time;
    }
  }
}

TEST_F(Debounce, KnowsALevelThatWasStableBeforeItWasValidAfterTheTime) {
  for (int time = 0; time < 256; ++time) {
    for (const std::uint32_t level : {kAllLines, 0U}) {
      dut_.time_i = static_cast<std::uint8_t>(time);
      dut_.valid_i = 0;
      dut_.level_i = level;
      reset();
      tick(3);
      dut_.valid_i = 1;
      const int needed = std::max(time, 1);
      EXPECT_EQ(hold(level, needed - 1), 0);
      ASSERT_EQ(dut_.known_o, 0U) << "too early, time " << time << ", level " << level;
      tick();
      ASSERT_EQ(dut_.known_o, kAllLines) << "too late, time " << time << ", level " << level;
      ASSERT_EQ(dut_.level_o, level);
    }
  }
}

TEST_F(Debounce, DropsAndCountsBounceShorterThanTheTime) {
  for (const int time : {2, 3, 5, 24, 255}) {
    dut_.time_i = static_cast<std::uint8_t>(time);
    settle(0);
    for (int width = 1; width <= time; ++width) {
      int glitches = hold(1, width);
      EXPECT_EQ(dut_.level_o, width == time ? 1U : 0U);
      glitches += hold(0, 2 * time);
      EXPECT_EQ(glitches, width < time ? 1 : 0) << "width " << width << " of " << time;
      EXPECT_EQ(dut_.level_o, 0U);
    }
  }
}

TEST_F(Debounce, ChatterRestartsTheCount) {
  dut_.time_i = 10;
  settle(0);
  int glitches = 0;
  for (int i = 0; i < 50; ++i) {
    glitches += hold(1, 9);
    glitches += hold(0, 1);
    ASSERT_EQ(dut_.level_o, 0U);
  }
  glitches += hold(1, 9);
  EXPECT_EQ(dut_.level_o, 0U);
  glitches += hold(1, 1);
  EXPECT_EQ(dut_.level_o, 1U);
  EXPECT_EQ(glitches, 50);
}

TEST_F(Debounce, LoweredTimeCountsAtOnce) {
  dut_.time_i = 200;
  settle(0);
  hold(1, 100);
  dut_.time_i = 20;
  tick();
  EXPECT_EQ(dut_.level_o, 1U);
}

TEST_F(Debounce, RaisedTimeIsWaitedForByALineThatCounts) {
  for (const int raised : {6, 20, 255}) {
    for (int run = 1; run < 5; ++run) {
      dut_.time_i = 5;
      settle(0);
      EXPECT_EQ(hold(1, run), 0);
      dut_.time_i = static_cast<std::uint8_t>(raised);
      EXPECT_EQ(hold(1, raised - run - 1), 0);
      ASSERT_EQ(dut_.level_o, 0U) << "too early, raised to " << raised << " after " << run;
      tick();
      ASSERT_EQ(dut_.level_o, 1U) << "too late, raised to " << raised << " after " << run;
    }
  }
}

TEST_F(Debounce, AdoptsTheFirstStableLevelSilently) {
  for (const std::uint32_t level : {0U, 1U, kAllLines, 0x2AAAAU}) {
    dut_.valid_i = 0;
    dut_.level_i = ~level & kAllLines;  // what a synchroniser may hold after reset
    reset();
    tick(2);
    EXPECT_EQ(dut_.known_o, 0U);
    dut_.valid_i = 1;
    for (int i = 0; i < 20; ++i) {  // still bouncing
      dut_.level_i = i % 3 == 0 ? ~level & kAllLines : level;
      tick();
      EXPECT_EQ(dut_.known_o, 0U);
      EXPECT_EQ(dut_.glitch_o, 0U);
    }
    dut_.level_i = level;
    for (int i = 0; i < 10; ++i) {
      tick();
      EXPECT_EQ(dut_.glitch_o, 0U);
      EXPECT_EQ(dut_.level_o, level);
    }
    EXPECT_EQ(dut_.known_o, kAllLines);
  }
}

TEST_F(Debounce, TreatsEveryLineAsTheReferenceDoes) {
  constexpr std::uint64_t kSeed = 11;
  SplitMix random(kSeed);
  for (int run = 0; run < 40; ++run) {
    reset();
    std::array<Line, kLines> reference;
    const int time = static_cast<int>(run < 20 ? random.below(12) : random.below(256));
    dut_.time_i = static_cast<std::uint8_t>(time);
    const std::uint32_t restlessness = 2 + random.below(static_cast<std::uint32_t>(2 * time) + 2);
    for (int cycle = 0; cycle < 3000; ++cycle) {
      for (int line = 0; line < kLines; ++line) {
        if (random.below(restlessness) == 0) dut_.level_i ^= 1U << line;
      }
      tick();
      std::uint32_t level = 0, known = 0, glitch = 0;
      for (std::size_t line = 0; line < kLines; ++line) {
        if (reference[line].sample(dut_.level_i >> line & 1, time)) glitch |= 1U << line;
        if (reference[line].level) level |= 1U << line;
        if (reference[line].known) known |= 1U << line;
      }
      ASSERT_EQ(dut_.level_o, level) << "seed " << kSeed << " run " << run << " cycle " << cycle;
      ASSERT_EQ(dut_.known_o, known) << "seed " << kSeed << " run " << run << " cycle " << cycle;
      ASSERT_EQ(dut_.glitch_o, glitch) << "seed " << kSeed << " run " << run << " cycle " << cycle;
    }
  }
}

}  // namespace
}  // namespace armature::test
