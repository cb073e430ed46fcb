// The geometry of a chain: which joints are passed, and the shape of rounded corners.
#include "controller/trajectory/cartesian/path_corners.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "controller/trajectory/cartesian/path_layout.hpp"
#include "tests/controller/support/path_rig.hpp"

namespace armature {
namespace {

using test::kBrisk;
using test::kReady;
using test::line_to;
using test::moved;
using test::turned_by;

struct Rig {
  Arm arm{test::irb120()};
  ArmPlane plane{test::irb120().arm, Transform{}};
  Transform start = arm.forward(kReady);
  CartesianPlan plan;

  void lay_out(const std::vector<SegmentRequest>& chain, bool rounds = true) {
    ASSERT_EQ(lay_out_path(plan, plane, kReady, start, chain).kind, PathProblem::Kind::kNone);
    lay_out_corners(plan, chain, rounds);
  }
  [[nodiscard]] Eigen::Vector3d at(double s) const { return tool_on_path(plan, s).tool.base_T_tool.position_mm; }
};

// Two lines of 40 mm and 60 mm.
std::vector<SegmentRequest> bend(const Transform& start, double angle_rad, double blend_mm, double turn_rad = 0.0) {
  const Transform corner = moved(start, 0, 40, 0);
  const Transform end = moved(corner, 60 * std::sin(angle_rad), 60 * std::cos(angle_rad), 0);
  return {line_to(corner, kBrisk, blend_mm), line_to(turned_by(end, turn_rad, {0, 0, 1}), kBrisk)};
}
// A line of 40 mm and a half circle that leaves it at a right angle or, `tangent`, in its direction.
std::vector<SegmentRequest> bow(const Transform& start, bool tangent, double blend_mm) {
  const Transform corner = moved(start, 0, 40, 0);
  const Eigen::Vector3d via{20, tangent ? 20.0 : 0.0, tangent ? 0.0 : 20.0};
  return {line_to(corner, kBrisk, blend_mm), test::arc_to(corner.position_mm + via, moved(corner, 40, 0, 0), kBrisk)};
}

TEST(PathCorners, PassesWhereTheDirectionGoesOnAndStopsWhereItBreaks) {
  Rig rig;
  const auto joint = [&](const std::vector<SegmentRequest>& chain) {
    rig.lay_out(chain);
    return joint_after(rig.plan, 0);
  };
  for (const double blend_mm : {0.0, 5.0}) {
    const PathJoint bent = blend_mm > 0.0 ? PathJoint::kRounded : PathJoint::kStop;
    EXPECT_EQ(joint(bend(rig.start, 0.0, blend_mm)), PathJoint::kSmooth);
    EXPECT_EQ(joint(bend(rig.start, 0.9e-3, blend_mm)), PathJoint::kSmooth);
    EXPECT_EQ(joint(bow(rig.start, true, blend_mm)), PathJoint::kSmooth);
    EXPECT_EQ(joint(bend(rig.start, 1.1e-3, blend_mm)), bent);
    EXPECT_EQ(joint(bend(rig.start, 1.5, blend_mm)), bent);
    EXPECT_EQ(joint(bow(rig.start, false, blend_mm)), bent);
    EXPECT_EQ(joint(bend(rig.start, 0.0, blend_mm, 0.5)), bent) << "begins to turn";
    EXPECT_EQ(joint(bend(rig.start, std::numbers::pi, blend_mm)), PathJoint::kStop) << "reverses";
    const Transform corner = moved(rig.start, 0, 40, 0);
    EXPECT_EQ(joint({line_to(corner, kBrisk, blend_mm), line_to(turned_by(corner, 0.3, {0, 0, 1}), kBrisk)}),
              PathJoint::kStop)
        << "only turns";
  }
  rig.lay_out(bend(rig.start, 1.5, 5.0), false);
  EXPECT_EQ(joint_after(rig.plan, 0), PathJoint::kStop);
}

TEST(PathCorners, APathBeginsAndEndsExactlyAtItsPosesAndIsAsLongAsItsSegments) {
  Rig rig;
  const auto chain = bend(rig.start, 1.0, 5.0, 0.7);
  rig.lay_out(chain);
  EXPECT_NEAR(length_of(rig.plan), 100.0, 1e-9);
  EXPECT_EQ(rig.at(0.0), rig.start.position_mm);
  EXPECT_EQ(rig.at(length_of(rig.plan)), chain[1].target.position_mm);
  EXPECT_EQ(tool_on_path(rig.plan, length_of(rig.plan)).rotation, chain[1].target.rotation);
  const Transform turned = turned_by(rig.start, 0.5, {0, 0, 1});
  rig.lay_out({line_to(turned, kBrisk)});
  EXPECT_NEAR(length_of(rig.plan), 0.5 * kTurnLever_mm, 1e-9);
  EXPECT_EQ(tool_on_path(rig.plan, length_of(rig.plan)).rotation, turned.rotation);
}

TEST(PathCorners, DirectionAndCurvatureAreContinuousThroughCorners) {
  Rig rig;
  for (const auto& chain : {bend(rig.start, 1.0, 2.0), bend(rig.start, 2.5, 2.0), bow(rig.start, false, 2.0)}) {
    rig.lay_out(chain);
    const double c = rig.plan.segments[0].corner;
    ASSERT_GT(c, 1.0);
    const double h = 1e-3 * c;
    const auto slope = [&](double s) -> Eigen::Vector3d { return (rig.at(s + h) - rig.at(s - h)) / (2.0 * h); };
    const auto curve = [&](double s) -> Eigen::Vector3d {
      return (rig.at(s + h) - 2.0 * rig.at(s) + rig.at(s - h)) / (h * h);
    };
    Eigen::Vector3d last_slope = slope(40.0 - 1.2 * c), last_curve = curve(40.0 - 1.2 * c);
    const double step = 0.01 * c;
    double most = 0.0;
    for (double s = 40.0 - 1.2 * c + step; s < 40.0 + 1.2 * c; s += step) {
      ASSERT_LT((slope(s) - last_slope).norm(), 2.0 * step / c) << s;
      // The curvature of a corner rises and falls by 1.5 |t2 - t1| / 2 c within a quarter of its length each.
      ASSERT_LT((curve(s) - last_curve).norm(), 0.15 / c) << s;
      last_slope = slope(s);
      last_curve = curve(s);
      most = std::max(most, last_curve.norm());
    }
    EXPECT_GT(most, 0.5 / c);
  }
}

// The distance of a point from the two segments, from dense samples.
double off_path(const CartesianPlan& plan, const Eigen::Vector3d& p) {
  double least = 1e9;
  for (std::size_t i = 0; i < plan.count; ++i) {
    for (int k = 0; k <= 4'000; ++k) least = std::min(least, (p - point(plan.segments[i].path, k / 4'000.0)).norm());
  }
  return least;
}

