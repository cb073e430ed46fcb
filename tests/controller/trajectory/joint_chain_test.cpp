// Joint moves through points without a stop, judged by their set-points.
#include "controller/trajectory/joint/joint_chain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "controller/base/timebase.hpp"
#include "tests/controller/support/draws.hpp"
#include "tests/controller/support/random.hpp"
#include "tests/controller/support/robots.hpp"

namespace armature {
namespace {

using test::degrees;
using test::kDeg;
using Points = std::vector<PerAxis<Radians>>;

RobotModel chain_robot() {
  RobotModel robot = test::paper_robot();
  for (AxisModel& axis : robot.axes) axis.max_jerk_rad_s3 = 6'000.0 * kDeg;
  robot.axes[2].max_accel_rad_s2 = 300.0 * kDeg;
  robot.axes[4].max_jerk_rad_s3 = 2'500.0 * kDeg;
  return robot;
}

PerAxis<AxisState> rest_at(const PerAxis<Radians>& place) {
  return make_per_axis([&](std::size_t axis) { return AxisState{.position = place[axis].value()}; });
}

// The set-points before, of and after the chain.
Points points_of(const JointChain& chain) {
  Points points;
  for (std::int64_t tick = -3; tick <= chain.duration.value() + 3; ++tick) {
    points.push_back(position(chain, seconds(Ticks{tick})));
  }
  return points;
}

// The least value, over all set-points, of the largest deviation of a joint.
double distance_of(const Points& points, const PerAxis<Radians>& via) {
  double least = std::numeric_limits<double>::infinity();
  for (const PerAxis<Radians>& point : points) {
    double most = 0.0;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      most = std::max(most, std::fabs(point[axis].value() - via[axis].value()));
    }
    least = std::min(least, most);
  }
  return least;
}

void expect_limits(const RobotModel& robot, const Points& points, bool with_jerk, const std::string& what) {
  for (std::size_t k = 3; k < points.size(); ++k) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const auto q = [&](std::size_t back) -> long double { return points[k - back][axis].value(); };
      const AxisModel& model = robot.axes[axis];
      const long double step_s = kTickSeconds;
      ASSERT_LE(std::fabs(q(0) - q(1)), model.max_speed_rad_s * step_s * (1 + 1e-5L)) << what << " tick " << k;
      ASSERT_LE(std::fabs(q(0) - 2 * q(1) + q(2)), model.max_accel_rad_s2 * step_s * step_s * (1 + 1e-5L))
          << what << " tick " << k << " axis " << axis;
      if (with_jerk) {
        const long double third = std::fabs(q(0) - 3 * q(1) + 3 * q(2) - q(3));
        ASSERT_LE(third, model.max_jerk_rad_s3 * step_s * step_s * step_s * (1 + 1e-3L) + 4e-15L)
            << what << " tick " << k << " axis " << axis;
      }
      ASSERT_LE(q(0), model.max_rad + 1e-9L) << what;
      ASSERT_GE(q(0), model.min_rad - 1e-9L) << what;
    }
  }
}

// The least value, over the set-points from..to - 1, of the step of the fastest joint, rad.
double slowest_step(const Points& points, std::size_t from, std::size_t to) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = from; k < to; ++k) {
    double most = 0.0;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      most = std::max(most, std::fabs((points[k][axis] - points[k - 1][axis]).value()));
    }
    least = std::min(least, most);
  }
  return least;
}

struct Corners {
  JointChain chain;
  std::vector<PerAxis<Radians>> targets;
  std::vector<double> blends_rad;  // of each target but the last
  std::int64_t stopped_ticks = 0;  // with a stop at each target
};

Corners random_corners(test::Random& random, const RobotModel& robot, ProfileKind kind) {
  Corners corners;
  PerAxis<Radians> start{};
  const auto count = static_cast<std::size_t>(random.integer(2, 6));
  for (std::size_t move = 0; move < count; ++move) {
    PerAxis<Radians> target;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const bool stays = random.integer(0, 3) == 0;
      target[axis] = stays ? start[axis] : Radians{random.real(-2.9, 2.9)};
    }
    const double speed = random.real(0.3, 1.0);
    const RetargetPlan alone = plan_retarget(robot, rest_at(start), target, speed, kind);
    corners.stopped_ticks += alone.duration.value();
    if (move == 0) {
      corners.chain = alone;
    } else {
      corners.blends_rad.push_back(random.integer(0, 4) == 0 ? 0.0 : random.real(0.005, 0.4));
      const int plans =
          append(corners.chain, robot, {.target = target, .speed = speed, .kind = kind}, corners.blends_rad.back());
      EXPECT_GE(plans, 1);
      EXPECT_LE(plans, 34);
    }
    corners.targets.push_back(target);
    start = target;
  }
  return corners;
}

class JointChainProperties : public testing::TestWithParam<ProfileKind> {};

