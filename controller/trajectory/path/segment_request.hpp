// The request for one segment of the tool's path, with its limits.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "controller/core/tag.hpp"
#include "controller/kinematics/transform.hpp"
#include "controller/trajectory/profile/time_law.hpp"

namespace armature {

// The largest value of any limit, in its own unit: far beyond any joint, and its square is still finite.
inline constexpr double kLargestPathLimit = 1e30;

// Limits of the tool's motion along the path. Rotation has its own limits, because a pure rotation has no length. In a
// rounded corner the larger limits of both segments apply.
struct PathLimits {
  double speed_mm_s = 0.0;   // > 0, as all of these, and <= kLargestPathLimit
  double accel_mm_s2 = 0.0;  // of the tool centre point, centripetal part included
  // kSCurve only: jerk of the time law, along the path. On an arc there is also a jerk across the path, 3 v a_along /
  // r, which reaches 1.53 times this limit. The joints keep their own jerk limits in any case.
  double jerk_mm_s3 = 0.0;
  double turn_speed_rad_s = 0.0;
  double turn_accel_rad_s2 = 0.0;
  double turn_jerk_rad_s3 = 0.0;  // kSCurve only
};

// One requested segment, in the base frame. It begins at the end of the previous one.
struct SegmentRequest {
  enum class Kind : std::uint8_t { kLine, kArc, kCircle };
  Kind kind = Kind::kLine;
  Eigen::Vector3d via_mm = Eigen::Vector3d::Zero();  // kArc, kCircle: second point
  Transform target{};  // base_T_tool at the end. kCircle: its position is the third point of the circle
  // The rotation of the target was not requested. It is the tool's own, as ArmPlane::kept() defines it, so its error is
  // always 0.
  bool keeps_orientation = false;
  PathLimits limits{};
  ProfileKind profile = ProfileKind::kTrapezoid;
  // How far from the corner to the next segment the tool point may leave the path; 0: exact stop. The orientation has
  // no tolerance of its own. Within the overlap both rotations are superposed: the error against the first one is what
  // the second one has covered, the error against the second one is what the first one has left. Both shares are those
  // of the lengths: at most min(blend_mm / length, 1/2) of the rotation of either segment. The same holds for pitch and
  // roll.
  double blend_mm = 0.0;
  Tag tag{};  // of the command
};

}  // namespace armature
