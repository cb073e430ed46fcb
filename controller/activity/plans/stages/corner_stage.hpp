// Joins paths and joint moves into one plan, where the first move of both has a blend: in either order, the arm leaves
// a path for a joint move without a stop, and ends a joint move on a path.
//
// What is planned waits in PlanOutbox::unsent() until the other one is planned, too. A chain of paths is joined only if
// the plan then has at most Plan::kMaxMoves moves, so a window never is. Corners are searched in steps, between
// which commands are accepted.
#pragma once

#include <cstddef>
#include <optional>

#include "controller/activity/activity_context.hpp"
#include "controller/activity/plans/stages/joint_stage.hpp"
#include "controller/activity/plans/stages/path_stage.hpp"
#include "controller/activity/plans/stages/plan_outbox.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/message/command.hpp"
#include "controller/trajectory/plan/corner_planner.hpp"

namespace armature {

class CornerStage {
 public:
  // References must outlive the stage.
  CornerStage(const ActivityContext& context, PathStage& path, JointStage& joints, PlanOutbox& outbox) noexcept
      : context_{context}, path_{path}, joints_{joints}, outbox_{outbox} {}

  // A corner is being searched.
  [[nodiscard]] bool busy() const noexcept { return departure_ || arrival_; }
  // One step of the search.
  void work(RegisterBus& bus) noexcept;

  // Moves that are not sent yet and are, or may be, in one plan.
  [[nodiscard]] std::size_t moves() const noexcept;
  // A plan is being joined.
  [[nodiscard]] bool joining() const noexcept { return outbox_.unsent().count > 0; }
  // The front of the queue is a joint move that can join what is planned.
  [[nodiscard]] bool joint_move_follows() const noexcept;
  // The joined plan ends with a path that leads to this move.
  [[nodiscard]] bool path_leads_on() const noexcept {
    return path_blend_mm_ > 0.0 && outbox_.unsent().count < Plan::kMaxPieces && joint_move_follows();
  }
  // A path may become a further piece of the joined plan, behind the joint moves.
  [[nodiscard]] bool may_join_another_path() const noexcept { return outbox_.unsent().count + 1 < Plan::kMaxPieces; }
  // The planner has a path that becomes a piece of a joined plan.
  [[nodiscard]] bool can_join_path() const noexcept;
  void join_path() noexcept;

  // Plans a joint move, the front of the queue, behind what is planned.
  void add(const JointMove& move, RegisterBus& bus, double residual_rad) noexcept;
  // The front of the queue cannot be planned: nothing joins it.
  void refuse_front(Refusal why) noexcept;
  void close() noexcept;

  // PieceStores that the joint moves need, with what they join.
  [[nodiscard]] std::size_t stores() const noexcept { return (outbox_.unsent().count + 2) / 2; }
  // Sends the joint moves, with what they join.
  void send_joints() noexcept;

  // Reports what is joined as refused.
  void drop(Refusal why) noexcept;

 private:
  void begin_departure(const JointMove& move, double residual_rad) noexcept;
  void end_departure() noexcept;
  void begin_arrival() noexcept;
  void end_arrival() noexcept;
  void end_adding(const JointMove& move, double residual_rad) noexcept;
  void add_path(Ticks from) noexcept;

  ActivityContext context_;
  PathStage& path_;
  JointStage& joints_;
  PlanOutbox& outbox_;
  double path_blend_mm_ = 0.0;  // of the last path of the joined plan, at its end
  bool path_left_ = false;      // the joint moves begin in motion on that path
  // At most one of both is under way. The move that departs is still the front of the queue.
  std::optional<DeparturePlanner> departure_;  // of the joint move `departing_` from that path
  std::optional<ArrivalPlanner> arrival_;      // of the last joint move on the path of the planner
  JointMove departing_{};
  double departing_residual_rad_ = 0.0;
};

}  // namespace armature
