#include "cosim/cli/run/pace.hpp"

#include <gtest/gtest.h>

#include <chrono>

namespace armature::cosim {
namespace {

using std::chrono::milliseconds;
constexpr Pace::Clock::time_point kStart{std::chrono::hours{1}};
constexpr Pace::Clock::duration kZero = Pace::Clock::duration::zero();

TEST(Pace, WaitsUntilTheShareOfRealTimeHasPassed) {
  Pace half{0.5, kStart};
  EXPECT_EQ(half.wait(0.1, kStart), milliseconds{200});
  EXPECT_EQ(half.wait(0.1, kStart + milliseconds{150}), milliseconds{50});
  EXPECT_EQ(half.wait(0.1, kStart + milliseconds{200}), kZero);
}

TEST(Pace, MakesUpForAShortDelay) {
  Pace real{1.0, kStart};
  EXPECT_EQ(real.wait(0.1, kStart + milliseconds{190}), kZero);
  EXPECT_EQ(real.wait(0.2, kStart + milliseconds{195}), milliseconds{5});
}

TEST(Pace, DoesNotHurryAfterALongDelay) {
  Pace real{1.0, kStart};
  EXPECT_EQ(real.wait(0.1, kStart + milliseconds{5100}), kZero);
  // 100 ms of the delay are made up for, 4900 ms are not.
  EXPECT_EQ(real.wait(0.2, kStart + milliseconds{5100}), kZero);
  EXPECT_EQ(real.wait(0.3, kStart + milliseconds{5100}), milliseconds{100});
}

}  // namespace
}  // namespace armature::cosim
