#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "cosim/plant/clock.hpp"
#include "cosim/plant/position_loop.hpp"

namespace armature::cosim {
namespace {

constexpr double kCountsPerRev = 10000.0;

// Independent model in SI units: classic Runge-Kutta with 20 sub-steps per step; limits on the derivative itself.
class RungeKutta {
 public:
  explicit RungeKutta(const DriveSpec& spec) : spec_{spec} {}

  double error = 0.0;  // [counts]
  double speed = 0.0;  // [counts/s]

  void step() {
    constexpr int kSubSteps = 20;
    const double h = kPlantStepSeconds / kSubSteps;
    for (int i = 0; i < kSubSteps; ++i) {
      const double v1 = speed, a1 = accel(error, v1);
      const double v2 = speed + 0.5 * h * a1, a2 = accel(error + 0.5 * h * v1, v2);
      const double v3 = speed + 0.5 * h * a2, a3 = accel(error + 0.5 * h * v2, v3);
      const double v4 = speed + h * a3, a4 = accel(error + h * v3, v4);
      error += h / 6.0 * (v1 + 2.0 * v2 + 2.0 * v3 + v4);
      speed += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
      if (limited) speed = std::clamp(speed, -max_speed(), max_speed());
    }
  }

  [[nodiscard]] double max_speed() const { return spec_.max_speed_rpm / 60.0 * kCountsPerRev; }
  [[nodiscard]] double max_accel() const {
    return spec_.max_torque_nm / spec_.inertia_kg_m2 / (2.0 * std::numbers::pi) * kCountsPerRev;
  }

  bool limited = false;

 private:
  [[nodiscard]] double accel(double x, double v) const {
    const double wn = 2.0 * std::numbers::pi * spec_.natural_hz;
    const double a = -wn * wn * x - 2.0 * spec_.damping * wn * v;
    return limited ? std::clamp(a, -max_accel(), max_accel()) : a;
  }

  DriveSpec spec_;
};

DriveSpec drive(double natural_hz, double damping) {
  DriveSpec spec;
  spec.natural_hz = natural_hz;
  spec.damping = damping;
  return spec;
}

struct Motor {
  explicit Motor(const DriveSpec& spec) : loop{spec, kCountsPerRev} {}
  void shift_reference(double counts) { shaft.error -= counts; }
  void step() { loop.step(shaft); }
  void brake() { loop.brake(shaft); }

  PositionLoop loop;
  Shaft shaft;
};

class PositionLoopResponse : public ::testing::TestWithParam<DriveSpec> {};

TEST_P(PositionLoopResponse, EqualsAFineIntegrationWhileNoLimitActs) {
  const DriveSpec spec = GetParam();
  Motor motor{spec};
  RungeKutta oracle{spec};
  for (int i = 0; i < 40'000; ++i) {
    if (i % 10'000 == 0) {
      const double jump = i % 20'000 == 0 ? 1.0 : -1.5;
      motor.shift_reference(jump);
      oracle.error -= jump;
    }
    motor.step();
    oracle.step();
    // The tail below 2^-20 counts is cut off.
    ASSERT_NEAR(motor.shaft.error, oracle.error, 1.1e-6) << "step " << i;
    if (!motor.shaft.at_rest()) {
      ASSERT_NEAR(motor.shaft.error, oracle.error, 1e-10) << "step " << i;
      ASSERT_NEAR(motor.shaft.speed / kPlantStepSeconds, oracle.speed, 1e-7) << "step " << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Drives, PositionLoopResponse,
                         ::testing::Values(drive(10, 1.0), drive(40, 0.3), drive(40, 0.7), drive(40, 1.0),
                                           drive(40, 1.5), drive(200, 1.0)));

TEST(PositionLoop, LagsARampByTwoZetaOverWn) {
  Motor motor{drive(40, 1.0)};
  for (int i = 0; i < 40'000; ++i) {
    motor.shift_reference(0.5);
    motor.step();
  }
  const double wn = 2.0 * std::numbers::pi * 40.0;
  const double speed = 0.5 / kPlantStepSeconds;
  EXPECT_NEAR(motor.shaft.speed, 0.5, 1e-6);
  // The reference is a staircase: at the end of a step it is half a stair behind the ramp through its corners.
  EXPECT_NEAR(-motor.shaft.error, 2.0 / wn * speed - 0.25, 1e-3);
}

TEST(PositionLoop, RespectsAndReachesTheTorqueAndTheSpeedLimit) {
  DriveSpec spec = drive(40, 1.0);
  spec.max_speed_rpm = 600.0;
  Motor motor{spec};
  RungeKutta oracle{spec};
  oracle.limited = true;
  const double max_accel = oracle.max_accel() * kPlantStepSeconds * kPlantStepSeconds;
  const double max_speed = oracle.max_speed() * kPlantStepSeconds;
  motor.shift_reference(4.0 * kCountsPerRev);
  oracle.error = -4.0 * kCountsPerRev;
  double fastest = 0.0, hardest = 0.0;
  for (int i = 0; i < 200'000; ++i) {
    const double before = motor.shaft.speed;
    motor.step();
    oracle.step();
    fastest = std::max(fastest, std::fabs(motor.shaft.speed));
    hardest = std::max(hardest, std::fabs(motor.shaft.speed - before));
    ASSERT_NEAR(motor.shaft.error, oracle.error, 2.0) << "step " << i;
  }
  EXPECT_DOUBLE_EQ(fastest, max_speed);
  EXPECT_NEAR(hardest, max_accel, 1e-12 * max_accel);
  EXPECT_TRUE(motor.shaft.at_rest());
}

TEST(PositionLoop, BrakesWithTheFullTorqueToAnExactStandstill) {
  const DriveSpec spec = drive(40, 1.0);
  Motor motor{spec};
  motor.shift_reference(5000.0);
  for (int i = 0; i < 500; ++i) motor.step();
  const double speed = motor.shaft.speed;
  const double from = motor.shaft.error;
  ASSERT_GT(speed, 0.1);
  const double max_accel = RungeKutta{spec}.max_accel() * kPlantStepSeconds * kPlantStepSeconds;
  int steps = 0;
  for (; !motor.shaft.stands(); ++steps) {
    const double before = motor.shaft.speed;
    motor.brake();
    ASSERT_LE(before - motor.shaft.speed, max_accel * (1.0 + 1e-9));
    ASSERT_GE(motor.shaft.speed, 0.0);
  }
  EXPECT_NEAR(steps, speed / max_accel, 1.001);
  EXPECT_NEAR(motor.shaft.error - from, speed * speed / (2.0 * max_accel), max_accel);
  const double stood = motor.shaft.error;
  motor.brake();
  EXPECT_EQ(motor.shaft.error, stood);
}

TEST(PositionLoop, ComesToAnExactRest) {
  Motor motor{drive(40, 1.0)};
  motor.shift_reference(200.0);
  int steps = 0;
  while (!motor.shaft.at_rest() && steps < 100'000) motor.step(), ++steps;
  EXPECT_LT(steps, 30'000);  // 0.15 s
  EXPECT_EQ(motor.shaft.error, 0.0);
}

TEST(PositionLoop, RefusesParametersThatMakeNoMotor) {
  EXPECT_THROW((PositionLoop{drive(0, 1.0), kCountsPerRev}), std::invalid_argument);
  EXPECT_THROW((PositionLoop{drive(40, 0), kCountsPerRev}), std::invalid_argument);
  EXPECT_THROW((PositionLoop{drive(40'000, 1.0), kCountsPerRev}), std::invalid_argument);
}

}  // namespace
}  // namespace armature::cosim
