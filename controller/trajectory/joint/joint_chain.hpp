// Joint moves that follow each other without a stop: each begins in the state of motion that the previous one has at
// that time, and only the last one ends at rest.
//
// The joints pass each point between two moves at a distance: the least value, over the set-points, of the largest
// deviation of a joint. The next move begins as early as this deviation allows, but never in the first half of a move.
// From there on all joints move to the next target in the least number of ticks.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/joint/corner_search.hpp"
#include "controller/trajectory/joint/joint_retarget.hpp"

namespace armature {

struct JointChain {
  static constexpr std::size_t kMaxMoves = 6;

  std::array<RetargetPlan, kMaxMoves> moves{};
  std::array<Ticks, kMaxMoves> starts{};  // of the moves, from the start of the chain; each ends where the next begins
  std::size_t count = 0;
  PerAxis<Radians> target{};
  Ticks duration{};
  Ticks passed{};  // from the start of the last move: the joints are closest to the end of the move before
  TimedOutputs outputs{};

  JointChain() = default;  // empty
  explicit JointChain(const RetargetPlan& only) noexcept { *this = only; }
  JointChain(const JointChain& other) noexcept { *this = other; }
  // Both copy only the moves that there are.
  JointChain& operator=(const JointChain& other) noexcept;
  JointChain& operator=(const RetargetPlan& only) noexcept;

  [[nodiscard]] Ticks end_of(std::size_t move) const noexcept { return move + 1 < count ? starts[move + 1] : duration; }
};

// The way of the joint that moves farthest, rad.
[[nodiscard]] double largest_difference(const PerAxis<Radians>& a, const PerAxis<Radians>& b) noexcept;

// The state of motion at a tick of a plan that ends at rest.
[[nodiscard]] PerAxis<AxisState> state_at_tick(const RetargetPlan& plan, std::int64_t tick) noexcept;

// Where a move is closest to a point: by the joint that deviates most.
[[nodiscard]] ClosestSetPoint closest_to(const PerAxis<Radians>& via, const RetargetPlan& plan) noexcept;

// The first tick of the last move at which another one may begin.
[[nodiscard]] std::int64_t earliest_start(const JointChain& chain) noexcept;

struct JointRequest {
  PerAxis<Radians> target{};
  double speed = 1.0;  // these three as in plan_retarget()
  double accel = 1.0;
  ProfileKind kind = ProfileKind::kTrapezoid;
};

// Adds a move to a chain that has at least one and fewer than kMaxMoves. The joints pass the present end of the chain
// at a distance of at most `blend_rad` >= 0; 0: they stop there. Returns the number of plans that were computed, at
// most 34, or 0 if the move would take longer than kLongestMove: then the chain is unchanged.
[[nodiscard]] int append(JointChain& chain, const RobotModel& robot, const JointRequest& next,
                         double blend_rad) noexcept;

// As for RetargetPlan.
[[nodiscard]] PerAxis<AxisState> state_at(const JointChain& chain, double t_s) noexcept;
[[nodiscard]] PerAxis<Radians> position(const JointChain& chain, double t_s) noexcept;

}  // namespace armature
