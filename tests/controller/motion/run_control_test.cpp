#include "controller/motion/run_control.hpp"

#include <gtest/gtest.h>

namespace armature {
namespace {

TEST(RunControl, StartsReleasedAtFullRate) {
  const RunControl control;
  EXPECT_FALSE(control.view().hold);
  EXPECT_EQ(control.view().share, 1.0);
}

TEST(RunControl, HoldAndShareDoNotTouchEachOther) {
  RunControl control;
  control.set_share(0.37);
  control.set_hold(true);
  EXPECT_TRUE(control.view().hold);
  EXPECT_EQ(control.view().share, 0.37);
  control.set_share(0.01);
  EXPECT_TRUE(control.view().hold);
  EXPECT_EQ(control.view().share, 0.01);
  control.set_hold(false);
  control.set_hold(false);
  EXPECT_FALSE(control.view().hold);
  EXPECT_EQ(control.view().share, 0.01);
}

TEST(RunControl, KeepsWholePercentExactlyAndEverythingElseInMillionths) {
  RunControl control;
  for (int percent = 1; percent <= 100; ++percent) {
    control.set_share(percent / 100.0);
    EXPECT_EQ(control.view().share, percent / 100.0);
  }
  control.set_share(1.0 / 3.0);
  EXPECT_EQ(control.view().share, 0.333333);
}

}  // namespace
}  // namespace armature
