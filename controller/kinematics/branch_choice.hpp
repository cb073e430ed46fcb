// Selects the branch of an inverse kinematics, and the number of turns of each joint.
#pragma once

#include <cstddef>

#include "controller/base/axes.hpp"
#include "controller/kinematics/ik_result.hpp"

namespace armature {

// The properties of a joint that the choice needs, in the vendor's convention.
struct JointRange {
  double min_rad = 0.0;
  double max_rad = 0.0;          // >= min_rad
  double max_speed_rad_s = 1.0;  // > 0
};

// An angle beyond a limit by at most this is treated as the limit: it is rounding, a ten-thousandth of a pulse.
inline constexpr double kLimitTolerance_rad = 1e-9;

// By how much an angle is outside its limits [rad]; 0: inside. Sets an angle that is outside by rounding only to the
// limit.
[[nodiscard]] inline double limit_excess(double& joint_rad, const JointRange& range) noexcept {
  const double above_rad = joint_rad - range.max_rad, below_rad = range.min_rad - joint_rad;
  if (above_rad <= 0.0 && below_rad <= 0.0) return 0.0;
  const double excess_rad = above_rad > below_rad ? above_rad : below_rad;
  if (excess_rad > kLimitTolerance_rad) return excess_rad;
  joint_rad = above_rad > 0.0 ? range.max_rad : range.min_rad;
  return 0.0;
}

// nearest_rad, which has the turn nearest to the previous angle, + n turns: the value inside the limits nearest to the
// previous angle, or, if there is none, the one nearest to the limits.
[[nodiscard]] double turned_inside(double nearest_rad, const JointRange& range) noexcept;

// The sum of the squares of the times of the joints in a joint move at full speed, |q_i - previous_i| / speed_i [s^2].
[[nodiscard]] double move_squares_s2(const JointAngles& joints, const JointAngles& previous,
                                     const PerAxis<JointRange>& ranges) noexcept;

// For solutions whose `branches` contain joints modulo 360 degrees. Fills the turns, within_limits and outside_axis of
// every branch, then selected, status, singular and axis. The selected branch takes the least time, that of the
// slowest joint. Equal times are ordered by move_squares_s2(), then by the order of branches. Solutions without
// branches are not changed. The previous joints must be within kLargestTheta_rad.
void choose_branch(IkSolutions& solutions, const JointAngles& previous, const PerAxis<JointRange>& ranges) noexcept;

}  // namespace armature
