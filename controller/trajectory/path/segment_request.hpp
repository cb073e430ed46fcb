// What is asked of the tool: one piece of path, and how fast it may be driven.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "controller/core/tag.hpp"
#include "controller/kinematics/transform.hpp"
#include "controller/trajectory/profile/time_law.hpp"

namespace armature {

// The largest of any limit, in its own unit: far beyond what a joint can do, and its square is a number still.
inline constexpr double kLargestPathLimit = 1e30;

// Limits of the tool's motion along the path. Turning has its own, because a pure rotation has no length. In a rounded
// corner the larger ones of both segments hold.
struct PathLimits {
  double speed_mm_s = 0.0;   // > 0, as all of these, and <= kLargestPathLimit
  double accel_mm_s2 = 0.0;  // of the tool centre point, centripetal part included
  // kSCurve only; of the time law, along the path. An arc jerks across it, too: 3 v a_along / r, which reaches 1.53
  // times this limit. Joints keep their own jerk limits all the same.
  double jerk_mm_s3 = 0.0;
  double turn_speed_rad_s = 0.0;
  double turn_accel_rad_s2 = 0.0;
  double turn_jerk_rad_s3 = 0.0;  // kSCurve only
};

// One segment as it was asked for, in the base frame. It begins where the one before ends.
struct SegmentRequest {
  enum class Kind : std::uint8_t { kLine, kArc, kCircle };
  Kind kind = Kind::kLine;
  Eigen::Vector3d via_mm = Eigen::Vector3d::Zero();  // kArc, kCircle: second point
  Transform target{};  // base_T_tool at the end. kCircle: its position is the third point of the circle
  // The target's rotation was not asked for: it is the tool's own, as ArmPlane::kept() has it there, and cannot be
  // missed.
  bool keeps_orientation = false;
  PathLimits limits{};
  ProfileKind profile = ProfileKind::kTrapezoid;
  // How far from the corner to the next segment the tool point may leave the path; 0: exact stop. There is no tolerance
  // of the orientation: within the overlap both turns are superposed, so it is off the first turn by what the second
  // one has covered, and off the second by what the first one has left. Both shares are those of the lengths: at most
  // min(blend_mm / length, 1/2) of the turn of either segment. The same holds for pitch and roll.
  double blend_mm = 0.0;
  Tag tag{};  // of the command
};

}  // namespace armature
