// The overload alarm of a drive against its closed form: with x times the rated torque its heat rises by (x^2 - k) / H
// in a second, and trips at 1. k and H follow from the times at two and three times the rated torque.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/cosim/servo/servo_rig.hpp"

namespace armature::cosim {
namespace {

constexpr double kAt200 = 0.8, kAt300 = 0.28;                             // [s]
constexpr double kNever = (4 * kAt200 - 9 * kAt300) / (kAt200 - kAt300);  // k
constexpr double kHeat = (9 - kNever) * kAt300;                           // H [s]
constexpr double kTenthOfPercent = 1e-3;

// The shaft of a drive whose torque is limited to `times` the rated one is held.
class HeldDrive {
 public:
  explicit HeldDrive(double times, bool has_alarm = true) : rig_{spec(times, has_alarm)} {
    rig_.step();
    rig_.arm.block(0, true);
  }

  void push(double seconds) { go(seconds, true); }
  void rest(double seconds) { go(seconds, false); }
  void off(double seconds) { rig_.run(seconds, false); }
  [[nodiscard]] bool tripped() const { return (rig_.arm.overloaded() & 1) != 0; }
  [[nodiscard]] bool asks_for_steps() const { return rig_.speed[0] != 0; }

  // The time of pushing until it trips, at most `limit` [s].
  double time_to_trip(double limit = 5) {
    rig_.error[0] = kFarAway;
    long steps = 0;
    for (; !tripped() && static_cast<double>(steps) * test::kServoStep < limit; ++steps) rig_.step();
    return static_cast<double>(steps) * test::kServoStep;
  }

 private:
  static constexpr double kFarAway = -1e6;  // [counts], for which the loops demand all the torque

  static AxisSpec spec(double times, bool has_alarm) {
    constexpr double kRated = 1.27;
    AxisSpec axis = test::plain_servo();
    axis.drive.max_torque_nm = times * kRated;
    if (!has_alarm) return axis;
    axis.dynamics->rated_torque_nm = kRated;
    axis.dynamics->overload_200_s = kAt200;
    axis.dynamics->overload_300_s = kAt300;
    return axis;
  }

  void go(double seconds, bool pushes) {
    rig_.error[0] = pushes ? kFarAway : 0;
    rig_.run(seconds);
  }

  test::ServoRig rig_;
};

TEST(ServoOverload, TripsAfterTheTimesOfTheRobotFile) {
  EXPECT_NEAR(HeldDrive{2}.time_to_trip(), kAt200, kTenthOfPercent * kAt200);
  EXPECT_NEAR(HeldDrive{3}.time_to_trip(), kAt300, kTenthOfPercent * kAt300);
}

TEST(ServoOverload, TripsSoonerWithTheSquareOfTheTorque) {
  for (const double times : {1.7, 2.5, 4.0}) {
    const double wanted = kHeat / (times * times - kNever);
    EXPECT_NEAR(HeldDrive{times}.time_to_trip(), wanted, kTenthOfPercent * wanted) << times;
  }
}

TEST(ServoOverload, NeverTripsBelowALittleMoreThanTheRatedTorque) {
  EXPECT_GT(kNever, 1);
  constexpr double kLong = 2.5;  // [s]
  EXPECT_EQ(HeldDrive{0.99 * std::sqrt(kNever)}.time_to_trip(kLong), kLong);
  EXPECT_EQ((HeldDrive{3, false}.time_to_trip(kLong)), kLong);
}

TEST(ServoOverload, RemembersTheHeatOfEarlierPushesLessWhatHasCooledDown) {
  for (const bool is_off : {false, true}) {
    HeldDrive drive{3};
    drive.push(0.2);
    if (is_off) {
      drive.off(0.3);
    } else {
      drive.rest(0.3);
    }
    const double heat = (0.2 * (9 - kNever) - 0.3 * kNever) / kHeat;
    const double wanted = (1 - heat) * kAt300;
    EXPECT_NEAR(drive.time_to_trip(), wanted, kTenthOfPercent * kAt300);
  }
  HeldDrive cold{3};
  cold.push(0.05);
  cold.rest(1);
  EXPECT_NEAR(cold.time_to_trip(), kAt300, kTenthOfPercent * kAt300);
}

TEST(ServoOverload, IsOverWhenTheDriveIsOffAndComesSoonerAgainWhileItIsHot) {
  HeldDrive drive{3};
  drive.time_to_trip();
  drive.off(0.1);
  EXPECT_FALSE(drive.tripped());
  const double wanted = 0.1 * kNever / (9 - kNever);
  EXPECT_NEAR(drive.time_to_trip(), wanted, kTenthOfPercent * kAt300);
}

// The plant makes steps while a shaft has a speed.
TEST(ServoOverload, AsksForStepsUntilItIsCold) {
  HeldDrive drive{3};
  drive.push(0.05);
  const double cold_after = 0.05 * (9 - kNever) / kNever;
  drive.rest(0.99 * cold_after);
  EXPECT_TRUE(drive.asks_for_steps());
  drive.rest(0.02 * cold_after);
  EXPECT_FALSE(drive.asks_for_steps());
}

}  // namespace
}  // namespace armature::cosim
