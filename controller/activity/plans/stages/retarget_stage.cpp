#include "controller/activity/plans/stages/retarget_stage.hpp"

#include "controller/activity/plans/retarget_request.hpp"

namespace armature {

std::optional<MoveRefused> RetargetStage::accept(const JointMove& move) noexcept {
  if (context_.owner.has(ActivityId::kJog) || context_.owner.has(ActivityId::kHoming) ||
      context_.owner.has(ActivityId::kConveyor)) {
    return refused(Refusal::kNotReady);
  }
  if (next_) refuse_next(Refusal::kReplaced);
  next_ = move;
  number_ = context_.queue.count_replacing();
  return std::nullopt;
}

void RetargetStage::send() noexcept {
  if (!next_ || waiting_ || !context_.owner.has(ActivityId::kPlans)) return;
  context_.owner.feed(
      ActivityId::kPlans,
      RetargetRequest{
          .goal = {.target = next_->target, .speed = next_->speed, .accel = next_->accel, .kind = next_->profile},
          .tag = next_->tag});
  outbox_.count_retarget();
  context_.queue.set_replaced_by(number_);
  next_.reset();
  waiting_ = true;
}

void RetargetStage::on_answer(const Answer& answer) noexcept {
  if (!waiting_) return;
  waiting_ = false;
  if (answer.kind == Answer::Kind::kRetargeted) context_.owner.replace(answer.position);
}

void RetargetStage::on_stop(StopKind how) noexcept {
  if (how != StopKind::kHold) waiting_ = false;
}

void RetargetStage::drop(Refusal why) noexcept {
  if (next_ && why != Refusal::kReplaced) refuse_next(why);
}

void RetargetStage::refuse_next(Refusal why) noexcept {
  context_.events.on_event(refused(why, next_->tag));
  next_.reset();
}

}  // namespace armature
