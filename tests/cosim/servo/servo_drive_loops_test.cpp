// The loops of the drive against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/cosim/servo/servo_rig.hpp"

namespace armature::cosim {
namespace {

using test::kServoStep;
using test::OneLink;
using test::plain_servo;
using test::ServoRig;

constexpr double kThousandth = 1e-3;
constexpr double kHalfCount = 0.5;  // what the position loop does not see

double lag_s(const AxisSpec& axis) {
  return 2 * axis.drive.damping / (test::kTwoPi * axis.drive.natural_hz);
}

TEST(ServoLoops, AnswerAStepAsASystemOfSecondOrder) {
  const AxisSpec axis = plain_servo();
  ServoRig rig{axis};
  constexpr double kCounts = 10'000;
  rig.step();
  rig.move_command(kCounts);
  const double wn = test::kTwoPi * axis.drive.natural_hz, zeta = axis.drive.damping;
  const double damped = wn * std::sqrt(1 - zeta * zeta);
  double worst = 0, highest = 0;
  for (int i = 1; i <= 40'000; ++i) {
    rig.step();
    const double t = i * kServoStep;
    const double wanted =
        1 - std::exp(-zeta * wn * t) * (std::cos(damped * t) + zeta * wn / damped * std::sin(damped * t));
    worst = std::max(worst, std::fabs(rig.motor() / kCounts - wanted));
    highest = std::max(highest, rig.motor() / kCounts);
  }
  EXPECT_LT(worst, kThousandth);
  EXPECT_NEAR(highest, 1 + std::exp(-zeta * wn / damped * std::numbers::pi), kThousandth);
}

TEST(ServoLoops, LagBehindARampByTwoZetaOverWn) {
  const AxisSpec axis = plain_servo();
  ServoRig rig{axis};
  constexpr double kSpeed = 200'000;  // counts/s
  rig.ramp(kSpeed, 1);
  EXPECT_NEAR(-rig.error[0], kSpeed * lag_s(axis) + kHalfCount, kThousandth * kSpeed * lag_s(axis));
}

TEST(ServoLoops, LagBehindARampByTheFilterAloneWithFullFeedForward) {
  AxisSpec axis = plain_servo();
  axis.dynamics->feed_forward = 1;
  axis.dynamics->smoothing_ms = 4;
  ServoRig rig{axis};
  constexpr double kSpeed = 200'000;
  rig.ramp(kSpeed, 1);
  EXPECT_NEAR(-rig.error[0], kSpeed * 4e-3, kThousandth * kSpeed * 4e-3 + kHalfCount);
}

TEST(ServoLoops, SmoothTheCommandWithTheTimeConstantOfTheFilter) {
  AxisSpec axis = plain_servo();
  axis.drive.natural_hz = 400;  // the loops follow at once
  axis.drive.damping = 1;
  axis.dynamics->smoothing_ms = 50;
  ServoRig rig{axis};
  rig.step();
  rig.move_command(100'000);
  rig.run(0.1);
  // Two time constants, less the lag of the loops, 2 / wn = 0.8 ms.
  EXPECT_NEAR(rig.motor() / 100'000, 1 - std::exp(-(0.1 - lag_s(axis)) / 0.05), kThousandth);
}

TEST(ServoLoops, AccelerateWithTheLimitOfTorqueUpToTheLimitOfSpeed) {
  AxisSpec axis = plain_servo();
  axis.drive.max_torque_nm = 0.1;
  axis.drive.max_speed_rpm = 600;
  axis.dynamics->gear_damping_nm_s = 20;  // the start makes the gear oscillate
  const OneLink link{.inertia_kg_m2 = 0.25};
  ServoRig rig{axis, link};
  rig.step();
  rig.move_command(1e7);
  rig.run(0.1);
  const double inertia = 2e-4 * 2500 + 0.25;
  EXPECT_NEAR(rig.motor_rad_s(), 0.1 * 50 / inertia * 0.1, kThousandth * 0.66);
  // The motor leads the load by the twist that accelerates it; the centre of both masses moves as a rigid body.
  const double centre = (0.5 * rig.motor_rad() + 0.25 * rig.load_rad()) / inertia;
  EXPECT_NEAR(centre, 0.1 * 50 / inertia * 0.1 * 0.1 / 2, kThousandth * 0.033);
  rig.run(1);
  const double max_rad_s = 600 / 60.0 * test::kTwoPi / 50;
  EXPECT_NEAR(rig.motor_rad_s(), max_rad_s, kThousandth * max_rad_s);
}

TEST(ServoLoops, GiveWayToALoadByTheStiffnessOfBothLoops) {
  AxisSpec axis = plain_servo();
  axis.dynamics->brake_nm = 10;
  ServoRig rig{axis, {.inertia_kg_m2 = 0.2, .weight_nm = 2}};
  rig.run(2);
  const double inertia = 2e-4 * 2500, wn = test::kTwoPi * 10;
  // torque = 2 zeta wn J x wn / (2 zeta) x error
  const double wanted = 2 / (inertia * wn * wn) / rig.rad_per_count;
  EXPECT_NEAR(-rig.error[0], wanted + kHalfCount, kThousandth * wanted);
}

TEST(ServoLoops, BringTheLoadBackWithAnIntegral) {
  AxisSpec axis = plain_servo();
  axis.dynamics->integral_ms = 50;
  ServoRig rig{axis, {.inertia_kg_m2 = 0.2, .weight_nm = 2}};
  rig.run(3);
  EXPECT_LT(std::fabs(rig.error[0]), kHalfCount + 0.01);
  EXPECT_NEAR(rig.arm.motor_torque(0), 2, 2 * kThousandth);
}

// Without anti-windup, the integral of a long acceleration would drive the axis far beyond its target.
TEST(ServoLoops, DoNotWindUpWhileTheTorqueIsLimited) {
  const auto overshoot = [](double integral_ms) {
    AxisSpec axis = plain_servo();
    axis.drive.damping = 1;
    axis.drive.max_torque_nm = 0.02;
    axis.dynamics->integral_ms = integral_ms;
    ServoRig rig{axis};
    rig.step();
    rig.move_command(2'000);
    double highest = 0;
    for (int i = 0; i < 400'000; ++i) {
      rig.step();
      highest = std::max(highest, rig.motor());
    }
    return highest / 2'000 - 1;
  };
  EXPECT_LT(overshoot(100), overshoot(0) + 0.2);
}

TEST(ServoLoops, FollowACurrentLoopOfFirstOrder) {
  AxisSpec axis = plain_servo();
  axis.drive.max_torque_nm = 0.1;
  axis.dynamics->current_hz = 100;
  ServoRig rig{axis};
  rig.move_command(1e6);
  const int steps = 400;
  for (int i = 0; i < steps; ++i) rig.step();
  EXPECT_NEAR(rig.arm.motor_torque(0) / 5, 1 - std::exp(-test::kTwoPi * 100 * steps * kServoStep), kThousandth);
}

}  // namespace
}  // namespace armature::cosim