TEST_P(JointChainProperties, EverySetPointIsWithinTheLimitsAndPassesEachPointAsNearAsAskedFor) {
  const RobotModel robot = chain_robot();
  test::Random random{61};
  std::int64_t stopped = 0, taken = 0;
  for (int draw = 0; draw < test::draws(60); ++draw) {
    const std::string what = "seed 61 draw " + std::to_string(draw);
    const Corners corners = random_corners(random, robot, GetParam());
    const Points points = points_of(corners.chain);
    expect_limits(robot, points, GetParam() == ProfileKind::kSCurve, what);
    if (HasFatalFailure()) return;
    ASSERT_EQ(points.front(), degrees({})) << what;
    ASSERT_EQ(points.back(), corners.targets.back()) << what;
    for (std::size_t i = 0; i < corners.blends_rad.size(); ++i) {
      // Where the joints pass the point, not where they may come back to it.
      const auto first = static_cast<std::ptrdiff_t>(corners.chain.starts[i].value());
      const auto last = static_cast<std::ptrdiff_t>((corners.chain.end_of(i + 1)).value());
      const Points passage{points.begin() + first, points.begin() + last + 4};
      ASSERT_LE(distance_of(passage, corners.targets[i]), corners.blends_rad[i] + 1e-12) << what << " corner " << i;
    }
    ASSERT_LE(corners.chain.duration.value(), corners.stopped_ticks) << what;
    stopped += corners.stopped_ticks;
    taken += corners.chain.duration.value();
  }
  // With corners of 0.2 rad in the mean.
  EXPECT_LT(static_cast<double>(taken), 0.95 * static_cast<double>(stopped));
}

TEST_P(JointChainProperties, NoStopBetweenMovesInOtherDirections) {
  const RobotModel robot = chain_robot();
  JointChain chain;
  chain = plan_retarget(robot, rest_at({}), degrees({60, 0, 0, 0, 0, 0}), 1.0, GetParam());
  const JointRequest next{.target = degrees({60, 60, 0, 0, 0, 0}), .kind = GetParam()};
  const JointRequest last{.target = degrees({0, 60, 40, 0, 0, 0}), .kind = GetParam()};
  ASSERT_GT(append(chain, robot, next, 5 * kDeg), 0);
  ASSERT_GT(append(chain, robot, last, 5 * kDeg), 0);
  const Points points = points_of(chain);
  const double full_step = 120 * kDeg * kTickSeconds;
  EXPECT_GT(slowest_step(points, 4'000, points.size() - 4'000), 0.2 * full_step);
  // The corners use the whole deviation.
  EXPECT_GT(distance_of(points, degrees({60, 0, 0, 0, 0, 0})), 4.9 * kDeg);
  EXPECT_GT(distance_of(points, degrees({60, 60, 0, 0, 0, 0})), 4.9 * kDeg);
}

TEST_P(JointChainProperties, AWideBlendBeginsInTheMiddleOfAMoveAndNotBefore) {
  const RobotModel robot = chain_robot();
  JointChain chain;
  chain = plan_retarget(robot, rest_at({}), degrees({60, 0, 0, 0, 0, 0}), 1.0, GetParam());
  const std::int64_t whole = chain.duration.value();
  ASSERT_EQ(append(chain, robot, {.target = degrees({60, 60, 0, 0, 0, 0}), .kind = GetParam()}, 3.0), 1);
  EXPECT_EQ(chain.starts[1].value(), (whole + 1) / 2);
}

TEST_P(JointChainProperties, WithoutABlendTheJointsStopExactly) {
  const RobotModel robot = chain_robot();
  JointChain chain;
  chain = plan_retarget(robot, rest_at({}), degrees({30, 10, 0, 0, 0, 0}), 1.0, GetParam());
  const std::int64_t whole = chain.duration.value();
  ASSERT_EQ(append(chain, robot, {.target = degrees({30, 60, 5, 0, 0, 0}), .kind = GetParam()}, 0.0), 1);
  EXPECT_EQ(chain.starts[1].value(), whole);
  EXPECT_EQ(position(chain, seconds(Ticks{whole})), degrees({30, 10, 0, 0, 0, 0}));
}

TEST_P(JointChainProperties, AMoveThatWouldTakeTooLongLeavesTheChainAsItIs) {
  const RobotModel robot = chain_robot();
  JointChain chain;
  chain = plan_retarget(robot, rest_at({}), degrees({30, 10, 0, 0, 0, 0}), 1.0, GetParam());
  const Ticks whole = chain.duration;
  ASSERT_EQ(append(chain, robot, {.target = degrees({0, 0, 0, 0, 0, 0}), .speed = 1e-7, .kind = GetParam()}, 0.1), 0);
  EXPECT_EQ(chain.count, 1u);
  EXPECT_EQ(chain.duration, whole);
}

INSTANTIATE_TEST_SUITE_P(Kinds, JointChainProperties, testing::Values(ProfileKind::kTrapezoid, ProfileKind::kSCurve),
                         [](const auto& instance) {
                           return instance.param == ProfileKind::kSCurve ? "Scurve" : "Trapezoid";
                         });

}  // namespace
}  // namespace armature
