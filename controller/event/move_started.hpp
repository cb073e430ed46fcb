// A move starts. Each segment of a chain is a move.
#pragma once

#include <cstdint>

#include "controller/core/axes.hpp"
#include "controller/core/tag.hpp"
#include "controller/core/units.hpp"
#include "controller/trajectory/path/position_path.hpp"
#include "controller/trajectory/profile/trapezoid.hpp"

namespace armature {

enum class MoveKind : std::uint8_t { kJoint, kLine, kArc };

struct MoveStarted {
  MoveKind kind = MoveKind::kJoint;
  Tag tag{};           // of the command
  Ticks start_tick{};  // the tick that computes the first step
  Ticks duration{};    // as planned: a stop shortens it; a hold, an override and every underrun lengthen it
  PerAxis<ProfileShape> shape{};
  PerAxis<double> peak_speed_rad_s{};
  PerAxis<double> accel_rad_s2{};
  // kLine, kArc: the three arrays above are empty.
  PositionPath path{};             // ideal path of the tool centre point in the base frame, corners not rounded
  double stretch = 1.0;            // by how much the joints made it slower than asked for
  std::uint8_t stretched_for = 0;  // joint 1..6 that asked for most of it; 0: none, or the tool in a rounded corner
  bool continues = false;          // blended with the move before
  // kJoint to a pose, kLine, kArc: the most by which the tool misses the orientation that was asked for, because five
  // joints cannot take it; at most ArmGeometry::max_projection_rad. 0 for six joints.
  double residual_rad = 0.0;
};

}  // namespace armature
