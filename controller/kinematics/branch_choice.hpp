// Which of the branches of an inverse kinematics the arm should take, and with how many turns of each joint.
#pragma once

#include <cstddef>

#include "controller/core/axes.hpp"
#include "controller/kinematics/ik_result.hpp"

namespace armature {

// What the choice must know of a joint, in the vendor's convention.
struct JointRange {
  double min_rad = 0.0;
  double max_rad = 0.0;          // >= min_rad
  double max_speed_rad_s = 1.0;  // > 0
};

// An angle beyond a limit by no more than this is rounding, a ten-thousandth of a pulse, and is taken as the limit.
inline constexpr double kLimitTolerance_rad = 1e-9;

// By how much an angle is outside its limits [rad]; 0: inside. Snaps an angle that is beyond by rounding only.
[[nodiscard]] double limit_excess(double& joint_rad, const JointRange& range) noexcept;

// joint_rad + n turns inside the limits and nearest to previous_rad, or where there is none the one that misses them by
// least.
[[nodiscard]] double turn_inside(double joint_rad, double previous_rad, const JointRange& range) noexcept;

// For solutions whose `branches` hold joints modulo 360 degrees: fills the turns, within_limits and outside_axis of
// every branch, then selected, status, singular and axis. The selected branch takes least time, max_i |q_i -
// previous_i| / speed_i over the joints; equal times are told apart by the sum of their squares, and then by the order
// of branches. Solutions without branches are left alone.
void choose_branch(IkSolutions& solutions, const JointAngles& previous, const PerAxis<JointRange>& ranges) noexcept;

}  // namespace armature
