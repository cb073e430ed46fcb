#include "controller/trajectory/plan/blend.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "controller/core/timebase.hpp"
#include "controller/trajectory/profile/synchronise.hpp"
#include "tests/controller/support/path_rig.hpp"

namespace armature {
namespace {

const PathLimits kLimits{.speed_mm_s = 500.0,
                         .accel_mm_s2 = 5'000.0,
                         .jerk_mm_s3 = 1e5,
                         .turn_speed_rad_s = 2.0,
                         .turn_accel_rad_s2 = 20.0,
                         .turn_jerk_rad_s3 = 500.0};

CartesianSegment straight(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                          ProfileKind kind = ProfileKind::kTrapezoid) {
  CartesianSegment segment;
  segment.path = line(from, to);
  const TimeLaw law = plan_time_law(kind, 1.0, law_limits(segment, kLimits, {}));
  segment.duration = whole_ticks(law.duration_s());
  segment.law = scale_in_time(law, static_cast<double>(segment.duration.value()) * kTickSeconds);
  return segment;
}

const Eigen::Vector3d kO = Eigen::Vector3d::Zero(), kX{100, 0, 0};

TEST(Blend, TheSharperTheCornerTheGentlerTheAcceleration) {
  for (const double theta : {0.0, 0.3, 1.0, std::numbers::pi / 3, std::numbers::pi / 2, 3.0, std::numbers::pi}) {
    const Eigen::Vector3d to = kX + 100.0 * Eigen::Vector3d{std::cos(theta), std::sin(theta), 0};
    const Easing easing_here = easing(straight(kO, kX), straight(kX, to), 5.0);
    EXPECT_NEAR(easing_here.accel, std::max(1.0, 2.0 * std::sin(0.5 * theta)), 1e-12) << theta;
    EXPECT_NEAR(easing_here.jerk, 2.0 * std::max(std::sin(0.5 * theta), std::cos(0.5 * theta)), 1e-12) << theta;
    EXPECT_EQ(easing_here.turn_accel, 1.0);
  }
}

// Turns about axes at an angle of theta to each other: alike their accelerations vanish in the corner, jerks add up.
TEST(Blend, TurnsAreEasedByTheAngleBetweenTheirAxes) {
  for (const double theta : {0.0, 0.3, 1.0, std::numbers::pi / 2, 3.0, std::numbers::pi}) {
    CartesianSegment first = straight(kO, kX), second = straight(kX, 2.0 * kX);
    const Eigen::Vector3d axis{std::cos(theta), std::sin(theta), 0};
    first.orientation = turn(Eigen::Matrix3d::Identity(), test::turned_by({}, 0.4, {1, 0, 0}).rotation);
    second.orientation =
        turn(first.orientation.end, Eigen::AngleAxisd{0.7, axis}.toRotationMatrix() * first.orientation.end);
    const Easing easing_here = easing(first, second, 5.0);
    EXPECT_NEAR(easing_here.turn_accel, std::max(1.0, 2.0 * std::sin(0.5 * theta)), 1e-12) << theta;
    EXPECT_NEAR(easing_here.turn_jerk, 2.0 * std::max(std::sin(0.5 * theta), std::cos(0.5 * theta)), 1e-12) << theta;
  }
}

TEST(Blend, AnExactStopNeedsNoCare) {
  const CartesianSegment a = straight(kO, kX), back = straight(kX, kO);
  CartesianSegment turning;
  turning.path = line(kX, kX);
  turning.orientation = turn(Eigen::Matrix3d::Identity(), test::turned_by({}, 1.0, {0, 0, 1}).rotation);
  EXPECT_EQ(easing(a, back, 0.0).accel, 1.0);
  EXPECT_EQ(easing(a, turning, 5.0).accel, 1.0);
  EXPECT_EQ(overlap(a, back, 0.0), Ticks{0});
  EXPECT_EQ(overlap(a, turning, 5.0), Ticks{0});
  EXPECT_EQ(overlap(turning, a, 5.0), Ticks{0});
}

TEST(Blend, OverlapsAsLongAsTheToleranceAllowsAndNoTickLonger) {
  for (const ProfileKind kind : {ProfileKind::kTrapezoid, ProfileKind::kSCurve}) {
    for (const double blend_mm : {1e-6, 0.1, 1.0, 5.0}) {
      const CartesianSegment a = straight(kO, kX, kind), b = straight(kX, {100, 300, 0}, kind);
      const std::int64_t ticks = overlap(a, b, blend_mm).value();
      const auto reach = [&](std::int64_t n) {
        const double t_s = static_cast<double>(n) * kTickSeconds;
        const double rest = 100.0 * (1.0 - position(a.law, a.law.duration_s() - t_s));
        return std::max(rest, 300.0 * position(b.law, t_s));
      };
      EXPECT_LE(reach(ticks), blend_mm * (1.0 + 1e-9) + 1e-12);
      EXPECT_GT(reach(ticks + 1), blend_mm);
    }
  }
}

TEST(Blend, ALargeToleranceEndsWithTheRampAndHalfOfTheDuration) {
  const CartesianSegment a = straight(kO, kX), b = straight(kX, {200, 0, 0}), stub = straight(kX, {101, 0, 0});
  EXPECT_NEAR(static_cast<double>(overlap(a, b, 1e6).value()) * kTickSeconds, 500.0 / 5'000.0, kTickSeconds);
  EXPECT_LE(overlap(a, stub, 1e6).value(), stub.duration.value() / 2);
  EXPECT_GE(overlap(a, stub, 1e6).value(), stub.duration.value() / 2 - 1);
}

TEST(Blend, AnArcLeavesRoomForItsCentripetalAcceleration) {
  CartesianSegment bend;
  for (const double r : {1.0, 10.0, 57.7, 100.0, 1'000.0}) {
    bend.path = arc({r, 0, 0}, {0, r, 0}, {-r, 0, 0}).value();
    const TimeLawLimits limits = law_limits(bend, kLimits, {});
    const double v = limits.speed * bend.path.length_mm, a = limits.accel * bend.path.length_mm;
    EXPECT_LE(v, kLimits.speed_mm_s * (1.0 + 1e-15));
    EXPECT_NEAR(std::hypot(a, v * v / r), kLimits.accel_mm_s2, 1e-9);
    EXPECT_GE(a, 0.4999 * kLimits.accel_mm_s2);
  }
}

TEST(Blend, TheSlowerOfMovingAndTurningDecides) {
  CartesianSegment both = straight(kO, kX);
  both.orientation.angle_rad = 2.0;
  const TimeLawLimits limits = law_limits(both, kLimits, {.turn_accel = 2.0});
  EXPECT_DOUBLE_EQ(limits.speed, 1.0);   // 2 rad/s over 2 rad; 500 mm/s over 100 mm
  EXPECT_DOUBLE_EQ(limits.accel, 5.0);   // 20 / 2 over 2; 5000 over 100
  EXPECT_DOUBLE_EQ(limits.jerk, 250.0);  // 500 over 2; 1e5 over 100
}

}  // namespace
}  // namespace armature
