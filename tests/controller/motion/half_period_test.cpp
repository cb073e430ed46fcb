// Half periods against a generator that is stepped cycle by cycle.
#include "controller/motion/half_period.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace armature {
namespace {

constexpr std::int64_t kTick = 2'500;

// One tick of the generator as rtl/pulse_width describes it.
struct Reference {
  int pulses = 0;
  std::int64_t last_high = 0;  // of the last pulse, as far as the trigger lets it
  std::int64_t low_since = 0;  // its falling edge before the trigger

  explicit Reference(std::int64_t width) {
    bool step = false;
    std::int64_t left = width, rose = 0, fell = 0;
    for (std::int64_t at = 1; at < kTick; ++at) {
      if (--left > 0) continue;
      left = width;
      step = !step;
      if (step) {
        ++pulses;
        rose = at;
      } else {
        fell = at;
        last_high = at - rose;
      }
    }
    if (step) {
      fell = kTick;
      last_high = kTick - rose;
    }
    low_since = kTick - fell;
  }
};

std::vector<Reference> all_widths() {
  std::vector<Reference> of{Reference{kTick}};  // [0] is not used
  for (std::int64_t width = 1; width < kTick + 20; ++width) of.emplace_back(width);
  return of;
}

constexpr HalfPeriodLimits kDrive{.min_width = Cycles{5}, .min_high = Cycles{5}, .dir_hold = Cycles{25}};

std::int64_t count_of(const HalfPeriodTable& table, std::int64_t n) {
  return pulses_of_width(table.width(Pulses{n})).value();
}

TEST(HalfPeriod, EveryWidthEmitsWhatTheSteppedGeneratorEmits) {
  const std::vector<Reference> reference = all_widths();
  for (std::int64_t width = 1; width < kTick + 20; ++width) {
    const Reference& expected = reference[static_cast<std::size_t>(width)];
    ASSERT_EQ(pulses_of_width(Cycles{width}).value(), expected.pulses) << width;
    ASSERT_EQ(pulses_of_width(Cycles{-width}).value(), -expected.pulses) << width;
    if (width >= kTick) continue;
    ASSERT_EQ(tick_end(Cycles{width}).last_high.value(), expected.last_high) << width;
    ASSERT_EQ(tick_end(Cycles{width}).low_since.value(), expected.low_since) << width;
  }
  EXPECT_EQ(pulses_of_width(Cycles{0}), Pulses{0});
}

// By trying all widths: the nearest count, of two equally near ones the smaller.
void expect_nearest(const HalfPeriodTable& table, const HalfPeriodLimits& limits) {
  const std::vector<Reference> reference = all_widths();
  const std::int64_t shortest = std::max<std::int64_t>(limits.min_width.value(), 7);
  for (std::int64_t n = 0; n <= 200; ++n) {
    std::int64_t nearest = 0;
    for (std::int64_t width = shortest; width < kTick; ++width) {
      const Reference& tick = reference[static_cast<std::size_t>(width)];
      if (tick.last_high < limits.min_high.value() || tick.pulses > 200) continue;
      const std::int64_t off = std::abs(tick.pulses - n), best = std::abs(nearest - n);
      if (off < best || (off == best && tick.pulses < nearest)) nearest = tick.pulses;
    }
    const std::int64_t width = table.width(Pulses{n}).value();
    ASSERT_EQ(count_of(table, n), nearest) << n;
    ASSERT_EQ(table.width(Pulses{-n}).value(), -width) << n;
    if (width == 0) continue;
    const Reference& tick = reference[static_cast<std::size_t>(width)];
    EXPECT_GE(width, shortest) << n;
    EXPECT_GE(tick.last_high, limits.min_high.value()) << n;
    // Of the widths with this count none is more even, unless it would hold the axis up at a reversal.
    const auto unevenness = [&](std::int64_t w) { return std::abs(2.0 * static_cast<double>(nearest * w) - kTick); };
    const bool free = tick.low_since >= limits.dir_hold.value();
    for (std::int64_t other = shortest; other < kTick; ++other) {
      const Reference& its = reference[static_cast<std::size_t>(other)];
      if (its.pulses != nearest || its.last_high < limits.min_high.value()) continue;
      const bool its_free = its.low_since >= limits.dir_hold.value();
      EXPECT_TRUE(free || !its_free) << n << ' ' << other;
      if (free != its_free) continue;
      EXPECT_LE(unevenness(width), unevenness(other)) << n << ' ' << other;
    }
  }
}

TEST(HalfPeriod, TakesTheNearestCountOfAllAllowedWidths) {
  constexpr HalfPeriodTable of_paper{HalfPeriodLimits{}};
  constexpr HalfPeriodTable of_drive{kDrive};
  expect_nearest(of_paper, {});
  expect_nearest(of_drive, kDrive);
  const HalfPeriodLimits turning{.min_width = Cycles{25}, .min_high = Cycles{5}, .dir_hold = Cycles{25}};
  expect_nearest(HalfPeriodTable{turning}, turning);
}

struct Errors {
  int exact = 0;  // of the counts 1..200
  std::int64_t lowest = 0, highest = 0;
  int first = 0;  // the smallest count that does not exist
};

Errors errors_of(const HalfPeriodTable& table) {
  Errors errors;
  for (int n = 200; n >= 1; --n) {
    const std::int64_t error = count_of(table, n) - n;
    errors.exact += error == 0;
    errors.lowest = std::min(errors.lowest, error);
    errors.highest = std::max(errors.highest, error);
    if (error != 0) errors.first = n;
  }
  return errors;
}

TEST(HalfPeriod, SixtyFourCountsExistAndSixtyWithPulsesThatADriveAccepts) {
  const Errors paper = errors_of(HalfPeriodTable{HalfPeriodLimits{}});
  EXPECT_EQ(paper.exact, 64);
  EXPECT_EQ(paper.first, 41);
  EXPECT_EQ(paper.lowest, -21);  // 179 for 200
  EXPECT_EQ(paper.highest, 11);
  const Errors drive = errors_of(HalfPeriodTable{kDrive});
  EXPECT_EQ(drive.exact, 60);
  EXPECT_EQ(drive.first, 41);
  EXPECT_EQ(drive.lowest, -44);  // 156 for 200
  EXPECT_EQ(drive.highest, 10);
}

// Near 200 the faster neighbour would be 208 pulses a tick, more than 4 Mpps.
TEST(HalfPeriod, IsNeverFasterThanTheDriveMayBe) {
  const HalfPeriodTable table{HalfPeriodLimits{}};
  for (const std::int64_t n : {179, 190, 194, 200, 201, 1'000'000}) {
    EXPECT_EQ(table.width(Pulses{n}), Cycles{7}) << n;
    EXPECT_EQ(table.width(Pulses{-n}), Cycles{-7}) << n;
  }
  EXPECT_EQ(pulses_of_width(Cycles{6}), Pulses{208});
  EXPECT_EQ(HalfPeriodTable{kDrive}.width(Pulses{200}), Cycles{8});
}

// What a tick has too many or too few the next ones make good: nothing but the present tick's error is ever owed.
TEST(HalfPeriod, TheResidualCarriedOnStaysWithinHalfAGap) {
  const HalfPeriodTable table{kDrive};
  for (std::int64_t speed = 0; speed <= 156 * 100; ++speed) {
    std::int64_t residual = 0;
    for (std::int64_t tick = 1; tick <= 40; ++tick) {
      const std::int64_t wanted = speed * tick / 100 - speed * (tick - 1) / 100 + residual;
      residual = wanted - count_of(table, wanted);
      ASSERT_LE(std::abs(residual), 10) << "speed " << speed << " tick " << tick;
    }
  }
}

}  // namespace
}  // namespace armature
