// Long paths in windows that are refilled while they run: judged by their set-points and forward kinematics only.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "controller/trajectory/plan/cartesian_planner.hpp"
#include "tests/controller/support/draws.hpp"
#include "tests/controller/support/path_rig.hpp"
#include "tests/controller/support/random.hpp"
#include "tests/controller/support/window_rig.hpp"

namespace armature {
namespace {

using test::kReady;
using test::line_to;
using test::moved;
using test::PathRig;
using test::Random;
using test::WindowRig;
using test::WindowRun;
using Polyline = std::vector<Eigen::Vector3d>;

constexpr PathLimits kFeed{.speed_mm_s = 100.0,
                           .accel_mm_s2 = 2'000.0,
                           .jerk_mm_s3 = 1e6,
                           .turn_speed_rad_s = 2.0,
                           .turn_accel_rad_s2 = 20.0,
                           .turn_jerk_rad_s3 = 1e3};

std::vector<SegmentRequest> polyline(const Transform& from, const Polyline& offsets_mm, const PathLimits& limits,
                                     double blend_mm, ProfileKind profile) {
  std::vector<SegmentRequest> requests;
  for (const Eigen::Vector3d& offset : offsets_mm) {
    requests.push_back(line_to(moved(from, offset.x(), offset.y(), offset.z()), limits, blend_mm, profile));
  }
  return requests;
}

// The set-points against the polyline: each is near it, in its order, and the joints and the tool keep their limits.
// What is wrong first, or nothing. `slack`: of the joints; the tool may have ten times as much, because a corner that
// lasts for a few ticks is checked at ticks and half-way between them only, and a hold shifts the set-points.
// `most_jerk`: of joints and tool, as a share of their limits.
std::string judge(const PathRig& rig, const std::vector<SegmentRequest>& requests, const WindowRun& run,
                  const PathLimits& limits, double blend_mm, double slack, double most_jerk) {
  const test::JointPeaks peaks = test::joint_peaks(rig.robot, run.joints);
  if (!(peaks.most(false) <= 1.0 + slack)) {
    return "joints: " + std::to_string(peaks.speed) + ", " + std::to_string(peaks.accel) + " at " +
           std::to_string(peaks.accel_at);
  }
  if (!(peaks.jerk <= most_jerk)) return "jerk of a joint: " + std::to_string(peaks.jerk);
  Polyline corners{rig.tool_at(run.joints.front()).position_mm};
  for (const SegmentRequest& request : requests) corners.push_back(request.target.position_mm);
  std::size_t segment = 0;
  std::vector<Eigen::Vector3d> tool;
  for (std::size_t k = 0; k < run.joints.size(); ++k) {
    tool.push_back(rig.tool_at(run.joints[k]).position_mm);
    // The first of the next segments that is near enough. The nearest may be one that the tool has yet to reach.
    double least = std::numeric_limits<double>::infinity();
    const std::size_t end = std::min(segment + 8, requests.size());
    for (std::size_t i = segment; i < end; ++i) {
      const Eigen::Vector3d way = corners[i + 1] - corners[i];
      const double share = std::clamp(way.dot(tool[k] - corners[i]) / way.squaredNorm(), 0.0, 1.0);
      least = std::min(least, (corners[i] + share * way - tool[k]).norm());
      if (least > blend_mm + 1e-7) continue;
      segment = i;
      break;
    }
    if (!(least <= blend_mm + 1e-7)) return "off the path by " + std::to_string(least) + " at " + std::to_string(k);
    if (k < 2) continue;
    const Eigen::Vector3d v = (tool[k] - tool[k - 1]) / 50e-6, before = (tool[k - 1] - tool[k - 2]) / 50e-6;
    if (!(v.norm() <= 1.002 * limits.speed_mm_s))
      return "speed " + std::to_string(v.norm()) + " at " + std::to_string(k);
    const double accel = (v - before).norm() / 50e-6;
    if (!(accel <= (1.002 + 10.0 * slack) * limits.accel_mm_s2))
      return "acceleration " + std::to_string(accel / limits.accel_mm_s2) + " at " + std::to_string(k);
    if (k < 3) continue;
    const Eigen::Vector3d oldest = (tool[k - 2] - tool[k - 3]) / 50e-6;
    const double jerk = (v - 2.0 * before + oldest).norm() / (50e-6 * 50e-6) / limits.jerk_mm_s3;
    if (!(jerk <= most_jerk)) return "jerk " + std::to_string(jerk) + " at " + std::to_string(k);
  }
  if (!((tool.back() - corners.back()).norm() < 1e-7)) return "end";
  return {};
}

// Loops whose radius changes slowly, as a drawing program writes them: chords of `step_mm`.
Polyline loops(std::size_t count, double step_mm) {
  Polyline points;
  double angle = 0.0;
  for (std::size_t i = 1; i <= count; ++i) {
    const double radius = 40.0 + 12.0 * std::sin(0.3 * angle);
    angle += step_mm / radius;
    points.push_back({radius * std::cos(angle) - 40.0, radius * std::sin(angle), 5.0 * std::sin(0.7 * angle)});
  }
  return points;
}

double length_mm(const Polyline& points) {
  double sum = points[0].norm();
  for (std::size_t i = 1; i < points.size(); ++i) sum += (points[i] - points[i - 1]).norm();
  return sum;
}

// For trapezoids and S-curves.
class PathWindow : public testing::TestWithParam<ProfileKind> {
 protected:
  [[nodiscard]] static bool smooth() { return GetParam() == ProfileKind::kSCurve; }
  [[nodiscard]] static double most_jerk() { return smooth() ? 1.05 : std::numeric_limits<double>::infinity(); }
};
INSTANTIATE_TEST_SUITE_P(Profiles, PathWindow, testing::Values(ProfileKind::kTrapezoid, ProfileKind::kSCurve),
                         [](const auto& test) { return test.param == ProfileKind::kSCurve ? "SCurve" : "Trapezoid"; });

TEST_P(PathWindow, ALongCurveRunsAtItsSpeedWithoutAStop) {
  const auto rig = std::make_unique<PathRig>(test::irb120());
  const Polyline points = loops(1'500, 0.5);
  const auto requests = polyline(rig->tool_at(kReady), points, kFeed, 0.05, GetParam());
  WindowRig windows{*rig, requests, 200, 64};
  const WindowRun run = windows.run(kReady, 1'000'000);
  ASSERT_TRUE(run.complete);
  EXPECT_EQ(judge(*rig, requests, run, kFeed, 0.05, 0.0, most_jerk()), "");
  EXPECT_EQ(run.rests, 1u);
  EXPECT_EQ(run.refused + run.late, 0u);
  EXPECT_EQ(run.largest, CartesianPlan::kMaxSegments);
  const double ideal_s = length_mm(points) / kFeed.speed_mm_s + kFeed.speed_mm_s / kFeed.accel_mm_s2;
  EXPECT_LT(static_cast<double>(run.joints.size() - 8) * 50e-6, 1.01 * ideal_s);
}

TEST_P(PathWindow, TenThousandShortLinesRunAtTheirSpeed) {
  const auto rig = std::make_unique<PathRig>(test::irb120());
  Random random{1};
  const Transform from = rig->tool_at(kReady);
  // A rounded rectangle again and again, each time 0.01 mm higher: lines of 0.1 to 1 mm, corners of radius 8 mm.
  Polyline points;
  for (int corner = 0; points.size() < static_cast<std::size_t>(test::draws(10'000)); ++corner) {
    const double heading = 0.5 * std::numbers::pi * corner;
    Eigen::Vector3d at = points.empty() ? Eigen::Vector3d::Zero() : points.back();
    const Eigen::Vector3d along{-std::sin(heading), std::cos(heading), 0.0}, aside{-along.y(), along.x(), 0.0};
    double left = 50.0;
    while (left > 1.1) {
      const double step = random.real(0.1, 1.0);
      points.push_back(at += step * along);
      left -= step;
    }
    points.push_back(at += left * along + Eigen::Vector3d{0.0, 0.0, 0.01});
    constexpr int kChords = 24;
    for (int i = 1; i <= kChords; ++i) {
      const double angle = 0.5 * std::numbers::pi * i / kChords;
      points.push_back(at + 8.0 * (std::sin(angle) * along + (1.0 - std::cos(angle)) * aside));
    }
  }
  const double length = length_mm(points);
  // A corner of the polyline needs 1.5e6 mm/s^3 at this speed.
  PathLimits limits = kFeed;
  limits.jerk_mm_s3 = 3e6;
  const auto requests = polyline(from, points, limits, 0.02, GetParam());
  WindowRig windows{*rig, requests, 200, 64};
  const WindowRun run = windows.run(kReady, 2'000'000);
  ASSERT_TRUE(run.complete);
  EXPECT_EQ(judge(*rig, requests, run, limits, 0.02, 0.0, most_jerk()), "");
  EXPECT_EQ(run.rests, 1u);
  EXPECT_EQ(run.refused + run.late, 0u);
  const double ideal_s = length / kFeed.speed_mm_s + kFeed.speed_mm_s / kFeed.accel_mm_s2;
  EXPECT_LT(static_cast<double>(run.joints.size() - 8) * 50e-6, 1.03 * ideal_s);
}

// Random polylines, supplied at random times, planned in random times, executed with random holds and overrides.
TEST_P(PathWindow, ALateSupplyStopsOnThePathAndGoesOn) {
  std::size_t rests = 0, late = 0, refused = 0, switches = 0;
  // The planning of an S-curve takes longer.
  const auto rounds = static_cast<std::uint64_t>(test::draws(smooth() ? 10 : 40));
  for (std::uint64_t round = 0; round < rounds; ++round) {
    Random random{700 + round};
    const auto rig = std::make_unique<PathRig>(test::irb120());
    const double step_mm = std::exp(random.real(std::log(0.1), std::log(3.0)));
    const bool jagged = random.integer(0, 2) == 0;
    Polyline points;
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    double heading = random.real(0.0, 6.0), bend = 0.0;
    const auto count = static_cast<std::size_t>(random.integer(40, 400));
    for (std::size_t i = 0; i < count; ++i) {
      const bool corner = jagged && random.integer(0, 9) == 0;
      bend = std::clamp(bend + random.real(-0.01, 0.01), -0.05, 0.05);
      heading += corner ? random.real(-2.5, 2.5) : bend * step_mm;
      if (at.norm() > 60.0) heading = std::atan2(-at.y(), -at.x());
      at += step_mm * random.real(0.5, 1.5) * Eigen::Vector3d{std::cos(heading), std::sin(heading), 0.1 * bend};
      points.push_back(at);
    }
    PathLimits limits = kFeed;
    limits.speed_mm_s = random.real(20.0, 400.0);
    limits.accel_mm_s2 = random.real(500.0, 8'000.0);
    const double blend_mm = random.integer(0, 4) == 0 ? 0.0 : step_mm * random.real(0.02, 0.5);
    limits.jerk_mm_s3 = std::exp(random.real(std::log(3e4), std::log(3e6)));
    const auto requests = polyline(rig->tool_at(kReady), points, limits, blend_mm, GetParam());
    WindowRig windows{*rig, requests, random.integer(20, 300), static_cast<std::size_t>(random.integer(1, 64))};
    // Arrives in batches.
    std::vector<std::int64_t> arrives;
    for (std::int64_t tick = 0; arrives.size() < requests.size();) {
      tick += random.integer(0, 3) == 0 ? random.integer(0, 4'000) : random.integer(0, 100);
      for (std::int64_t i = random.integer(1, 40); i > 0 && arrives.size() < requests.size(); --i)
        arrives.push_back(tick);
    }
    windows.supplied = [&arrives](std::int64_t tick) {
      return static_cast<std::size_t>(std::upper_bound(arrives.begin(), arrives.end(), tick) - arrives.begin());
    };
    windows.planning_ticks = [&random] {
      return random.integer(0, 9) == 0 ? random.integer(0, 2'000) : random.integer(0, 20);
    };
    const bool changes_rate = random.integer(0, 1) == 0;
    double wanted = 1.0;
    if (changes_rate) {
      windows.rate = [&random, &wanted](std::int64_t tick) {
        if (tick % 97 == 0 && random.integer(0, 9) == 0)
          wanted = random.integer(0, 1) == 0 ? 1.0 : random.real(0.0, 1.0);
        return wanted;
      };
    }
    const WindowRun run = windows.run(kReady, 3'000'000);
    ASSERT_TRUE(run.complete) << round;
    ASSERT_EQ(judge(*rig, requests, run, limits, blend_mm, changes_rate ? 1e-3 : 0.0,
                    changes_rate ? 2.0 * most_jerk() : most_jerk()),
              "")
        << round << ": blend " << blend_mm << ", steps of " << step_mm;
    rests += run.rests;
    late += run.late;
    refused += run.refused;
    switches += run.switches.size();
  }
  EXPECT_LE(refused, smooth() ? 1u : 0u);
  if (test::few_draws()) return;
  // All of it happened.
  EXPECT_GT(rests, rounds + rounds / 4);
  EXPECT_GT(late, rounds / 6);
  EXPECT_GT(switches, 3 * rounds);
}

}  // namespace
}  // namespace armature
