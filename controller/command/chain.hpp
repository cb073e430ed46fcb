// Cartesian moves that are planned together: the tool passes from each to the next without a stop, because the corner
// may be rounded or because both have the same direction there.
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
  Chain() = default;
  Chain(const Chain&) = delete;  // the requests refer to points of the chain
  Chain& operator=(const Chain&) = delete;

  // True when `move` can be added: the chain is empty, or there is room and no stop before the move. There is a stop
  // after a move with `exact_stop`, and where the direction of the tool point changes by more than kSmooth_rad without
  // a blend radius. Changes of the rotation are left to the planner.
  [[nodiscard]] bool accepts(const CartesianMove& move, const UserFrames& base_T_user,
                             const ArmPlane& plane) const noexcept;

  // Empties the chain; it then starts with the tool at `base_T_tool`.
  void restart(const Transform& base_T_tool) noexcept;
  void clear() noexcept { count_ = spline_count_ = output_count_ = 0; }

  // Adds a valid move (move_checks.hpp) that the chain accepts. The tool frame and a kept orientation refer to the end
  // of the previous move on its ideal path.
  void add(const CartesianMove& move, const UserFrames& base_T_user, const ArmPlane& plane) noexcept;

  // In the base frame, valid until the chain changes. The last request has no blend.
  [[nodiscard]] std::span<const SegmentRequest> requests() const noexcept { return {requests_.data(), count_}; }

 private:
  // `through` becomes the points of a spline.
  [[nodiscard]] SegmentRequest request_of(const CartesianMove& move, const UserFrames& base_T_user,
                                          const ArmPlane& plane, ThroughPoints& through) const noexcept;

  std::array<SegmentRequest, CartesianPlan::kMaxSegments> requests_{};
  std::size_t count_ = 0;
  std::array<ThroughPoints, CartesianPlan::kMaxSplines> splines_{};  // of the requests, in their order
  std::size_t spline_count_ = 0;
  std::size_t output_count_ = 0;
  Transform end_{};                                           // base_T_tool after the last move
  double last_blend_mm_ = 0.0;                                // of the last move; applies when another move follows
  bool last_stops_ = false;                                   // exactly
  Eigen::Vector3d last_direction_ = Eigen::Vector3d::Zero();  // at the end of the last move; 0: it has none
};

}  // namespace armature
