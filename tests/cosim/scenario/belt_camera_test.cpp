// When the samples of a camera arrive, and how wrong they are.
#include "cosim/belt/belt_camera.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace armature::cosim {
namespace {

TEST(CameraSamples, ArriveAtEachPeriodLateByTheDeadTime) {
  const CameraSamples samples{{.period_ms = 20, .dead_time_ms = 40.03, .noise_mm = 0}, 1};
  std::vector<std::int64_t> ticks;
  for (std::int64_t tick = 0; tick < 2'100; ++tick) {
    if (const auto sample = samples.arriving(tick)) {
      EXPECT_EQ(*sample, static_cast<std::int64_t>(ticks.size()));
      ticks.push_back(tick);
    }
  }
  EXPECT_EQ(ticks, (std::vector<std::int64_t>{801, 1'201, 1'601, 2'001}));
  EXPECT_NEAR(samples.dead_time_s(), 0.04005, 1e-12);
  EXPECT_EQ(samples.noise_mm(3), 0);
}

TEST(CameraSamples, DoNotArriveOfTheTimeInWhichTheTargetIsHidden) {
  const CameraSamples samples{{.period_ms = 20, .dead_time_ms = 40, .hidden_s = {0.1, 0.16}}, 1};
  std::vector<std::int64_t> numbers;
  for (std::int64_t tick = 0; tick < 5'000; ++tick) {
    if (const auto sample = samples.arriving(tick)) numbers.push_back(*sample);
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

}  // namespace
}  // namespace armature::cosim
