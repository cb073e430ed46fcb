// A plant whose mechanics has a state of its own: whole ticks, and ticks that are taken back.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "cosim/plant/plant.hpp"
#include "cosim/scenario/files/robot_loader.hpp"

namespace armature::cosim {
namespace {

constexpr Cycles kDynamicTick{2500};

RobotSpec dynamic_robot() {
  return load_robot(std::filesystem::path{ARMATURE_SOURCE_DIR} / "scenarios/robots/vo2021_6r_dynamic.toml");
}

// Its drives have so weak motors that the weight of the arm overheats them.
RobotSpec hot_robot() {
  RobotSpec robot = dynamic_robot();
  for (AxisSpec& axis : robot.axes) {
    axis.dynamics->rated_torque_nm = 0.1;
    axis.dynamics->overload_200_s = 1.3;
    axis.dynamics->overload_300_s = 0.45;
  }
  return robot;
}

// The servos are on, and the arm holds its weight.
class HoldingPlant {
 public:
  explicit HoldingPlant(const RobotSpec& robot = dynamic_robot()) : plant{robot} {
    SocOutputs out;
    out.servo_on = kAllAxes;
    plant.on_outputs(Cycles{0}, out);
    advance_before(Cycles{12'500'001});
  }
  void advance_before(Cycles end) {
    while (plant.next_event() < end) plant.advance(plant.next_event());
  }

  Plant plant;
};

TEST(DynamicPlant, MovesInWholeTicksAsInStepsAlsoAfterATickThatWasTakenBack) {
  HoldingPlant steps, ticks;
  double changed = 0;
  for (int i = 0; i < 60; ++i) {
    TickPulses tick;
    tick.begins = Cycles{12'500'001} + Cycles{kDynamicTick.value() * i};
    tick.ends = tick.begins + kDynamicTick;
    const PerAxis<double> before = *steps.plant.load_lead_deg();
    steps.advance_before(tick.ends);
    ASSERT_TRUE(ticks.plant.begin_tick(tick, Cycles{30})) << i;
    if (i % 3 == 1) {
      ticks.plant.revert_tick();
      ASSERT_EQ(*ticks.plant.load_lead_deg(), before) << i;
      ASSERT_TRUE(ticks.plant.begin_tick(tick, Cycles{30})) << i;
    }
    ASSERT_EQ(*ticks.plant.load_lead_deg(), *steps.plant.load_lead_deg()) << i;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      ASSERT_EQ(ticks.plant.following_error(axis), steps.plant.following_error(axis)) << i;
      changed = std::max(changed, std::fabs((*steps.plant.load_lead_deg())[axis] - before[axis]));
    }
  }
  EXPECT_GT(changed, 0);  // the loads still move a little
}

TEST(DynamicPlant, HangsInItsGearsByItsWeight) {
  const HoldingPlant holding;
  const PerAxis<double> lead = holding.plant.load_lead_deg().value();
  EXPECT_LT(std::fabs(lead[0]), 0.006);  // no weight: anywhere in the play
  EXPECT_LT(lead[1], -0.02);
  EXPECT_LT(lead[2], -0.02);
  EXPECT_LT(lead[4], -0.04);
  EXPECT_FALSE(Plant{RobotSpec{}}.load_lead_deg());
}

// The brakes are not in at once, and the weight of the arm turns the motor of axis 2 meanwhile.
TEST(DynamicPlant, AMotorThatIsBlockedDoesNotTurnWhenTheServosGoOff) {
  HoldingPlant free, blocked;
  const Counts before = blocked.plant.motor_counts(1);
  blocked.plant.block(1);
  for (HoldingPlant* holding : {&free, &blocked}) {
    holding->plant.on_outputs(Cycles{12'500'001}, SocOutputs{});
    holding->advance_before(Cycles{15'000'000});
  }
  EXPECT_NE(free.plant.motor_counts(1), before);
  EXPECT_EQ(blocked.plant.motor_counts(1), before);
}

TEST(DynamicPlant, AHotDriveGivesAnAlarmUntilItsServoIsOff) {
  HoldingPlant holding{hot_robot()};
  EXPECT_EQ(holding.plant.inputs().drive_alarm, 0);
  holding.advance_before(Cycles{50'000'000});
  const std::uint8_t alarms = holding.plant.inputs().drive_alarm;
  EXPECT_EQ(alarms & 0b10, 0b10);  // axis 2 holds the most
  EXPECT_EQ(alarms & 0b01, 0);     // axis 1 holds nothing
  holding.plant.on_outputs(Cycles{50'000'000}, SocOutputs{});
  holding.advance_before(Cycles{50'002'500});
  EXPECT_EQ(holding.plant.inputs().drive_alarm, 0);
}

TEST(DynamicPlant, ATickInWhichADriveGetsTooHotIsNoWholeTick) {
  HoldingPlant steps{hot_robot()}, ticks{hot_robot()};
  for (int i = 0;; ++i) {
    ASSERT_LT(i, 20'000);
    TickPulses tick;
    tick.begins = Cycles{12'500'001} + Cycles{kDynamicTick.value() * i};
    tick.ends = tick.begins + kDynamicTick;
    steps.advance_before(tick.ends);
    const bool is_whole = ticks.plant.begin_tick(tick, Cycles{30});
    ASSERT_EQ(is_whole, steps.plant.inputs().drive_alarm == 0) << i;
    if (!is_whole) break;
  }
}

}  // namespace
}  // namespace armature::cosim
