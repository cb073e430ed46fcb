// Joint moves between two states of motion, judged by sampling their laws, and by other planners where these apply.
#include "controller/trajectory/joint/joint_passage.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "controller/base/timebase.hpp"
#include "tests/controller/support/random.hpp"
#include "tests/controller/support/robots.hpp"

namespace armature {
namespace {

using test::kDeg;
using States = PerAxis<AxisState>;

RobotModel passage_robot() {
  RobotModel robot = test::paper_robot();
  for (AxisModel& axis : robot.axes) axis.max_jerk_rad_s3 = 6'000.0 * kDeg;
  robot.axes[2].max_accel_rad_s2 = 300.0 * kDeg;
  robot.axes[4].max_jerk_rad_s3 = 2'500.0 * kDeg;
  return robot;
}

States random_states(test::Random& random, const RobotModel& robot, bool in_motion) {
  return make_per_axis([&](std::size_t axis) {
    AxisState state{.position = random.real(-2, 2)};
    if (!in_motion) return state;
    state.velocity = random.real(-0.9, 0.9) * robot.axes[axis].max_speed_rad_s;
    // So small that the speed was and stays within its limit.
    state.accel = random.real(-0.25, 0.25) * robot.axes[axis].max_accel_rad_s2;
    return state;
  });
}

States reversed(const States& states) {
  return make_per_axis([&](std::size_t axis) {
    return AxisState{states[axis].position, -states[axis].velocity, states[axis].accel};
  });
}

PerAxis<Radians> positions(const States& states) {
  return make_per_axis([&](std::size_t axis) { return Radians{states[axis].position}; });
}

class JointPassageProperties : public testing::TestWithParam<ProfileKind> {
 protected:
  [[nodiscard]] RetargetPlan plan(const States& start, const States& end) const {
    return plan_passage(robot, start, end, 1.0, GetParam());
  }
  RobotModel robot = passage_robot();
};

TEST_P(JointPassageProperties, BeginsAndEndsInTheStatesAndKeepsTheLimits) {
  test::Random random{81};
  for (int draw = 0; draw < 400; ++draw) {
    const std::string what = "seed 81 draw " + std::to_string(draw);
    const States start = random_states(random, robot, draw % 2 == 1), end = random_states(random, robot, draw % 4 >= 2);
    const RetargetPlan passage = plan(start, end);
    const double whole_s = seconds(passage.duration);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const AxisModel& model = robot.axes[axis];
      const PhaseLaw& law = passage.laws[axis];
      ASSERT_NEAR(law.at(0.0).position, start[axis].position, 1e-12) << what;
      ASSERT_NEAR(law.at(0.0).velocity, start[axis].velocity, 1e-12) << what;
      const AxisState last = law.at(whole_s * (1 - 1e-13));
      ASSERT_NEAR(last.position, end[axis].position, 1e-11) << what;
      ASSERT_NEAR(last.velocity, end[axis].velocity, 1e-9) << what;
      ASSERT_NEAR(law.duration_s(), whole_s, 1e-11) << what;
      ASSERT_EQ(position(passage, whole_s)[axis].value(), end[axis].position) << what;
      const bool with_jerk = GetParam() == ProfileKind::kSCurve;
      if (with_jerk) {
        ASSERT_NEAR(last.accel, end[axis].accel, 1e-7) << what;
      }
      // The states themselves may only be left at the limits, so sampling finds what the phases do.
      AxisState before = law.at(0.0);
      constexpr int kSamples = 3'000;
      for (int i = 1; i < kSamples; ++i) {
        const AxisState now = law.at(whole_s * i / kSamples);
        const double step_s = whole_s / kSamples;
        ASSERT_LE(std::fabs(now.velocity), model.max_speed_rad_s * (1 + 1e-9)) << what << " axis " << axis;
        ASSERT_LE(std::fabs(now.accel), model.max_accel_rad_s2 * (1 + 1e-9)) << what << " axis " << axis;
        ASSERT_NEAR(now.position - before.position, 0.5 * (now.velocity + before.velocity) * step_s,
                    model.max_accel_rad_s2 * step_s * step_s)
            << what;
        if (with_jerk) {
          ASSERT_LE(std::fabs(now.accel - before.accel), model.max_jerk_rad_s3 * step_s * (1 + 1e-6)) << what;
        }
        before = now;
      }
    }
  }
}

// Where one end rests, plan_retarget() computes the optimum.
TEST_P(JointPassageProperties, TakesTheLeastTimeToAndFromRest) {
  test::Random random{82};
  for (int draw = 0; draw < 400; ++draw) {
    const States rest = random_states(random, robot, false), moving = random_states(random, robot, draw % 3 > 0);
    const std::int64_t to = plan_retarget(robot, moving, positions(rest), 1.0, GetParam()).duration.value();
    EXPECT_LE(std::llabs(plan(moving, rest).duration.value() - to), 1) << "seed 82 draw " << draw;
    // In reversed time.
    EXPECT_LE(std::llabs(plan(rest, reversed(moving)).duration.value() - to), 1) << "seed 82 draw " << draw;
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, JointPassageProperties, testing::Values(ProfileKind::kTrapezoid, ProfileKind::kSCurve),
                         [](const auto& instance) {
                           return instance.param == ProfileKind::kSCurve ? "Scurve" : "Trapezoid";
                         });

// One axis between two speeds, with the closed form for accelerations that may jump: full acceleration to a peak or to
// the limit of the speed, and full acceleration to the end.
TEST(JointPassage, OfOneAxisBetweenTwoSpeedsTakesTheLeastTime) {
  const RobotModel robot = passage_robot();
  test::Random random{84};
  for (int draw = 0; draw < 500; ++draw) {
    const long double limit = robot.axes[0].max_speed_rad_s, accel = robot.axes[0].max_accel_rad_s2;
    const long double v0 = random.real(-1, 1) * robot.axes[0].max_speed_rad_s;
    const long double v1 = random.real(-1, 1) * robot.axes[0].max_speed_rad_s, way = random.real(-2, 2);
    const long double direct = 0.5L * (v0 + v1) * std::fabs(v1 - v0) / accel;
    const long double sign = way >= direct ? 1 : -1;
    const long double peak = std::sqrt(std::max(sign * accel * way + 0.5L * (v0 * v0 + v1 * v1), 0.0L));
    long double least_s = (2 * peak - sign * (v0 + v1)) / accel;
    if (peak > limit) {
      const long double on_ramps = (limit * limit - 0.5L * (v0 * v0 + v1 * v1)) / accel;
      least_s = (2 * limit - sign * (v0 + v1)) / accel + (sign * way - on_ramps) / limit;
    }
    States start{}, end{};
    start[0] = {0.0, static_cast<double>(v0), 0.0};
    end[0] = {static_cast<double>(way), static_cast<double>(v1), 0.0};
    const RetargetPlan passage = plan_passage(robot, start, end, 1.0, ProfileKind::kTrapezoid);
    const auto least_ticks = static_cast<double>(least_s / static_cast<long double>(kTickSeconds));
    EXPECT_GE(static_cast<double>(passage.duration.value()), least_ticks - 1e-3) << "seed 84 draw " << draw;
    EXPECT_LE(static_cast<double>(passage.duration.value()), least_ticks + 1.0) << "seed 84 draw " << draw;
  }
}

}  // namespace
}  // namespace armature
