// When the samples of a camera arrive, how wrong they are, and what the controller gets of a belt.
#include "cosim/belt/belt_camera.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "controller/base/timebase.hpp"
#include "cosim/belt/measured_belt.hpp"

namespace armature::cosim {
namespace {

TEST(CameraSamples, ArriveAtEachPeriodLateByTheDeadTime) {
  const CameraSamples samples{{.period_ms = 20, .dead_time_ms = 40.03, .noise_mm = 0}, 1};
  std::vector<std::int64_t> ticks;
  for (std::int64_t tick = 0; tick < 2'100; ++tick) {
    if (const auto sample = samples.arriving(Ticks{tick})) {
      EXPECT_EQ(*sample, static_cast<std::int64_t>(ticks.size()));
      ticks.push_back(tick);
    }
  }
  EXPECT_EQ(ticks, (std::vector<std::int64_t>{801, 1'201, 1'601, 2'001}));
  EXPECT_EQ(samples.dead_time(), Ticks{801});
  EXPECT_EQ(samples.noise_mm(3), 0);
}

TEST(CameraSamples, DoNotArriveOfTheTimeInWhichTheTargetIsHidden) {
  const CameraSamples samples{{.period_ms = 20, .dead_time_ms = 40, .hidden_s = {0.1, 0.16}}, 1};
  std::vector<std::int64_t> numbers;
  for (std::int64_t tick = 0; tick < 5'000; ++tick) {
    if (const auto sample = samples.arriving(Ticks{tick})) numbers.push_back(*sample);
  }
  EXPECT_EQ(numbers, (std::vector<std::int64_t>{0, 1, 2, 3, 4, 8, 9, 10}));
}

TEST(CameraSamples, HaveAPeriodOfOneTickAtLeast) {
  EXPECT_EQ(to_camera({.period_ms = 0.001}).period, Ticks{1});
}

TEST(CameraSamples, HaveNoiseOfTheStandardDeviationWithoutABias) {
  constexpr int kSamples = 100'000;
  const CameraSamples samples{{.noise_mm = 0.3}, 4411};
  double sum = 0, squares = 0, neighbours = 0;
  int beyond_two = 0;
  for (int i = 0; i < kSamples; ++i) {
    const double mm = samples.noise_mm(i);
    sum += mm;
    squares += mm * mm;
    neighbours += mm * samples.noise_mm(i + 1);
    if (std::fabs(mm) > 0.6) ++beyond_two;
  }
  EXPECT_NEAR(sum / kSamples, 0, 0.004);
  EXPECT_NEAR(std::sqrt(squares / kSamples), 0.3, 0.003);
  EXPECT_NEAR(neighbours / squares, 0, 0.015);
  EXPECT_NEAR(beyond_two / static_cast<double>(kSamples), 0.0455, 0.004);  // of a normal distribution
}

TEST(CameraSamples, DependOnTheSeedAndTheNumberOnly) {
  const CameraSamples one{{}, 7}, same{{}, 7}, other{{}, 8};
  EXPECT_EQ(one.noise_mm(5), same.noise_mm(5));
  EXPECT_NE(one.noise_mm(5), one.noise_mm(6));
  EXPECT_NE(one.noise_mm(5), other.noise_mm(5));
}

TEST(MeasuredBelt, HasACountOfItsEncoderInEachTick) {
  const MeasuredBelt belt{{.mm_per_count = 0.01, .speed_mm_s = 100}, 1};
  for (const std::int64_t tick : {0, 1, 20'000}) {
    const auto sample = belt.sample(Ticks{tick}, seconds(Ticks{tick}));
    ASSERT_TRUE(sample);
    EXPECT_EQ(sample->taken, Ticks{tick});
    EXPECT_NEAR(static_cast<double>(sample->counts), static_cast<double>(tick) * kTickSeconds * 100 / 0.01, 1);
  }
}

TEST(MeasuredBelt, HasASampleOfItsCameraFromBeforeTheDeadTime) {
  ConveyorSpec spec{.mm_per_count = 0.01, .speed_mm_s = 100};
  spec.camera = BeltCameraSpec{.period_ms = 20, .dead_time_ms = 40, .noise_mm = 0};
  const MeasuredBelt belt{spec, 1};
  EXPECT_FALSE(belt.sample(Ticks{1'999}, seconds(Ticks{1'999})));
  const auto sample = belt.sample(Ticks{2'000}, seconds(Ticks{2'000}));
  ASSERT_TRUE(sample);
  EXPECT_EQ(sample->taken, Ticks{1'200});
  EXPECT_NEAR(static_cast<double>(sample->counts), 0.06 * 100 / 0.01, 1);
}

}  // namespace
}  // namespace armature::cosim
