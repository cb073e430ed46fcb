// TrackingErrorMeter on rows made by hand: a belt along x at 100 mm/s, a part that passed at 0, a path that ends at 10
// mm.
#include "cosim/report/measure/tracking_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "cosim/report/measure/path_error.hpp"
#include "cosim/time/clock.hpp"
#include "tests/cosim/support/position_paths.hpp"

namespace armature::cosim {
namespace {

using Eigen::Vector3d;

constexpr double kSteady_mm_s = 100;

RobotSpec fast_drives() {
  RobotSpec spec;
  for (AxisSpec& axis : spec.axes) axis.drive.natural_hz = 1000;
  return spec;
}

ConveyorSpec steady_belt() {
  return {.speed_mm_s = kSteady_mm_s, .part_s = {0.0}};
}

struct TrackingErrorTest : testing::Test {
  void report(PartPhase phase) { meter.add(PartFollowed{.phase = phase, .tick = Ticks{row.tick}}); }
  void synchronise() {
    report(PartPhase::kBegun);
    meter.add(MoveStarted{.path = test::line_path({0, 0, 0}, {10, 0, 0}), .on_conveyor = true});
    report(PartPhase::kSynchronised);
  }
  // The set-point and the tool are beside the path by so much. A set-point is executed two ticks after the encoders
  // were read, which was at this trigger.
  void tick(double reference_mm, double encoder_mm) {
    row.telemetry.tick = Ticks{row.tick};
    const double belt_mm = kSteady_mm_s * to_seconds(Cycles{row.cycle}), two_ticks_mm = kSteady_mm_s * 2 * 50e-6;
    row.tool_point = ToolPoint{Vector3d{belt_mm + two_ticks_mm, reference_mm, 0}, Vector3d{belt_mm, 0, encoder_mm}};
    meter.add(row);
    ++row.tick;
    row.cycle += 2500;
  }

  TrackingErrorMeter meter{fast_drives(), steady_belt()};
  TraceRow row{.cycle = 2500};
};

TEST_F(TrackingErrorTest, HasTheRootOfTheMeanSquareOfAllMeasuredTicks) {
  tick(100, 100);  // the arm does not follow yet
  synchronise();
  const std::int64_t memory = memory_ticks(fast_drives());
  for (std::int64_t i = 0; i <= memory; ++i)
    tick(i % 2 == 0 ? 3 : 4, 100);  // the drives still respond to what was before
  ASSERT_TRUE(meter.rms_of_set_points_mm());
  EXPECT_FALSE(meter.rms_of_encoders_mm());
  for (const double mm : {1.0, 7.0, 1.0, 7.0}) tick(0, mm);
  report(PartPhase::kLeaving);
  tick(100, 100);
  const std::int64_t threes = memory / 2 + 1, fours = memory + 1 - threes;
  const double squares = 9.0 * static_cast<double>(threes) + 16.0 * static_cast<double>(fours);
  EXPECT_NEAR(*meter.rms_of_set_points_mm(), std::sqrt(squares / static_cast<double>(memory + 5)), 1e-9);
  EXPECT_NEAR(*meter.rms_of_encoders_mm(), 5.0, 1e-9);
  EXPECT_NEAR(meter.of_set_points()->mm, 4.0, 1e-9);
  EXPECT_NEAR(meter.of_encoders()->mm, 7.0, 1e-9);
}

TEST_F(TrackingErrorTest, HasNoneBeforeTheArmFollows) {
  tick(1, 1);
  EXPECT_FALSE(meter.rms_of_set_points_mm());
  EXPECT_FALSE(meter.of_set_points());
}

}  // namespace
}  // namespace armature::cosim
