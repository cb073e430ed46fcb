#include "controller/activity/jog/velocity_change.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "controller/base/timebase.hpp"
#include "tests/controller/support/random.hpp"

namespace armature {
namespace {

using Twist = VelocityChange::Twist;
using Limits = VelocityChange::Limits;

// A velocity that changes as commanded, tick by tick, with the accelerations and jerks between its ticks.
class ChangingVelocity {
 public:
  explicit ChangingVelocity(const Eigen::Matrix<double, 6, 6>& jacobian) : jacobian_{jacobian} {
    change_.keep(Twist::Zero());
  }

  void command(const Twist& wanted, const Limits& limits) {
    if (!change_.plan(seconds(Ticks{ticks_}), velocity, of(accel), of(wanted - velocity), limits)) change_.keep(wanted);
    ticks_ = 0;
  }
  void tick() {
    const Twist next = change_.at(seconds(Ticks{++ticks_})), next_accel = (next - velocity) / kTickSeconds;
    jerk = (next_accel - accel) / kTickSeconds;
    accel = next_accel;
    velocity = next;
  }

  Twist velocity = Twist::Zero(), accel = Twist::Zero(), jerk = Twist::Zero();

 private:
  VelocityChange::Change of(const Twist& twist) const {
    const Twist rates = jacobian_ * twist;
    VelocityChange::Change change{.twist = twist};
    for (std::size_t axis = 0; axis < kAxes; ++axis) change.joints_rad_s[axis] = rates(static_cast<Eigen::Index>(axis));
    return change;
  }

