// Friction, gear and brakes against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "tests/cosim/servo/servo_rig.hpp"

namespace armature::cosim {
namespace {

using test::kServoStep;
using test::OneLink;
using test::plain_servo;
using test::ServoRig;

constexpr double kPartOfThousand = 1e-3;

// Mean frequency of the twist [rad/s] in so many seconds, by its zeros.
double twist_frequency(ServoRig& rig, double seconds) {
  const auto steps = static_cast<int>(seconds / kServoStep);
  double before = rig.arm.twist_rad(0);
  double first = -1, last = -1;
  int periods = -1;
  for (int i = 1; i <= steps; ++i) {
    rig.step(false);
    const double twist = rig.arm.twist_rad(0);
    if (before < 0 && twist >= 0) {
      last = i - twist / (twist - before);
      if (periods++ < 0) first = last;
    }
    before = twist;
  }
  return periods * test::kTwoPi / ((last - first) * kServoStep);
}

AxisSpec soft_gear() {
  AxisSpec axis = plain_servo();
  axis.dynamics->stiffness_nm_rad = 5'000;
  axis.dynamics->gear_damping_nm_s = 0;
  return axis;
}
constexpr OneLink kWheel{.inertia_kg_m2 = 0.3};

// A blow of the motor excites both masses.
void strike(ServoRig& rig) {
  rig.step();
  rig.move_command(3'000);
  rig.run(0.002);
}

TEST(ServoGear, OscillatesFreelyAtTheResonanceOfTwoMasses) {
  ServoRig rig{soft_gear(), kWheel};
  strike(rig);
  const double wanted = std::sqrt(5'000 * (1 / 0.5 + 1 / 0.3));
  EXPECT_NEAR(twist_frequency(rig, 0.5), wanted, kPartOfThousand * wanted);
}

TEST(ServoGear, OscillatesAtTheAntiResonanceBeforeALockedMotor) {
  AxisSpec axis = soft_gear();
  axis.dynamics->brake_nm = 1e6;
  ServoRig rig{axis, kWheel};
  strike(rig);
  const double wanted = std::sqrt(5'000 / 0.3);
  EXPECT_NEAR(twist_frequency(rig, 0.5), wanted, kPartOfThousand * wanted);
}

TEST(ServoGear, LosesItsPlayInAReversal) {
  AxisSpec axis = plain_servo();
  axis.drive.damping = 1;
  axis.dynamics->backlash_deg = 0.05;
  axis.dynamics->gear_damping_nm_s = 10;
  axis.dynamics->joint_viscous_nm_s = 5;
  ServoRig rig{axis, {.inertia_kg_m2 = 0.05}};
  constexpr double kSpeed = 20'000;  // counts/s
  rig.ramp(kSpeed, 1);
  const double forward = rig.arm.twist_rad(0), stood = rig.load_rad();
  rig.ramp(-kSpeed, 1);
  const double play = 0.05 * test::kTwoPi / 360;
  const double bent = 5 * kSpeed * rig.rad_per_count / 1e4;
  EXPECT_NEAR(forward - rig.arm.twist_rad(0), play + 2 * bent, kPartOfThousand * play);
  EXPECT_LT(rig.load_rad(), stood);
}

// In the gap the teeth do not touch: the load stands while the motor turns.
TEST(ServoGear, LeavesTheLoadWhereItIsWithinThePlay) {
  AxisSpec axis = plain_servo();
  axis.dynamics->backlash_deg = 0.1;
  ServoRig rig{axis, {.inertia_kg_m2 = 0.05}};
  rig.step();
  const double half_play_counts = 0.05 * test::kTwoPi / 360 / rig.rad_per_count;
  rig.ramp(0.9 * half_play_counts / 0.5, 0.5);
  rig.run(0.5);
  EXPECT_NEAR(rig.motor(), 0.9 * half_play_counts, 1);
  EXPECT_EQ(rig.arm.load_speed(0), 0);
  EXPECT_NEAR(rig.load_rad(), 0, 1e-12);
  rig.ramp(0.9 * half_play_counts / 0.5, 0.5);
  rig.run(0.01);
  EXPECT_GT(rig.load_rad(), 0.5 * half_play_counts * rig.rad_per_count);
}

// 20 N m on the joint are 0.4 N m at the motor, whose brake holds 1 N m. Afterwards all is as before.
TEST(ServoGear, IsTwistedByACollisionAndItsBrakeHolds) {
  AxisSpec axis = plain_servo();
  axis.dynamics->brake_nm = 1;
  axis.dynamics->gear_damping_nm_s = 10;
  ServoRig rig{axis, {.inertia_kg_m2 = 0.05}};
  rig.arm.push(0, 20);
  rig.run(1, false);
  EXPECT_EQ(rig.error[0], 0);
  EXPECT_NEAR(rig.arm.twist_rad(0), -20 / 1e4, kPartOfThousand * 20 / 1e4);
  rig.arm.push(0, 0);
  rig.run(1, false);
  EXPECT_NEAR(rig.arm.twist_rad(0), 0, 1e-9);
}

// Without damping a load that is pushed swings to twice the twist that it would have at rest.
TEST(ServoGear, SwingsToTwiceTheTwistOfACollision) {
  AxisSpec axis = soft_gear();
  axis.dynamics->brake_nm = 1e6;
  ServoRig rig{axis, kWheel};
  rig.step(false);
  rig.arm.push(0, 20);
  double most = 0;
  for (int i = 0; i < 20'000; ++i) {
    rig.step(false);
    most = std::max(most, -rig.arm.twist_rad(0));
  }
  EXPECT_NEAR(most, 2 * 20 / 5'000.0, kPartOfThousand * 2 * 20 / 5'000.0);
}

TEST(ServoMotor, StopsByCoulombFrictionAfterTheWayOfItsEnergy) {
  AxisSpec axis = plain_servo();
  axis.dynamics->coulomb_nm = 0.02;
  ServoRig rig{axis};
  rig.ramp(300'000, 1);
  const double speed = rig.motor_rad_s(), from = rig.motor_rad();
  const double decel = 0.02 * 50 / (2e-4 * 2500 + 1e-4);
  rig.run(speed / decel + 0.1, false);
  EXPECT_NEAR(rig.motor_rad() - from, speed * speed / (2 * decel), kPartOfThousand * speed * speed / (2 * decel));
  const double stands = rig.error[0];
  rig.run(0.1, false);
  EXPECT_EQ(rig.error[0], stands);  // friction holds, bit for bit
}

TEST(ServoMotor, SlowsDownWithTheTimeConstantOfItsDynamicBrake) {
  AxisSpec axis = plain_servo();
  axis.dynamics->dynamic_brake_nm_s = 0.01;
  ServoRig rig{axis};
  rig.ramp(300'000, 1);
  const double speed = rig.motor_rad_s();
  rig.run(0.03, false);
  const double wanted = std::exp(-0.03 * 0.01 * 2500 / (2e-4 * 2500 + 1e-4));
  EXPECT_NEAR(rig.motor_rad_s() / speed, wanted, kPartOfThousand);
}

TEST(ServoBrake, HoldsALoadBitForBit) {
  AxisSpec axis = plain_servo();
  axis.dynamics->brake_nm = 0.3;
  ServoRig rig{axis, {.inertia_kg_m2 = 1, .weight_nm = 10}};
  rig.run(1, false);
  EXPECT_EQ(rig.error[0], 0);
  EXPECT_EQ(rig.speed[0], 0);
  EXPECT_NEAR(rig.arm.twist_rad(0), 10 / 1e4, 1e-6);  // from the start: no oscillation
}

// 10 N m at the joint are 0.2 N m at the motor.
TEST(ServoBrake, SlipsWithTooSmallAShareOfItsTorqueAndHoldsAgain) {
  for (const bool slips : {false, true}) {
    AxisSpec axis = plain_servo();
    axis.dynamics->brake_nm = 0.3;
    ServoRig rig{axis, {.inertia_kg_m2 = 1, .weight_nm = 10}};
    rig.run(0.1, false);
    rig.arm.weaken_brake(0, slips ? 0.6 : 0.7);
    rig.run(0.1, false);
    EXPECT_EQ(rig.error[0] != 0, slips);
    rig.arm.weaken_brake(0, 1);
    rig.run(1, false);
    const double stands = rig.error[0];
    rig.run(0.1, false);
    EXPECT_EQ(rig.error[0], stands);
  }
}

// The plant makes steps while a shaft has a speed.
TEST(ServoBrake, AsksForStepsUntilItIsOpen) {
  AxisSpec axis = plain_servo();
  axis.dynamics->brake_nm = 1;
  axis.dynamics->brake_release_ms = 10;
  ServoRig rig{axis};
  for (int i = 0; i < 2'000; ++i) {
    rig.step();
    ASSERT_NE(rig.speed[0], 0) << i;
  }
  rig.step();
  EXPECT_FALSE(rig.arm.brake_engaged(0));
  EXPECT_EQ(rig.error[0], 0);
  EXPECT_EQ(rig.speed[0], 0);  // nothing pulls
}

TEST(ServoBrake, AsksForStepsUntilTheLoadRestsToo) {
  AxisSpec axis = soft_gear();
  axis.dynamics->brake_nm = 1e6;
  axis.dynamics->gear_damping_nm_s = 5;
  ServoRig rig{axis, kWheel};
  strike(rig);
  rig.run(0.1, false);
  const double stands = rig.error[0];
  EXPECT_NE(rig.speed[0], 0);
  EXPECT_GT(std::fabs(rig.arm.load_speed(0)), 1e-3);
  rig.run(3, false);
  EXPECT_EQ(rig.speed[0], 0);
  EXPECT_EQ(rig.error[0], stands);
  EXPECT_LT(std::fabs(rig.arm.load_speed(0)), 1e-6);
}

TEST(ServoBrake, SlipsAboveItsTorque) {
  AxisSpec axis = plain_servo();
  axis.dynamics->brake_nm = 0.18;  // 9 N m at the joint
  axis.dynamics->gear_damping_nm_s = 50;
  ServoRig rig{axis, {.inertia_kg_m2 = 1, .weight_nm = 10}};
  rig.run(0.1, false);
  const double speed = rig.motor_rad_s();
  rig.run(0.1, false);
  const double wanted = -(10.0 - 9.0) / (0.5 + 1);
  EXPECT_NEAR((rig.motor_rad_s() - speed) / 0.1, wanted, kPartOfThousand * std::fabs(wanted));
}

TEST(ServoBrake, EngagesAndReleasesAfterItsDelays) {
  AxisSpec axis = plain_servo();
  axis.dynamics->brake_nm = 1;
  axis.dynamics->brake_engage_ms = 20;
  axis.dynamics->brake_release_ms = 10;
  ServoRig rig{axis};
  EXPECT_TRUE(rig.arm.brake_engaged(0));
  for (int i = 0; i < 2'000; ++i) rig.step(true);
  EXPECT_TRUE(rig.arm.brake_engaged(0));
  rig.step(true);
  EXPECT_FALSE(rig.arm.brake_engaged(0));
  for (int i = 0; i < 4'000; ++i) rig.step(false);
  EXPECT_FALSE(rig.arm.brake_engaged(0));
  rig.step(false);
  EXPECT_TRUE(rig.arm.brake_engaged(0));
}

// Before the brake engages the load falls, against the dynamic brake only.
TEST(ServoBrake, LetsTheLoadSagDuringItsDelay) {
  AxisSpec axis = plain_servo();
  axis.dynamics = DynamicsSpec{.rotor_inertia_kg_m2 = 2e-4,
                               .current_hz = 1e6,
                               .integral_ms = 20,
                               .dynamic_brake_nm_s = 0.1,
                               .brake_nm = 1,
                               .brake_engage_ms = 200,
                               .stiffness_nm_rad = 1e4,
                               .gear_damping_nm_s = 20};
  ServoRig rig{axis, {.inertia_kg_m2 = 1, .weight_nm = 10}};
  rig.run(3);
  const double from = rig.motor_rad();
  rig.run(3, false);
  // torque / drag until it engages, after the time constant J / drag = 1.5 / 250 s
  const double speed = 10.0 / 250;
  EXPECT_NEAR(from - rig.motor_rad(), speed * (0.2 - 1.5 / 250), 0.01 * speed * 0.2);
  EXPECT_EQ(rig.speed[0], 0);
}

TEST(ServoNumbers, RefuseWhatTheStepCannotHold) {
  AxisSpec axis = plain_servo();
  axis.dynamics->stiffness_nm_rad = 1e7;
  EXPECT_THROW((ServoRig{axis}), std::invalid_argument);
  axis = plain_servo();
  axis.dynamics->stiffness_nm_rad = std::numeric_limits<double>::infinity();
  EXPECT_THROW((ServoRig{axis}), std::invalid_argument);
  axis = plain_servo();
  axis.dynamics->rotor_inertia_kg_m2 = 0;
  EXPECT_THROW((ServoRig{axis}), std::invalid_argument);
  axis = plain_servo();
  axis.drive.natural_hz = 20'000;
  EXPECT_THROW((ServoRig{axis}), std::invalid_argument);
}

}  // namespace
}  // namespace armature::cosim
