// Cartesian moves that are planned together: each but the last has a blend radius.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "controller/command/command.hpp"
#include "controller/command/frames.hpp"
#include "controller/kinematics/transform.hpp"
#include "controller/trajectory/path/arm_plane.hpp"
#include "controller/trajectory/plan/cartesian_plan.hpp"
#include "controller/trajectory/plan/cartesian_planner.hpp"

namespace armature {

class Chain {
 public:
  [[nodiscard]] bool empty() const noexcept { return count_ == 0; }
  // A move can be added: there is none, or the last one wants to be blended with the next.
  [[nodiscard]] bool open() const noexcept;

  // Empty, with the tool at `base_T_tool`.
  void restart(const Transform& base_T_tool) noexcept;
  void clear() noexcept { count_ = 0; }

  // Adds a valid move, see move_checks.hpp, while open(). Frames and orientations that are kept refer to where the move
  // before ends on its ideal path.
  void add(const CartesianMove& move, const UserFrames& base_T_user, const ArmPlane& plane) noexcept;

  // In the base frame. The last one is not blended.
  [[nodiscard]] std::span<const SegmentRequest> requests() const noexcept { return {requests_.data(), count_}; }

 private:
  std::array<SegmentRequest, CartesianPlan::kMostSegments> requests_{};
  std::size_t count_ = 0;
  Transform end_{};             // base_T_tool after the last move
  double last_blend_mm_ = 0.0;  // of the last move, should another one follow
};

}  // namespace armature
