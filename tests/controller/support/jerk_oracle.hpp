// The shortest motion along a path under limits of jerk, found without any code of the planner's laws: a law on a fine
// grid, equally spaced in time, by an interior-point method.
//
// b is the square of the speed of the parameter, a its acceleration: b' = 2 a. With the derivatives of a joint or of
// the tool by the parameter, its acceleration q' a + q'' b is linear in the law. Its jerk is the difference of two
// accelerations divided by the time between them. What the method finds is a motion; that it keeps the limits is
// checked on samples every 50 us, and where it does not, the limits are lowered.
#pragma once

#include "tests/controller/support/path_rig.hpp"

namespace armature::test {

// The largest values on samples every 50 us, as shares of the limits of joints and tool.
struct SampledShares {
  double speed = 0.0, accel = 0.0, jerk = 0.0;
};

struct OracleMotion {
  double duration_s = 0.0;
  SampledShares shares{};
};

// The motion along the path of the plan in `rig`, with exact stops where that has them. All its segments have the same
// limits. `nodes`: of the finest grid between two stops. The first grid has its points where the plan is at equally
// spaced times; the path has no joint at which the tangent or the curvature jumps.
[[nodiscard]] OracleMotion fastest_with_jerk(const PathRig& rig, int nodes);

// Of the set-points of the plan in `rig` itself, `shift` ticks before each tick.
[[nodiscard]] SampledShares shares_of_plan(const PathRig& rig, double shift = 0.0);

}  // namespace armature::test
