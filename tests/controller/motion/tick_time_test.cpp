// The ticks of the logic against the clock of the core.
#include "controller/motion/tick_time.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>

#include "tests/support/split_mix.hpp"

namespace armature {
namespace {

constexpr std::int64_t kTickLength = kTickCycles.value();

// A core that waits for each trigger.
class Core {
 public:
  // Ticks of this length, until one is wrong. Returns their number; none: none of them is.
  std::optional<int> first_wrong(std::int64_t length, int ticks) {
    for (int i = 0; i < ticks; ++i) {
      tick(length, 0);
      if (time.wrong()) return i + 1;
    }
    return std::nullopt;
  }

  // The trigger comes `length` after the one before, and the core wakes `late` after it.
  void tick(std::int64_t length, std::int64_t late, std::uint32_t missed = 0) {
    constexpr std::int64_t kWork = 800;
    trigger_ += length;
    const std::int64_t waits = woke_ + kWork, wakes = trigger_ + late;
    time.wake(Cycles{late == 0 ? waits : wakes}, Cycles{wakes});
    time.observe(missed);
    woke_ = wakes;
  }

  TickTime time;

 private:
  std::int64_t trigger_ = 0, woke_ = 0;
};

TEST(TickTime, ATickOfAnotherLengthIsWrongWithinTwoMeasurements) {
  for (const std::int64_t length : {kTickLength + 1024, kTickLength + 32, kTickLength + 20, kTickLength - 20,
                                    kTickLength - 64, kTickLength - 1024}) {
    Core core;
    core.time.start(Cycles{});
    EXPECT_EQ(core.first_wrong(kTickLength, 1'000), std::nullopt);
    EXPECT_LE(core.first_wrong(length, 1'000).value_or(1'000), 128) << length;
    EXPECT_FALSE(core.time.stood_still());
  }
}

TEST(TickTime, SmallDifferencesAreNotWrong) {
  for (const std::int64_t length : {kTickLength + 19, kTickLength - 19}) {
    Core core;
    EXPECT_EQ(core.first_wrong(length, 1'000), std::nullopt) << length;
  }
}

TEST(TickTime, ItIsRightAgainAfterAMeasurement) {
  Core core;
  ASSERT_TRUE(core.first_wrong(kTickLength + 100, 1'000));
  for (int i = 0; i < 128; ++i) core.tick(kTickLength, 0);
  EXPECT_FALSE(core.time.wrong());
}

// Late by up to a tick, with and without missed triggers.
TEST(TickTime, ALateCoreSeesNoWrongTick) {
  test::SplitMix random(11);
  Core core;
  for (int i = 0; i < 100'000; ++i) {
    const bool late = random.below(8) == 0, misses = late && random.below(2) == 0;
    const std::int64_t passed = misses ? 2 * kTickLength : kTickLength;
    core.tick(passed, late ? 1 + static_cast<std::int64_t>(random.below(2'000)) : 0, misses ? 1 : 0);
    ASSERT_FALSE(core.time.wrong() || core.time.stood_still()) << i;
  }
}

TEST(TickTime, AClockThatStoodStillIsNoTickOfAnotherLength) {
  Core core;
  for (int i = 0; i < 1'000; ++i) {
    const bool stands = i % 70 == 69;
    core.tick(stands ? 3 * kTickLength : kTickLength, 0);
    ASSERT_EQ(core.time.stood_still(), stands);
    ASSERT_FALSE(core.time.wrong());
  }
}

TEST(TickTime, WithoutAnUnderrunCounterOnlyTheWaitCounts) {
  TickTime time;
  time.wake(Cycles{0}, Cycles{kTickLength * 3 / 2});
  time.observe(std::nullopt);
  EXPECT_FALSE(time.stood_still());
  time.wake(Cycles{kTickLength * 3 / 2}, Cycles{kTickLength * 3 + 1});
  time.observe(std::nullopt);
  EXPECT_TRUE(time.stood_still());
}

}  // namespace
}  // namespace armature
