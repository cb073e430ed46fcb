// The vendors' arms at zero, as the ROS-Industrial models have them (irb120_3_58_macro, kr6r900sixx_macro,
// lrmate200id_macro .xacro): where each axis is and which way it turns, and the frame tool0. These numbers owe nothing
// to Denavit-Hartenberg parameters, signs or offsets.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>

#include "controller/kinematics/arm.hpp"
#include "cosim/scenario/to_controller.hpp"
#include "tests/cosim/support/kinematics_oracle.hpp"

namespace armature::cosim {
namespace {

struct Axis {
  Eigen::Vector3d point_mm;   // somewhere on it
  Eigen::Vector3d direction;  // of a positive turn
};
struct Vendor {
  std::string robot;
  std::array<Axis, kAxes> axes;
  Eigen::Vector3d flange_mm;
  Eigen::Vector3d flange_x;  // of tool0; its z faces forward
};

const Eigen::Vector3d kX{1, 0, 0};
const Eigen::Vector3d kY{0, 1, 0};
const Eigen::Vector3d kZ{0, 0, 1};

// x forward, z up.
const std::array kVendors{
    Vendor{"abb_irb120",
           {{{{0, 0, 0}, kZ},
             {{0, 0, 290}, kY},
             {{0, 0, 560}, kY},
             {{0, 0, 630}, kX},
             {{302, 0, 630}, kY},
             {{0, 0, 630}, kX}}},
           {374, 0, 630},
           -kZ},
    Vendor{"kuka_kr6_r900",
           {{{{0, 0, 0}, -kZ},
             {{25, 0, 400}, kY},
             {{480, 0, 400}, kY},
             {{0, 0, 435}, -kX},
             {{900, 0, 435}, kY},
             {{0, 0, 435}, -kX}}},
           {980, 0, 435},
           -kZ},
    Vendor{"fanuc_lrmate200id",
           {{{{0, 0, 0}, kZ},
             {{50, 0, 330}, kY},
             {{50, 0, 660}, -kY},
             {{0, 0, 695}, -kX},
             {{385, 0, 695}, -kY},
             {{0, 0, 695}, -kX}}},
           {465, 0, 695},
           kZ},
};

class RobotVendor : public testing::TestWithParam<Vendor> {};

TEST_P(RobotVendor, AtZeroEveryAxisIsWhereTheMakerHasIt) {
  const Vendor& vendor = GetParam();
  const Arm arm{to_robot_model(test::load_project_robot(vendor.robot))};
  const Transform flange = arm.forward({});
  EXPECT_LT((flange.position_mm - vendor.flange_mm).norm(), 1e-9) << flange.position_mm.transpose();
  EXPECT_LT((flange.rotation.col(2) - kX).norm(), 1e-12) << "the flange faces forward";
  EXPECT_LT((flange.rotation.col(0) - vendor.flange_x).norm(), 1e-12) << flange.rotation.col(0).transpose();
  const Jacobian jacobian = arm.jacobian({});
  for (int joint = 0; joint < 6; ++joint) {
    const Axis& axis = vendor.axes[static_cast<std::size_t>(joint)];
    const Eigen::Vector3d turn = jacobian.col(joint).tail<3>();
    const Eigen::Vector3d move = jacobian.col(joint).head<3>();
    EXPECT_LT((turn - axis.direction).norm(), 1e-12) << "joint " << joint + 1 << " turns about " << turn.transpose();
    EXPECT_LT((move - axis.direction.cross(vendor.flange_mm - axis.point_mm)).norm(), 1e-9)
        << "joint " << joint + 1 << " moves the flange by " << move.transpose();
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, RobotVendor, testing::ValuesIn(kVendors),
                         [](const auto& suite) { return suite.param.robot; });

}  // namespace
}  // namespace armature::cosim
