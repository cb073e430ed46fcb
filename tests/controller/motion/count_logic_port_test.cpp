#include "controller/motion/count_logic_port.hpp"

#include <gtest/gtest.h>

#include "tests/controller/support/fake_logic.hpp"
#include "tests/controller/support/robots.hpp"

namespace armature {
namespace {

TEST(CountLogicPort, TheSlowestDriveSetsTheTimesAroundAChangeOfDirection) {
  RobotModel robot = test::paper_robot();
  robot.axes[2].dir_setup_cycles = 1'023;
  robot.axes[5].dir_hold_cycles = 26;
  test::FakeLogic logic;
  CountLogicPort{logic}.start(robot);
  EXPECT_EQ(logic.dir_setup, 1'023u);
  EXPECT_EQ(logic.dir_hold, 26u);
}

TEST(CountLogicPort, FastDrivesShortenTheTimesAroundAChangeOfDirection) {
  RobotModel robot = test::paper_robot();
  for (AxisModel& axis : robot.axes) {
    axis.dir_setup_cycles = 7;
    axis.dir_hold_cycles = 0;
  }
  test::FakeLogic logic;
  CountLogicPort{logic}.start(robot);
  EXPECT_EQ(logic.dir_setup, 7u);
  EXPECT_EQ(logic.dir_hold, 0u);
}

}  // namespace
}  // namespace armature
