// Rounded corners where one segment brakes for a part of a tick before the next one begins: what lasts so short is
// within the joints' limits wherever set-points lie between ticks.
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "tests/controller/support/path_rig.hpp"
#include "tests/controller/support/random.hpp"

namespace armature {
namespace {

using test::PathRig;

// Five short lines with brisk limits and blends.
bool plan_corners(PathRig& rig, std::uint64_t seed) {
  test::Random random{seed};
  PerAxis<double> start_deg{};
  const PerAxis<double> low{-60, -20, -20, -60, 40, -60}, high{60, 20, 20, 60, 90, 60};
  for (std::size_t axis = 0; axis < kAxes; ++axis) start_deg[axis] = random.real(low[axis], high[axis]);
  const JointAngles start = test::degrees(start_deg);
  PathLimits limits = test::kBrisk;
  limits.speed_mm_s = random.real(80, 500);
  limits.accel_mm_s2 = random.real(1e4, 5e4);
  limits.turn_accel_rad_s2 = 200;
  limits.turn_speed_rad_s = 10;
  const double size_mm = random.real(2, 15);
  Transform at = rig.tool_at(start);
  std::vector<SegmentRequest> chain;
  for (int i = 0; i < 5; ++i) {
    const double x_mm = random.real(-1, 1) * size_mm;
    const double y_mm = random.real(-1, 1) * size_mm;
    const double z_mm = random.real(-1, 1) * size_mm * 0.5;
    at = test::moved(at, x_mm, y_mm, z_mm);
    const double blend_mm = random.real(0.05, 0.6) * size_mm;
    chain.push_back(test::line_to(at, limits, blend_mm));
  }
  return rig.plan(start, chain) == CartesianPlanner::Progress::kDone;
}

// Without a look between ticks these exceed the limit by 5 to 14 %.
TEST(CartesianKink, JointsKeepTheirAccelerationWhereverSetPointsLie) {
  for (const std::uint64_t seed : {253u, 401u, 2049u, 2183u, 3433u}) {
    PathRig rig{test::irb120()};
    ASSERT_TRUE(plan_corners(rig, seed));
    for (int eighths = 0; eighths < 8; ++eighths) {
      const test::JointPeaks peaks = test::joint_peaks(rig.robot, rig.set_points(eighths / 8.0));
      EXPECT_LE(peaks.accel, 1.0) << "seed " << seed << ", " << eighths << " eighths of a tick later: axis "
                                  << peaks.accel_axis << " at set-point " << peaks.accel_at;
    }
  }
}

}  // namespace
}  // namespace armature
