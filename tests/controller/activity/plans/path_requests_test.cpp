#include "controller/activity/plans/stages/path_requests.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "controller/kinematics/five_r.hpp"

#include "tests/controller/support/command_geometry.hpp"

namespace armature {
namespace {

using test::kQuarter;
using test::kSixAxes;

const Transform kStart{.position_mm = {100, 200, 300}};

CartesianMove line_to(FramedPose target, double blend_mm = 0.0) {
  return {.target = std::move(target), .blend_mm = blend_mm};
}

CartesianMove arc_to(FramedPose target, const Eigen::Vector3d& via_mm) {
  return {.kind = SegmentRequest::Kind::kArc, .target = std::move(target), .via_mm = via_mm};
}

bool accepts(const PathRequests& chain, const CartesianMove& move) {
  return chain.accepts(move, {}, kSixAxes);
}

TEST(PathRequests, AcceptsAnyFirstMoveAndAnyMoveAfterABlend) {
  PathRequests chain;
  chain.restart(kStart);
  EXPECT_TRUE(chain.empty());
  EXPECT_TRUE(accepts(chain, line_to({.position_mm = {1, 0, 0}})));
  chain.add(line_to({.position_mm = {1, 0, 0}}, 5.0), {}, kSixAxes);
  EXPECT_FALSE(chain.empty());
  EXPECT_TRUE(accepts(chain, line_to({.position_mm = {2, 7, 0}})));
  chain.add(line_to({.position_mm = {2, 7, 0}}), {}, kSixAxes);
  EXPECT_FALSE(accepts(chain, line_to({.position_mm = {1, 0, 0}})));
}

TEST(PathRequests, WithoutABlendAcceptsOnlyAMoveThatGoesOnInTheSameDirection) {
  const Eigen::Vector3d corner = kStart.position_mm + Eigen::Vector3d{50, 0, 0};
  const auto from_corner = [&](double x, double y, double z) {
    return FramedPose{.position_mm = corner + Eigen::Vector3d{x, y, z}};
  };
  PathRequests chain;
  chain.restart(kStart);
  chain.add(line_to(from_corner(0, 0, 0)), {}, kSixAxes);
  EXPECT_TRUE(accepts(chain, line_to(from_corner(20, 0, 0))));
  EXPECT_TRUE(accepts(chain, line_to(from_corner(20, 0.019, 0))));
  EXPECT_FALSE(accepts(chain, line_to(from_corner(20, 0.021, 0))));
  EXPECT_FALSE(accepts(chain, line_to(from_corner(-20, 0, 0))));
  EXPECT_FALSE(accepts(chain, line_to(from_corner(0, 0, 0))));                                      // no direction
  EXPECT_FALSE(accepts(chain, arc_to(from_corner(20, 0, 0), corner + Eigen::Vector3d{10, 0, 0})));  // no circle
  const Eigen::Vector3d via = corner + Eigen::Vector3d{10 * std::sqrt(0.5), 10 - 10 * std::sqrt(0.5), 0};
  const CartesianMove quarter = arc_to(from_corner(10, 10, 0), via);
  ASSERT_TRUE(accepts(chain, quarter));
  chain.add(quarter, {}, kSixAxes);
  EXPECT_TRUE(accepts(chain, line_to(from_corner(10, 30, 0))));
  EXPECT_FALSE(accepts(chain, line_to(from_corner(20, 20, 0))));
}

TEST(PathRequests, AcceptsNothingAfterAnExactStop) {
  PathRequests chain;
  chain.restart(kStart);
  CartesianMove move = line_to({.frame = kToolFrame, .position_mm = {1, 0, 0}});
  move.exact_stop = true;
  chain.add(move, {}, kSixAxes);
  EXPECT_FALSE(accepts(chain, line_to({.frame = kToolFrame, .position_mm = {1, 0, 0}})));
  chain.restart(kStart);
  EXPECT_TRUE(accepts(chain, move));
}

TEST(PathRequests, TakesAsManyMovesAsAFirstPlanHas) {
  PathRequests chain;
  chain.restart(kStart);
  std::size_t added = 0;
  const CartesianMove move = line_to({.position_mm = {1, 0, 0}}, 1.0);
  for (; accepts(chain, move) && added < 100; ++added) chain.add(move, {}, kSixAxes);
  EXPECT_EQ(added, CartesianPlan::kMaxFirstSegments);
  EXPECT_EQ(chain.requests().size(), CartesianPlan::kMaxFirstSegments);
}

TEST(PathRequests, TheLastMoveStopsExactlyAndIsBlendedAsSoonAsAnotherOneFollows) {
  PathRequests chain;
  chain.restart(kStart);
  chain.add(line_to({.position_mm = {1, 0, 0}}, 5.0), {}, kSixAxes);
  EXPECT_EQ(chain.requests()[0].blend_mm, 0.0);
  chain.add(line_to({.position_mm = {2, 0, 0}}, 7.0), {}, kSixAxes);
  EXPECT_EQ(chain.requests()[0].blend_mm, 5.0);
  EXPECT_EQ(chain.requests()[1].blend_mm, 0.0);
}

TEST(PathRequests, RelativeMovesBeginWhereTheOneBeforeEnds) {
  PathRequests chain;
  chain.restart(kStart);
  chain.add(line_to({.frame = kToolFrame, .position_mm = {10, 0, 0}, .rotation = kQuarter}, 1.0), {}, kSixAxes);
  chain.add(line_to({.frame = kToolFrame, .position_mm = {10, 0, 0}}, 1.0), {}, kSixAxes);
  chain.add(line_to({.position_mm = {0, 0, 0}}), {}, kSixAxes);
  const auto requests = chain.requests();
  EXPECT_EQ(requests[0].target.position_mm, Eigen::Vector3d(110, 200, 300));
  EXPECT_EQ(requests[1].target.position_mm, Eigen::Vector3d(110, 210, 300));  // x of the tool points to y by then
  EXPECT_EQ(requests[1].target.rotation, kQuarter);
  EXPECT_EQ(requests[2].target.position_mm, Eigen::Vector3d(0, 0, 0));
  EXPECT_EQ(requests[2].target.rotation, kQuarter);
}

TEST(PathRequests, ThePointsOfAnArcShareItsFrame) {
  UserFrames frames{};
  frames[0] = Transform{.rotation = kQuarter, .position_mm = {1000, 0, 0}};
  PathRequests chain;
  chain.restart(kStart);
  chain.add({.kind = SegmentRequest::Kind::kArc,
             .target = {.frame = FrameId{1}, .position_mm = {1, 0, 0}},
             .via_mm = {0, 1, 0}},
            frames, kSixAxes);
  EXPECT_EQ(chain.requests()[0].kind, SegmentRequest::Kind::kArc);
  EXPECT_EQ(chain.requests()[0].via_mm, Eigen::Vector3d(999, 0, 0));
  EXPECT_EQ(chain.requests()[0].target.position_mm, Eigen::Vector3d(1000, 1, 0));
}

TEST(PathRequests, AfterACircleTheToolIsWhereItBeganAndTurnedAsAsked) {
  PathRequests chain;
  chain.restart(kStart);
  chain.add({.kind = SegmentRequest::Kind::kCircle,
             .target = {.frame = kToolFrame, .position_mm = {10, 10, 0}, .rotation = kQuarter},
             .via_mm = {10, 0, 0},
             .blend_mm = 1.0},
            {}, kSixAxes);
  chain.add(line_to({.frame = kToolFrame, .position_mm = {5, 0, 0}}), {}, kSixAxes);
  const auto requests = chain.requests();
  EXPECT_EQ(requests[0].via_mm, Eigen::Vector3d(110, 200, 300));
  EXPECT_EQ(requests[0].target.position_mm, Eigen::Vector3d(110, 210, 300));  // its third point
  EXPECT_EQ(requests[1].target.position_mm, Eigen::Vector3d(100, 205, 300));
  EXPECT_EQ(requests[1].target.rotation, kQuarter);
}

// The arm of Hu 2012; its hand reaches forwards and down, in the plane of axis 1.
const ArmGeometry kFiveAxes{
    .family = ArmFamily::kFiveR, .a1_mm = 11.0, .a2_mm = 100.0, .a3_mm = 95.0, .a4_mm = 32.0, .d5_mm = 145.0};
const ArmPlane kPlane{kFiveAxes, {}};
const Transform kTilted = FiveR{kFiveAxes}.to_transform({.x_mm = 200, .z_mm = -50, .pitch_rad = -0.7, .roll_rad = 0.2});

TEST(PathRequests, RelativeMovesOfATiltedFiveAxisHandFollowTheArmRound) {
  PathRequests chain;
  chain.restart(kTilted);
  chain.add(line_to({.position_mm = {0, 200, -50}}, 1.0), {}, kPlane);
  chain.add(line_to({.frame = kToolFrame, .position_mm = {1, 2, 3}}), {}, kPlane);
  // A quarter turn on, and the tool's frame with it.
  const Eigen::Matrix3d there = kQuarter * kTilted.rotation;
  const auto requests = chain.requests();
  EXPECT_TRUE(requests[0].keeps_orientation);
  EXPECT_LT((requests[0].target.rotation - there).norm(), 1e-14);
  const Eigen::Vector3d expected = Eigen::Vector3d{0, 200, -50} + there * Eigen::Vector3d{1, 2, 3};
  EXPECT_LT((requests[1].target.position_mm - expected).norm(), 1e-12);
}

TEST(PathRequests, ACircleOfATiltedFiveAxisHandEndsTurnedAsItBegan) {
  PathRequests chain;
  chain.restart(kTilted);
  chain.add(
      {.kind = SegmentRequest::Kind::kCircle, .target = {.position_mm = {180, -60, -50}}, .via_mm = {180, 60, -50}}, {},
      kPlane);
  EXPECT_EQ(chain.requests()[0].target.rotation, kTilted.rotation);
}

TEST(PathRequests, KnowsTheTimeOfItsMovesAtTheSpeedsOfTheirLimits) {
  constexpr PathLimits kLimits{.speed_mm_s = 10.0, .turn_speed_rad_s = 0.5};
  PathRequests chain;
  chain.restart(kStart);
  CartesianMove line = line_to({.position_mm = kStart.position_mm + Eigen::Vector3d{0, 30, 40}}, 1.0);
  CartesianMove circle{.kind = SegmentRequest::Kind::kCircle,
                       .target = {.position_mm = kStart.position_mm + Eigen::Vector3d{20, 30, 40}},
                       .via_mm = kStart.position_mm + Eigen::Vector3d{10, 40, 40}};
  CartesianMove turn = line_to({.position_mm = line.target.position_mm, .rotation = kStart.rotation * kQuarter}, 1.0);
  for (CartesianMove* move : {&line, &circle, &turn}) {
    move->limits = kLimits;
    chain.add(*move, {}, kSixAxes);
  }
  EXPECT_EQ(chain.least_s(0), 0.0);
  EXPECT_NEAR(chain.least_s(1), 5.0, 1e-12);
  const double around_s = 2.0 * std::numbers::pi;
  EXPECT_NEAR(chain.least_s(2), 5.0 + around_s, 1e-12);
  // A quarter turn takes pi s. The angle is taken for twice the sine of its half, 0.90 of it.
  EXPECT_NEAR(chain.least_s(3), 5.0 + around_s + 0.900316 * std::numbers::pi, 1e-6);
  chain.drop_front(1);
  EXPECT_NEAR(chain.least_s(1), around_s, 1e-12);
  EXPECT_NEAR(chain.least_s(2), around_s + 0.900316 * std::numbers::pi, 1e-6);
  chain.add(line, {}, kSixAxes);
  EXPECT_NEAR(chain.least_s(3) - chain.least_s(2), 0.0, 1e-12);  // the tool is there
}

TEST(PathRequests, ARestartForgetsWhatWas) {
  PathRequests chain;
  chain.restart(kStart);
  chain.add(line_to({.position_mm = {1, 0, 0}}, 5.0), {}, kSixAxes);
  chain.clear();
  EXPECT_TRUE(chain.empty());
  chain.restart({.position_mm = {7, 8, 9}});
  chain.add(line_to({.frame = kToolFrame, .position_mm = {1, 0, 0}}), {}, kSixAxes);
  ASSERT_EQ(chain.requests().size(), 1u);
  EXPECT_EQ(chain.requests()[0].target.position_mm, Eigen::Vector3d(8, 8, 9));
}

}  // namespace
}  // namespace armature
