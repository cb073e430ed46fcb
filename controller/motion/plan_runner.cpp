#include "controller/motion/plan_runner.hpp"

#include <optional>
#include <utility>

#include "controller/motion/move_reports.hpp"

namespace armature {

PlanRunner::PlanRunner(const RobotModel& robot, const Arm& arm, MotionMailbox& mailbox,
                       ControllerObserver& observer) noexcept
    : mailbox_{mailbox}, observer_{observer}, sampler_{robot, arm, {}} {}

PlanRunner::Outcome PlanRunner::advance(Ticks tick) noexcept {
  Outcome outcome;
  // Before the orders: when a hold is seen to be released, the stop that released it is there too.
  const RunControl::View control = mailbox_.control.view();
  outcome.wake = count_plans_over() || mailbox_.wake_each_tick.load(std::memory_order_relaxed);
  if (stopping_ && (!under_way_ || sampler_.rate() == 0.0)) {
    give_up_plan();
    outcome.at_rest = true;
  }
  take_order(outcome);
  if (!stopping_ && !under_way_ && !control.hold) start_next_plan(control.share, outcome);

  const bool moved = under_way_;
  if (stopping_) {
    sampler_.brake();
  } else {
    sampler_.advance(control.hold ? 0.0 : control.share);
  }
  if (under_way_) report_progress(tick);
  outcome.inverses = sampler_.inverses();
  if (stopping_) {
    outcome.state = MotionState::kStopping;
  } else if (control.hold && (moved || !mailbox_.plans.empty())) {
    outcome.state = MotionState::kHolding;
  } else if (moved) {
    outcome.state = MotionState::kMoving;
  }
  return outcome;
}

// The set that ends a plan is committed in the tick of its end, starts with the next trigger and is out with the one
// after.
bool PlanRunner::count_plans_over() noexcept {
  const std::uint32_t over = std::exchange(plans_pulsing_, plans_ended_);
  if (over == mailbox_.plans_over.load(std::memory_order_relaxed)) return false;
  mailbox_.plans_over.store(over, std::memory_order_release);
  return true;
}

void PlanRunner::take_order(Outcome& outcome) noexcept {
  const std::optional<MotionOrder> order = mailbox_.orders.try_pop();
  if (!order || *order != MotionOrder::kStop) return;
  drop_plans();
  stopping_ = under_way_;
  if (!stopping_) outcome.at_rest = true;
}

void PlanRunner::start_next_plan(double share, Outcome& outcome) noexcept {
  const MotionPlan* plan = mailbox_.plans.front();
  if (plan == nullptr) return;
  sampler_.start(*plan, share);
  mailbox_.plans.drop_front();
  under_way_ = true;
  begun_ = finished_ = 0;
  outcome.plan_taken = true;
}

// A move begins in the tick that makes its first step, and ends in the one that makes its last.
void PlanRunner::report_progress(Ticks tick) noexcept {
  const MotionPlan& plan = sampler_.plan();
  const std::size_t moves = moves_in(plan);
  const double elapsed = sampler_.elapsed();
  const bool ended = !sampler_.busy();
  for (; begun_ < moves; ++begun_) {
    if (!ended && !(static_cast<double>(span_of(plan, begun_).start.value()) < elapsed)) break;
    observer_.on_move_started(report_of(plan, begun_, tick));
  }
  for (; finished_ < begun_; ++finished_, ++moves_finished_) {
    if (!ended && static_cast<double>(span_of(plan, finished_).end.value()) > elapsed) break;
  }
  under_way_ = !ended;
  if (ended) ++plans_ended_;
}

void PlanRunner::stand_at(const PerAxis<Radians>& position) noexcept {
  sampler_.stand_at(position);
  under_way_ = stopping_ = false;
}

void PlanRunner::abandon() noexcept {
  give_up_plan();
  drop_plans();
  plans_pulsing_ = plans_ended_;  // nothing is emitted in Fault
  mailbox_.plans_over.store(plans_ended_, std::memory_order_release);
}

void PlanRunner::drop_plans() noexcept {
  while (const MotionPlan* plan = mailbox_.plans.front()) {
    for (std::size_t move = 0; move < moves_in(*plan); ++move) observer_.on_move_refused(dropped(*plan, move));
    mailbox_.plans.drop_front();
    ++plans_ended_;
  }
}

void PlanRunner::give_up_plan() noexcept {
  if (under_way_) {
    ++plans_ended_;
    for (std::size_t moves = moves_in(sampler_.plan()); begun_ < moves; ++begun_) {
      observer_.on_move_refused(dropped(sampler_.plan(), begun_));
    }
  }
  stand_at(sampler_.position());
}

}  // namespace armature
