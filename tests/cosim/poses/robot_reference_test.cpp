// The reference vectors of the ABB IRB 120 against its robot file: dimensions, limits, speeds and every answer.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "controller/kinematics/arm.hpp"
#include "cosim/scenario/to_controller.hpp"
#include "tests/controller/support/reference_data.hpp"
#include "tests/cosim/support/kinematics_oracle.hpp"

namespace armature::cosim {
namespace {

using nlohmann::json;

class RobotReference : public testing::Test {
 protected:
  static Transform pose_of(const json& rows) {
    Transform pose;
    for (int row = 0; row < 3; ++row) {
      const auto numbers = rows[static_cast<std::size_t>(row)].get<std::array<double, 4>>();
      for (int column = 0; column < 3; ++column) {
        pose.rotation(row, column) = numbers[static_cast<std::size_t>(column)];
      }
      pose.position_mm(row) = numbers[3];
    }
    return pose;
  }

  const json reference_ = armature::test::read_reference("ik6r_abb_irb120.json");
  const RobotSpec spec_ = test::load_project_robot("abb_irb120");
  const Arm arm_{to_robot_model(spec_)};
};

TEST_F(RobotReference, TheFileHasItsNumbers) {
  const KinematicsSpec& arm = spec_.kinematics.value();
  const json& dh = reference_["dh"];
  EXPECT_EQ(arm.a1_mm, dh["a1"]);
  EXPECT_EQ(arm.a2_mm, dh["a2"]);
  EXPECT_EQ(arm.a3_mm, dh["a3"]);
  EXPECT_EQ(arm.d1_mm, dh["d1"]);
  EXPECT_EQ(arm.d4_mm, dh["d4"]);
  EXPECT_EQ(arm.d6_mm, dh["d6"]);
  for (std::size_t i = 0; i < kAxes; ++i) {
    EXPECT_EQ(arm.sign[i], reference_["sign"][i]);
    EXPECT_EQ(arm.offset_deg[i], reference_["offset_deg"][i]);
    EXPECT_EQ(spec_.axes[i].min_deg, reference_["lo_deg"][i]);
    EXPECT_EQ(spec_.axes[i].max_deg, reference_["hi_deg"][i]);
    EXPECT_EQ(spec_.axes[i].max_speed_deg_s, reference_["vmax_deg_s"][i]);
  }
}

TEST_F(RobotReference, EveryPoseHasItsBranchesAndItsChoice) {
  int chosen = 0;
  for (const json& expected : reference_["poses"]) {
    SCOPED_TRACE(expected["q_vendor_deg"].dump());
    const JointAngles previous = test::to_radians(expected["prev_vendor_deg"].get<PerAxis<double>>());
    const IkSolutions solutions = arm_.inverse(pose_of(expected["T"]), previous);
    const json& branches = expected["branches"];
    ASSERT_EQ(solutions.count, branches.size());
    for (std::size_t i = 0; i < solutions.count; ++i) {
      const IkBranch& branch = solutions.branches[i];
      EXPECT_EQ(branch.shoulder, branches[i]["shoulder"].get<int>());
      EXPECT_EQ(branch.elbow, branches[i]["elbow"].get<int>());
      EXPECT_EQ(branch.flip, branches[i]["flip"].get<int>());
      EXPECT_EQ(branch.singular, branches[i]["sing"].get<int>());
      EXPECT_EQ(branch.within_limits, branches[i]["within_limits"].get<bool>());
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const double theta = spec_.kinematics->sign[axis] * branch.joints[axis].value() +
                             spec_.kinematics->offset_deg[axis] * test::kRadPerDeg;
        const double off = theta - branches[i]["theta"][axis].get<double>();
        ASSERT_NEAR(std::remainder(off, 2 * std::numbers::pi), 0, 1e-11) << "branch " << i << ", axis " << axis + 1;
      }
    }
    const json& selected = expected["selected"];
    if (selected.is_null()) {
      EXPECT_EQ(solutions.selected, -1);
      continue;
    }
    ++chosen;
    ASSERT_EQ(solutions.selected, selected["branch"].get<int>());
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      ASSERT_NEAR(solutions.branches[static_cast<std::size_t>(solutions.selected)].joints[axis].value(),
                  selected["q_vendor_deg"][axis].get<double>() * test::kRadPerDeg, 1e-11);
    }
  }
  EXPECT_GT(chosen, 100);
}

}  // namespace
}  // namespace armature::cosim
