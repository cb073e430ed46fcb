// Joints 1 to 3 for a point of the hand, with joints 4 to 6 given.
#include <gtest/gtest.h>

#include <Eigen/SVD>

#include "controller/kinematics/arm.hpp"
#include "tests/controller/support/six_r_rig.hpp"

namespace armature {
namespace {

TEST(TrackPoint, BringsThePointOfTheHandToItsPlaceWithTheGivenWrist) {
  test::Random random{20'261'122};
  for (const ArmGeometry& geometry : test::vendor_arms()) {
    const Arm arm{test::robot_with(geometry)};
    int tried = 0;
    while (tried < 1000) {
      JointAngles there;
      for (Radians& joint : there) joint = Radians{random.real(-3.0, 3.0)};
      const Eigen::Vector3d tool{random.real(-60, 60), random.real(-60, 60), random.real(-20, 90)};
      const Eigen::Vector3d point = arm.forward(there) * tool;
      // Where joints 1 to 3 move the point in every direction, by numerical differences.
      Eigen::Matrix3d moves;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        JointAngles beside = there;
        beside[axis] += Radians{1e-6};
        moves.col(static_cast<Eigen::Index>(axis)) = (arm.forward(beside) * tool - point) / 1e-6;
      }
      if (moves.jacobiSvd().singularValues()(2) < 80.0) continue;
      ++tried;
      JointAngles near = there;
      for (std::size_t axis = 0; axis < 3; ++axis) near[axis] += Radians{random.real(-0.03, 0.03)};
      const IkTracking found = arm.track_point(point, tool, near);
      ASSERT_TRUE(solved(found.status));
      ASSERT_LT((arm.forward(found.joints) * tool - point).norm(), 1e-9);
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        ASSERT_NEAR(found.joints[axis].value(), there[axis].value(), 1e-9) << "the solution that it came from";
      }
    }
  }
}

TEST(TrackPoint, SaysHowFarThePointIsOutOfReach) {
  const Arm arm{test::robot_with(test::irb120_geometry())};
  const JointAngles near = test::degrees({0, 0, 0, 0, 0, 0});
  const IkTracking far = arm.track_point({2000, 0, 290}, {0, 0, 0}, near);
  EXPECT_EQ(far.status, IkStatus::kUnreachable);
  // The hand points forward, so forearm and hand are one link.
  EXPECT_NEAR(far.margin_mm, 2000 - 270 - std::hypot(70, 302 + 72), 1e-9);
  // A point 50 mm beside the plane of the arm cannot be 20 mm from axis 1.
  const IkTracking beside = arm.track_point({20, 0, 600}, {0, 50, 0}, near);
  EXPECT_EQ(beside.status, IkStatus::kUnreachable);
  EXPECT_NEAR(beside.margin_mm, 30, 1e-9);
}

}  // namespace
}  // namespace armature
