#include "controller/robot/axis_units.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/controller/support/random.hpp"

namespace armature {
namespace {

constexpr double kDeg = std::numbers::pi / 180.0;

AxisModel model(double gear_ratio, std::int32_t pulses_per_rev, std::int32_t counts_per_rev) {
  return {.gear_ratio = gear_ratio,
          .pulses_per_rev = pulses_per_rev,
          .counts_per_rev = counts_per_rev,
          .max_speed_rad_s = 120.0 * kDeg,
          .max_accel_rad_s2 = 600.0 * kDeg};
}

TEST(AxisUnits, APulseOfThePaperIs720Microdegrees) {
  const AxisUnits units{model(50.0, 10'000, 10'000)};
  EXPECT_DOUBLE_EQ(units.rad_per_pulse() / kDeg, 7.2e-4);
  EXPECT_EQ(units.to_pulses(Radians{80.4 * kDeg}), Pulses{111'667});
  EXPECT_EQ(units.to_pulses(Radians{-60.0 * kDeg}), Pulses{-83'333});
}

TEST(AxisUnits, ANegativeGearTurnsTheMotorTheOtherWay) {
  const AxisUnits units{model(-50.0, 10'000, 10'000)};
  EXPECT_EQ(units.to_pulses(Radians{36.0 * kDeg}), Pulses{-50'000});
  EXPECT_NEAR(units.to_radians(Counts{-50'000}).value(), 36.0 * kDeg, 1e-15);
  EXPECT_GT(units.pulses_per_count(), 0.0);
  EXPECT_GT(units.max_pulses_per_tick(), 0.0);
  EXPECT_GT(units.max_pulses_per_tick2(), 0.0);
}

TEST(AxisUnits, PulsesAndCountsMayDiffer) {
  const AxisUnits units{model(100.0, 5'000, 8'192)};
  EXPECT_DOUBLE_EQ(units.pulses_per_count(), 5'000.0 / 8'192.0);
  EXPECT_DOUBLE_EQ(units.to_exact_pulses(Counts{8'192}), 5'000.0);
  EXPECT_NEAR(units.to_radians(Counts{819'200}).value(), 2.0 * std::numbers::pi, 1e-14);
}

TEST(AxisUnits, CountsAndPulsesOfOneAngleAgree) {
  test::Random random{2};
  for (int i = 0; i < 10'000; ++i) {
    const double sign = random.integer(0, 1) == 0 ? -1.0 : 1.0;
    const auto per_rev = static_cast<std::int32_t>(random.integer(1, 200'000));
    const AxisUnits units{model(sign * random.real(1.0, 200.0), per_rev, per_rev)};
    const Counts counts{random.integer(-50'000'000, 50'000'000)};
    ASSERT_EQ(units.to_pulses(units.to_radians(counts)).value(), counts.value());
  }
}

TEST(AxisUnits, ThePulseGeneratorsLimitTheSpeedOfAFineDrive) {
  AxisModel fine = model(50.0, 131'072, 131'072);
  fine.max_speed_rad_s = 400.0 * kDeg;
  const AxisUnits units{fine};
  EXPECT_NEAR(units.max_speed_rad_s() / kDeg, 219.7265625, 1e-9);  // 4e6 / 131072 / 50 revolutions per second
  EXPECT_DOUBLE_EQ(units.max_pulses_per_tick(), 200.0);
}

TEST(AxisUnits, TheModelLimitsTheSpeedOfACoarseDrive) {
  const AxisUnits units{model(50.0, 10'000, 10'000)};
  EXPECT_DOUBLE_EQ(units.max_speed_rad_s(), 120.0 * kDeg);
  EXPECT_NEAR(units.max_pulses_per_tick(), 120.0 / 7.2e-4 * 50e-6, 1e-12);
  EXPECT_NEAR(units.max_pulses_per_tick2(), 600.0 / 7.2e-4 * 50e-6 * 50e-6, 1e-15);
}

}  // namespace
}  // namespace armature
