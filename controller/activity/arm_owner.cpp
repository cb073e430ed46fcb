#include "controller/activity/arm_owner.hpp"

#include <cassert>

#include "controller/activity/move_checks.hpp"

namespace armature {

std::optional<PerAxis<Radians>> ArmOwner::rest() const noexcept {
  bool idle = has(ActivityId::kPlans) && !mailbox_.control.view().hold;
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
  for_each([](Activity& activity) { activity.stop(StopKind::kHold); });
  mailbox_.control.set_hold(true);
  return std::nullopt;
}

std::optional<MoveRefused> ArmOwner::accept(const Resume&) noexcept {
  mailbox_.control.set_hold(false);
  return std::nullopt;
}

std::optional<MoveRefused> ArmOwner::accept(const SetOverride& wanted) noexcept {
  std::optional<MoveRefused> refusal = find_refusal(wanted);
  if (!refusal) mailbox_.control.set_share(wanted.share);
  return refusal;
}

std::optional<MoveRefused> ArmOwner::accept(const Stop& stop) noexcept {
  const bool soft = stop.kind == Stop::Kind::kSoft, plans = has(ActivityId::kPlans);
  // A quick stop that is braking stays one.
  if (!soft || plans) mailbox_.control.set_soft_stop(soft);
  drop(Refusal::kNotReady);
  for_each([soft](Activity& activity) { activity.stop(soft ? StopKind::kSoft : StopKind::kQuick); });
  if (plans) order(MotionOrder::kStop);
  mailbox_.control.set_hold(false);
  return std::nullopt;
}

std::optional<MoveRefused> ArmOwner::accept(const ClearFault& clear) noexcept {
  if (phase_ == Phase::kUnusable) return MoveRefused{.reason = Refusal::kNotReady};
  if (phase_ != Phase::kFault) return std::nullopt;
  clear_tag_ = clear.tag;
  order(MotionOrder::kClearFault);
  return std::nullopt;
}

std::optional<MoveRefused> ArmOwner::accept(const SwitchOff&) noexcept {
  if (!rest()) return MoveRefused{.reason = Refusal::kNotReady};
  order(MotionOrder::kSwitchOff);
  return std::nullopt;
}

void ArmOwner::order(MotionOrder order) noexcept {
  [[maybe_unused]] const bool pushed = mailbox_.orders.try_push(order);
  assert(pushed);  // never full, see MotionMailbox
  await_rest();
}

void ArmOwner::on_notice(const MotionNotice& notice) noexcept {
  switch (notice.kind) {
    case MotionNotice::Kind::kAtRest:
      return on_rest(notice);
    case MotionNotice::Kind::kFault:
      return on_fault();
    case MotionNotice::Kind::kFaultPersists:
      events_.on_event(MoveRefused{.reason = Refusal::kNotReady, .tag = clear_tag_});
      phase_ = Phase::kFault;
      return drop(Refusal::kNotReady);
    case MotionNotice::Kind::kUnusable:
      phase_ = Phase::kUnusable;
      return drop(Refusal::kNotReady);
    case MotionNotice::Kind::kRetargeted:
    case MotionNotice::Kind::kNotRetargeted:
      return;
  }
}

void ArmOwner::on_rest(const MotionNotice& notice) noexcept {
  bool answered = true;
  for_each([&](const Activity& activity) { answered = answered && activity.answered_by(notice); });
  if (!answered) return;
  for_each([](Activity& activity) { activity.on_rest(); });
  if (has(ActivityId::kConveyor)) drop(Refusal::kPartLost);
  owner_ = ActivityId::kPlans;
  phase_ = Phase::kOwned;
  end_ = notice.position;
  const std::uint32_t all = (1u << robot_.axis_count) - 1u;
  referenced_ = (notice.referenced & all) == all;
  if (!referenced_) drop(Refusal::kNotReferenced);
}

void ArmOwner::on_fault() noexcept {
  owner_ = ActivityId::kPlans;
  phase_ = Phase::kFault;
  mailbox_.control.set_hold(false);  // no move is left to resume
  drop(Refusal::kNotReady);
  for_each([](Activity& activity) { activity.on_rest(); });
}

}  // namespace armature
