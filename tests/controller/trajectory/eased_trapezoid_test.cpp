#include "controller/trajectory/profile/eased_trapezoid.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "controller/trajectory/profile/time_law.hpp"
#include "tests/controller/support/random.hpp"

namespace armature {
namespace {

constexpr std::uint64_t kEasedSeed = 71;

// Ends of up to a third of the distance 1, gentler than the ramps and within the speed limit.
EasedTrapezoid random_profile(test::Random& random, ProfileLimits& limits) {
  limits = {.speed = random.real(0.1, 5.0), .accel = random.real(0.5, 50.0)};
  const auto end = [&]() -> GentleEnd {
    const double accel = limits.accel / random.real(1.0, 2.0);
    const double longest_s = std::min(std::sqrt(2.0 / 3.0 / accel), limits.speed / accel);
    return {.accel = accel, .time_s = longest_s * random.real(0.0, 1.0)};
  };
  const GentleEnd first = end();
  return plan_eased(1.0, limits, first, end());
}

TEST(EasedTrapezoid, PositionIsTheIntegralOfSpeedAndSpeedThatOfAcceleration) {
  SCOPED_TRACE("seed " + std::to_string(kEasedSeed));
  test::Random random{kEasedSeed};
  for (int draw = 0; draw < 50; ++draw) {
    ProfileLimits limits;
    const EasedTrapezoid p = random_profile(random, limits);
    constexpr int kSteps = 2'000;
    const double dt = p.duration_s / kSteps;
    double covered = 0.0, speed = 0.0;
    for (int k = 0; k < kSteps; ++k) {
      const double middle_s = (k + 0.5) * dt;
      covered += velocity(p, middle_s) * dt;
      speed += acceleration(p, middle_s) * dt;
      ASSERT_NEAR(position(p, (k + 1) * dt), covered, 1e-5);
      ASSERT_NEAR(velocity(p, (k + 1) * dt), speed, 6.0 * limits.accel * dt);
      ASSERT_LE(velocity(p, middle_s), limits.speed * (1.0 + 1e-15));
      ASSERT_LE(std::fabs(acceleration(p, middle_s)), limits.accel);
    }
    EXPECT_EQ(position(p, p.duration_s), 1.0);
    EXPECT_EQ(velocity(p, p.duration_s), 0.0);
    EXPECT_EQ(acceleration(p, 0.5 * p.first.time_s), p.first.accel);
    EXPECT_EQ(acceleration(p, p.duration_s - 0.5 * p.last.time_s), -p.last.accel);
  }
}

TEST(EasedTrapezoid, TimesInvertPositionsFromBothEnds) {
  SCOPED_TRACE("seed " + std::to_string(kEasedSeed));
  test::Random random{kEasedSeed};
  for (int draw = 0; draw < 100; ++draw) {
    ProfileLimits limits;
    TimeLaw law;
    law.eased = true;
    law.eased_trapezoid = random_profile(random, limits);
    law = scale_in_time(law, law.duration_s() * random.real(1.0, 3.0));
    for (const double covered : {1e-9, 0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 0.999}) {
      EXPECT_NEAR(position(law, time_at(law, covered)), covered, 1e-12);
      EXPECT_NEAR(1.0 - position(law, law.duration_s() - time_before_end(law, covered)), covered, 1e-12);
    }
  }
}

TEST(EasedTrapezoid, WithoutGentleEndsItIsTheTrapezoid) {
  for (const double speed : {0.2, 1.0, 10.0}) {
    const ProfileLimits limits{.speed = speed, .accel = 4.0};
    const EasedTrapezoid p = plan_eased(1.0, limits, {}, {});
    const TrapezoidProfile plain = plan_profile(1.0, limits);
    EXPECT_NEAR(p.duration_s, plain.duration_s, 1e-14);
    for (double t_s = 0.0; t_s < p.duration_s; t_s += 0.01) EXPECT_NEAR(position(p, t_s), position(plain, t_s), 1e-13);
  }
}

}  // namespace
}  // namespace armature
