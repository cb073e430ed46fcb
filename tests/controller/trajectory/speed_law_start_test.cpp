// A law that must begin with a given speed, against closed forms: which demands close behind its start it takes back.
#include <gtest/gtest.h>

#include <memory>

#include "controller/trajectory/law/speed_law.hpp"

namespace armature {
namespace {

constexpr double kMaxSquare = 9.0, kStartSquare = 4.0;  // with an acceleration of 1

// Begins with kStartSquare, in a path of length 10.
std::unique_ptr<SpeedLaw> running_law() {
  LawLimits limits;
  limits.bands[0] = {.by_accel = 1.0};
  limits.most_square = kMaxSquare;
  auto law = std::make_unique<SpeedLaw>();
  for (int i = 0; i <= 100; ++i) {
    if (!law->append(0.1 * i, limits)) ADD_FAILURE();
  }
  law->start_with(kStartSquare);
  return law;
}

double square_at(const SpeedLaw& law, double s) {
  return law.square(law.point_at(s + 1e-9));
}

TEST(SpeedLawStart, BrakesWithAllItsAccelerationToACapThatIsTooClose) {
  const auto law = running_law();
  law->cap(0.5, 3.0, 2.0);
  law->plan();
  ASSERT_FALSE(law->starts_as_asked());
  ASSERT_TRUE(law->ease_start());
  law->plan();
  ASSERT_TRUE(law->starts_as_asked());
  EXPECT_NEAR(square_at(*law, 0.5), kStartSquare - 2.0 * 0.5, 1e-6);
  EXPECT_NEAR(square_at(*law, 1.0), 2.0, 1e-6);
  EXPECT_NEAR(square_at(*law, 2.9), 2.0, 1e-6);  // the rest of the cap remains
}

TEST(SpeedLawStart, TakesBackHalfOfASlowDownUntilItStartsAsAsked) {
  const auto law = running_law();
  law->plan();
  law->lower(0.2, 0.6, 0.4);  // of the speed: a square of 1.44, and an acceleration of 0.16
  law->plan();
  ASSERT_FALSE(law->starts_as_asked());
  int times = 0;
  for (; !law->starts_as_asked() && times < 20; ++times) {
    ASSERT_TRUE(law->ease_start());
    law->plan();
  }
  ASSERT_TRUE(law->starts_as_asked());
  EXPECT_LE(times, 3);
  EXPECT_LT(square_at(*law, 0.6), 0.7 * kMaxSquare);  // and no more than that
}

TEST(SpeedLawStart, HasNothingToTakeBackFromTheLimitsThemselves) {
  const auto law = running_law();
  law->start_with(kMaxSquare + 1.0);
  law->plan();
  ASSERT_FALSE(law->starts_as_asked());
  EXPECT_FALSE(law->ease_start());
}

}  // namespace
}  // namespace armature
