// Cartesian moves that are being planned as one path. While the planning has not ended, further moves join, and it
// starts again.
//
// It works in slices of kSlice inverse kinematics, plus at most PathPass::kMaxInverses. Commands are accepted between
// two slices, so a Stop or a Hold never waits for a long check.
#pragma once

#include <cstddef>
#include <cstdint>

#include "controller/activity/activity_context.hpp"
#include "controller/activity/plans/stages/path_requests.hpp"
#include "controller/activity/plans/stages/planning_cost.hpp"
#include "controller/base/units.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/trajectory/plan/cartesian_planner.hpp"

namespace armature {

class PathStage {
 public:
  static constexpr std::int64_t kSlice = 100;  // 0.7 ms where an inverse kinematics takes 7 us
  using Progress = CartesianPlanner::Progress;

  // The frames may change while the stage is empty.
  explicit PathStage(const ActivityContext& context) noexcept;
  PathStage(const PathStage&) = delete;
  PathStage& operator=(const PathStage&) = delete;

  [[nodiscard]] bool empty() const noexcept { return requests_.empty(); }
  [[nodiscard]] PathRequests& requests() noexcept { return requests_; }
  [[nodiscard]] const PathRequests& requests() const noexcept { return requests_; }
  [[nodiscard]] CartesianPlanner& planner() noexcept { return planner_; }
  [[nodiscard]] const CartesianPlanner& planner() const noexcept { return planner_; }
  // The path is in the frame of a part on the conveyor.
  [[nodiscard]] bool on_part() const noexcept { return on_part_; }
  // Base and tool where the next path starts, and the pose that a move has there.
  [[nodiscard]] Transform tool_at_end() const noexcept;
  [[nodiscard]] Transform resolve(const FramedPose& pose) const noexcept;

  // Takes the front of the queue.
  void begin(const CartesianMove& move, bool on_part, RegisterBus& bus) noexcept;
  // Starts the planning if it has not started, or if moves of the queue have joined. True: it has.
  bool start_planning(RegisterBus& bus) noexcept;
  void work(RegisterBus& bus) noexcept;
  // The next path follows a stop that nobody asked for.
  void set_unasked_stop(bool unasked) noexcept { unasked_stop_ = unasked; }

  // The move of the queue that continues this path, or null.
  [[nodiscard]] const CartesianMove* next() const noexcept;
  // Takes it.
  void take(const CartesianMove& move) noexcept;
  [[nodiscard]] bool continues_with(const CartesianMove& move) const noexcept {
    return requests_.continues_with(move, context_.frames, plane_);
  }

  // The plan of `added` moves is ready.
  void measure(std::size_t added, RegisterBus& bus) noexcept;
  // The planning of a window begins.
  void start_clock(RegisterBus& bus) noexcept { began_ = bus.now(); }
  [[nodiscard]] const PlanningCost& cost() const noexcept { return cost_; }

  // Reports that the path is refused, the move to blame with its reason and the others with kChainRefused. The moves
  // that continue it are refused when they come, see drop_rest().
  void refuse(const PathProblem& problem) noexcept;
  void drop_rest() noexcept;
  // Reports all moves but the first `sent` as refused.
  void drop(Refusal why, std::size_t sent) noexcept;
  void cancel() noexcept;
  void clear() noexcept;

 private:
  ActivityContext context_;
  ArmPlane plane_;  // with the tool
  PathRequests requests_;
  CartesianPlanner planner_;
  PlanningCost cost_;
  Cycles began_{};  // the planning
  bool on_part_ = false;
  bool unasked_stop_ = false;   // before the first request, which is planned from rest
  bool dropping_rest_ = false;  // a move was refused, and those behind it are
};

}  // namespace armature
