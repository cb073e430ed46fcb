// A checked motion of the tool along lines and arcs, ready to be executed: up to kMostSegments segments, each with its
// own time law, the next one beginning before the one before has ended where the corner may be rounded.
//
// Blending is superposition: while two segments overlap in time, the tool is where the first one has it, plus what the
// second one has covered. It leaves the corner by less than the shorter of the two remaining ways, so the tolerance in
// mm decides how long they overlap. Orientations are superposed the same way; so are pitch and roll.
//
// On a five-axis arm orientations have to stay in the arm's plane; Turning tells how, five_axis_turning.hpp which.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "controller/core/tag.hpp"
#include "controller/core/units.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/kinematics/ik_result.hpp"
#include "controller/kinematics/transform.hpp"
#include "controller/trajectory/path/arm_plane.hpp"
#include "controller/trajectory/path/orientation_path.hpp"
#include "controller/trajectory/path/position_path.hpp"
#include "controller/trajectory/path/segment_request.hpp"
#include "controller/trajectory/profile/time_law.hpp"

namespace armature {

// How the tool turns along a segment. Whatever it is, the tool centre point stays on the path.
enum class Turning : std::uint8_t {
  kInSpace,   // about one axis that is fixed in space
  kUpright,   // the same, then brought into the arm's plane: an upright hand that is not vertical to rounding
  kFollowing  // pitch and roll change steadily, the heading follows the tool point
};

// Both angles change linearly with the share of the path.
struct PlaneTurn {
  PlaneAngles start{};
  PlaneAngles way{};  // signed
};

// A rate_bend where jerk is not limited.
inline constexpr double kAnyBend = std::numeric_limits<double>::infinity();

struct CartesianSegment {
  PositionPath path{};  // of the tool centre point, in the base frame
  Turning turning = Turning::kInSpace;
  OrientationPath orientation{};  // of the tool, in the base frame; not of kFollowing
  PlaneTurn plane_turn{};         // kFollowing only
  TimeLaw law{};                  // of s = 0..1 for position and orientation alike; takes whole ticks
  Ticks start{};                  // from the start of the plan
  Ticks duration{};
  PathLimits limits{};             // of the tool, as they were asked for: a change of the rate keeps them too
  double stretch = 1.0;            // by how much the time law was slowed down for the joints, >= 1
  std::uint8_t stretched_for = 0;  // joint 1..6 that asked for most of it; 0: none, or the tool in a rounded corner
  // Five joints: by how much the tool misses the orientation that was asked for, at the end of the segment or, where an
  // upright hand turns, at its worst set-point; 0 for six.
  double residual_rad = 0.0;
  double rate_bend = kAnyBend;  // w of rate_bend.hpp: how suddenly the rate may change while the segment is under way
  Tag tag{};                    // of the command
};

struct CartesianPlan {
  static constexpr std::size_t kMostSegments = 16;

  CartesianPlan() = default;
  // Only `count` segments are copied, and those beyond stay what they were: a plan of one is a tenth of the bytes of
  // one of 16, and the motion loop copies it within a tick, out of memory that the other core has written.
  CartesianPlan(const CartesianPlan& other) noexcept { *this = other; }
  CartesianPlan& operator=(const CartesianPlan& other) noexcept;

  JointAngles start{};
  JointAngles target{};
  Transform tool_T_flange{};  // inverse of what the tool is on the flange
  std::array<CartesianSegment, kMostSegments> segments{};
  std::size_t count = 0;
  Ticks duration{};  // of all
};

// The tick of the plan at which the segment ends.
[[nodiscard]] inline Ticks end_of(const CartesianSegment& segment) noexcept {
  return segment.start + segment.duration;
}

// By how much the tool turns on the segment, as far as its limits of turning go: the heading that follows the tool
// point is left out, since it comes with the position. kFollowing: hypot of pitch and roll.
[[nodiscard]] double turn_angle_rad(const CartesianSegment& segment) noexcept;

// How much of its path the segment has covered `t_s` after the start of the plan, 0..1; exactly 1 from its end on.
[[nodiscard]] double share_at(const CartesianSegment& segment, double t_s) noexcept;

struct ToolSample {
  HeldTool tool{};
  // What the limits of turning are about: pitch and roll where the heading follows, this rotation otherwise.
  std::optional<PlaneAngles> in_plane{};
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
};

// By how much the tool turns between two close samples, as its limits of turning count it, rad: (pitch, roll, 0), or
// the rotation vector in the base frame.
[[nodiscard]] Eigen::Vector3d limited_turn(const ToolSample& from, const ToolSample& to) noexcept;

// The tool at `t_s` from the start of the plan; at its end exactly that of the last segment. The plan has at least one
// segment.
[[nodiscard]] ToolSample tool_sample(const CartesianPlan& plan, double t_s) noexcept;

// The tool at this share of a segment that is driven by itself, 0..1.
[[nodiscard]] ToolSample tool_sample(const CartesianSegment& segment, double share,
                                     const Transform& tool_T_flange) noexcept;

// base_T_tool of tool_sample(plan, t_s).
[[nodiscard]] inline Transform tool_pose(const CartesianPlan& plan, double t_s) noexcept {
  return tool_sample(plan, t_s).tool.base_T_tool;
}

// Index of the segment that began last before or at `t_s`.
[[nodiscard]] std::size_t segment_at(const CartesianPlan& plan, double t_s) noexcept;

// The arm at a moment between start and end, given its joints at a moment that is close.
//
// A path that passes the wrist singularity turns theta_4 and theta_6 by half a turn in no time when it misses by 1e-12
// rad as when it misses by nothing. So the tick's length of path in whose middle theta_5 changes its sign is passed
// with theta_4 half-way between those one tick before and after; theta_5 and theta_6 follow. Both are half a tick or
// more away from the singularity, so neither rounding nor the miss counts, at whatever moments the path is looked at.
// The orientation is off by less than the miss, which is below 1e-11 rad on a path that PathCheck accepts.
struct FollowedTool {
  IkTracking tracking{};
  bool through_wrist = false;  // theta_4 was taken from both sides
  int inverses = 1;            // computed: up to kMostInverses, 1 where |sin(theta_5)| >= 1e-3
  static constexpr int kMostInverses = 4;
};
[[nodiscard]] FollowedTool follow_tool(const CartesianPlan& plan, const Arm& arm, double t_s,
                                       const JointAngles& previous) noexcept;

// The joints at `t_s`, given those of a moment that is close: exactly `start` before, exactly `target` from the end on.
// A plan has been checked at every tick. Between ticks the path may be beyond what may be planned by less than a tick's
// curvature: there the joints go on smoothly (IkTracking::joints). Limits are not left, PathCheck keeps a margin.
// Beyond the reach a checked plan is by 1e-8 mm at most: to be farther out between ticks, the elbow would turn round
// faster than accelerations allow.
[[nodiscard]] JointAngles position(const CartesianPlan& plan, const Arm& arm, double t_s,
                                   const JointAngles& previous) noexcept;
// The same; adds to `inverses` how many inverse kinematics it computed, at most FollowedTool::kMostInverses.
[[nodiscard]] JointAngles position(const CartesianPlan& plan, const Arm& arm, double t_s, const JointAngles& previous,
                                   int& inverses) noexcept;

}  // namespace armature
