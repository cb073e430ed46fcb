// A move or a dwell starts. Each segment of a chain is a move.
#pragma once

#include <cstdint>

#include "controller/base/axes.hpp"
#include "controller/base/members.hpp"
#include "controller/base/tag.hpp"
#include "controller/base/units.hpp"
#include "controller/trajectory/path/position_path.hpp"
#include "controller/trajectory/path/segment_request.hpp"
#include "controller/trajectory/profile/trapezoid.hpp"

namespace armature {

enum class MoveKind : std::uint8_t { kJoint, kLine, kArc, kSpline, kDwell };

[[nodiscard]] constexpr bool is_path(MoveKind kind) noexcept {
  return kind == MoveKind::kLine || kind == MoveKind::kArc || kind == MoveKind::kSpline;
}

struct MoveStarted {
  MoveKind kind = MoveKind::kJoint;
  Tag tag{};           // of the command
  Ticks start_tick{};  // the tick that computes the first step
  Ticks duration{};    // as planned: a stop shortens it; holds, overrides and underruns lengthen it
  PerAxis<ProfileShape> shape{};
  PerAxis<double> peak_speed_rad_s{};
  PerAxis<double> accel_rad_s2{};
  // Along a path: the three arrays above are empty.
  PathGeometry path{};             // ideal path of the tool centre point in the base frame, without rounded corners;
                                   // kSpline: without its curve
  ThroughPoints through{};         // kSpline: the points of the path between its start and its end
  bool on_conveyor = false;        // `path` is that for a part at the sync point, and moves with the belt
  double stretch = 1.0;            // factor by which the move was slowed down to keep the joint limits
  std::uint8_t stretched_for = 0;  // joint 1..6 that needed most of it; 0: none, or the tool in a rounded corner
  bool continues = false;          // blended with the previous move
  // The first move after a stop on the path where the tool should have continued: core 1 had the move before the arm
  // began to brake, but had no plan in time that continues the motion.
  bool unasked_stop = false;
  bool rapid = false;  // along a path: CartesianMove::rapid
  // For kJoint to a pose, and along a path: the largest error of the tool's orientation. Five joints cannot always
  // reach it; at most ArmGeometry::max_projection_rad. Six joints: at a wrist singularity, see AtSingularity.
  double residual_rad = 0.0;
  ARMATURE_MEMBERS(MoveStarted, kind, tag, start_tick, duration, shape, peak_speed_rad_s, accel_rad_s2, path, through,
                   on_conveyor, stretch, stretched_for, continues, unasked_stop, rapid, residual_rad)
};

}  // namespace armature
