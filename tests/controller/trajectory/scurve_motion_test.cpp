// S-curves in time: continuity, ends, symmetry, the inverse and other durations.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "controller/trajectory/profile/scurve.hpp"
#include "tests/controller/support/random.hpp"

namespace armature {
namespace {

SCurveProfile random_profile(test::Random& random) {
  const auto decades = [&](double least, double most) { return std::pow(10.0, random.real(least, most)); };
  const double distance = decades(-9.0, 6.0) * (random.integer(0, 1) == 0 ? 1.0 : -1.0);
  const double speed = decades(-4.0, 4.0), accel = decades(-3.0, 6.0), jerk = decades(-2.0, 8.0);
  return plan_scurve(distance, {.speed = speed, .accel = accel, .jerk = jerk});
}

TEST(ScurveMotion, StartsAndEndsExactlyAndStays) {
  test::Random random{211};
  for (int draw = 0; draw < 10'000; ++draw) {
    const SCurveProfile p = random_profile(random);
    const double distance = p.sign * p.distance;
    for (const double before : {-1.0, 0.0}) {
      ASSERT_EQ(position(p, before), 0.0);
      ASSERT_EQ(velocity(p, before), 0.0);
      ASSERT_EQ(acceleration(p, before), 0.0);
      ASSERT_EQ(jerk(p, before), p.sign * p.jerk);
    }
    for (const double after : {p.duration_s, 2.0 * p.duration_s}) {
      ASSERT_EQ(position(p, after), distance) << "seed 211 draw " << draw;
      ASSERT_EQ(velocity(p, after), 0.0);
      ASSERT_EQ(acceleration(p, after), 0.0);
      ASSERT_EQ(jerk(p, after), 0.0);
    }
    ASSERT_NEAR(position(p, std::nextafter(p.duration_s, 0.0)), distance, 1e-15 * p.distance);
  }
}

TEST(ScurveMotion, IsSymmetricInTime) {
  test::Random random{212};
  for (int draw = 0; draw < 20'000; ++draw) {
    const SCurveProfile p = random_profile(random);
    const double t = random.real(0.0, 0.5) * p.duration_s, mirrored = p.duration_s - t;
    const double rounding_s = 4e-16 * p.duration_s;
    ASSERT_NEAR(position(p, t) + position(p, mirrored), p.sign * p.distance, 2e-15 * p.distance) << "seed 212 " << draw;
    ASSERT_NEAR(velocity(p, t), velocity(p, mirrored), 1e-15 * p.peak_speed + rounding_s * p.peak_accel) << draw;
    ASSERT_NEAR(acceleration(p, t), -acceleration(p, mirrored), 1e-15 * p.peak_accel + rounding_s * p.jerk) << draw;
  }
}

TEST(ScurveMotion, AccelerationSpeedAndPositionAreContinuous) {
  test::Random random{213};
  for (int draw = 0; draw < 10'000; ++draw) {
    const SCurveProfile p = random_profile(random);
    const double ramp_s = 2.0 * p.jerk_s + p.hold_s;
    const double step_s = 1e-12 * p.duration_s;
    for (const double border : {p.jerk_s, p.jerk_s + p.hold_s, ramp_s, 0.5 * p.duration_s, ramp_s + p.cruise_s,
                                p.duration_s - p.jerk_s - p.hold_s, p.duration_s - p.jerk_s, p.duration_s}) {
      const double before = border - step_s, after = border + step_s;
      ASSERT_LE(std::fabs(acceleration(p, after) - acceleration(p, before)),
                2.1 * step_s * p.jerk + 1e-13 * p.peak_accel)
          << "seed 213 draw " << draw << " border " << border << " of " << p.duration_s;
      ASSERT_LE(std::fabs(velocity(p, after) - velocity(p, before)), 2.1 * step_s * p.peak_accel + 1e-13 * p.peak_speed)
          << "seed 213 draw " << draw << " border " << border << " of " << p.duration_s;
      ASSERT_LE(std::fabs(position(p, after) - position(p, before)), 2.1 * step_s * p.peak_speed + 1e-14 * p.distance)
          << "seed 213 draw " << draw << " border " << border << " of " << p.duration_s;
    }
  }
}

// What a drive would see: third differences of evenly spaced positions, each a mean of the jerk.
TEST(ScurveMotion, ThirdDifferencesOfThePositionStayBelowTheJerk) {
  test::Random random{214};
  for (int draw = 0; draw < 300; ++draw) {
    const SCurveProfile p = random_profile(random);
    const double h = p.duration_s / 300.0;
    const double rounding = 2e-15 * p.distance / (h * h * h);
    double most = 0.0;
    for (int i = -3; i <= 303; ++i) {
      const double t = i * h;
      const double third =
          position(p, t + 2.0 * h) - 3.0 * position(p, t + h) + 3.0 * position(p, t) - position(p, t - h);
      most = std::max(most, std::fabs(third) / (h * h * h));
    }
    ASSERT_LE(most, p.jerk * (1.0 + 1e-9) + rounding) << "seed 214 draw " << draw;
    if (p.jerk_s > 4.0 * h) {
      ASSERT_GE(most, p.jerk * (1.0 - 1e-9) - rounding) << "seed 214 draw " << draw;
    }
  }
}

TEST(ScurveMotion, TimeAtInvertsPosition) {
  test::Random random{215};
  for (int draw = 0; draw < 10'000; ++draw) {
    const SCurveProfile p = random_profile(random);
    for (const double share : {random.real(0.0, 1.0), random.real(0.0, 1e-3), 1.0 - random.real(0.0, 1e-3), 0.5}) {
      const double covered = share * p.distance;
      const double t = time_at(p, covered);
      ASSERT_NEAR(std::fabs(position(p, t)), covered, 4e-15 * p.distance)
          << "seed 215 draw " << draw << " share " << share;
    }
    // Near the start also relative to what is covered.
    const double little = 1e-12 * p.distance;
    ASSERT_NEAR(std::fabs(position(p, time_at(p, little))), little, 1e-14 * little) << "seed 215 draw " << draw;
    ASSERT_EQ(time_at(p, 0.0), 0.0);
    ASSERT_EQ(time_at(p, -1.0), 0.0);
    ASSERT_EQ(time_at(p, p.distance), p.duration_s);
    ASSERT_EQ(time_at(p, 2.0 * p.distance), p.duration_s);
  }
}

TEST(ScurveMotion, TimeAtInvertsPositionAtTheBordersOfPhases) {
  test::Random random{216};
  for (int draw = 0; draw < 5'000; ++draw) {
    const SCurveProfile p = random_profile(random);
    const double ramp_s = 2.0 * p.jerk_s + p.hold_s;
    for (const double border :
         {p.jerk_s, p.jerk_s + p.hold_s, ramp_s, 0.5 * p.duration_s, p.duration_s - ramp_s, p.duration_s - p.jerk_s}) {
      for (const double t : {border * (1.0 - 1e-9), border, border * (1.0 + 1e-9)}) {
        const double covered = std::fabs(position(p, t));
        // How far a rounding of the covered distance moves the time: most where the profile is slow.
        const double slack_s = 4e-15 * p.duration_s + 2e-15 * p.distance / std::fabs(velocity(p, t));
        ASSERT_NEAR(time_at(p, covered), t, slack_s) << "seed 216 draw " << draw;
      }
    }
  }
}

TEST(ScurveMotion, SlowedDownItIsTheSamePathInExactlyThatTime) {
  test::Random random{217};
  for (int draw = 0; draw < 10'000; ++draw) {
    const SCurveProfile p = random_profile(random);
    const double stretch = std::pow(10.0, random.real(0.0, 3.0));
    const SCurveProfile slow = scale_in_time(p, stretch * p.duration_s);
    ASSERT_EQ(slow.duration_s, stretch * p.duration_s);
    ASSERT_EQ(position(slow, slow.duration_s), p.sign * p.distance);
    ASSERT_LE(slow.peak_speed, p.peak_speed);
    ASSERT_LE(slow.peak_accel, p.peak_accel);
    ASSERT_LE(slow.jerk, p.jerk);
    const double t = random.real(0.0, 1.0) * p.duration_s;
    const double k = 1.0 / stretch;
    ASSERT_NEAR(position(slow, stretch * t), position(p, t), 4e-15 * p.distance) << "seed 217 draw " << draw;
    ASSERT_NEAR(velocity(slow, stretch * t), velocity(p, t) * k,
                1e-14 * k * (p.peak_speed + p.duration_s * p.peak_accel))
        << "seed 217 draw " << draw;
    ASSERT_NEAR(acceleration(slow, stretch * t), acceleration(p, t) * k * k,
                1e-14 * k * k * (p.peak_accel + p.duration_s * p.jerk))
        << "seed 217 draw " << draw;
    ASSERT_NEAR(slow.jerk, p.jerk * k * k * k, 1e-14 * p.jerk * k * k * k) << "seed 217 draw " << draw;
  }
}

TEST(ScurveMotion, StaysFiniteForTheSmallestAndForHugeDistances) {
  for (const double distance : {5e-324, 1e-320, 1e-300, 1e-100, 1e-12, 1e9, 1e100, 1e300}) {
    for (const double jerk_limit : {1e-3, 1.0, 1e9}) {
      const SCurveProfile p = plan_scurve(distance, {.speed = 2.0, .accel = 10.0, .jerk = jerk_limit});
      ASSERT_GT(p.duration_s, 0.0) << distance;
      for (const SCurveProfile& profile : {p, scale_in_time(p, p.duration_s + 50e-6)}) {
        EXPECT_EQ(position(profile, profile.duration_s), distance);
        for (const double share : {0.0, 1e-9, 0.1, 0.5, 0.9, 1.0}) {
          const double t = share * profile.duration_s;
          EXPECT_TRUE(std::isfinite(position(profile, t))) << distance << " " << share;
          EXPECT_TRUE(std::isfinite(velocity(profile, t))) << distance << " " << share;
          EXPECT_TRUE(std::isfinite(acceleration(profile, t))) << distance << " " << share;
          EXPECT_TRUE(std::isfinite(time_at(profile, share * distance))) << distance << " " << share;
        }
      }
    }
  }
}

}  // namespace
}  // namespace armature
