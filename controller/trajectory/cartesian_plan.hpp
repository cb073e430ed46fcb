// A checked motion of the tool along lines and arcs, ready to be executed: up to kMostSegments segments, each with its
// own time law, the next one beginning before the one before has ended where the corner may be rounded.
//
// Blending is superposition: while two segments overlap in time, the tool is where the first one has it, plus what the
// second one has covered. It leaves the corner by less than the shorter of the two remaining ways, so the tolerance in
// mm decides how long they overlap. Orientations are superposed the same way.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "controller/core/units.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/kinematics/ik_result.hpp"
#include "controller/kinematics/transform.hpp"
#include "controller/trajectory/orientation_path.hpp"
#include "controller/trajectory/position_path.hpp"
#include "controller/trajectory/time_law.hpp"

namespace armature {

struct CartesianSegment {
  PositionPath path{};            // of the tool centre point, in the base frame
  OrientationPath orientation{};  // of the tool, in the base frame
  TimeLaw law{};                  // of s = 0..1 for position and orientation alike; takes whole ticks
  Ticks start{};                  // from the start of the plan
  Ticks duration{};
  double stretch = 1.0;  // by how much the time law was slowed down for the joints, >= 1
  // Five joints: the most by which a set-point of the segment misses the orientation that was asked for; 0 for six.
  double residual_rad = 0.0;
  std::uint32_t tag = 0;  // of the command
};

struct CartesianPlan {
  static constexpr std::size_t kMostSegments = 16;

  JointAngles start{};
  JointAngles target{};
  Transform tool_T_flange{};  // inverse of what the tool is on the flange
  std::array<CartesianSegment, kMostSegments> segments{};
  std::size_t count = 0;
  Ticks duration{};  // of all
};

// How much of its path the segment has covered `t_s` after the start of the plan, 0..1; exactly 1 from its end on.
[[nodiscard]] double share_at(const CartesianSegment& segment, double t_s) noexcept;

// base_T_tool at `t_s` from the start of the plan; at its end exactly that of the last segment. The plan has at least
// one segment.
[[nodiscard]] Transform tool_pose(const CartesianPlan& plan, double t_s) noexcept;

// Index of the segment that began last before or at `t_s`.
[[nodiscard]] std::size_t segment_at(const CartesianPlan& plan, double t_s) noexcept;

// The joints at `t_s`, given those of a moment that is close: exactly `start` before, exactly `target` from the end on.
// A plan has been checked at every tick; should a pose between ticks have no solution, `previous` is kept.
[[nodiscard]] JointAngles position(const CartesianPlan& plan, const Arm& arm, double t_s,
                                   const JointAngles& previous) noexcept;

}  // namespace armature
