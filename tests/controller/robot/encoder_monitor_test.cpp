// The monitor of encoder speed and acceleration: its limits, to the count, and its windows.
#include "controller/robot/encoder_monitor.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/controller/support/robots.hpp"

namespace armature {
namespace {

// 500 000 counts per turn of the joint, 20 000 ticks per second: 1 count per tick is 14.4 deg/s.
constexpr double kDegSOfCount = 14.4;

RobotModel robot_with(double speed_deg_s, double accel_deg_s2) {
  RobotModel robot = test::paper_robot();
  robot.axes[2].encoder_speed_rad_s = speed_deg_s * test::kDeg;
  robot.axes[2].encoder_accel_rad_s2 = accel_deg_s2 * test::kDeg;
  return robot;
}

class Encoders {
 public:
  explicit Encoders(const RobotModel& robot) : monitor_{robot} {}
  // Moves axis 3 for so many ticks. Adds what was found.
  void move(int ticks, std::int64_t counts_per_tick) {
    for (int i = 0; i < ticks; ++i) {
      counts_[2] += Counts{counts_per_tick};
      monitor_.observe(counts_);
      too_fast |= monitor_.too_fast();
      too_hard |= monitor_.too_hard();
    }
  }
  void restart() { monitor_.restart(); }
  unsigned too_fast = 0, too_hard = 0;

 private:
  PerAxis<Counts> counts_{};
  EncoderMonitor monitor_;
};

TEST(EncoderMonitor, FindsASpeedAboveTheLimitWithinTwoWindows) {
  for (const std::int64_t sign : {1, -1}) {
    Encoders at_limit{robot_with(10 * kDegSOfCount, 0)};
    at_limit.move(400, sign * 10);
    EXPECT_EQ(at_limit.too_fast, 0u);
    Encoders above{robot_with(9.9 * kDegSOfCount, 0)};
    above.move(7, 0);
    above.move(2 * static_cast<int>(EncoderMonitor::kSpeedTicks), sign * 10);
    EXPECT_EQ(above.too_fast, 0b000100u);
  }
}

TEST(EncoderMonitor, FindsAChangeOfSpeedAboveTheLimitAndNoSlowerOne) {
  // From rest to 10 counts per tick within a window of 100 ticks: 1000 counts, less the rounding of two.
  const double accel = 10 * kDegSOfCount / 0.005;
  for (const bool above : {false, true}) {
    Encoders encoders{robot_with(0, above ? 0.99 * accel : 1.001 * accel)};
    encoders.move(205, 0);  // the windows of axis 3 begin at the fifth tick
    encoders.move(200, 10);
    EXPECT_EQ(encoders.too_hard, above ? 0b000100u : 0u);
    encoders.too_hard = 0;
    encoders.move(200, 0);
    EXPECT_EQ(encoders.too_hard, above ? 0b000100u : 0u) << "an encoder that stops";
  }
}

TEST(EncoderMonitor, WithoutLimitsItFindsNothingAndAfterARestartNothingOfBefore) {
  Encoders free{robot_with(0, 0)};
  free.move(300, 100'000);
  EXPECT_EQ(free.too_fast | free.too_hard, 0u);
  Encoders encoders{robot_with(100 * kDegSOfCount, 100)};
  encoders.move(150, 50);
  encoders.restart();
  encoders.move(150, 0);
  EXPECT_EQ(encoders.too_fast | encoders.too_hard, 0u);
}

}  // namespace
}  // namespace armature
