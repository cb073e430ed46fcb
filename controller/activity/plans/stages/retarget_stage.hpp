// The joint move that begins at once. Core 0 plans it from the present state of motion. Planning stops until core 0 has
// answered; then the moves that came before are dropped, or continue when it was refused.
#pragma once

#include <cstdint>
#include <optional>

#include "controller/activity/activity.hpp"
#include "controller/activity/activity_context.hpp"
#include "controller/activity/plans/stages/plan_outbox.hpp"
#include "controller/message/command.hpp"

namespace armature {

class RetargetStage final : public Activity {
 public:
  // References must outlive the stage.
  RetargetStage(const ActivityContext& context, PlanOutbox& outbox) noexcept : context_{context}, outbox_{outbox} {}

  // Core 0 has not answered.
  [[nodiscard]] bool waits() const noexcept { return waiting_; }
  // Accepts a valid move; it replaces one that was not sent yet.
  [[nodiscard]] std::optional<MoveRefused> accept(const JointMove& move) noexcept;
  // Sends the latest one while plans have the arm.
  void send() noexcept;

  // Activity. After a stop, a rest and a fault an answer that comes later has no effect.
  [[nodiscard]] bool idle() const noexcept override { return !waiting_; }
  void on_stop(StopKind how) noexcept override;
  void drop(Refusal why) noexcept override;
  void on_answer(const Answer& answer) noexcept override;
  void on_rest() noexcept override { waiting_ = false; }

 private:
  void refuse_next(Refusal why) noexcept;

  ActivityContext context_;
  PlanOutbox& outbox_;
  std::optional<JointMove> next_{};  // to be sent
  std::uint32_t number_ = 0;         // of the latest one, see MoveQueue
  bool waiting_ = false;
};

}  // namespace armature
