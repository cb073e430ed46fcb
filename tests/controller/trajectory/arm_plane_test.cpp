#include "controller/trajectory/path/arm_plane.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <string>

#include "controller/kinematics/five_r.hpp"
#include "tests/controller/support/five_r_rig.hpp"

namespace armature {
namespace {

using test::hu_arm;
using test::kPi;
using test::Random;

Transform random_tool(Random& random) {
  return {rotation_from_rpy(random.real(-1, 1), random.real(-1, 1), random.real(-3, 3)),
          {random.real(-5, 5), random.real(-5, 5), random.real(-5, 5)}};
}

// Joints give the pose; nothing of this file's subject is in the product of links.
TEST(ArmPlane, FindsTheAnglesOfEveryPoseThatTheArmCanHold) {
  constexpr std::uint64_t kSeed = 81;
  Random random{kSeed};
  for (int draw = 0; draw < 500; ++draw) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", draw " + std::to_string(draw));
    const Transform tool = random_tool(random);
    const ArmPlane plane{hu_arm(), tool};
    const Transform pose = test::product_of_links(hu_arm(), test::random_theta(random)) * tool;
    if (std::hypot(pose.position_mm.x(), pose.position_mm.y()) < 0.5) continue;
    const ArmPlane::Nearest nearest = plane.nearest(pose);
    ASSERT_LT(nearest.residual_rad, 1e-12);
    const HeldTool held = hold_tool(nearest.angles, pose.position_mm, tool);
    // x is a square root: digits are lost where it is small. The flange decides what the arm can hold.
    ASSERT_EQ(held.missing_mm, 0.0);
    ASSERT_LT((held.base_T_tool.rotation - pose.rotation).norm(), 1e-11);
    ASSERT_EQ(held.base_T_tool.position_mm, pose.position_mm);
  }
}

TEST(ArmPlane, HoldsTheToolPointExactlyWithTheFlangeInThePlane) {
  constexpr std::uint64_t kSeed = 82;
  Random random{kSeed};
  for (int draw = 0; draw < 500; ++draw) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", draw " + std::to_string(draw));
    const Transform tool = random_tool(random);
    const PlaneAngles angles{random.real(-kPi, kPi), random.real(-kPi, kPi)};
    const Eigen::Vector3d point{random.real(-20, 20), random.real(-20, 20), random.real(-20, 20)};
    if (std::hypot(point.x(), point.y()) < 9.0) continue;
    const HeldTool held = hold_tool(angles, point, tool);
    ASSERT_EQ(held.missing_mm, 0.0);
    const Transform flange = held.base_T_tool * inverse(tool);
    const NearestPose5 pose = FiveR{hu_arm()}.from_transform(flange);
    ASSERT_LT(pose.residual_rad, 1e-13);
    // The tool point is before the arm that has these angles.
    const bool behind = std::cos(pose.pose.heading_rad) * point.x() + std::sin(pose.pose.heading_rad) * point.y() < 0;
    const double sign = behind ? -1.0 : 1.0;
    ASSERT_LT(std::fabs(std::remainder(sign * pose.pose.pitch_rad - angles.pitch_rad, 2 * kPi)), 1e-12);
    ASSERT_LT(std::fabs(std::remainder(pose.pose.roll_rad + (behind ? kPi : 0.0) - angles.roll_rad, 2 * kPi)), 1e-12);
  }
}

TEST(ArmPlane, TellsByHowMuchAToolIsTooFarAsideForItsPoint) {
  const Transform tool{.position_mm = {0, 5, 1}};
  // At a roll of 0 the tool's y axis is horizontal and normal to the plane.
  EXPECT_NEAR(hold_tool({-0.5, 0.0}, {3, 0, -7}, tool).missing_mm, 2.0, 1e-12);
  EXPECT_NEAR(hold_tool({-0.5, kPi / 6}, {3, 0, -7}, tool).missing_mm, 5.0 * std::cos(kPi / 6) - 3.0, 1e-12);
  EXPECT_EQ(hold_tool({-0.5, kPi / 2}, {3, 0, -7}, tool).missing_mm, 0.0);
  EXPECT_EQ(hold_tool({-0.5, 0.0}, {3, 4.001, -7}, tool).missing_mm, 0.0);
  EXPECT_TRUE(hold_tool({-0.5, 0.0}, {0, 0, 0}, {}).base_T_tool.rotation.allFinite());
}

