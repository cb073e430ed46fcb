// A checked motion of the tool along lines, arcs and splines, ready for execution, with up to kMaxSegments segments.
//
// The segments are one path with one parameter s: the length in mm or, for a segment that only rotates, the angle times
// kTurnLever_mm. One law for the whole path, the table, gives s over time. A rounded corner is a piece of the path: in
// its 2 c of s, the first segment's share runs out while that of the second begins, and both are superposed,
//   p = p1(end - c + 2 c (u - B)) + p2(2 c B) - corner,   B = u^3 - u^4 / 2,  u = 0..1.
// So its tangent is (1 - b) t1 + b t2 with b = 3 u^2 - 2 u^3, and its curvature is continuous. The orientations are
// superposed in the same way.
//
// Plans form windows over a longer path: while one is executed, the next one is planned, which contains the rest of its
// segments and further ones. Both agree up to `same_until`, where the next one has more to come. Each ends in a stop,
// so a window that comes too late is not missed: the motion stops on the path.
//
// On a five-axis arm orientations must stay in the arm's plane; see Turning and five_axis_turning.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "controller/base/tag.hpp"
#include "controller/base/timebase.hpp"
#include "controller/base/units.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/kinematics/configuration.hpp"
#include "controller/kinematics/ik_result.hpp"
#include "controller/kinematics/transform.hpp"
#include "controller/trajectory/cartesian/wrist_bend.hpp"
#include "controller/trajectory/law/time_table.hpp"
#include "controller/trajectory/path/arm_plane.hpp"
#include "controller/trajectory/path/orientation_path.hpp"
#include "controller/trajectory/path/position_path.hpp"
#include "controller/trajectory/path/segment_request.hpp"
#include "controller/trajectory/path/timed_outputs.hpp"
#include "controller/trajectory/profile/time_law.hpp"

namespace armature {

// How the tool rotates along a segment. In all cases the tool centre point stays on the path.
enum class Turning : std::uint8_t {
  kInSpace,    // about one axis that is fixed in space
  kIntoPlane,  // the same, then turned into the arm's plane: a tool that is upright, but not exactly vertical, and a
               // tilted one on request
  kFollowing   // pitch and roll change linearly, the heading follows the tool point
};

// Both angles change linearly with the share of the path.
struct PlaneTurn {
  PlaneAngles start{};
  PlaneAngles change{};  // signed change
};

// A rotation counts as the way of a point at this distance from the tool point, where only one of both has a length.
inline constexpr double kTurnLever_mm = 100.0;

struct CartesianSegment {
  PositionPath path{};  // of the tool centre point, in the base frame
  Turning turning = Turning::kInSpace;
  OrientationPath orientation{};  // of the tool, in the base frame; not used by kFollowing
  PlaneTurn plane_turn{};         // kFollowing only
  // The parameter at the start of the segment, its length, and c of the rounded corner at its end,
  // at most half of the length; 0: none.
  double from = 0.0;
  double length = 0.0;
  double corner = 0.0;
  ProfileKind profile = ProfileKind::kTrapezoid;  // kSCurve: with limited jerk
  // From the start of the plan. A segment may begin and end within a tick. Then the segment before ends with the tick,
  // and this one starts with it.
  Ticks start{};
  Ticks duration{};
  PathLimits limits{};             // of the tool, as requested; changes of the rate keep them too
  double stretch = 1.0;            // factor by which the time law was slowed down to keep the joint limits, >= 1
  std::uint8_t stretched_for = 0;  // joint 1..6 that needed most of it; 0: none, or the tool in a rounded corner
  // Five joints: the orientation error of the tool at the end of the segment or, where its rotation in space is turned
  // into the plane of the arm, the largest one. Six joints: the largest one on a bend.
  double residual_rad = 0.0;
  // The largest jerk of joints and tool in equal parts of the duration, see jerk_share.hpp; 0 where it is not limited.
  static constexpr std::size_t kParts = 16;
  std::array<std::uint8_t, kParts> jerk_use{};
  AtSingularity at_singularity = AtSingularity::kSlow;
  double orientation_tolerance_rad = 0.0;  // kBend
  Configuration configuration{};           // requested at the end
  bool rapid = false;                      // of the command, for its event
  Tag tag{};                               // of the command
};

// The part of a Cartesian plan between two exact stops. Where the tool rests the rate may begin a new change.
struct PlanRun {
  bool limits_jerk = false;  // a segment is an S-curve
  double end_ticks = 0.0;    // path time, from the start of the plan
};

struct CartesianPlan {
  static constexpr std::size_t kMaxSegments = 256;
  // Of a plan that begins at rest, so that the motion begins soon.
  static constexpr std::size_t kMaxFirstSegments = 16;
  static constexpr std::size_t kMaxSplines = 4;
  // Set-points of the plan before that are part of a window.
  static constexpr Ticks kSharedTicks{8};

