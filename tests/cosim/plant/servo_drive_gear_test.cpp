#include <gtest/gtest.h>

#include <stdexcept>

#include "cosim/plant/electronic_gear.hpp"
#include "cosim/time/random.hpp"

namespace armature::cosim {
namespace {

struct Ratio {
  std::int32_t counts;
  std::int32_t pulses;
};

class ElectronicGearRatio : public ::testing::TestWithParam<Ratio> {};

// reference = pulses * counts / pulses_per_rev: checked by whole * pulses_per_rev + remainder == pulses * counts.
TEST_P(ElectronicGearRatio, IsExactAfterEveryPulseOfARandomWalk) {
  const auto [counts, per_rev] = GetParam();
  constexpr std::uint64_t kSeed = 7;
  Random random{kSeed};
  ElectronicGear gear{counts, per_rev};
  std::int64_t sum = 0;
  int direction = 1;
  for (int i = 0; i < 200'000; ++i) {
    if (random.chance(0.001)) direction = -direction;
    gear.pulses(direction);
    sum += direction;
    ASSERT_EQ(gear.whole() * per_rev + gear.remainder(), sum * counts) << "seed " << kSeed << ", pulse " << i;
    ASSERT_GE(gear.remainder(), 0);
    ASSERT_LT(gear.remainder(), per_rev);
  }
}

INSTANTIATE_TEST_SUITE_P(Ratios, ElectronicGearRatio,
                         ::testing::Values(Ratio{10000, 10000}, Ratio{131072, 10000}, Ratio{10000, 131072},
                                           Ratio{10000, 9999}, Ratio{4, 3}, Ratio{2'000'000'000, 7}));

TEST(ElectronicGear, IsExactBeyondThirtyTwoBits) {
  ElectronicGear gear{2'000'000'000, 3};
  for (int i = 0; i < 10; ++i) gear.pulses(+1);
  EXPECT_EQ(gear.whole(), 6'666'666'666);
  EXPECT_EQ(gear.remainder(), 2);
}

TEST(ElectronicGear, StartsOverAtAGivenCount) {
  ElectronicGear gear{4, 3};
  gear.pulses(-1);
  gear.set(-12);
  EXPECT_EQ(gear.whole(), -12);
  EXPECT_EQ(gear.fraction(), 0.0);
}

TEST(ElectronicGear, RefusesARatioThatIsNotPositive) {
  EXPECT_THROW((ElectronicGear{0, 1}), std::invalid_argument);
  EXPECT_THROW((ElectronicGear{1, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace armature::cosim