  Eigen::Matrix<double, 6, 6> jacobian_;
  VelocityChange change_;
  std::int64_t ticks_ = 0;
};

Twist drawn(test::Random& random, double move, double turn) {
  Twist twist;
  for (Eigen::Index i = 0; i < 6; ++i) twist(i) = random.real(-1.0, 1.0) * (i < 3 ? move : turn);
  return twist;
}

Limits limits_of(double accel, double jerk, double joint_accel) {
  Limits limits{.accel_mm_s2 = accel,
                .turn_accel_rad_s2 = 0.01 * accel,
                .jerk_mm_s3 = jerk,
                .turn_jerk_rad_s3 = 0.01 * jerk,
                .tick_s = kTickSeconds};
  limits.joint_accel_rad_s2.fill(joint_accel);
  return limits;
}

TEST(VelocityChange, KeepsAccelerationAndJerkWheneverACommandComes) {
  test::Random random{909};
  for (int draw = 0; draw < 400; ++draw) {
    Eigen::Matrix<double, 6, 6> jacobian;
    for (Eigen::Index i = 0; i < 36; ++i) jacobian(i) = random.real(-1.0, 1.0) * (i < 18 ? 1e-3 : 1.0);
    const Limits limits = limits_of(random.real(200, 2'000), random.real(2'000, 50'000), random.real(1.0, 20.0));
    ChangingVelocity moving{jacobian};
    double accel = 0.0;
    Twist wanted = Twist::Zero();
    for (int change = 0; change < 12; ++change) {
      const bool turns = random.integer(0, 2) > 0, moves = random.integer(0, 2) > 0;
      wanted = change == 11 ? Twist{Twist::Zero()} : drawn(random, moves ? 200.0 : 0.0, turns ? 1.0 : 0.0);
      moving.command(wanted, limits);
      const std::int64_t ticks = change == 11 ? 200'000 : random.integer(1, 2'000);
      for (std::int64_t i = 0; i < ticks && (change < 11 || moving.velocity != wanted); ++i) {
        moving.tick();
        ASSERT_LE(moving.jerk.head<3>().norm(), limits.jerk_mm_s3 * (1 + 1e-6) + 1e-2) << "seed 909 draw " << draw;
        ASSERT_LE(moving.jerk.tail<3>().norm(), limits.turn_jerk_rad_s3 * (1 + 1e-6) + 1e-4)
            << "seed 909 draw " << draw;
        ASSERT_LE(moving.accel.head<3>().norm(), limits.accel_mm_s2 * (1 + 1e-9)) << "seed 909 draw " << draw;
        ASSERT_LE(moving.accel.tail<3>().norm(), limits.turn_accel_rad_s2 * (1 + 1e-9)) << "seed 909 draw " << draw;
        const double joint = (jacobian * moving.accel).cwiseAbs().maxCoeff();
        ASSERT_LE(joint, limits.joint_accel_rad_s2[0] * (1 + 1e-9)) << "seed 909 draw " << draw;
        accel = std::max(accel, moving.accel.head<3>().norm());
      }
    }
    ASSERT_EQ(moving.velocity, wanted) << "seed 909 draw " << draw;
    EXPECT_GT(accel, 0.0);
  }
}

TEST(VelocityChange, IsStraightAndAsFastAsTheLimitsAllowFromAConstantVelocity) {
  ChangingVelocity moving{Eigen::Matrix<double, 6, 6>::Zero()};
  Twist wanted = Twist::Zero();
  wanted.head<3>() = Eigen::Vector3d{60, 80, 0};
  moving.command(wanted, limits_of(500.0, 10'000.0, 1.0));
  int ticks = 0;
  for (; moving.velocity != wanted && ticks < 100'000; ++ticks) {
    moving.tick();
    EXPECT_LT(moving.velocity.head<3>().cross(wanted.head<3>()).norm(), 1e-9);
  }
  EXPECT_NEAR(ticks * kTickSeconds, 100.0 / 500.0 + 500.0 / 10'000.0, 2 * kTickSeconds);
}

// A velocity that rises as a joystick is pushed, in many small steps, keeps its acceleration.
TEST(VelocityChange, GoesOnWithItsAccelerationWhenTheCommandGoesFurther) {
  ChangingVelocity moving{Eigen::Matrix<double, 6, 6>::Zero()};
  Twist wanted = Twist::Zero();
  double accel = 0.0;
  for (int step = 1; step <= 50; ++step) {
    wanted(0) = 10.0 * step;
    wanted(1) = 0.1 * step * (step % 2);
    moving.command(wanted, limits_of(500.0, 10'000.0, 1.0));
    for (int i = 0; i < 400; ++i) moving.tick();
    if (step > 10) accel = std::max(accel, moving.accel(0));
  }
  EXPECT_GT(accel, 450.0);
  EXPECT_GT(moving.velocity(0), 400.0);
}

// Along one axis the velocity stays between what was commanded, also when a command comes with a far smaller jerk.
TEST(VelocityChange, NeverRunsBeyondTheCommandsWhateverTheirJerk) {
  test::Random random{910};
  for (int draw = 0; draw < 400; ++draw) {
    ChangingVelocity moving{Eigen::Matrix<double, 6, 6>::Zero()};
    double least = 0.0, most = 0.0;
    for (int change = 0; change < 8; ++change) {
      Twist wanted = Twist::Zero();
      wanted(2) = random.real(-100, 100);
      least = std::min(least, wanted(2));
      most = std::max(most, wanted(2));
      moving.command(wanted, limits_of(random.real(100, 2'000), std::pow(10.0, random.real(2.0, 5.0)), 1.0));
      for (std::int64_t i = random.integer(1, 3'000); i > 0; --i) {
        moving.tick();
        ASSERT_GE(moving.velocity(2), least - 0.05) << "seed 910 draw " << draw;
        ASSERT_LE(moving.velocity(2), most + 0.05) << "seed 910 draw " << draw;
      }
    }
  }
}

TEST(VelocityChange, HasNoPlanWhereNothingLimitsItOrAJointCannotFollow) {
  VelocityChange change;
  const VelocityChange::Change none{};
  EXPECT_FALSE(change.plan(0.0, Twist::Zero(), none, none, limits_of(500.0, 10'000.0, 1.0)));
  VelocityChange::Change way{.twist = Twist::Ones()};
  way.joints_rad_s[3] = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(change.plan(0.0, Twist::Zero(), none, way, limits_of(500.0, 10'000.0, 1.0)));
}

}  // namespace
}  // namespace armature
