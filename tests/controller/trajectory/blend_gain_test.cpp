// What rounded corners are worth: a chain with blends against the same chain with exact stops.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "tests/controller/support/draws.hpp"
#include "tests/controller/support/path_rig.hpp"
#include "tests/controller/support/tool_jerk.hpp"

namespace armature {
namespace {

using test::degrees;
using test::kReady;
using test::line_to;
using test::moved;
using test::PathRig;
using Progress = CartesianPlanner::Progress;

constexpr PathLimits kPen{.speed_mm_s = 250.0,
                          .accel_mm_s2 = 3'000.0,
                          .jerk_mm_s3 = 1e6,
                          .turn_speed_rad_s = 4.0,
                          .turn_accel_rad_s2 = 40.0,
                          .turn_jerk_rad_s3 = 2'000.0};

// With limited jerk a chain may take longer than its paths one by one, because each of these has its own tau.
constexpr double kMaxLoss = 1.05;

bool any_rounded(const CartesianPlan& plan) {
  for (std::size_t i = 1; i < plan.count; ++i) {
    if (plan.segments[i].start < end_of(plan.segments[i - 1])) return true;
  }
  return false;
}

std::int64_t ticks(PathRig& rig, const JointAngles& start, std::vector<SegmentRequest> chain, double blend_mm) {
  for (SegmentRequest& request : chain) request.blend_mm = blend_mm;
  return rig.plan(start, chain) == Progress::kDone ? rig.planner.plan().duration.value() : -1;
}

// From the tool's place at kReady through `points` in its horizontal plane.
std::vector<SegmentRequest> polygon(const PathRig& rig, const std::vector<Eigen::Vector2d>& points,
                                    ProfileKind profile = ProfileKind::kTrapezoid) {
  std::vector<SegmentRequest> chain;
  const Transform start = rig.tool_at(kReady);
  for (const Eigen::Vector2d& p : points) chain.push_back(line_to(moved(start, p.x(), p.y(), 0), kPen, 0.0, profile));
  return chain;
}

std::vector<Eigen::Vector2d> star(double radius_mm) {
  std::vector<Eigen::Vector2d> points;
  for (int i = 1; i <= 5; ++i) {
    const double phi = 0.8 * std::numbers::pi * i;
    points.emplace_back(radius_mm * (std::cos(phi) - 1.0), radius_mm * std::sin(phi));
  }
  return points;
}

// The corner point of two lines is missed by exactly blend_mm where half of the shorter line allows it, otherwise by
// what that allows: 3/16 of it for a unit change of direction.
TEST(BlendGain, TheTrapezoidUsesTheWholeToleranceOfACorner) {
  PathRig rig{test::irb120()};
  for (const double turn : {0.2, 1.0, 0.5 * std::numbers::pi, 2.5}) {
    for (const double blend_mm : {0.01, 0.5, 5.0, 100.0}) {
      const Eigen::Vector2d corner{60, 0};
      const auto chain = polygon(rig, {corner, corner + 40.0 * Eigen::Vector2d{std::cos(turn), std::sin(turn)}});
      ASSERT_GT(ticks(rig, kReady, chain, blend_mm), 0);
      const CartesianPlan& plan = rig.planner.plan();
      double nearest_mm = 1e9;
      for (std::int64_t tick = 0; tick < 4 * plan.duration.value(); ++tick) {
        const Transform pose = tool_pose(plan, static_cast<double>(tick) * 0.25 * kTickSeconds);
        nearest_mm = std::min(nearest_mm, (pose.position_mm - chain[0].target.position_mm).norm());
      }
      const double most_mm = 20.0 * 3.0 / 16.0 * 2.0 * std::sin(0.5 * turn);
      EXPECT_NEAR(nearest_mm, std::min(blend_mm, most_mm), 1e-3) << turn << " " << blend_mm;
      const test::ToolPeaks peaks = test::tool_peaks(plan, kPen);
      EXPECT_GT(peaks.accel, 0.99);
      EXPECT_LE(peaks.accel, 1.001);
    }
  }
}

TEST(BlendGain, AStarIsFasterWithRoundedCorners) {
  PathRig rig{test::irb120()};
  const auto chain = polygon(rig, star(10.0));
  const std::int64_t exact = ticks(rig, kReady, chain, 0.0), blended = ticks(rig, kReady, chain, 1.5);
  ASSERT_GT(blended, 0);
  EXPECT_LT(static_cast<double>(blended), 0.96 * static_cast<double>(exact));  // sharp: |t2 - t1| = 1.9
}

TEST(BlendGain, AnyToleranceAndAnyAngleGainOrStop) {
  for (const ProfileKind profile : {ProfileKind::kTrapezoid, ProfileKind::kSCurve}) {
    PathRig rig{test::irb120()};
    for (const double turn : {0.0, 0.5, 1.0, 0.5 * std::numbers::pi, 2.5, std::numbers::pi}) {
      const Eigen::Vector2d corner{8, 0};
      const auto chain =
          polygon(rig, {corner, corner + 8.0 * Eigen::Vector2d{std::cos(turn), std::sin(turn)}}, profile);
      const std::int64_t exact = ticks(rig, kReady, chain, 0.0);
      std::int64_t last = exact;
      for (const double blend_mm : {0.001, 0.01, 0.1, 1.0, 3.0, 100.0}) {
        const std::int64_t blended = ticks(rig, kReady, chain, blend_mm);
        EXPECT_GT(blended, 0);
        if (profile == ProfileKind::kTrapezoid) {
          // Straight on the tool passes in any case, and back it rests in any case.
          const bool gains = turn > 0.0 && turn < std::numbers::pi;
          EXPECT_LE(blended, exact) << turn << " " << blend_mm;
          EXPECT_LE(blended, last + 2) << turn << " " << blend_mm;
          EXPECT_EQ(blended < exact, gains) << turn << " " << blend_mm;
          EXPECT_EQ(any_rounded(rig.planner.plan()), turn < std::numbers::pi) << turn << " " << blend_mm;
        } else {
          // A corner with a micrometre of room is passed as slowly as an exact stop.
          EXPECT_LE(static_cast<double>(blended), kMaxLoss * static_cast<double>(exact)) << turn << " " << blend_mm;
          const bool gains = blend_mm > 0.5 && turn > 0.0 && turn < 3.0;
          EXPECT_TRUE(blended < exact || !gains) << turn << " " << blend_mm;
        }
        last = blended;
      }
    }
  }
}

TEST(BlendGain, RoundedSCurvesKeepTheJerkOfMoveAndTurn) {
  int rounded_moves = 0, rounded_turns = 0;
  for (const bool turns : {false, true}) {
    for (const double bend : {0.0, 0.4, 0.8}) {
      for (const double blend_mm : {0.5, 2.0, 5.0, 10.0}) {
        PathRig rig{test::irb120()};
        const Transform start = rig.tool_at(kReady);
        PathLimits limits = kPen;
        if (turns) {
          limits.turn_speed_rad_s = 0.4;
          limits.turn_accel_rad_s2 = 4.0;
          limits.turn_jerk_rad_s3 = 200.0;
        }
        const Eigen::Vector3d axis{std::sin(bend), 0, std::cos(bend)};
        Transform corner = moved(start, 30, 0, 0);
        Transform end = moved(corner, 30 * std::cos(bend), 30 * std::sin(bend), 0);
        if (turns) {
          corner = test::turned_by(corner, 0.3, {0, 0, 1});
          end.rotation = test::turned_by(corner, 0.3, axis).rotation;
        }
        const std::vector<SegmentRequest> chain{line_to(corner, limits, blend_mm, ProfileKind::kSCurve),
                                                line_to(end, limits, 0.0, ProfileKind::kSCurve)};
        ASSERT_EQ(rig.plan(kReady, chain), Progress::kDone);
        (turns ? rounded_turns : rounded_moves) += any_rounded(rig.planner.plan()) ? 1 : 0;
        const test::ToolJerks jerks = test::tool_jerks(rig.planner.plan(), limits);
        EXPECT_LE(jerks.move, 1.05) << turns << " " << bend << " " << blend_mm;
        EXPECT_LE(jerks.turn, 1.05) << turns << " " << bend << " " << blend_mm;
        EXPECT_GT(std::max(jerks.move, jerks.turn), 0.4);
      }
    }
  }
  EXPECT_GE(rounded_moves, 6);
  EXPECT_GE(rounded_turns, 6);
}

// The time of random chains with blends over that with exact stops. Arcs, turns, limits that differ from segment to
// segment, and joints that need more time. `profile`: of a segment; chosen at random if there is none.
struct Ratios {
  double largest = 0.0, mean = 0.0;
  int compared = 0;
};
Ratios blended_over_exact(std::optional<ProfileKind> profile) {
  constexpr std::uint64_t kSeed = 61;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  test::Random random{kSeed};
  PathRig rig{test::irb120(), 20.0, Transform{Eigen::Matrix3d::Identity(), {15, 0, 40}}};
  Ratios ratios;
  for (int draw = 0; draw < test::draws(60); ++draw) {
    JointAngles start = kReady;
    for (Radians& joint : start) joint += Radians{random.real(-0.6, 0.6)};
    Transform at = rig.tool_at(start);
    std::vector<SegmentRequest> chain;
    const std::int64_t count = random.integer(2, 5);
    for (std::int64_t i = 0; i < count; ++i) {
      PathLimits limits = test::kBrisk;
      limits.speed_mm_s *= random.real(0.1, 1.0);
      limits.accel_mm_s2 *= random.real(0.1, 2.0) * (draw % 2 == 0 ? 1.0 : 8.0);  // too much for the joints
      const auto drawn = random.integer(0, 2) == 0 ? ProfileKind::kSCurve : ProfileKind::kTrapezoid;
      const ProfileKind kind = profile.value_or(drawn);
      const auto step = [&] {
        return Eigen::Vector3d{random.real(-15, 15), random.real(-15, 15), random.real(-15, 15)};
      };
      const Eigen::Vector3d via = at.position_mm + step();
      const std::int64_t shape = random.integer(0, 3);
      at.position_mm += step();
      if (shape == 0) {  // into variables: each compiler has its own order of arguments
        const Eigen::Vector3d axis = step();
        const double angle = random.real(0.0, 0.4);
        at = test::turned_by(at, angle, axis);
      }
      chain.push_back(shape == 1 ? test::arc_to(via, at, limits, 0.0, kind) : line_to(at, limits, 0.0, kind));
    }
    const std::int64_t exact = ticks(rig, start, chain, 0.0);
    if (exact < 0) continue;
    const std::int64_t blended = ticks(rig, start, chain, random.real(0.0, 6.0));
    EXPECT_GT(blended, 0) << "chain " << draw;
    const double ratio = static_cast<double>(blended) / static_cast<double>(exact);
    ratios.largest = std::max(ratios.largest, ratio);
    ratios.mean += ratio;
    ++ratios.compared;
  }
  ratios.mean /= ratios.compared;
  testing::Test::RecordProperty("largest", std::to_string(ratios.largest));
  testing::Test::RecordProperty("mean", std::to_string(ratios.mean));
  EXPECT_GT(ratios.compared, test::least(40));
  return ratios;
}

TEST(BlendGain, RandomTrapezoidsGainAndNoneLoses) {
  const Ratios ratios = blended_over_exact(ProfileKind::kTrapezoid);
  EXPECT_LE(ratios.largest, 1.0);
  EXPECT_LE(ratios.mean, 0.89);
}

// One tau for a whole motion costs most where its paths have very different limits and its corners are very small.
TEST(BlendGain, RandomSCurvesGainOnTheAverage) {
  const Ratios ratios = blended_over_exact(ProfileKind::kSCurve);
  EXPECT_LE(ratios.largest, 1.36);
  EXPECT_LE(ratios.mean, 0.93);
}

TEST(BlendGain, RandomChainsOfBothProfilesGainOnTheAverage) {
  const Ratios ratios = blended_over_exact(std::nullopt);
  EXPECT_LE(ratios.largest, 1.47);
  EXPECT_LE(ratios.mean, 0.98);
}

}  // namespace
}  // namespace armature