TEST(PathCorners, LeaveThePathAndTheCornerPointByBlendMm) {
  Rig rig;
  for (const double blend_mm : {0.1, 1.0, 3.0}) {
    for (const auto& chain : {bend(rig.start, 0.5, blend_mm), bend(rig.start, 1.5, blend_mm),
                              bend(rig.start, 2.5, blend_mm), bow(rig.start, false, blend_mm)}) {
      rig.lay_out(chain);
      const double c = rig.plan.segments[0].corner;
      ASSERT_LE(c, 20.0);
      const Eigen::Vector3d corner = chain[0].target.position_mm;
      double nearest = 1e9, farthest = 0.0;
      for (int k = 0; k <= 60; ++k) {
        const Eigen::Vector3d p = rig.at(40.0 - c + 2.0 * c * k / 60.0);
        nearest = std::min(nearest, (p - corner).norm());
        farthest = std::max(farthest, off_path(rig.plan, p));
      }
      EXPECT_LE(std::max(nearest, farthest), blend_mm * 1.001 + 1e-3);
      if (c < 19.9) {
        EXPECT_GE(std::max(nearest, farthest), blend_mm * 0.98);
      }
    }
  }
}

TEST(PathCorners, KeepTheOrientationAsWellAsAPointAtTheLever) {
  Rig rig;
  for (const double turn_rad : {0.1, 1.0, 3.0}) {
    const double blend_mm = 1.0;
    rig.lay_out(bend(rig.start, 0.2, blend_mm, turn_rad));
    const Eigen::Matrix3d off = tool_on_path(rig.plan, 40.0).rotation * rig.start.rotation.transpose();
    EXPECT_LE(Eigen::AngleAxisd{off}.angle() * kTurnLever_mm, 1.001 * blend_mm) << turn_rad;
    EXPECT_GT(rig.plan.segments[0].corner, 0.0);
  }
}

TEST(PathCorners, TwoCornersShareASegment) {
  Rig rig;
  const Transform a = moved(rig.start, 0, 40, 0), b = moved(a, 10, 0, 0), c = moved(b, 0, 40, 0);
  rig.lay_out({line_to(a, kBrisk, 50.0), line_to(b, kBrisk, 50.0), line_to(c, kBrisk)});
  EXPECT_NEAR(rig.plan.segments[0].corner, 5.0, 1e-9);
  EXPECT_NEAR(rig.plan.segments[1].corner, 5.0, 1e-9);
  for (double s = 30.0; s < 60.0; s += 0.01) ASSERT_LT((rig.at(s + 0.01) - rig.at(s)).norm(), 0.0101) << s;
}

}  // namespace
}  // namespace armature
