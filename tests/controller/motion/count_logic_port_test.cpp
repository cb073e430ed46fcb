#include "controller/motion/count_logic_port.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

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

// The fake ends the program when a time is written after the servos are on, as a bus error does.
TEST(CountLogicPort, SetsTheTimesBeforeItEnablesTheDrives) {
  test::FakeLogic logic;
  CountLogicPort port{logic};
  port.start(test::paper_robot());
  ASSERT_EQ(logic.servo_on(), 0x3Fu);
  for (const std::uint32_t offset : {0x14u, 0x1Cu, 0x20u, 0x24u}) {
    const RegAddr addr = test::FakeLogic::kPulses + offset;
    EXPECT_THROW(logic.write(addr, 2'500), std::logic_error) << std::hex << offset;
  }
  port.set_servo(false);
  port.start(test::paper_robot());
  EXPECT_EQ(logic.servo_on(), 0x3Fu);
}

}  // namespace
}  // namespace armature
