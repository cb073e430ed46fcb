// Poses of a tool in a user frame, against Orocos KDL with the same chain and the same places.
#include "cosim/poses/pose_frames.hpp"

#include <gtest/gtest.h>

#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/frames.hpp>
#include <kdl/jntarray.hpp>

#include "controller/kinematics/arm.hpp"
#include "cosim/scenario/to_controller.hpp"
#include "tests/cosim/support/kinematics_oracle.hpp"

namespace armature::cosim {
namespace {

using armature::test::Random;

constexpr std::uint64_t kFramesSeed = 14;
constexpr int kFramesPoses = 500;

struct FramesPlace {
  PoseSpec spec;
  [[nodiscard]] Transform transform() const { return to_transform(spec); }
  [[nodiscard]] KDL::Frame kdl() const {
    const auto& [roll, pitch, yaw] = spec.rpy_deg;
    return {KDL::Rotation::RPY(roll * test::kRadPerDeg, pitch * test::kRadPerDeg, yaw * test::kRadPerDeg),
            KDL::Vector{spec.xyz_mm[0], spec.xyz_mm[1], spec.xyz_mm[2]}};
  }
};

FramesPlace random_place(Random& random, double far_mm) {
  FramesPlace place;
  for (double& mm : place.spec.xyz_mm) mm = random.real(-far_mm, far_mm);
  for (double& deg : place.spec.rpy_deg) deg = random.real(-180, 180);
  return place;
}

void expect_near(const Transform& pose, const KDL::Frame& expected, int number) {
  for (int row = 0; row < 3; ++row) {
    ASSERT_NEAR(pose.position_mm(row), expected.p(row), 1e-9) << "pose " << number << ", seed " << kFramesSeed;
    for (int column = 0; column < 3; ++column) {
      ASSERT_NEAR(pose.rotation(row, column), expected.M(row, column), 1e-12) << "pose " << number;
    }
  }
}

class PoseFramesKdl : public testing::TestWithParam<std::string> {};

TEST_P(PoseFramesKdl, ToolAndUserFrameGiveThePosesOfKdl) {
  const RobotSpec spec = test::load_project_robot(GetParam());
  const KDL::Chain chain = test::kdl_chain(*spec.kinematics);
  KDL::ChainFkSolverPos_recursive solver{chain};
  const Arm arm{to_robot_model(spec)};
  Random random{kFramesSeed};
  for (int i = 0; i < kFramesPoses; ++i) {
    const JointAngles joints = test::to_radians(test::random_joints_deg(random, spec));
    KDL::JntArray kdl_joints{static_cast<unsigned>(spec.axis_count)};
    for (std::size_t axis = 0; axis < spec.axis_count; ++axis) {
      kdl_joints(static_cast<unsigned>(axis)) = joints[axis].value();
    }
    KDL::Frame flange;
    ASSERT_GE(solver.JntToCart(kdl_joints, flange), 0);
    const FramesPlace tool = random_place(random, 200), user = random_place(random, 800);
    const Transform pose = arm.forward(joints);

    expect_near(PoseFrames{tool.transform(), {}}.shown(pose), flange * tool.kdl(), i);
    expect_near(PoseFrames{{}, user.transform()}.shown(pose), user.kdl().Inverse() * flange, i);
    const PoseFrames both{tool.transform(), user.transform()};
    const KDL::Frame user_T_tool = user.kdl().Inverse() * flange * tool.kdl();
    expect_near(both.shown(pose), user_T_tool, i);
    // The inverse kinematics of the pose that KDL computed find the joints of the flange.
    Transform wanted;
    for (int row = 0; row < 3; ++row) {
      wanted.position_mm(row) = user_T_tool.p(row);
      for (int column = 0; column < 3; ++column) wanted.rotation(row, column) = user_T_tool.M(row, column);
    }
    expect_near(both.flange(wanted), flange, i);
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, PoseFramesKdl, testing::ValuesIn(test::arms()),
                         [](const auto& suite) { return suite.param; });

TEST(PoseFrames, LeavePosesAsTheyAreWithoutToolAndFrame) {
  const Transform pose{rotation_from_rpy(0.1, -0.0, 2.0), {1.0, -0.0, 3.0}};
  EXPECT_EQ(PoseFrames{}.shown(pose).rotation, pose.rotation);
  EXPECT_EQ(PoseFrames{}.shown(pose).position_mm, pose.position_mm);
  EXPECT_EQ(PoseFrames{}.flange(pose).position_mm, pose.position_mm);
  EXPECT_EQ(PoseFrames{}.point() + " in " + PoseFrames{}.frame(), "flange in its base");
}

}  // namespace
}  // namespace armature::cosim
