#include "controller/cell/frames.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/controller/support/command_geometry.hpp"

namespace armature {
namespace {

using test::kQuarter;
using test::kSixAxes;

// Half a turn about x: y and z are turned over.
const Eigen::Matrix3d kHalf = (Eigen::Matrix3d() << 1, 0, 0, 0, -1, 0, 0, 0, -1).finished();
const Transform kTool{.rotation = kHalf, .position_mm = {100, 200, 300}};

UserFrames one_frame() {
  UserFrames frames{};
  frames[2] = Transform{.rotation = kQuarter, .position_mm = {10, 20, 30}};
  return frames;
}

TEST(Frames, KnowsBaseToolAndTheUserFramesThatAreDefined) {
  const UserFrames frames = one_frame();
  EXPECT_TRUE(is_known(kBaseFrame, frames));
  EXPECT_TRUE(is_known(kToolFrame, frames));
  EXPECT_TRUE(is_known(FrameId{3}, frames));
  for (const int index : {1, 2, 4, 16, 17, 100, 254}) {
    EXPECT_FALSE(is_known(FrameId{static_cast<std::uint8_t>(index)}, frames)) << index;
  }
}

TEST(Frames, APoseInTheBaseIsTakenAsItIs) {
  const Transform pose = resolve({.position_mm = {1, 2, 3}, .rotation = kQuarter}, {}, kTool, kSixAxes, true);
  EXPECT_EQ(pose.position_mm, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(pose.rotation, kQuarter);
}

TEST(Frames, APoseInAUserFrameIsTurnedAndShiftedWithIt) {
  const Transform pose =
      resolve({.frame = FrameId{3}, .position_mm = {1, 2, 3}, .rotation = kHalf}, one_frame(), kTool, kSixAxes, true);
  EXPECT_EQ(pose.position_mm, Eigen::Vector3d(10 - 2, 20 + 1, 33));
  EXPECT_EQ(pose.rotation, kQuarter * kHalf);
}

TEST(Frames, APoseInTheToolFrameIsRelativeToTheTool) {
  const Transform pose =
      resolve({.frame = kToolFrame, .position_mm = {1, 2, 3}, .rotation = kQuarter}, {}, kTool, kSixAxes, true);
  EXPECT_EQ(pose.position_mm, Eigen::Vector3d(101, 198, 297));
  EXPECT_EQ(pose.rotation, kHalf * kQuarter);
}

TEST(Frames, WithoutARotationTheToolKeepsItsOrientationInSpaceWhateverTheFrame) {
  for (const FrameId frame : {kBaseFrame, FrameId{3}, kToolFrame}) {
    EXPECT_EQ(resolve({.frame = frame, .position_mm = {1, 2, 3}}, one_frame(), kTool, kSixAxes, true).rotation, kHalf);
  }
}

TEST(Frames, ARotationWithSixDecimalsComesOutOrthonormal) {
  Eigen::Matrix3d rough;
  rough << 0.866025, -0.5, 0, 0.5, 0.866025, 0, 0, 0, 1;
  const Eigen::Matrix3d fine = resolve({.rotation = rough}, {}, kTool, kSixAxes, true).rotation;
  const Eigen::Matrix3d error = fine.transpose() * fine - Eigen::Matrix3d::Identity();
  EXPECT_LT(error.cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_LT((fine - rough).cwiseAbs().maxCoeff(), 1e-6);
}

}  // namespace
}  // namespace armature
