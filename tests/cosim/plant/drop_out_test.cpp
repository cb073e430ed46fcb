#include "cosim/plant/drop_out.hpp"

#include <gtest/gtest.h>

#include "cosim/plant/plant.hpp"

namespace armature::cosim {
namespace {

constexpr Cycles kTime{100};
constexpr std::uint8_t kAll = 0x3F;

TEST(DropOut, OpensWhenTheHeartbeatHasBeenConstantForItsTime) {
  DropOut relay{kTime};
  EXPECT_EQ(relay.opens_at(), kNever) << "nothing is enabled";
  EXPECT_EQ(relay.on_pins(Cycles{10}, kAll, false), kAll);
  EXPECT_EQ(relay.opens_at(), Cycles{110}) << "from the first enable";
  EXPECT_EQ(relay.on_pins(Cycles{60}, kAll, true), kAll);
  EXPECT_EQ(relay.opens_at(), Cycles{160});
  EXPECT_EQ(relay.on_pins(Cycles{70}, kAll, true), kAll);
  EXPECT_EQ(relay.opens_at(), Cycles{160}) << "a constant level is no sign of life";
  EXPECT_EQ(relay.on_pins(Cycles{80}, 1, false), 1);
  EXPECT_EQ(relay.opens_at(), Cycles{180}) << "both edges count";
}

TEST(DropOut, StaysOpenUntilAllEnablesHaveBeenLow) {
  DropOut relay{kTime};
  relay.on_pins(Cycles{10}, kAll, false);
  relay.open();
  EXPECT_EQ(relay.opens_at(), kNever);
  EXPECT_EQ(relay.on_pins(Cycles{200}, kAll, true), 0) << "the heartbeat alone does not close it";
  EXPECT_EQ(relay.on_pins(Cycles{210}, 1, true), 0);
  EXPECT_EQ(relay.on_pins(Cycles{220}, 0, true), 0);
  EXPECT_EQ(relay.on_pins(Cycles{230}, kAll, true), kAll);
  EXPECT_EQ(relay.opens_at(), Cycles{330});
}

TEST(DropOut, TakesThePowerFromTheDrivesOfThePlantInItsCycle) {
  Plant plant{RobotSpec{}, kTime};
  SocOutputs out;
  out.servo_on = kAll;
  plant.on_outputs(Cycles{10}, out);
  EXPECT_EQ(plant.servo_enables(), kAll);
  out.heartbeat = true;
  plant.on_outputs(Cycles{50}, out);
  EXPECT_LE(plant.next_event(), Cycles{150});
  while (plant.next_event() < Cycles{150}) plant.advance(plant.next_event());
  EXPECT_EQ(plant.servo_enables(), kAll);
  EXPECT_EQ(plant.next_event(), Cycles{150});
  plant.advance(Cycles{150});
  EXPECT_EQ(plant.servo_enables(), 0);
  out.step = 1;
  plant.on_outputs(Cycles{160}, out);
  EXPECT_EQ(plant.drive_pulses(0), Pulses{0});
  EXPECT_NE(plant.ignored_pulses(0), Pulses{0});
}

TEST(DropOut, APlantWithoutTheRelayNeedsNoHeartbeat) {
  Plant plant{RobotSpec{}};
  SocOutputs out;
  out.servo_on = kAll;
  plant.on_outputs(Cycles{10}, out);
  while (plant.next_event() < Cycles{1'000'000}) plant.advance(plant.next_event());
  EXPECT_EQ(plant.servo_enables(), kAll);
}

}  // namespace
}  // namespace armature::cosim
