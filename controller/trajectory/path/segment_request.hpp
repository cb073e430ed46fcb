// The request for one segment of the tool's path, with its limits.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "controller/base/members.hpp"
#include "controller/base/misfit.hpp"
#include "controller/base/tag.hpp"
#include "controller/kinematics/configuration.hpp"
#include "controller/kinematics/transform.hpp"
#include "controller/trajectory/path/path_output.hpp"
#include "controller/trajectory/path/position_path.hpp"
#include "controller/trajectory/path/spline.hpp"
#include "controller/trajectory/profile/time_law.hpp"

namespace armature {

// The largest value of any limit, in its own unit: far beyond any joint, and its square is still finite.
inline constexpr double kLargestPathLimit = 1e30;

// Limits of the tool's motion along the path. Rotation has its own limits, because a pure rotation has no length. Up to
// the middle of a rounded corner those of the first segment apply, then those of the second.
struct PathLimits {
  double speed_mm_s = 0.0;   // > 0, as all of these, and <= kLargestPathLimit
  double accel_mm_s2 = 0.0;  // of the tool centre point, centripetal part included
  // kSCurve only: the whole jerk, also across the path, as the third difference of the set-points. It is exceeded by at
  // most 5 %. The joints keep their own jerk limits as well.
  double jerk_mm_s3 = 0.0;
  double turn_speed_rad_s = 0.0;
  double turn_accel_rad_s2 = 0.0;
  double turn_jerk_rad_s3 = 0.0;  // kSCurve only
  double joint_accel = 1.0;       // share of the joints' acceleration limits, (0, 1]
  ARMATURE_MEMBERS(PathLimits, speed_mm_s, accel_mm_s2, jerk_mm_s3, turn_speed_rad_s, turn_accel_rad_s2,
                   turn_jerk_rad_s3, joint_accel)
};

// The larger of both, limit by limit.
[[nodiscard]] PathLimits larger(const PathLimits& a, const PathLimits& b) noexcept;

// A motion around an axis, and along it at the same time (arc_about()).
struct AboutAxis {
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  // of any length
  double angle_rad = 0.0;                           // right-handed about the axis, up to kMaxRevolutions either way
  double advance_mm = 0.0;                          // along the axis
  ARMATURE_MEMBERS(AboutAxis, axis, angle_rad, advance_mm)
};
inline constexpr double kMaxRevolutions = 100.0;

// The points between the start and the end of a spline, in their order.
struct ThroughPoints {
  static constexpr std::size_t kMax = Spline::kMaxPoints - 2;
  ThroughPoints() noexcept { mm.fill(Eigen::Vector3d::Zero()); }
  [[nodiscard]] constexpr const void* misfit() const noexcept { return first_misfit({{&count, count <= kMax}}); }
  [[nodiscard]] std::span<const Eigen::Vector3d> view() const noexcept { return {mm.data(), count}; }
  std::array<Eigen::Vector3d, kMax> mm;
  std::uint8_t count = 0;  // 1..kMax for a spline
  ARMATURE_MEMBERS(ThroughPoints, mm, count)
};

// What to do where the joints cannot follow the tool at its speed because the path passes a singularity.
enum class AtSingularity : std::uint8_t {
  kRefuse,  // refuse the path
  kSlow,    // slow down there, up to the largest stretch of the planner
  kBend,  // wrist singularity: leave the orientation by at most orientation_tolerance_rad. The tool point stays on the
          // path. Where that is not enough, and at other singularities: as kSlow
};

// One requested segment, in the base frame. It begins at the end of the previous one.
struct SegmentRequest {
  enum class Kind : std::uint8_t { kLine, kArc, kCircle, kArcAbout, kSpline };
  Kind kind = Kind::kLine;
  Eigen::Vector3d via_mm = Eigen::Vector3d::Zero();  // kArc, kCircle: second point; kArcAbout: a point of the axis
  AboutAxis about{};                                 // kArcAbout
  // kSpline: the 1..ThroughPoints::kMax points between its start and its end, which are not copied with the request.
  std::span<const Eigen::Vector3d> through_mm{};
  Transform target{};  // base_T_tool at the end. kCircle: its position is the third point of the circle; kArcAbout: its
                       // position has no effect
  // The rotation of the target was not requested. It is the tool's own, as ArmPlane::kept() defines it, so its error is
  // always 0.
  bool keeps_orientation = false;
  // kTangent: with the tangent of the path; the rotation of the target is that of turn_with() at the end. kSlerp: as
  // kSteady, but on five joints about one axis in space, for any tool.
  enum class Turning : std::uint8_t { kSteady, kTangent, kSlerp };
  Turning turning = Turning::kSteady;
  PathLimits limits{};
  ProfileKind profile = ProfileKind::kTrapezoid;
  // Largest distance of the rounded corner to the next segment from the corner point and from both segments; 0: exact
  // stop, except where the next segment continues in the same direction. Half of the shorter segment may be rounded.
  // Within the corner both rotations are superposed, and so are pitch and roll. The corner is so short that the
  // rotation, as the way of a point kTurnLever_mm from the tool point, keeps this distance as well (path_corners.hpp).
  // Where jerk is limited, a jump of the curvature, as between a line and an arc, is rounded as well.
  double blend_mm = 0.0;
  AtSingularity at_singularity = AtSingularity::kSlow;
  double orientation_tolerance_rad = 0.0;  // kBend
  Configuration configuration{};           // requested at the end; the path is refused if it ends with another one
  PathOutputs outputs{};
  bool rapid = false;  // of the command, for its event
  Tag tag{};           // of the command
};

// The path of the tool centre point from `from_mm`. `curve` becomes that of a spline and must outlive the path; it is
// not changed for other kinds. Nothing if the points of an arc or a circle do not determine one, or those of a spline
// are refused by Spline::through().
[[nodiscard]] std::optional<PositionPath> path_of(const SegmentRequest& request, const Eigen::Vector3d& from_mm,
                                                  Spline& curve) noexcept;

}  // namespace armature
