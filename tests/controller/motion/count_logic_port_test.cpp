#include "controller/motion/count_logic_port.hpp"

#include <gtest/gtest.h>

#include <cstdint>
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

TEST(CountLogicPort, ShiftsThePositionsOfAnAxisAndItsIndex) {
  test::FakeLogic logic;
  CountLogicPort port{logic};
  port.start(test::paper_robot());
  EXPECT_FALSE(port.index(2)) << "not latched";
  logic.index_seen = 0b000100;
  logic.index_position(2) = static_cast<std::uint32_t>(-300);
  const auto move_to = [&](std::int64_t counts) {
    logic.drives[2].position = static_cast<double>(counts);
    logic.drives[2].stuck = true;
    logic.pass(test::FakeLogic::kTick);
    return port.sample().encoder[2];
  };
  EXPECT_EQ(move_to(-500), Counts{-500});
  EXPECT_EQ(port.index(2), Counts{-300});
  port.shift_position(2, Counts{10'000});
  EXPECT_EQ(port.last().encoder[2], Counts{9'500});
  EXPECT_EQ(port.index(2), Counts{9'700});
  port.shift_position(2, Counts{1});
  EXPECT_EQ(move_to(-400), Counts{9'601});
  EXPECT_EQ(port.last().encoder[1], Counts{0}) << "the other axes stay";
}

// The position needs 64 bits while the registers have 32.
TEST(CountLogicPort, FindsTheIndexNearAPositionBeyondTheRegister) {
  test::FakeLogic logic;
  CountLogicPort port{logic};
  port.start(test::paper_robot());
  logic.drives[0].stuck = true;
  for (const std::int64_t counts : {2'000'000'000LL, 4'000'000'000LL, 4'294'967'200LL}) {
    logic.drives[0].position = static_cast<double>(counts);
    logic.pass(test::FakeLogic::kTick);
    EXPECT_EQ(port.sample().encoder[0], Counts{counts});
  }
  logic.index_seen = 1;
  logic.index_position(0) = 104;  // 2^32 + 104
  EXPECT_EQ(port.index(0), Counts{4'294'967'400});
}

}  // namespace
}  // namespace armature
