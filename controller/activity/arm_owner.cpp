#include "controller/activity/arm_owner.hpp"

#include "controller/activity/move_checks.hpp"

namespace armature {

std::optional<PerAxis<Radians>> ArmOwner::rest() const noexcept {
  bool idle = has(ActivityId::kPlans) && !channel_.control.view().hold;
  for_each([&](const Activity& activity) { idle = idle && activity.idle(); });
  if (!idle) return std::nullopt;
  return end_;
}

void ArmOwner::lend(ActivityId to) noexcept {
  owner_ = to;
  phase_ = Phase::kOwned;
}

void ArmOwner::drop(Refusal why) noexcept {
  for_each([why](Activity& activity) { activity.drop(why); });
}

void ArmOwner::replace(const PerAxis<Radians>& end) noexcept {
  end_ = end;
  drop(Refusal::kReplaced);
}

std::optional<MoveRefused> ArmOwner::accept(const Hold&) noexcept {
  for_each([](Activity& activity) { activity.on_stop(StopKind::kHold); });
  if (!has(ActivityId::kPlans)) stop(StopKind::kHold);
  channel_.control.set_hold(true);
  return std::nullopt;
}

std::optional<MoveRefused> ArmOwner::accept(const Resume&) noexcept {
  channel_.control.set_hold(false);
  return std::nullopt;
}

std::optional<MoveRefused> ArmOwner::accept(const SetOverride& wanted) noexcept {
  std::optional<MoveRefused> refusal = find_refusal(wanted);
  if (!refusal) channel_.control.set_share(wanted.share);
  return refusal;
}

std::optional<MoveRefused> ArmOwner::accept(const Stop& command) noexcept {
  const StopKind how = command.kind == Stop::Kind::kSoft ? StopKind::kSoft : StopKind::kQuick;
  drop(Refusal::kNotReady);
  for_each([how](Activity& activity) { activity.on_stop(how); });
  stop(how);
  channel_.control.set_hold(false);
  return std::nullopt;
}

void ArmOwner::stop(StopKind how) noexcept {
  if (in_fault()) return;
  if (phase_ == Phase::kAwaitingRest && how <= ending_) return;
  channel_.send(Request::Kind::kStop, owner_, ++sent_, [how](Request& request) { request.stop = how; });
  await_rest(how);
}

void ArmOwner::await_rest(StopKind how) noexcept {
  phase_ = Phase::kAwaitingRest;
  ending_ = how;
}

std::optional<MoveRefused> ArmOwner::accept(const ClearFault& clear) noexcept {
  if (phase_ == Phase::kUnusable) return refused(Refusal::kNotReady);
  if (phase_ != Phase::kFault) return std::nullopt;
  clear_tag_ = clear.tag;
  order(Request::Kind::kClearFault);
  return std::nullopt;
}

std::optional<MoveRefused> ArmOwner::accept(const SwitchOff&) noexcept {
  if (!rest()) return refused(Refusal::kNotReady);
  order(Request::Kind::kSwitchOff);
  return std::nullopt;
}

// An order for the loop: nothing can stop the arm before its answer.
void ArmOwner::order(Request::Kind kind) noexcept {
  channel_.send(kind, ActivityId::kPlans, ++sent_, [](Request&) {});
  await_rest(StopKind::kQuick);
}

void ArmOwner::read_answers() noexcept {
  while (const std::optional<Answer> answer = channel_.loop.answers.try_pop()) on_answer(*answer);
}

void ArmOwner::on_answer(const Answer& answer) noexcept {
  switch (answer.kind) {
    case Answer::Kind::kRest:
      return on_rest(answer);
    case Answer::Kind::kFault:
      return on_fault();
    case Answer::Kind::kFaultPersists:
      events_.on_event(refused(Refusal::kNotReady, clear_tag_));
      phase_ = Phase::kFault;
      return drop(Refusal::kNotReady);
    case Answer::Kind::kUnusable:
      phase_ = Phase::kUnusable;
      return drop(Refusal::kNotReady);
    case Answer::Kind::kRetargeted:
    case Answer::Kind::kNotRetargeted:
      return for_each([&](Activity& activity) { activity.on_answer(answer); });
  }
}

void ArmOwner::on_rest(const Answer& answer) noexcept {
  if (answer.number != sent_) return;  // the answer to a later request follows
  for_each([](Activity& activity) { activity.on_rest(); });
  if (has(ActivityId::kConveyor)) drop(Refusal::kPartLost);
  lend(ActivityId::kPlans);
  end_ = answer.position;
  const std::uint32_t all = (1u << robot_.axis_count) - 1u;
  referenced_ = (answer.referenced & all) == all;
  if (!referenced_) drop(Refusal::kNotReferenced);
}

void ArmOwner::on_fault() noexcept {
  owner_ = ActivityId::kPlans;
  phase_ = Phase::kFault;
  channel_.control.set_hold(false);  // no move is left to resume
  drop(Refusal::kNotReady);
  for_each([](Activity& activity) { activity.on_rest(); });
}

}  // namespace armature
