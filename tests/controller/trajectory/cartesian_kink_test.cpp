// Rounded corners where one segment brakes for a part of a tick before the next one begins: what lasts so short is
// within the limits of joints and tool wherever set-points lie between ticks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "controller/base/timebase.hpp"
#include "controller/trajectory/check/kink_check.hpp"
#include "controller/trajectory/check/path_check.hpp"
#include "controller/trajectory/law/speed_law.hpp"
#include "tests/controller/support/path_rig.hpp"
#include "tests/controller/support/random.hpp"

namespace armature {
namespace {

using test::PathRig;

// Five short lines with brisk limits and blends.
bool plan_corners(PathRig& rig, std::uint64_t seed) {
  test::Random random{seed};
  PerAxis<double> start_deg{};
  const PerAxis<double> low{-60, -20, -20, -60, 40, -60}, high{60, 20, 20, 60, 90, 60};
  for (std::size_t axis = 0; axis < kAxes; ++axis) start_deg[axis] = random.real(low[axis], high[axis]);
  const JointAngles start = test::degrees(start_deg);
  PathLimits limits = test::kBrisk;
  limits.speed_mm_s = random.real(80, 500);
  limits.accel_mm_s2 = random.real(1e4, 5e4);
  limits.turn_accel_rad_s2 = 200;
  limits.turn_speed_rad_s = 10;
  const double size_mm = random.real(2, 15);
  Transform at = rig.tool_at(start);
  std::vector<SegmentRequest> chain;
  for (int i = 0; i < 5; ++i) {
    const double x_mm = random.real(-1, 1) * size_mm;
    const double y_mm = random.real(-1, 1) * size_mm;
    const double z_mm = random.real(-1, 1) * size_mm * 0.5;
    at = test::moved(at, x_mm, y_mm, z_mm);
    const double blend_mm = random.real(0.05, 0.6) * size_mm;
    chain.push_back(test::line_to(at, limits, blend_mm));
  }
  return rig.plan(start, chain) == CartesianPlanner::Progress::kDone;
}

// Without a look between ticks these exceed the limit by 5 to 14 %.
TEST(CartesianKink, JointsKeepTheirAccelerationWhereverSetPointsLie) {
  for (const std::uint64_t seed : {253u, 401u, 2049u, 2183u, 3433u}) {
    PathRig rig{test::irb120()};
    ASSERT_TRUE(plan_corners(rig, seed));
    for (int eighths = 0; eighths < 8; ++eighths) {
      const test::JointPeaks peaks = test::joint_peaks(rig.robot, rig.set_points(eighths / 8.0));
      EXPECT_LE(peaks.accel, 1.0) << "seed " << seed << ", " << eighths << " eighths of a tick later: axis "
                                  << peaks.accel_axis << " at set-point " << peaks.accel_at;
    }
  }
}

// The largest second difference of the tool at ticks that are later by `shift`, as an acceleration.
double tool_accel_mm_s2(const CartesianPlan& plan, double shift) {
  double most = 0.0;
  for (std::int64_t tick = 0; tick < plan.duration.value() + 2; ++tick) {
    const auto at = [&](double back) {
      const double ticks = static_cast<double>(tick) + shift - back;
      return tool_pose(plan, std::max(ticks, 0.0) * kTickSeconds).position_mm;
    };
    most = std::max(most, (at(0.0) - 2.0 * at(1.0) + at(2.0)).norm());
  }
  return most / (kTickSeconds * kTickSeconds);
}

// The largest excess of the tool that is found at ticks and half-way between them, or around the kinks of the law.
double tool_excess(const PathRig& rig, const CartesianPlan& plan, bool around_kinks) {
  PathCheck check{rig.robot};
  KinkCheck kinks{rig.arm};
  kinks.begin(plan);
  check.begin(plan.start, tool_sample(plan, 0.0));
  double most = 1.0;
  for (std::int64_t tick = 1; tick <= plan.duration.value() + 3; ++tick) {
    const auto at_tick = static_cast<double>(tick);
    if (around_kinks) {
      kinks.sample(plan, tick, plan.start, check);
    } else {
      check.add(plan, plan.start, tool_sample(plan, at_tick * kTickSeconds));
      check.add_tool_between(plan, tool_sample(plan, (at_tick - 0.5) * kTickSeconds));
    }
    const PathCheck::Place place = check.take_latest();
    if (place.axis == 0) most = std::max(most, place.stretch);
  }
  return most;
}

// A line of ten nanometres. It takes three ticks, half of them to speed up.
CartesianPlan short_line(PathRig& rig) {
  const Transform end = test::moved(rig.tool_at(test::kReady), 1e-5, 0, 0);
  EXPECT_EQ(rig.plan(test::kReady, test::line_to(end, test::kBrisk)), CartesianPlanner::Progress::kDone);
  CartesianPlan plan = rig.planner.plan();
  const double length = plan.segments[0].length, half_s = 1.4999 * kTickSeconds;
  LawLimits limits;
  limits.bands[0] = {.by_accel = half_s * half_s / length};
  limits.most_square = 1e6;
  const auto law = std::make_unique<SpeedLaw>();
  EXPECT_TRUE(law->append(0.0, limits) && law->append(length, limits));
  law->plan();
  plan.table.assign(*law);
  plan.duration = plan.segments[0].duration = plan.table.duration();
  return plan;
}

// The acceleration over two ticks is largest a quarter of a tick beside the ticks and the middles between them.
TEST(CartesianKink, TheToolIsCheckedAtQuartersOfATick) {
  PathRig rig{test::irb120()};
  CartesianPlan plan = short_line(rig);
  ASSERT_EQ(plan.duration, Ticks{3});
  const double coarse = std::max(tool_accel_mm_s2(plan, 0.0), tool_accel_mm_s2(plan, 0.5));
  const double fine = std::max(tool_accel_mm_s2(plan, 0.25), tool_accel_mm_s2(plan, 0.75));
  ASSERT_GT(fine, 1.03 * coarse);
  const double limit = plan.segments[0].limits.accel_mm_s2 = std::sqrt(coarse * fine);
  EXPECT_EQ(tool_excess(rig, plan, false), 1.0);
  EXPECT_NEAR(tool_excess(rig, plan, true), std::sqrt(fine / limit / (1.0 + PathCheck::kToolTolerance)), 1e-6);
}

}  // namespace
}  // namespace armature
