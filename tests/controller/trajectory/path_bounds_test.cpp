// What the bounds say is kept must be so at every time: random chains of six and five axes, from 1 mm/s to the fastest,
// are planned, and the bounds look at them with limits that are lower than the plan kept. Set-points one tick apart, at
// a random phase, are the oracle: wherever all times of a difference are said to be kept, the difference keeps the
// limit.
//
// 400 chains take some ten seconds. In an hour, ARMATURE_CAMPAIGN=500 in the environment looks at 200 000.
#include "controller/trajectory/check/path_bounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "controller/robot/axis_units.hpp"
#include "controller/trajectory/check/path_check.hpp"
#include "tests/controller/support/draws.hpp"
#include "tests/controller/support/path_rig.hpp"
#include "tests/controller/support/random_chains.hpp"

namespace armature {
namespace {

using test::PathRig;
using test::Random;

constexpr double kStep_s = kTickSeconds;
// Of a checked limit: the jumps of a law that SpanCheck::joins() permits, and rounding of the set-points.
constexpr double kMissed = 1e-3, kMissedOfJerk = 0.015;

int campaign() {
  const char* times = std::getenv("ARMATURE_CAMPAIGN");
  return times != nullptr ? std::max(1, std::atoi(times)) : 1;
}

struct Kept {
  std::vector<std::pair<double, double>> times;  // ticks, those that follow each other joined
  double ticks = 0.0;
};

Kept kept_by(const RobotModel& robot, const Arm& arm, const CartesianPlan& plan) {
  const auto bounds = std::make_unique<PathBounds>(robot, arm);
  bounds->begin(plan);
  Kept kept;
  double from = 0.0;
  bool joins = false;
  for (PathBounds::Found found{}; found != PathBounds::Found::kEnd;) {
    found = bounds->step(plan);
    const double to = bounds->ticks();
    if (found == PathBounds::Found::kKept) {
      if (!joins) kept.times.emplace_back(from, from);
      kept.times.back().second = to;
      kept.ticks += to - from;
    }
    if (found != PathBounds::Found::kSearching) joins = found == PathBounds::Found::kKept;
    from = to;
  }
  return kept;
}

// The largest difference over ticks within kept times, as a share of the checked limit.
struct Worst {
  double share = 0.0;
  std::string what;
  void add(double size, double limit, const char* name, double tick) {
    if (!(size / limit > share)) return;
    share = size / limit;
    what = std::string{name} + " at tick " + std::to_string(tick);
  }
};

struct Sample {
  JointAngles joints{};
  ToolSample tool{};
};

void judge(const RobotModel& robot, const CartesianPlan& plan, std::span<const Sample> at, std::size_t order,
           double tick, bool smooth, Worst& worst) {
  constexpr double kShare = PathCheck::kCheckedShare, kToolLimit = 1.0 + PathCheck::kToolTolerance;
  constexpr double kJerkLimit = (1.0 + kMissedOfJerk) / (1.0 + kMissed);
  const PathLimits& limits = plan.segments[0].limits;
  const std::size_t k = at.size() - 1;
  if (order == 3 && !smooth) return;
  for (std::size_t axis = 0; axis < robot.axis_count; ++axis) {
    const AxisModel& model = robot.axes[axis];
    const auto q = [&](std::size_t back) { return at[k - back].joints[axis].value(); };
    if (order == 1) {
      worst.add(std::fabs(q(0) - q(1)), kShare * AxisUnits{model}.max_speed_rad_s() * kStep_s, "joint speed", tick);
    } else if (order == 2) {
      worst.add(std::fabs(q(0) - 2.0 * q(1) + q(2)), kShare * model.max_accel_rad_s2 * kStep_s * kStep_s, "joint accel",
                tick);
    } else {
      worst.add(std::fabs(q(0) - 3.0 * (q(1) - q(2)) - q(3)),
                kJerkLimit * kShare * model.max_jerk_rad_s3 * kStep_s * kStep_s * kStep_s, "joint jerk", tick);
    }
  }
  const auto move = [&](std::size_t back) -> Eigen::Vector3d {
    return at[k - back].tool.tool.base_T_tool.position_mm - at[k - back - 1].tool.tool.base_T_tool.position_mm;
  };
  const auto turn = [&](std::size_t back) { return limited_turn(at[k - back - 1].tool, at[k - back].tool); };
  if (order == 1) {
    worst.add(move(0).norm(), limits.speed_mm_s * kStep_s, "speed", tick);
    worst.add(turn(0).norm(), limits.turn_speed_rad_s * kStep_s, "turn speed", tick);
  } else if (order == 2) {
    worst.add((move(0) - move(1)).norm(), kToolLimit * limits.accel_mm_s2 * kStep_s * kStep_s, "accel", tick);
    worst.add((turn(0) - turn(1)).norm(), kToolLimit * limits.turn_accel_rad_s2 * kStep_s * kStep_s, "turn accel",
              tick);
  } else {
    constexpr double kJerk = kJerkLimit * (1.0 + PathCheck::kJerkTolerance);
    worst.add((move(0) - 2.0 * move(1) + move(2)).norm(), kJerk * limits.jerk_mm_s3 * kStep_s * kStep_s * kStep_s,
              "jerk", tick);
    worst.add((turn(0) - 2.0 * turn(1) + turn(2)).norm(), kJerk * limits.turn_jerk_rad_s3 * kStep_s * kStep_s * kStep_s,
              "turn jerk", tick);
  }
}

// At the start and one tick after the other, `shift` ticks before each tick.
std::vector<Sample> set_points(const Arm& arm, const CartesianPlan& plan, double shift) {
  std::vector<Sample> all(1, {plan.start, tool_sample(plan, 0.0)});
  for (std::int64_t tick = 1; tick <= plan.duration.value(); ++tick) {
    const double t_s = (static_cast<double>(tick) - shift) * kStep_s;
    all.push_back({position(plan, arm, t_s, all.back().joints), tool_sample(plan, t_s)});
  }
  return all;
}

Worst worst_in(const RobotModel& robot, const CartesianPlan& plan, const std::vector<Sample>& all, double shift,
               const Kept& kept) {
  const bool smooth = plan.segments[0].profile == ProfileKind::kSCurve;
  Worst worst;
  std::size_t next = 0;
  for (std::size_t tick = 2; tick < all.size(); ++tick) {
    const double time = static_cast<double>(tick) - shift;
    while (next < kept.times.size() && kept.times[next].second < time) ++next;
    if (next == kept.times.size()) break;
    // The way from the start to the first set-point is less than a tick.
    for (std::size_t order = 1; order <= 3 && order < tick; ++order) {
      if (time - static_cast<double>(order) < kept.times[next].first) break;
      judge(robot, plan, std::span{all}.subspan(tick - order, order + 1), order, time, smooth, worst);
    }
  }
  return worst;
}

// A chain of one profile and one set of limits, so that no set-point has those of two segments.
test::RandomChain chain_of(Random& random, const RobotModel& robot) {
  const bool smooth = random.integer(0, 1) == 0, blended = random.integer(0, 3) != 0;
  const auto begin = static_cast<test::Begin>(random.integer(0, 2));
  const test::Laws laws = smooth ? test::Laws::kSCurves : test::Laws::kTrapezoids;
  test::RandomChain chain = test::ChainMaker{random, robot, laws, blended, begin}.make();
  const double slower = random.integer(0, 1) == 0 ? 1.0 : test::log_uniform(random, 0.01, 1.0);
  PathLimits limits = chain.requests[0].limits;
  limits.speed_mm_s *= slower;
  limits.turn_speed_rad_s *= slower;
  for (SegmentRequest& request : chain.requests) request.limits = limits;
  return chain;
}

TEST(PathBounds, WhatIsKeptKeepsEveryLimitAtEveryTime) {
  constexpr std::uint64_t kBoundsSeed = 33'000;
  constexpr std::int64_t kLongestPlan = 20'000;  // ticks of a plan that is looked at
  const int draws = test::draws(400) * campaign();
  int plans = 0, lower = 0;
  double ticks = 0.0, kept_ticks = 0.0, most = 0.0;
  for (int draw = 0; draw < draws; ++draw) {
    Random random{kBoundsSeed + static_cast<std::uint64_t>(draw)};
    const test::RandomChain chain = chain_of(random, draw % 3 == 2 ? test::hu2012() : test::irb120());
    const auto rig = std::make_unique<PathRig>(chain.robot, 20.0, chain.tool);
    if (rig->plan(chain.start, chain.requests) != CartesianPlanner::Progress::kDone) continue;
    const auto plan = std::make_unique<CartesianPlan>(rig->planner.plan());
    if (plan->table.empty() || plan->duration.value() > kLongestPlan) continue;
    ++plans;
    const double shift = random.real(0.0, 1.0);
    const std::vector<Sample> all = set_points(rig->arm, *plan, shift);
    for (const bool lowered : {false, true}) {
      RobotModel robot = chain.robot;
      if (lowered) {
        for (AxisModel& axis : robot.axes) {
          axis.max_speed_rad_s *= random.real(0.2, 1.0);
          axis.max_accel_rad_s2 *= random.real(0.2, 1.0);
          axis.max_jerk_rad_s3 *= random.real(0.2, 1.0);
        }
        PathLimits limits = plan->segments[0].limits;
        limits.speed_mm_s *= random.real(0.5, 1.0);
        limits.accel_mm_s2 *= random.real(0.2, 1.0);
        limits.jerk_mm_s3 *= random.real(0.2, 1.0);
        limits.turn_accel_rad_s2 *= random.real(0.2, 1.0);
        for (std::size_t i = 0; i < plan->count; ++i) plan->segments[i].limits = limits;
      }
      const Kept kept = kept_by(robot, rig->arm, *plan);
      const Worst worst = worst_in(robot, *plan, all, shift, kept);
      EXPECT_LE(worst.share, 1.0 + kMissed) << worst.what << " of draw " << draw << (lowered ? ", lowered" : "");
      most = std::max(most, worst.share);
      if (lowered) {
        const Worst anywhere = worst_in(robot, *plan, all, shift, {.times = {{0.0, 1e12}}});
        lower += anywhere.share > 1.0 ? 1 : 0;
      } else {
        ticks += static_cast<double>(plan->duration.value());
        kept_ticks += kept.ticks;
      }
    }
  }
  RecordProperty("largest_share", std::to_string(most));
  if (campaign() > 1)
    std::printf("%d plans, %.0f ticks, %.4f kept, largest %.6f\n", plans, ticks, kept_ticks / ticks, most);
  EXPECT_GT(plans, test::least(180));
  EXPECT_GT(lower, test::least(160));  // had set-points beyond a limit
  EXPECT_GT(kept_ticks, 0.85 * ticks);
}

// The wrist centre passes axis 1 and comes out behind it. Joint 1 turns by d / (v t) before and behind: much in a tick
// for a distance d that samples of the line hardly show. The plan is one for a stronger arm.
TEST(PathBounds, ALineThatPassesAxisOneIsNotKeptThere) {
  const RobotModel robot = test::irb120();
  RobotModel strong = robot;
  for (AxisModel& axis : strong.axes) {
    axis.max_speed_rad_s *= 10.0;
    axis.max_accel_rad_s2 *= 1e4;
    axis.max_jerk_rad_s3 *= 1e6;
  }
  const Transform to_wrist{Eigen::Matrix3d::Identity(), {0.0, 0.0, -72.0}};
  const JointAngles start = test::degrees({-90, -30, 20, 0, 60, 0});
  for (const double distance_mm : {1e-9, 1e-8, 1e-7}) {
    const auto rig = std::make_unique<PathRig>(strong, 1e6, to_wrist);
    Transform from = rig->tool_at(start);
    from.position_mm = {distance_mm, -120.0, from.position_mm.z()};
    const IkSolutions at_start = rig->arm.inverse(from * inverse(to_wrist), start);
    ASSERT_GE(at_start.selected, 0);
    const SegmentRequest line = test::line_to(test::moved(from, 0.0, 200.0, 0.0), test::kBrisk);
    const JointAngles& joints = at_start.branches[static_cast<std::size_t>(at_start.selected)].joints;
    ASSERT_EQ(rig->plan(joints, line), CartesianPlanner::Progress::kDone) << distance_mm;
    const CartesianPlan& plan = rig->planner.plan();
    const std::vector<Sample> all = set_points(rig->arm, plan, 0.5);
    const Kept kept = kept_by(robot, rig->arm, plan);
    const Worst anywhere = worst_in(robot, plan, all, 0.5, {.times = {{0.0, 1e12}}});
    EXPECT_GT(anywhere.share, 1.0) << distance_mm;
    const Worst worst = worst_in(robot, plan, all, 0.5, kept);
    EXPECT_LE(worst.share, 1.0 + kMissed) << worst.what << " at a distance of " << distance_mm;
    EXPECT_GT(kept.ticks, 0.5 * static_cast<double>(plan.duration.value())) << distance_mm;
  }
}

}  // namespace
}  // namespace armature
