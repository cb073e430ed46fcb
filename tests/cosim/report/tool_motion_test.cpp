// ToolMotionMeter on set-points made by hand. A tick is 50 us.
#include "cosim/report/measure/tool_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace armature::cosim {
namespace {

using Eigen::Vector3d;

constexpr double kTick = 50e-6;

struct ToolMotion : testing::Test {
  ToolMotion() { row.telemetry.referenced = 0b01'1111; }

  void tick(const Vector3d& set_point_mm) {
    meter.add(row, set_point_mm);
    ++row.tick;
    row.cycle += 2500;
  }

  ToolMotionMeter meter{5};
  TraceRow row;
};

TEST_F(ToolMotion, OfAStraightLineIsItsSpeedAndItsAcceleration) {
  constexpr double kSpeed = 400, kAccel = 5000;  // 1600 ticks of acceleration
  const Vector3d start{400, -100, 300}, along = Vector3d{2, -3, 6} / 7;
  for (int i = 0; i < 2000; ++i) {
    const double t = i * kTick, rising = std::min(t, kSpeed / kAccel);
    tick(start + along * (kAccel * rising * rising / 2 + kSpeed * (t - rising)));
  }
  EXPECT_NEAR(meter.speed_mm_s()->value, kSpeed, 1e-6);
  EXPECT_NEAR(meter.accel_mm_s2()->value, kAccel, 1e-3);
}

TEST_F(ToolMotion, OfACircleIsTheSpeedAndTheCentripetalAcceleration) {
  constexpr double kSpeed = 100, kRadius = 20;
  for (int i = 0; i < 100; ++i) {
    const double angle = i * kTick * kSpeed / kRadius;
    tick({kRadius * std::cos(angle), kRadius * std::sin(angle), 7});
  }
  EXPECT_NEAR(meter.speed_mm_s()->value, kSpeed, 1e-4);
  EXPECT_NEAR(meter.accel_mm_s2()->value, kSpeed * kSpeed / kRadius, 1e-2);
}

TEST_F(ToolMotion, RemembersTheFirstTickOfThePeaks) {
  for (const double x : {0, 0, 1, 3, 4, 6}) tick({x, 0, 0});
  EXPECT_NEAR(meter.speed_mm_s()->value, 2 / kTick, 1e-9);
  EXPECT_EQ(meter.speed_mm_s()->at->tick, 3);
  EXPECT_EQ(meter.speed_mm_s()->at->at, Cycles{3 * 2500});
  EXPECT_NEAR(meter.accel_mm_s2()->value, 1 / (kTick * kTick), 1e-3);
  EXPECT_EQ(meter.accel_mm_s2()->at->tick, 2);
}

TEST_F(ToolMotion, IsUnknownUntilThereAreTwoAndThreeSetPoints) {
  tick({1, 2, 3});
  EXPECT_FALSE(meter.speed_mm_s());
  tick({1, 2, 3});
  EXPECT_EQ(meter.speed_mm_s()->value, 0);
  EXPECT_FALSE(meter.speed_mm_s()->at);
  EXPECT_FALSE(meter.accel_mm_s2());
  tick({1, 2, 3});
  EXPECT_EQ(meter.accel_mm_s2()->value, 0);
}

TEST_F(ToolMotion, AJumpAroundAFaultIsNoMotion) {
  for (const double x : {0, 1, 2}) tick({x, 0, 0});
  row.telemetry.state = MotionState::kFault;
  tick({90, 0, 0});
  row.telemetry.state = MotionState::kIdle;
  for (const double x : {500, 500, 501}) tick({x, 0, 0});
  EXPECT_NEAR(meter.speed_mm_s()->value, 1 / kTick, 1e-9);
  EXPECT_NEAR(meter.accel_mm_s2()->value, 1 / (kTick * kTick), 1e-3);
}

TEST_F(ToolMotion, IsNotMeasuredWhileAnAngleIsUnknown) {
  row.telemetry.referenced = 0b00'1111;
  for (const double x : {0, 5, 20}) tick({x, 0, 0});
  EXPECT_FALSE(meter.speed_mm_s());
  row.telemetry.referenced = 0b01'1111;
  for (const double x : {100, 101, 102}) tick({x, 0, 0});
  EXPECT_NEAR(meter.speed_mm_s()->value, 1 / kTick, 1e-9);
  EXPECT_NEAR(meter.accel_mm_s2()->value, 0, 1e-3);
}

}  // namespace
}  // namespace armature::cosim