  CartesianPlan() = default;
  // Copies only `count` segments, the splines that there are and the points of the table; those beyond keep their old
  // values. The motion loop copies a plan within a tick, from memory that the other core has written. The paths of the
  // copy refer to its own splines.
  CartesianPlan(const CartesianPlan& other) noexcept { *this = other; }
  CartesianPlan& operator=(const CartesianPlan& other) noexcept;

  JointAngles start{};
  JointAngles target{};
  Transform tool_T_flange{};    // inverse of flange_T_tool
  Transform end_base_T_tool{};  // where the last segment ends
  std::array<CartesianSegment, kMaxSegments> segments{};
  std::size_t count = 0;
  // Of the segments, in their order: a spline needs far more memory than other paths.
  std::array<Spline, kMaxSplines> splines{};
  std::size_t spline_count = 0;
  TimeTable table{};   // s over time; empty for a path of no length
  WristBends bends{};  // passages of the wrist singularity on which the orientation leaves the path
  Ticks duration{};    // of the whole plan
  TimedOutputs outputs{};

  // A window that continues the plan before it. All times are from tick `origin` of that plan on, where the arm is at
  // `start`, so some segments start before 0. From kLeastTicks on, until `same_until`, both plans are the same.
  bool continues = false;
  Ticks origin{};
  double same_until_ticks = 0.0;
  std::size_t dropped = 0;  // segments of that plan that are not part of this one: over at `origin`
  std::size_t known = 0;    // the first segments of this plan: they are part of that one, too
  // The first outputs of that plan: over at `origin`. Those behind them, up to `same_until`, are the first of this
  // plan.
  std::size_t outputs_over = 0;
  bool after_unasked_stop = false;  // MoveStarted::unasked_stop of its first segment
  PlanRun first_run{};              // of this plan: to find it, a tick of the motion loop has too little time
  static constexpr double kLeastTicks = 2.0;
};

// The tick of the plan in which the segment ends.
[[nodiscard]] inline Ticks end_of(const CartesianSegment& segment) noexcept {
  return segment.start + segment.duration;
}

// The rotation of the tool on the segment to which its limits of rotation apply. The heading that follows the tool
// point is not included, because it results from the position. kFollowing: hypot of pitch and roll.
[[nodiscard]] double turn_angle_rad(const CartesianSegment& segment) noexcept;

// Share of the segment's path that is covered at `t_s` from the start of the plan, 0..1; exactly 1 from its end on.
[[nodiscard]] double share_at(const CartesianPlan& plan, std::size_t segment, double t_s) noexcept;

struct ToolSample {
  HeldTool tool{};
  // The quantity to which the limits of rotation apply: pitch and roll where the heading follows, otherwise this
  // rotation.
  std::optional<PlaneAngles> in_plane{};
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
};

// Rotation of the tool between two close samples, as its limits of rotation count it, rad: (pitch, roll, 0), or the
// rotation vector in the base frame.
[[nodiscard]] Eigen::Vector3d limited_turn(const ToolSample& from, const ToolSample& to) noexcept;

// The tool at `t_s` from the start of the plan; at its end exactly that of the last segment. The plan must have at
// least one segment.
[[nodiscard]] ToolSample tool_sample(const CartesianPlan& plan, double t_s) noexcept;

// Shares of the paths of two segments at `u` = 0..1 of a corner with the parameter `c`, see above.
struct CornerShares {
  double first, second;
};
[[nodiscard]] CornerShares corner_shares(const CartesianSegment& first, const CartesianSegment& second, double c,
                                         double u) noexcept;

// The tool at the parameter `s` of a plan whose corners are laid out (path_corners.hpp), exact at both ends.
[[nodiscard]] ToolSample tool_on_path(const CartesianPlan& plan, double s) noexcept;

// The tool at this share, 0..1, of a segment that is executed alone.
[[nodiscard]] ToolSample tool_sample(const CartesianSegment& segment, double share,
                                     const Transform& tool_T_flange) noexcept;

// base_T_tool of tool_sample(plan, t_s).
[[nodiscard]] inline Transform tool_pose(const CartesianPlan& plan, double t_s) noexcept {
  return tool_sample(plan, t_s).tool.base_T_tool;
}

// Index of the last segment that began before or at `t_s`.
[[nodiscard]] std::size_t segment_at(const CartesianPlan& plan, double t_s) noexcept;
// Index of the last segment that begins before or at the parameter `s`.
[[nodiscard]] std::size_t segment_on_path(const CartesianPlan& plan, double s) noexcept;

// base_T_tool for these joints.
[[nodiscard]] Transform held_tool_pose(const CartesianPlan& plan, const Arm& arm, const JointAngles& joints) noexcept;

// The arm at the parameter `s`, nearest to the joints at a parameter that is close enough to know the elbow by it. The
// wrist may turn farther in between.
[[nodiscard]] IkTracking joints_on_path(const CartesianPlan& plan, const Arm& arm, double s,
                                        const JointAngles& near) noexcept;

// The arm at a time between start and end, given its joints at a close time.
//
// A path that misses the wrist singularity by 1e-12 rad turns theta_4 and theta_6 by half a turn in almost no time, and
// so does a path that passes it exactly. Therefore theta_4 is interpolated on the tick's length of path in whose middle
// theta_5 changes its sign: it is half-way between its values one tick before and one tick after, and theta_5 and
// theta_6 follow. Both values are at least half a tick away from the singularity, so neither rounding nor the miss
// affects them, at whatever times the path is sampled. The orientation error is smaller than the miss, which is below
// 1e-11 rad on a path that PathCheck accepts.
struct FollowedTool {
  IkTracking tracking{};
  bool through_wrist = false;  // theta_4 was set from both sides
  bool on_bend = false;        // the orientation may differ from that of the path
  int inverses = 1;            // computed: up to kMaxInverses, 1 where |sin(theta_5)| >= 1e-3
  static constexpr int kMaxInverses = 4;
};
[[nodiscard]] FollowedTool follow_tool(const CartesianPlan& plan, const Arm& arm, double t_s,
                                       const JointAngles& previous) noexcept;
// The same, where the tool at `t_s` is known to be here.
[[nodiscard]] FollowedTool follow_tool(const CartesianPlan& plan, const Arm& arm, double t_s,
                                       const Transform& base_T_tool, const JointAngles& previous) noexcept;

// The joints at `t_s`, given those at a close time: exactly `start` before the plan, exactly `target` from its end on.
// A plan was checked at every tick. Between ticks the path may exceed the planning limits by less than a tick's
// curvature; there the joints continue smoothly (IkTracking::joints). Joint limits are kept, because PathCheck keeps a
// margin. A checked plan is beyond the reach by at most 1e-8 mm: for more, the elbow would have to turn faster than
// accelerations allow.
[[nodiscard]] JointAngles position(const CartesianPlan& plan, const Arm& arm, double t_s,
                                   const JointAngles& previous) noexcept;
// As above; adds the number of computed inverse kinematics to `inverses`, at most FollowedTool::kMaxInverses.
[[nodiscard]] JointAngles position(const CartesianPlan& plan, const Arm& arm, double t_s, const JointAngles& previous,
                                   int& inverses) noexcept;
// The same with follow() instead of follow_tool().
template <class Follow>
[[nodiscard]] JointAngles position(const CartesianPlan& plan, double t_s, const JointAngles& previous, int& inverses,
                                   Follow follow) noexcept {
  if (t_s <= 0.0) return plan.start;
  if (t_s >= seconds(plan.duration)) return plan.target;
  const FollowedTool followed = follow();
  inverses += followed.inverses;
  return followed.tracking.found ? followed.tracking.joints : previous;
}

}  // namespace armature
