#include "controller/language/job/state/pin_levels.hpp"

#include <gtest/gtest.h>

#include "tests/controller/language/job/machine_rig.hpp"

namespace armature::job {
namespace {

TEST(PinLevels, AreThoseOfThePortUpToTheLastPinOfTheArm) {
  test::RecordingPort port;
  PinLevels levels;
  port.inputs[16] = true;
  port.outputs[15] = true;
  levels.set(17, true);
  EXPECT_TRUE(levels.level(16, false, port));
  EXPECT_FALSE(levels.level(16, true, port));
  EXPECT_TRUE(levels.level(15, true, port));
  EXPECT_FALSE(levels.level(15, false, port));
  EXPECT_TRUE(levels.level(17, true, port));
  EXPECT_FALSE(levels.level(18, true, port));
  levels.set(PinLevels::kMaxOutputs, true);
  EXPECT_TRUE(levels.level(PinLevels::kMaxOutputs, true, port));
  levels.reset();
  EXPECT_FALSE(levels.level(17, true, port));
}

TEST(PinLevels, KnowHowManyPinsAGroupHas) {
  EXPECT_EQ(pins_of(IoType::kInput), 1U);
  EXPECT_EQ(pins_of(IoType::kOutputHalfGroup), 4U);
  EXPECT_EQ(pins_of(IoType::kInputGroup), 8U);
  EXPECT_EQ(pins_of(IoType::kRegister), 0U);
  EXPECT_TRUE(is_output(IoType::kOutputGroup));
  EXPECT_FALSE(is_output(IoType::kInputGroup));
}

}  // namespace
}  // namespace armature::job
