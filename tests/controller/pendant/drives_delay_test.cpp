#include "controller/pendant/parts/drives_delay.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace armature::pendant {
namespace {

Cycles ms(std::int64_t count) {
  return Cycles{count * 50'000};
}

TEST(DrivesDelay, SwitchesOnAtOnceWhenTheArmHasStoodForLong) {
  DrivesDelay delay;
  EXPECT_FALSE(delay.take_due(ms(1)));
  delay.request();
  EXPECT_TRUE(delay.requested());
  EXPECT_TRUE(delay.take_due(ms(1)));
  EXPECT_FALSE(delay.requested());
  EXPECT_FALSE(delay.take_due(ms(1)));
}

TEST(DrivesDelay, WaitsLongerAfterAnAlarmThanAfterDrivesThatWereSwitchedOff) {
  for (const auto& [cause, wait_ms] : {std::pair{FaultCause::kDrivesOff, 6}, std::pair{FaultCause::kEstop, 50}}) {
    DrivesDelay delay;
    delay.on_fault(cause);
    delay.update(ms(10));
    delay.update(ms(12));
    delay.request();
    EXPECT_FALSE(delay.take_due(ms(10 + wait_ms) - Cycles{1}));
    EXPECT_TRUE(delay.take_due(ms(10 + wait_ms)));
  }
}

TEST(DrivesDelay, ACancelledRequestIsNeverDue) {
  DrivesDelay delay;
  delay.request();
  delay.cancel();
  EXPECT_FALSE(delay.take_due(ms(1'000)));
}

}  // namespace
}  // namespace armature::pendant
