#include "controller/trajectory/profile/trapezoid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/controller/support/profile_checks.hpp"
#include "tests/controller/support/random.hpp"
#include "tests/controller/support/reference_data.hpp"

namespace armature {
namespace {

TEST(Trapezoid, AgreesWithTheReferenceProfiles) {
  const auto reference = test::read_reference("profiles.json");
  ASSERT_EQ(reference["single"].size(), 51u);
  for (const auto& expected : reference["single"]) {
    SCOPED_TRACE(expected["kind"].get<std::string>() + " q=" + expected["q"].dump());
    const TrapezoidProfile profile = plan_profile(expected["q"], {.speed = expected["w"], .accel = expected["a"]});
    test::expect_profile(profile, expected["profile"]);
    test::expect_samples(profile, expected["samples"]);
  }
}

TEST(Trapezoid, NoDistanceTakesNoTime) {
  for (const double zero : {0.0, -0.0}) {
    const TrapezoidProfile profile = plan_profile(zero, {.speed = 120.0, .accel = 600.0});
    EXPECT_EQ(profile.shape, ProfileShape::kNone);
    EXPECT_EQ(profile.duration_s, 0.0);
    EXPECT_EQ(position(profile, 0.5), 0.0);
    EXPECT_EQ(velocity(profile, 0.5), 0.0);
    EXPECT_EQ(acceleration(profile, 0.0), 0.0);
  }
}

TEST(Trapezoid, JustReachingTheSpeedLimitIsATriangle) {
  const TrapezoidProfile profile = plan_profile(24.0, {.speed = 120.0, .accel = 600.0});  // q a = w^2
  EXPECT_EQ(profile.shape, ProfileShape::kTriangle);
  EXPECT_EQ(profile.peak_speed, 120.0);
}

TEST(Trapezoid, TimeAtInvertsPosition) {
  test::Random random{10};
  for (int i = 0; i < 10'000; ++i) {
    const double distance = random.real(-360.0, 360.0);
    const auto profile = plan_profile(distance, {.speed = random.real(1.0, 400.0), .accel = random.real(10.0, 5000.0)});
    const double covered = random.real(0.0, std::fabs(distance));
    ASSERT_NEAR(std::fabs(position(profile, time_at(profile, covered))), covered, 1e-13 * std::fabs(distance));
  }
  const auto profile = plan_profile(-50.0, {.speed = 120.0, .accel = 600.0});
  EXPECT_EQ(time_at(profile, 0.0), 0.0);
  EXPECT_EQ(time_at(profile, -1.0), 0.0);
  EXPECT_EQ(time_at(profile, 50.0), profile.duration_s);
  EXPECT_EQ(time_at(profile, 51.0), profile.duration_s);
}

TEST(Trapezoid, EndsExactlyAndStays) {
  test::Random random{3};
  for (int i = 0; i < 10'000; ++i) {
    const double distance = random.real(-360.0, 360.0);
    const auto profile = plan_profile(distance, {.speed = random.real(1.0, 400.0), .accel = random.real(10.0, 5000.0)});
    ASSERT_EQ(position(profile, 0.0), 0.0);
    ASSERT_EQ(position(profile, profile.duration_s), distance);
    ASSERT_EQ(position(profile, profile.duration_s + 1.0), distance);
    ASSERT_EQ(velocity(profile, profile.duration_s), 0.0);
  }
}

TEST(Trapezoid, VelocityAndAccelerationAreTheDerivativesOfPosition) {
  test::Random random{4};
  for (int i = 0; i < 2'000; ++i) {
    const auto profile = plan_profile(random.real(-90.0, 90.0),
                                      {.speed = random.real(10.0, 200.0), .accel = random.real(100.0, 1000.0)});
    const double h = profile.duration_s * 1e-4;
    const double t = random.real(h, profile.duration_s - h);
    const double jump = std::fmin(std::fabs(t - profile.accel_s), std::fabs(t - profile.duration_s + profile.accel_s));
    if (jump < 2.0 * h) continue;
    const double slope = (position(profile, t + h) - position(profile, t - h)) / (2.0 * h);
    const double bend = (velocity(profile, t + h) - velocity(profile, t - h)) / (2.0 * h);
    ASSERT_NEAR(slope, velocity(profile, t), 1e-7 * profile.peak_speed);
    ASSERT_NEAR(bend, acceleration(profile, t), 1e-7 * profile.accel);
  }
}

TEST(Trapezoid, PositionIsContinuousAtTheMiddle) {
  test::Random random{5};
  for (int i = 0; i < 10'000; ++i) {
    const double q = random.real(1e-6, 360.0);
    const double accel = random.real(10.0, 5000.0);
    const double shortest_s = 2.0 * std::sqrt(q / accel);
    const TrapezoidProfile profile = plan_with_accel(q, accel, shortest_s * random.real(1.0, 100.0));
    const double before = position(profile, 0.5 * profile.duration_s);
    const double after = position(profile, std::nextafter(0.5 * profile.duration_s, profile.duration_s));
    ASSERT_NEAR(before, after, 1e-13 * q);
  }
}

TEST(Trapezoid, KeepsItsDigitsForANanodegree) {
  // The print's eq. (13), (T a - sqrt(T^2 a^2 - 4 q a)) / 2, is wrong in the fifth digit here.
  const double q = 1e-9, accel = 600.0, duration_s = 0.87;
  const double printed =
      0.5 * (duration_s * accel - std::sqrt(duration_s * duration_s * accel * accel - 4 * q * accel));
  const double exact = 1.149425287358853e-09;  // 50 digits
  EXPECT_NEAR(plan_with_accel(q, accel, duration_s).peak_speed, exact, 1e-14 * exact);
  EXPECT_GT(std::fabs(printed - exact), 1e-6 * exact);
}

TEST(Trapezoid, TooShortATimeForTheAccelerationNeedsMore) {
  const TrapezoidProfile profile = plan_with_accel(10.0, 600.0, 0.1);
  EXPECT_EQ(profile.shape, ProfileShape::kTriangle);
  EXPECT_DOUBLE_EQ(profile.accel, 4.0 * 10.0 / 0.01);
  EXPECT_GT(profile.accel, 600.0);
}

}  // namespace
}  // namespace armature
