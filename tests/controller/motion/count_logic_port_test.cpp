#include "controller/motion/count_logic_port.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <stdexcept>

#include "controller/regs/pulse_train_regs.hpp"
#include "tests/controller/support/model_logic.hpp"
#include "tests/controller/support/robots.hpp"

namespace armature {
namespace {

constexpr RegAddr kDirSetup = test::ModelLogic::kPulses + regs::pulse_train::kDirSetupOffset;
constexpr RegAddr kDirHold = test::ModelLogic::kPulses + regs::pulse_train::kDirHoldOffset;

TEST(CountLogicPort, TheSlowestDriveSetsTheTimesAroundAChangeOfDirection) {
  RobotModel robot = test::paper_robot();
  robot.axes[2].dir_setup_cycles = 1'023;
  robot.axes[5].dir_hold_cycles = 26;
  test::ModelLogic logic;
  CountLogicPort{logic}.start(robot);
  EXPECT_EQ(logic.peek(kDirSetup), 1'023u);
  EXPECT_EQ(logic.peek(kDirHold), 26u);
}

TEST(CountLogicPort, FastDrivesShortenTheTimesAroundAChangeOfDirection) {
  RobotModel robot = test::paper_robot();
  for (AxisModel& axis : robot.axes) {
    axis.dir_setup_cycles = 7;
    axis.dir_hold_cycles = 0;
  }
  test::ModelLogic logic;
  CountLogicPort{logic}.start(robot);
  EXPECT_EQ(logic.peek(kDirSetup), 7u);
  EXPECT_EQ(logic.peek(kDirHold), 0u);
}

// The logic refuses a time that is written after the servos are on.
TEST(CountLogicPort, SetsTheTimesBeforeItEnablesTheDrives) {
  test::ModelLogic logic;
  CountLogicPort port{logic};
  port.start(test::paper_robot());
  ASSERT_EQ(logic.servo_on(), 0x3Fu);
  for (const std::uint32_t offset : {0x14u, 0x1Cu, 0x20u, 0x24u}) {
    const RegAddr addr = test::ModelLogic::kPulses + offset;
    EXPECT_THROW(logic.write(addr, 2'500), std::logic_error) << std::hex << offset;
  }
  port.set_servo(false);
  port.start(test::paper_robot());
  EXPECT_EQ(logic.servo_on(), 0x3Fu);
}

TEST(CountLogicPort, ShiftsThePositionsOfAnAxisAndItsIndex) {
  test::ModelLogic logic;
  CountLogicPort port{logic};
  port.start(test::paper_robot());
  EXPECT_FALSE(port.index(2)) << "not latched";
  logic.pass_index(2, -300);
  const auto move_to = [&](std::int64_t counts) {
    logic.drives[2].position = static_cast<double>(counts);
    logic.drives[2].stuck = true;
    logic.pass(test::ModelLogic::kTick);
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
  test::ModelLogic logic;
  CountLogicPort port{logic};
  port.start(test::paper_robot());
  logic.drives[0].stuck = true;
  for (const std::int64_t counts : {2'000'000'000LL, 4'000'000'000LL, 4'294'967'200LL}) {
    logic.drives[0].position = static_cast<double>(counts);
    logic.pass(test::ModelLogic::kTick);
    EXPECT_EQ(port.sample().encoder[0], Counts{counts});
  }
  logic.pass_index(0, 4'294'967'400);
  EXPECT_EQ(port.index(0), Counts{4'294'967'400});
}

}  // namespace
}  // namespace armature
