// The motion of the arm behind a belt, without its estimator: any belt may be expected, so any correction, too.
#include "controller/activity/conveyor/conveyor_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "controller/base/timebase.hpp"
#include "controller/trajectory/state/axis_reach.hpp"
#include "tests/controller/support/conveyor_rig.hpp"
#include "tests/controller/support/joint_envelope.hpp"
#include "tests/controller/support/random.hpp"

namespace armature {
namespace {

using namespace test::conveyor;

constexpr std::uint64_t kBeltSeed = 54;
constexpr std::int64_t kMostTicks = 4'000;
constexpr int kDraws = 1'000;

RobotModel slow_robot(test::Random& random) {
  RobotModel robot = test::irb120();
  for (AxisModel& axis : robot.axes) {
    axis.max_accel_rad_s2 = random.real(5.0, 60.0);
    axis.max_speed_rad_s = random.real(0.2, 3.0);
  }
  return robot;
}

// Little room for each joint, so that the edges of the ranges are near.
void narrow(RobotModel& robot, const PerAxis<Radians>& stand, test::Random& random) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    robot.axes[axis].min_rad = stand[axis].value() - random.real(0.1, 30.0) * test::kDeg;
    robot.axes[axis].max_rad = stand[axis].value() + random.real(0.1, 30.0) * test::kDeg;
  }
}

// The belt of each tick: jumps of any size, at any times, with a velocity that has nothing to do with them.
class AnyBelt {
 public:
  explicit AnyBelt(test::Random& random)
      : random_{random}, every_{random.integer(1, 500)}, size_mm_{std::pow(10.0, random.real(-2.0, 6.0))} {}

  AxisState next() {
    if (random_.integer(1, every_) == 1) {
      belt_.position = random_.real(-size_mm_, size_mm_);
      belt_.velocity = random_.real(-1'000.0, 1'000.0);
    }
    belt_.position += belt_.velocity * kTickSeconds;
    return belt_;
  }

 private:
  test::Random& random_;
  std::int64_t every_;
  double size_mm_;
  AxisState belt_{};
};

// By how much the stop that the source makes then leaves the range, in the way of one tick of acceleration.
double behind_the_range(const AxisModel& axis, const AxisState& state) {
  const TimeLawLimits limits{.speed = std::fabs(state.velocity) + 1.0, .accel = axis.max_accel_rad_s2};
  const PhaseLaw stop = plan_to_velocity(ProfileKind::kTrapezoid, state, 0.0, limits);
  const double end = stop.at(stop.duration_s()).position, tick = axis.max_accel_rad_s2 * kTickSeconds * kTickSeconds;
  return std::max(end - axis.max_rad, axis.min_rad - end) / tick;
}

TEST(ConveyorMotion, KeepsTheLimitsOfTheJointsWhateverBeltIsExpected) {
  test::Random random{kBeltSeed};
  test::JointEnvelope nearest;
  int refused = 0;
  double behind = -1e9;
  for (int draw = 0; draw < kDraws; ++draw) {
    RobotModel robot = slow_robot(random);
    ConveyorConfig config = *with_conveyor(random.real(100.0, 2'000.0)).conveyor;
    config.accel_mm_s2 = random.real(500.0, 20'000.0);
    const Transform tool = with_conveyor().flange_T_tool;
    const IkTracking stand = Arm{robot}.soonest(pointing_down(380, -60, 260) * inverse(tool), {});
    ASSERT_TRUE(stand.found);
    narrow(robot, stand.joints, random);
    const Arm arm{robot};
    ConveyorMotion motion{robot, arm, config, tool, 1.0};
    motion.begin(stand.joints, 0.0);
    motion.start_dwell(Ticks{0});
    AnyBelt belt{random};
    std::vector<PerAxis<Radians>> points(2, stand.joints);
    bool trouble = false;
    for (std::int64_t tick = 0; tick < kMostTicks && !trouble; ++tick) {
      trouble = motion.advance(belt.next()).any;
      points.push_back(motion.position());
      const PerAxis<AxisState> state = motion.state();
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        behind = std::max(behind, behind_the_range(robot.axes[axis], state[axis]));
      }
    }
    if (trouble) points.pop_back();  // the joints begin to stop instead
    refused += trouble ? 1 : 0;
    const test::JointEnvelope found = test::joint_envelope(robot, points);
    ASSERT_EQ(found.beyond, "") << "seed " << kBeltSeed << " draw " << draw;
    nearest.add(found);
  }
  EXPECT_LE(behind, 1.0);
  // The limits were reached, in some runs exceeded but for the refusal of a set-point, and in others not.
  EXPECT_GT(nearest.speed, 0.999);
  EXPECT_GT(nearest.accel, 0.999);
  EXPECT_GT(nearest.range, 0.9);
  EXPECT_GT(refused, kDraws / 4);
  EXPECT_LT(refused, kDraws);
}

}  // namespace
}  // namespace armature
