// Joints to a file of poses to a file of solutions and back, for every robot of the project.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "controller/kinematics/arm.hpp"
#include "cosim/poses/number_csv.hpp"
#include "cosim/poses/pose_files.hpp"
#include "cosim/scenario/to_controller.hpp"
#include "tests/cosim/support/kinematics_oracle.hpp"

namespace armature::cosim {
namespace {

constexpr std::uint64_t kRoundTripSeed = 2021;
constexpr std::size_t kRoundTripPoses = 200;

// Fields of a line of the solutions file.
std::vector<std::string> split(std::string_view line) {
  std::vector<std::string> fields(1);
  for (const char c : line) {
    if (c == ',') {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  return fields;
}

class RobotRoundTrip : public testing::TestWithParam<std::string> {
 protected:
  RobotSpec spec_ = test::load_project_robot(GetParam());
  Arm arm_{to_robot_model(spec_)};
};

TEST_P(RobotRoundTrip, EveryBranchOfTheFileGivesBackThePoseAndOneOfThemTheJoints) {
  armature::test::Random random{kRoundTripSeed};
  std::vector<PerAxis<double>> joints;
  std::vector<Transform> poses;
  for (std::size_t i = 0; i < kRoundTripPoses; ++i) {
    joints.push_back(test::random_joints_deg(random, spec_));
    poses.push_back(arm_.forward(test::to_radians(joints.back())));
  }
  const std::vector<PoseRow> rows = parse_poses(poses_text(poses), "poses.csv", spec_.axis_count);
  ASSERT_EQ(rows.size(), kRoundTripPoses);

  SolutionsText solutions{spec_.axis_count};
  for (std::size_t i = 0; i < kRoundTripPoses; ++i) {
    ASSERT_EQ(rows[i].pose.rotation, poses[i].rotation);
    ASSERT_EQ(rows[i].pose.position_mm, poses[i].position_mm);
    solutions.add(arm_.inverse(rows[i].pose, test::to_radians(joints[i])));
  }

  std::string_view rest = solutions.text();
  std::vector<int> selected(kRoundTripPoses, 0);
  rest.remove_prefix(rest.find('\n') + 1);
  while (!rest.empty()) {
    const std::vector<std::string> fields = split(rest.substr(0, rest.find('\n')));
    rest.remove_prefix(rest.find('\n') + 1);
    ASSERT_EQ(fields.size(), 8 + spec_.axis_count);
    ASSERT_NE(fields[1], "none") << "pose " << fields[0] << ", seed " << kRoundTripSeed;
    const std::size_t pose = std::stoul(fields[0]);
    PerAxis<double> deg{};
    for (std::size_t i = 0; i < spec_.axis_count; ++i) deg[i] = parse_number(fields[8 + i]).value();
    const Transform again = arm_.forward(test::to_radians(deg));
    ASSERT_LT((again.rotation - poses[pose].rotation).cwiseAbs().maxCoeff(), 1e-13) << "pose " << pose;
    ASSERT_LT((again.position_mm - poses[pose].position_mm).cwiseAbs().maxCoeff(), 1e-10) << "pose " << pose;
    if (fields[7] != "1") continue;
    ++selected[pose];
    EXPECT_EQ(fields[6], "1") << "selected outside the limits";
    // The joints before were those of the pose: nothing is nearer. A double root costs half of the digits.
    for (std::size_t i = 0; i < spec_.axis_count; ++i) ASSERT_NEAR(deg[i], joints[pose][i], 1e-5) << "pose " << pose;
  }
  EXPECT_EQ(std::count(selected.begin(), selected.end(), 1), static_cast<std::ptrdiff_t>(kRoundTripPoses));
}

TEST_P(RobotRoundTrip, AJointMayBeExactlyAtItsLimit) {
  for (std::size_t joint = 0; joint < spec_.axis_count; ++joint) {
    for (const double limit : {spec_.axes[joint].min_deg, spec_.axes[joint].max_deg}) {
      SCOPED_TRACE("joint " + std::to_string(joint + 1) + " at " + std::to_string(limit));
      // The others well inside, and no singular arm: there a double root costs half of the digits.
      PerAxis<double> deg{};
      for (std::size_t i = 0; i < spec_.axis_count; ++i) {
        deg[i] = spec_.axes[i].min_deg + 0.58 * (spec_.axes[i].max_deg - spec_.axes[i].min_deg);
      }
      deg[joint] = limit;
      ASSERT_GT(arm_.manipulability(test::to_radians(deg)).elbow, 1e-3);
      const IkSolutions solutions = arm_.inverse(arm_.forward(test::to_radians(deg)), test::to_radians(deg));
      ASSERT_GE(solutions.selected, 0);
      const JointAngles& joints = solutions.branches[static_cast<std::size_t>(solutions.selected)].joints;
      for (std::size_t i = 0; i < spec_.axis_count; ++i) {
        EXPECT_NEAR(joints[i].value() / test::kRadPerDeg, deg[i], 1e-9) << "joint " << i + 1;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, RobotRoundTrip, testing::ValuesIn(test::arms()),
                         [](const auto& suite) { return suite.param; });

}  // namespace
}  // namespace armature::cosim