// By no more than the approach is off the plane: at most its tilt, however near to axis 1 the point is.
TEST(ArmPlane, BringsAToolThatIsAlmostInThePlaneIntoItAndLeavesItsPoint) {
  constexpr std::uint64_t kSeed = 83;
  Random random{kSeed};
  int checked = 0;
  for (int draw = 0; draw < 500; ++draw) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", draw " + std::to_string(draw));
    const Transform tool = random_tool(random);
    const PlaneAngles angles{1e-4, random.real(-kPi, kPi)};
    const HeldTool start = hold_tool(angles, {random.real(0.5, 15), random.real(-5, 5), -3}, tool);
    const Transform& exact = start.base_T_tool;
    const Eigen::Vector3d flange = (exact * inverse(tool)).position_mm;
    if (start.missing_mm > 0.0 || std::hypot(flange.x(), flange.y()) < 0.5) continue;
    ++checked;
    ASSERT_LT((into_plane(exact, tool).base_T_tool.rotation - exact.rotation).norm(), 1e-12);
    Transform off = exact;
    off.rotation = Eigen::AngleAxisd{1e-4, Eigen::Vector3d{random.real(-1, 1), random.real(-1, 1), 1}.normalized()} *
                   exact.rotation;
    const HeldTool held = into_plane(off, tool);
    ASSERT_EQ(held.base_T_tool.position_mm, off.position_mm);
    const Eigen::Matrix3d turn = held.base_T_tool.rotation.transpose() * off.rotation;
    ASSERT_LT(Eigen::AngleAxisd{turn}.angle(), 2.001e-4);
    ASSERT_LT(FiveR{hu_arm()}.from_transform(held.base_T_tool * inverse(tool)).residual_rad, 1e-12);
  }
  EXPECT_GT(checked, 300);
}

TEST(ArmPlane, KeepsAnUprightHandInSpaceAndPitchAndRollOfATiltedOne) {
  const ArmPlane plane{hu_arm(), {}};
  const Eigen::Vector3d from{20, 0, -3}, to{0, 20, 4};
  const auto at = [&](double pitch) { return hold_tool({pitch, 0.4}, from, {}).base_T_tool; };
  for (const double upright : {0.0, kPi, 1e-4})
    EXPECT_EQ(plane.kept(at(upright), to, true), at(upright).rotation) << upright;
  for (const double tilted : {2e-4, -0.5, kPi - 2e-4}) {
    const Eigen::Matrix3d quarter = Eigen::AngleAxisd{kPi / 2, Eigen::Vector3d::UnitZ()}.toRotationMatrix();
    EXPECT_LT((plane.kept(at(tilted), to, true) - quarter * at(tilted).rotation).norm(), 1e-14) << tilted;
  }
  // Over axis 1 a straight line leads without turning; any other way leads round.
  const Eigen::Vector3d behind{-15, 0, 4};
  EXPECT_EQ(plane.kept(at(-0.5), behind, true), at(-0.5).rotation);
  EXPECT_GT((plane.kept(at(-0.5), behind, false) - at(-0.5).rotation).norm(), 1.0);
  ArmGeometry six;
  six.family = ArmFamily::kSixR;
  EXPECT_EQ((ArmPlane{six, {}}.kept(at(-0.5), to, true)), at(-0.5).rotation);
}

TEST(ArmPlane, AnApproachAcrossThePlaneIsAQuarterTurnAway) {
  const ArmPlane plane{hu_arm(1.1, 3.0), {}};
  const Transform across{.rotation = Eigen::AngleAxisd{kPi / 2, Eigen::Vector3d::UnitX()}.toRotationMatrix(),
                         .position_mm = {20, 0, 0}};
  EXPECT_GE(plane.nearest(across).residual_rad, kPi / 2 - 1e-12);
}

}  // namespace
}  // namespace armature
