#include "controller/base/rounding.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/controller/support/random.hpp"

namespace armature {
namespace {

TEST(RoundHalfAway, TakesTiesAwayFromZero) {
  EXPECT_EQ(round_half_away(0.5), 1);
  EXPECT_EQ(round_half_away(-0.5), -1);
  EXPECT_EQ(round_half_away(2.5), 3);
  EXPECT_EQ(round_half_away(-2.5), -3);
  EXPECT_EQ(round_half_away(-0.0), 0);
}

TEST(RoundHalfAway, IsRightJustBelowATie) {
  EXPECT_EQ(round_half_away(0.49999999999999994), 0);  // where floor(x + 0.5) gives 1
  EXPECT_EQ(round_half_away(-0.49999999999999994), 0);
  EXPECT_EQ(round_half_away(4503599627370495.5), 4503599627370496);
  EXPECT_EQ(round_half_away(9007199254740993.0), 9007199254740992);  // the double nearest to the literal
}

TEST(RoundHalfAway, AgreesWithTheStandardLibrary) {
  test::Random random{1};
  for (int i = 0; i < 100'000; ++i) {
    const double largest = i % 2 == 0 ? 1e9 : 1e13, x = random.real(-largest, largest);
    ASSERT_EQ(round_half_away(x), std::llround(x)) << x;
  }
}

TEST(RoundedUp, AgreesWithTheStandardLibrary) {
  test::Random random{2};
  for (int i = 0; i < 100'000; ++i) {
    const double x = random.real(-1e9, 1e9), whole = std::floor(x);
    ASSERT_EQ(rounded_up(x), std::ceil(x)) << x;
    ASSERT_EQ(rounded_up(whole), whole) << x;
  }
}

}  // namespace
}  // namespace armature
