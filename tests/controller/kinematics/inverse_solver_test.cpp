// An arm whose closed forms are solved elsewhere: each function asks for them, and its results are those of software.
#include "controller/kinematics/inverse_solver.hpp"

#include <gtest/gtest.h>

#include <type_traits>

#include "controller/kinematics/arm.hpp"
#include "tests/controller/support/path_rig.hpp"
#include "tests/controller/support/random.hpp"

namespace armature {
namespace {

template <class Family>
class Elsewhere final : public InverseSolver {
 public:
  explicit Elsewhere(const ArmGeometry& geometry) : family_{geometry} {}

  RawTracking track(const Transform& base_T_flange, const Theta& previous, double wrist_zone,
                    bool keep_elbow) noexcept override {
    ++asked;
    if constexpr (std::is_same_v<Family, SixR>) {
      return family_.track(base_T_flange, previous, wrist_zone, keep_elbow);
    } else {
      return family_.track(base_T_flange, previous);
    }
  }
  RawTracking track_point(const Eigen::Vector3d& point_mm, const Eigen::Vector3d& flange_p_mm,
                          const Theta& previous) noexcept override {
    ++asked;
    if constexpr (std::is_same_v<Family, SixR>) return family_.track_point(point_mm, flange_p_mm, previous);
    return {};
  }
  RawSolutions inverse(const Transform& base_T_flange, const Theta& previous) noexcept override {
    ++asked;
    return family_.inverse(base_T_flange, previous);
  }

  int asked = 0;

 private:
  Family family_;
};

template <class Result>
void expect_equal(const Result& a, const Result& b) {
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.margin_mm, b.margin_mm);
  EXPECT_EQ(a.residual_rad, b.residual_rad);
  EXPECT_EQ(a.singular, b.singular);
  if constexpr (requires { a.joints; }) {
    EXPECT_EQ(a.found, b.found);
    EXPECT_EQ(a.joints, b.joints);
  } else {
    ASSERT_EQ(a.count, b.count);
    EXPECT_EQ(a.selected, b.selected);
    for (std::size_t i = 0; i < a.count; ++i) EXPECT_EQ(a.branches[i].joints, b.branches[i].joints);
  }
}

template <class Family>
void compare(const RobotModel& robot) {
  constexpr std::uint64_t kSeed = 31;
  test::Random random{kSeed};
  const Arm software{robot};
  Arm arm{robot};
  Elsewhere<Family> solver{robot.arm};
  arm.solve_with(&solver);
  const auto both = [&](auto solve) {
    solver.asked = 0;
    expect_equal(solve(software), solve(arm));
    EXPECT_GE(solver.asked, 1);
  };
  for (int draw = 0; draw < 500; ++draw) {
    JointAngles previous{}, joints{};
    for (std::size_t axis = 0; axis < robot.axis_count; ++axis) {
      previous[axis] = Radians{random.real(-1.5, 1.5)};
      joints[axis] = previous[axis] + Radians{random.real(-0.2, 0.2)};
    }
    Transform pose = software.forward(joints);
    if (draw % 10 == 0) pose.position_mm *= 3.0;  // mostly out of reach
    both([&](const Arm& of) { return of.inverse(pose, previous); });
    both([&](const Arm& of) { return of.soonest(pose, previous); });
    both([&](const Arm& of) { return of.track(pose, previous); });
    both([&](const Arm& of) { return of.track_keeping_elbow(pose, previous); });
    both([&](const Arm& of) { return of.track_keeping_theta4(pose, previous); });
    if constexpr (std::is_same_v<Family, SixR>) {
      both([&](const Arm& of) { return of.track_point(pose * Eigen::Vector3d{5, 0, 80}, {5, 0, 80}, previous); });
    }
  }
}

TEST(InverseSolver, IsAskedByEachFunctionOfAnArmWithSixJoints) {
  compare<SixR>(test::irb120());
}

TEST(InverseSolver, IsAskedByEachFunctionOfAnArmWithFiveJoints) {
  compare<FiveR>(test::hu2012(0.1));
}

TEST(InverseSolver, IsNotAskedOnceItIsTakenBack) {
  const RobotModel robot = test::irb120();
  Arm arm{robot};
  Elsewhere<SixR> solver{robot.arm};
  arm.solve_with(&solver);
  arm.solve_with(nullptr);
  EXPECT_TRUE(arm.track(arm.forward({}), {}).found);
  EXPECT_EQ(solver.asked, 0);
}

}  // namespace
}  // namespace armature
