// Every robot file against Orocos KDL: the same chain built by other code from the same numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainjnttojacsolver.hpp>
#include <kdl/jacobian.hpp>
#include <kdl/jntarray.hpp>

#include "controller/kinematics/arm.hpp"
#include "cosim/scenario/to_controller.hpp"
#include "tests/cosim/support/kinematics_oracle.hpp"

namespace armature::cosim {
namespace {

using armature::test::Random;

constexpr std::uint64_t kKdlSeed = 120;
constexpr int kKdlPoses = 500;

class RobotKdl : public testing::TestWithParam<std::string> {
 protected:
  [[nodiscard]] KDL::JntArray next_joints() {
    joints_deg_ = test::random_joints_deg(random_, spec_);
    KDL::JntArray joints{static_cast<unsigned>(spec_.axis_count)};
    for (std::size_t i = 0; i < spec_.axis_count; ++i) joints(static_cast<unsigned>(i)) = joints_rad()[i].value();
    return joints;
  }
  [[nodiscard]] JointAngles joints_rad() const { return test::to_radians(joints_deg_); }

  // Of the Jacobian's upper rows and of positions.
  static constexpr double kToleranceMm = 1e-9;
  static constexpr double kTolerance = 1e-12;

  RobotSpec spec_ = test::load_project_robot(GetParam());
  KDL::Chain chain_ = test::kdl_chain(*spec_.kinematics);
  Arm arm_{to_robot_model(spec_)};
  Random random_{kKdlSeed};
  PerAxis<double> joints_deg_{};
};

// Five joints have no rates for every velocity, and joint_rates() does not offer them.
class SixRKdl : public RobotKdl {};

std::vector<std::string> six_r_arms() {
  std::vector<std::string> names = test::arms();
  std::erase_if(
      names, [](const std::string& name) { return test::load_project_robot(name).kinematics->family != kSixRFamily; });
  return names;
}

TEST_P(RobotKdl, HasTheSamePoses) {
  KDL::ChainFkSolverPos_recursive solver{chain_};
  for (int i = 0; i < kKdlPoses; ++i) {
    KDL::Frame frame;
    ASSERT_GE(solver.JntToCart(next_joints(), frame), 0);
    const Transform pose = arm_.forward(joints_rad());
    for (int row = 0; row < 3; ++row) {
      ASSERT_NEAR(pose.position_mm(row), frame.p(row), kToleranceMm) << "pose " << i << ", seed " << kKdlSeed;
      for (int column = 0; column < 3; ++column) {
        ASSERT_NEAR(pose.rotation(row, column), frame.M(row, column), kTolerance) << "pose " << i;
      }
    }
  }
}

TEST_P(RobotKdl, HasTheSameJacobians) {
  KDL::ChainJntToJacSolver solver{chain_};
  KDL::Jacobian expected{chain_.getNrOfJoints()};
  for (int i = 0; i < kKdlPoses; ++i) {
    ASSERT_GE(solver.JntToJac(next_joints(), expected), 0);
    const Jacobian jacobian = arm_.jacobian(joints_rad());
    for (unsigned row = 0; row < 6; ++row) {
      for (unsigned column = 0; column < kAxes; ++column) {
        const double value = column < spec_.axis_count ? expected(row, column) : 0.0;
        ASSERT_NEAR(jacobian(row, column), value, row < 3 ? kToleranceMm : kTolerance)
            << "row " << row << ", joint " << column + 1 << ", pose " << i << ", seed " << kKdlSeed;
      }
    }
  }
}

// The closed-form rates, through KDL's Jacobian, give back the velocity that was asked for.
TEST_P(SixRKdl, JointRatesGiveTheVelocityOfTheFlange) {
  KDL::ChainJntToJacSolver solver{chain_};
  KDL::Jacobian jacobian{chain_.getNrOfJoints()};
  int tested = 0;
  for (int i = 0; i < kKdlPoses; ++i) {
    ASSERT_GE(solver.JntToJac(next_joints(), jacobian), 0);
    const Manipulability away = arm_.manipulability(joints_rad());
    if (away.shoulder * away.elbow * away.wrist < 1e-3) continue;
    ++tested;
    const auto random_vector = [this](double size) {
      return Eigen::Vector3d{random_.real(-size, size), random_.real(-size, size), random_.real(-size, size)};
    };
    const Eigen::Vector3d v = random_vector(100);
    const Eigen::Vector3d w = random_vector(1);
    const PerAxis<double> rates = arm_.joint_rates(joints_rad(), v, w);
    for (unsigned row = 0; row < 6; ++row) {
      double velocity = 0;
      for (unsigned column = 0; column < kAxes; ++column) velocity += jacobian(row, column) * rates[column];
      const double expected = row < 3 ? v(row) : w(row - 3);
      ASSERT_NEAR(velocity, expected, row < 3 ? 1e-8 : 1e-10)
          << "row " << row << ", pose " << i << ", seed " << kKdlSeed;
    }
  }
  EXPECT_GT(tested, kKdlPoses / 2);
}

INSTANTIATE_TEST_SUITE_P(Robots, RobotKdl, testing::ValuesIn(test::arms()),
                         [](const auto& suite) { return suite.param; });
INSTANTIATE_TEST_SUITE_P(Robots, SixRKdl, testing::ValuesIn(six_r_arms()),
                         [](const auto& suite) { return suite.param; });

}  // namespace
}  // namespace armature::cosim
