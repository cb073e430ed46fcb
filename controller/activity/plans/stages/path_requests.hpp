// Cartesian moves that are planned together, or as successive windows of one path: the tool passes from each to the
// next without a stop, because the corner may be rounded or because both have the same direction there.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "controller/cell/frames.hpp"
#include "controller/kinematics/transform.hpp"
#include "controller/message/command.hpp"
#include "controller/trajectory/cartesian/cartesian_plan.hpp"
#include "controller/trajectory/path/arm_plane.hpp"
#include "controller/trajectory/plan/cartesian_planner.hpp"

namespace armature {

class PathRequests {
 public:
  [[nodiscard]] bool empty() const noexcept { return count_ == 0; }
  PathRequests() = default;
  PathRequests(const PathRequests&) = delete;  // the requests refer to points of the chain
  PathRequests& operator=(const PathRequests&) = delete;

  // True when `move` can be added before the chain is planned: it is empty, or there is room and continues_with().
  [[nodiscard]] bool accepts(const CartesianMove& move, const UserFrames& base_T_user,
                             const ArmPlane& plane) const noexcept;
  // True when there is room and no stop between the last move, which may have been dropped, and `move`. There is a stop
  // after a move with `exact_stop`, and where the direction of the tool point changes by more than kSmooth_rad without
  // a blend radius. Changes of the rotation are left to the planner.
  [[nodiscard]] bool continues_with(const CartesianMove& move, const UserFrames& base_T_user,
                                    const ArmPlane& plane) const noexcept;
  // True when there is a move for which continues_with() is true.
  [[nodiscard]] bool continues() const noexcept;
  // The blend radius of the last move.
  [[nodiscard]] double last_blend_mm() const noexcept { return last_blend_mm_; }

  // Empties the chain; it then starts with the tool at `base_T_tool`.
  void restart(const Transform& base_T_tool) noexcept;
  // Removes the first moves, which have been planned. Those behind continue them.
  void drop_front(std::size_t count) noexcept;
  void clear() noexcept { count_ = spline_count_ = output_count_ = 0; }

  // Adds a valid move (move_checks.hpp) that the chain accepts. The tool frame and a kept orientation refer to the end
  // of the previous move on its ideal path.
  void add(const CartesianMove& move, const UserFrames& base_T_user, const ArmPlane& plane) noexcept;

  // The blend radius of the move before the first one; 0 if there is none.
  [[nodiscard]] double blend_before_mm() const noexcept { return blend_before_mm_; }

  // All moves get at most this speed and acceleration of the tool point, where they are above 0.
  void slow_down(const PathLimits& most) noexcept;

  // In the base frame, valid until the chain changes. The last request has no blend.
  [[nodiscard]] std::span<const SegmentRequest> requests() const noexcept { return {requests_.data(), count_}; }
  // The number of requests, from the first one, that have at most so many outputs together.
  [[nodiscard]] std::size_t count_with_outputs(std::size_t most) const noexcept;
  // The time of the first `count` requests at the speeds of their limits. The motion may take longer.
  [[nodiscard]] double least_s(std::size_t count) const noexcept { return count > 0 ? least_s_[count - 1] : 0.0; }

 private:
  // `through` becomes the points of a spline.
  [[nodiscard]] SegmentRequest request_of(const CartesianMove& move, const UserFrames& base_T_user,
                                          const ArmPlane& plane, ThroughPoints& through) const noexcept;

  std::array<SegmentRequest, CartesianPlan::kMaxSegments> requests_{};
  std::size_t count_ = 0;
  std::array<double, CartesianPlan::kMaxSegments> least_s_{};        // of the requests up to each one
  std::array<ThroughPoints, CartesianPlan::kMaxSplines> splines_{};  // of the requests, in their order
  std::size_t spline_count_ = 0;
  std::size_t output_count_ = 0;
  Transform end_{};             // base_T_tool after the last move
  double last_blend_mm_ = 0.0;  // of the last move; applies when another move follows
  double blend_before_mm_ = 0.0;
  bool last_stops_ = false;                                   // exactly
  Eigen::Vector3d last_direction_ = Eigen::Vector3d::Zero();  // at the end of the last move; 0: it has none
};

}  // namespace armature
