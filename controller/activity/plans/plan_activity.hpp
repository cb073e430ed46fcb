// The activity that has the arm by default: executes the moves of the queue as plans.
//
// A move is checked when it arrives. It is planned from the end of the previous move, so plans follow each other
// without a pause, and planning continues while the arm moves. Some errors show only in planning: a pose out of reach,
// a path that a joint cannot follow, a move that would take too long. The move is then refused, and the moves after it
// are planned from where the arm will stand without it. Poses are resolved at planning time too: the frame "tool" is
// the tool's pose at the start of the move.
//
// The stages, each with its own state: a path (PathStage), a long one in windows (WindowStage), a chain of joint moves
// (JointStage), corners between both (CornerStage), a joint move that begins at once (RetargetStage).
#pragma once

#include <cstdint>
#include <optional>

#include "controller/activity/activity.hpp"
#include "controller/activity/activity_context.hpp"
#include "controller/activity/plans/stages/corner_stage.hpp"
#include "controller/activity/plans/stages/joint_stage.hpp"
#include "controller/activity/plans/stages/path_stage.hpp"
#include "controller/activity/plans/stages/plan_outbox.hpp"
#include "controller/activity/plans/stages/retarget_stage.hpp"
#include "controller/activity/plans/stages/window_stage.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/message/command.hpp"

namespace armature {

class PlanActivity final : public Activity {
 public:
  explicit PlanActivity(const ActivityContext& context) noexcept;

  // A move or a command for pins of the queue.
  template <QueuedMove Move>
  [[nodiscard]] std::optional<MoveRefused> accept(const Move& move) noexcept;

  // kNothing: the front of the queue is next. kWaiting: for core 0, or for moves.
  enum class Work : std::uint8_t { kNothing, kWaiting, kDone };
  // One step of what is being planned.
  [[nodiscard]] Work work(RegisterBus& bus) noexcept;
  // Plans the front of the queue, or begins to. False: there is no room.
  [[nodiscard]] bool execute(const JointMove& move, RegisterBus& bus) noexcept;
  [[nodiscard]] bool execute(const PoseMove& move, RegisterBus& bus) noexcept;
  [[nodiscard]] bool execute(const CartesianMove& move, RegisterBus& bus) noexcept;
  [[nodiscard]] bool execute(const Dwell& dwell, RegisterBus& bus) noexcept;
  [[nodiscard]] bool may_work() const noexcept { return context_.owner.has(ActivityId::kPlans) && !retarget_.waits(); }
  // The arm is at the end of all plans, and no Hold is active.
  [[nodiscard]] bool stand() const noexcept { return outbox_.stands(); }
  [[nodiscard]] bool waits_for_time() const noexcept { return window_.waits_for_time(); }

  [[nodiscard]] RetargetStage& retarget() noexcept { return retarget_; }
  // The stage of paths, which is lent to the conveyor while it is empty.
  [[nodiscard]] PathStage& path() noexcept { return path_; }
  // Plans to core 0, also those of the conveyor.
  [[nodiscard]] PlanOutbox& outbox() noexcept { return outbox_; }

  // Activity
  [[nodiscard]] bool idle() const noexcept override;
  void drop(Refusal why) noexcept override;
  void on_rest() noexcept override;

 private:
  [[nodiscard]] bool has_room_for_path() const noexcept;
  void plan(const JointMove& move, RegisterBus& bus, double residual_rad = 0.0) noexcept;
  void plan(const PoseMove& move, RegisterBus& bus) noexcept;
  void work_on_path(RegisterBus& bus) noexcept;
  [[nodiscard]] bool add_to_joints(RegisterBus& bus) noexcept;
  [[nodiscard]] bool add_to_joined(RegisterBus& bus) noexcept;

  ActivityContext context_;
  PlanOutbox outbox_;
  PathStage path_;
  WindowStage window_;
  JointStage joints_;
  CornerStage corner_;
  RetargetStage retarget_;
};

}  // namespace armature
