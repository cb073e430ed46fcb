#include "controller/trajectory/profile/time_law.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/controller/support/random.hpp"

namespace armature {
namespace {

constexpr TimeLawLimits kLawLimits{.speed = 120.0, .accel = 600.0, .jerk = 9'000.0};

TEST(TimeLaw, IsTheTrapezoidOrTheScurveOfItsKind) {
  for (const double distance : {-50.0, -0.25, 0.0, 1e-6, 3.0, 200.0}) {
    const TimeLaw trapezoid = plan_time_law(ProfileKind::kTrapezoid, distance, kLawLimits);
    const TimeLaw scurve = plan_time_law(ProfileKind::kSCurve, distance, kLawLimits);
    const TrapezoidProfile expected_trapezoid = plan_profile(distance, {.speed = 120.0, .accel = 600.0});
    const SCurveProfile expected_scurve = plan_scurve(distance, {.speed = 120.0, .accel = 600.0, .jerk = 9'000.0});
    EXPECT_EQ(trapezoid.shape(), expected_trapezoid.shape);
    EXPECT_EQ(trapezoid.duration_s(), expected_trapezoid.duration_s);
    EXPECT_EQ(trapezoid.peak_speed(), expected_trapezoid.peak_speed);
    EXPECT_EQ(trapezoid.peak_accel(), expected_trapezoid.accel);
    EXPECT_EQ(scurve.shape(), expected_scurve.shape);
    EXPECT_EQ(scurve.duration_s(), expected_scurve.duration_s);
    EXPECT_EQ(scurve.peak_speed(), expected_scurve.peak_speed);
    EXPECT_EQ(scurve.peak_accel(), expected_scurve.peak_accel);
    for (int i = -1; i <= 41; ++i) {
      const double t = 0.05 * i;
      EXPECT_EQ(position(trapezoid, t), position(expected_trapezoid, t));
      EXPECT_EQ(velocity(trapezoid, t), velocity(expected_trapezoid, t));
      EXPECT_EQ(acceleration(trapezoid, t), acceleration(expected_trapezoid, t));
      EXPECT_EQ(time_at(trapezoid, 5.0 * i), time_at(expected_trapezoid, 5.0 * i));
      EXPECT_EQ(position(scurve, t), position(expected_scurve, t));
      EXPECT_EQ(velocity(scurve, t), velocity(expected_scurve, t));
      EXPECT_EQ(acceleration(scurve, t), acceleration(expected_scurve, t));
      EXPECT_EQ(time_at(scurve, 5.0 * i), time_at(expected_scurve, 5.0 * i));
    }
  }
}

TEST(TimeLaw, ATrapezoidNeedsNoJerk) {
  const TimeLaw law = plan_time_law(ProfileKind::kTrapezoid, 80.4, {.speed = 120.0, .accel = 600.0});
  EXPECT_DOUBLE_EQ(law.duration_s(), 0.87);
}

TEST(TimeLaw, AnScurveTakesLongerThanATrapezoidButHardlyWithALargeJerk) {
  for (const double distance : {0.01, 1.0, 40.0, 300.0}) {
    const double trapezoid_s = plan_time_law(ProfileKind::kTrapezoid, distance, kLawLimits).duration_s();
    EXPECT_GT(plan_time_law(ProfileKind::kSCurve, distance, kLawLimits).duration_s(), trapezoid_s);
    TimeLawLimits hard = kLawLimits;
    hard.jerk = 1e12;
    EXPECT_NEAR(plan_time_law(ProfileKind::kSCurve, distance, hard).duration_s(), trapezoid_s, 1e-8);
  }
}

TEST(TimeLaw, KeepsItsKindAndItsPathWhenSlowedDown) {
  test::Random random{221};
  for (const ProfileKind kind : {ProfileKind::kTrapezoid, ProfileKind::kSCurve}) {
    for (int draw = 0; draw < 1'000; ++draw) {
      const double distance = random.real(-300.0, 300.0);
      const TimeLaw law = plan_time_law(kind, distance, kLawLimits);
      const double stretch = random.real(1.0, 20.0);
      const TimeLaw slow = scale_in_time(law, stretch * law.duration_s());
      ASSERT_EQ(slow.kind, kind);
      ASSERT_EQ(slow.shape(), law.shape());
      ASSERT_EQ(slow.duration_s(), stretch * law.duration_s());
      ASSERT_NEAR(slow.peak_speed() * stretch, law.peak_speed(), 1e-13 * law.peak_speed());
      ASSERT_NEAR(slow.peak_accel() * stretch * stretch, law.peak_accel(), 1e-13 * law.peak_accel());
      const double t = random.real(0.0, law.duration_s());
      ASSERT_NEAR(position(slow, stretch * t), position(law, t), 1e-14 * std::fabs(distance)) << "seed 221 " << draw;
    }
    EXPECT_EQ(scale_in_time(plan_time_law(kind, 0.0, kLawLimits), 0.5).duration_s(), 0.5);
  }
}

}  // namespace
}  // namespace armature
