// Six coupled axes: the renewal of the mass matrix, and going back.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cosim/servo/servo_arm.hpp"
#include "tests/cosim/servo/servo_rig.hpp"

namespace armature::cosim {
namespace {

AxisSpec coupled_axis() {
  AxisSpec axis = test::plain_servo();
  axis.drive = {.natural_hz = 40, .damping = 1, .max_speed_rpm = 3000, .max_torque_nm = 1.27, .inertia_kg_m2 = 2e-4};
  axis.dynamics = DynamicsSpec{.rotor_inertia_kg_m2 = 3e-5,
                               .viscous_nm_s = 1e-4,
                               .coulomb_nm = 0.02,
                               .integral_ms = 20,
                               .smoothing_ms = 1,
                               .dynamic_brake_nm_s = 0.05,
                               .brake_nm = 1.5,
                               .stiffness_nm_rad = 15'000,
                               .gear_damping_nm_s = 5,
                               .backlash_deg = 0.01};
  return axis;
}

ArmModel six_links() {
  ArmModel model{.joints = 6, .links = {}, .gravity_m_s2 = {0, 0, -9.80665}};
  const double a[] = {0.05, 0.28, 0.035, 0, 0, 0}, d[] = {0.33, 0, 0, 0.3, 0, 0.08}, sine[] = {1, 0, 1, -1, 1, 0};
  for (std::size_t i = 0; i < kAxes; ++i) {
    const double mass = 6.0 - static_cast<double>(i);
    model.links[i] = {.a_m = a[i],
                      .d_m = d[i],
                      .sin_alpha = sine[i],
                      .cos_alpha = sine[i] == 0 ? 1.0 : 0.0,
                      .offset_rad = i == 1 ? 1.5707963 : 0.0,
                      .body = {mass, {-a[i] / 2, 0.01, -d[i] / 3}, {0.01 * mass, 0.01 * mass, 0.01 * mass, 0, 0, 0}}};
  }
  return model;
}

struct SixAxes {
  explicit SixAxes(int renewal)
      : arm{servo_numbers(make_per_axis([](std::size_t) { return coupled_axis(); }), test::kServoStep), six_links(),
            renewal} {}

  void step(int i) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      // To and fro with 120 deg/s and 660 deg/s^2, at 10000 counts a turn and 50 : 1.
      const double t = i * test::kServoStep, way = t < 0.18 ? t * t * 458'000 : 14'900 + (t - 0.18) * 166'667;
      const double counts = (axis % 2 == 0 ? 1 : -1) * way;
      error[axis] -= counts - reference[axis];
      reference[axis] = counts;
    }
    arm.step(kAll, reference, error, speed);
  }

  static constexpr std::uint8_t kAll = 0b111111;
  ServoArm arm;
  AxisNumbers reference, error, speed;
};

TEST(ServoArmCoupling, HardlyDependsOnTheRenewalOfTheMassMatrix) {
  SixAxes each{1}, tenth{10};
  double worst = 0, largest = 0;
  for (int i = 0; i < 100'000; ++i) {
    each.step(i);
    tenth.step(i);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      worst = std::max(worst, std::fabs(each.error[axis] - tenth.error[axis]));
      largest = std::max(largest, std::fabs(each.error[axis]));
    }
  }
  EXPECT_GT(largest, 1000);  // counts
  EXPECT_GT(worst, 0);
  EXPECT_LT(worst, 0.1);  // 0.025 seen
}

TEST(ServoArmCoupling, RepeatsTheSameBitsAfterGoingBack) {
  SixAxes arm{10};
  for (int i = 0; i < 5'003; ++i) arm.step(i);
  arm.arm.keep();
  const AxisNumbers reference = arm.reference, error = arm.error, speed = arm.speed;
  for (int i = 5'003; i < 5'050; ++i) arm.step(i);
  const AxisNumbers first = arm.error;
  arm.arm.take_back();
  arm.reference = reference;
  arm.error = error;
  arm.speed = speed;
  for (int i = 5'003; i < 5'050; ++i) arm.step(i);
  for (std::size_t axis = 0; axis < kAxes; ++axis) EXPECT_EQ(arm.error[axis], first[axis]) << axis;
}

TEST(ServoArmCoupling, MovesAHeldAxisByTheReactionOfAnother) {
  SixAxes arm{10};
  AxisNumbers reference, error, speed;
  for (int i = 0; i < 40'000; ++i) arm.arm.step(SixAxes::kAll, reference, error, speed);
  const double quiet = error[1];
  reference[2] += 2'000;
  error[2] -= 2'000;
  double moved = 0;
  for (int i = 0; i < 4'000; ++i) {
    arm.arm.step(SixAxes::kAll, reference, error, speed);
    moved = std::max(moved, std::fabs(error[1] - quiet));
  }
  EXPECT_GT(moved, 3);  // counts
}

}  // namespace
}  // namespace armature::cosim
