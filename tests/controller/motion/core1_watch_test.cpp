// Core 0 watches core 1: both cores of the controller, of which core 1 stops.
#include <gtest/gtest.h>

#include "controller/motion/loop_channel.hpp"
#include "tests/controller/support/controller_rig.hpp"

namespace armature {
namespace {

using test::ControllerRig;
using test::kFigure9Deg;

TEST(Core1Watch, ASilentCore1IsAFaultUntilItAnswers) {
  ControllerRig rig;
  bool awake = true;
  rig.core1_awake = [&] { return awake; };
  rig.at(10'500, [&] { awake = false; });
  rig.at(20'000, [&] { awake = true; });
  rig.submit_at(20'200, ClearFault{});
  rig.move_at(21'000, kFigure9Deg);
  rig.run(40'000);
  ASSERT_EQ(rig.faults.size(), 1u);
  EXPECT_EQ(rig.faults[0].cause, FaultCause::kCore1Silent);
  // The first question that stays without an answer is asked within a period.
  EXPECT_GT(rig.faults[0].tick, Ticks{10'498} + Core1Watch::kPatience);
  EXPECT_LE(rig.faults[0].tick, Ticks{10'502} + Core1Watch::kPatience + Core1Watch::kPeriod);
  EXPECT_EQ(rig.logic.servo_on(), 0x3Fu);
  EXPECT_EQ(rig.last().state, MotionState::kIdle);
  rig.expect_at(kFigure9Deg);
}

TEST(Core1Watch, WaitsForCore1) {
  ControllerRig rig;
  bool awake = true;
  rig.core1_awake = [&] { return awake; };
  rig.at(10'500, [&] { awake = false; });
  rig.at(10'500 + Core1Watch::kPatience.value(), [&] { awake = true; });
  rig.run(20'000);
  EXPECT_TRUE(rig.faults.empty());
}

}  // namespace
}  // namespace armature
