#include "controller/activity/plans/plan_source.hpp"

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>

#include "controller/activity/plans/move_events.hpp"

namespace armature {

PlanSource::PlanSource(const RobotModel& robot, const Arm& arm, Channel& channel, EventListener& events) noexcept
    : robot_{robot},
      store_{channel.plan_store},
      loop_{channel.loop},
      events_{events},
      sampler_{robot, arm, {}},
      in_motion_{robot, sampler_},
      progress_{events} {}

SetPoint& PlanSource::advance(Ticks tick, const RunControl::View& control) noexcept {
  pins_.written(tick, events_);
  set_point_.stopped = set_point_.planned = false;
  set_point_.wake = count_plans_over();
  if (stopping_ && in_motion_.in_step() && (!under_way_ || sampler_.rate() == 0.0)) {
    cancel_plan(tick);
    set_point_.stopped = true;
  }
  accept_stop();
  if (!stopping_) begin_plans(tick, control);
  // An override does not make a dwell longer.
  const double share = under_way_ && is_dwell(sampler_.plan()) ? 1.0 : control.share;

  const bool moved = under_way_;
  const StepsAhead::Step step = in_motion_.next([&] {
    if (stopping_) {
      brake();
    } else {
      sampler_.advance(a_move_starts() ? sampler_.rate() : control.hold ? 0.0 : share);
    }
  });
  if (under_way_) {
    pins_.advance(sampler_.plan(), step.elapsed, !step.busy);
    store_.progress.set({number_, static_cast<std::uint32_t>(step.elapsed)});
    report_progress(step, tick);
  }
  set_point_.pins = pins_.next();
  set_point_.position = step.position;
  set_point_.rate = step.rate;
  set_point_.inverses = in_motion_.inverses();
  set_point_.planned = in_motion_.worked();
  set_point_.state = state_of_motion(control.hold, moved);
  return set_point_;
}

void PlanSource::begin_plans(Ticks tick, const RunControl::View& control) noexcept {
  if (!in_motion_.active()) {
    continue_with_next();
    if (control.hold) return;
    if (retarget_) in_motion_.begin(retarget_->goal);
  }
  if (in_motion_.ready()) retarget(*std::exchange(retarget_, std::nullopt), tick);
  if (!in_motion_.active() && !control.hold && !under_way_) start_next_plan(control.share);
}

// In the next step, which then keeps its rate: there is no time to change it and to report a move.
bool PlanSource::a_move_starts() const noexcept {
  const double rate = sampler_.rate();
  return under_way_ && rate > 0.0 && sampler_.may_keep_rate() &&
         progress_.starts_before(sampler_.plan(), sampler_.elapsed() + rate);
}

// `moved`: a plan was under way in this tick.
MotionState PlanSource::state_of_motion(bool hold, bool moved) const noexcept {
  if (stopping_) return MotionState::kStopping;
  if (hold && (moved || !store_.plans.empty())) return MotionState::kHolding;
  return moved ? MotionState::kMoving : MotionState::kIdle;
}

// The last set of a plan is committed in the tick of its end. It starts with the next trigger and is complete at the
// one after.
bool PlanSource::count_plans_over() noexcept {
  const std::uint32_t over = std::exchange(plans_pulsing_, plans_ended_);
  if (over == store_.over.load(std::memory_order_relaxed)) return false;
  store_.over.store(over, std::memory_order_release);
  return true;
}

void PlanSource::accept_stop() noexcept {
  if (!stop_) return;
  soft_ = *stop_ != StopKind::kQuick;
  stop_.reset();
  drop_all();
  stopping_ = under_way_;
  if (!stopping_) in_motion_.reset();
  if (!stopping_) set_point_.stopped = true;
}

// A quick stop replaces a soft one that is braking.
void PlanSource::stop(StopKind how) noexcept {
  if (stopping_) {
    soft_ = soft_ && how != StopKind::kQuick;
  } else if (!stop_ || how > *stop_) {
    stop_ = how;
  }
}

void PlanSource::brake() noexcept {
  if (soft_) {
    sampler_.advance(0.0);
  } else {
    sampler_.brake();
  }
}

// Replaces the active plan by the one that continues it, at a time at which both are the same.
void PlanSource::continue_with_next() noexcept {
  const Plan* plan = store_.plans.front();
  const CartesianPlan* next = plan == nullptr ? nullptr : plan->only_path();
  if (next == nullptr || !next->continues) return;
  if (!under_way_ || sampler_.missed(*next)) {
    drop_next_plan();
    store_.late.store(++plans_late_, std::memory_order_release);
    set_point_.wake = true;
  } else if (sampler_.can_continue_with(*next)) {
    sampler_.continue_with(*next);
    pins_.continue_with(*next);
    release_plan();
    take_next_plan();
    ++plans_ended_;
    progress_.continue_without(next->dropped);
    set_point_.wake = true;
  } else {
    read_ahead_.advance(*next);
  }
}

void PlanSource::retarget(const RetargetRequest& request, Ticks tick) noexcept {
  in_motion_.end();
  const bool started = start_retarget(request, tick);
  if (!started) ++plans_ended_;
  [[maybe_unused]] const bool pushed =
      loop_.answers.try_push({.kind = started ? Answer::Kind::kRetargeted : Answer::Kind::kNotRetargeted,
                              .position = request.goal.target,
                              .number = loop_.number});
  assert(pushed);  // never full, see Channel
  set_point_.wake = true;
}

// Returns whether a motion within the limits leads to the target.
bool PlanSource::start_retarget(const RetargetRequest& request, Ticks tick) noexcept {
  const RetargetPlan& plan = in_motion_.planned().plan();
  if (plan.duration > kLongestMove) {
    events_.on_event(refused(Refusal::kInvalidTarget, request.tag));
    return false;
  }
  if (const std::optional<std::size_t> axis = in_motion_.planned().outside()) {
    const auto number = static_cast<std::uint8_t>(*axis + 1);
    const PhaseLaw::Extent extent = plan.laws[*axis].extent();
    const AxisModel& model = robot_.axes[*axis];
    const bool above = extent.largest - model.max_rad > model.min_rad - extent.least;
    const PathProblem beyond{.angle_rad = above ? extent.largest : extent.least,
                             .limit_rad = above ? model.max_rad : model.min_rad};
    events_.on_event(
        MoveRefused{.reason = Refusal::kOutsideLimits, .axis = number, .path = beyond, .tag = request.tag});
    return false;
  }
  if (under_way_) {
    end_plan(tick, Refusal::kReplaced);
    release_plan();
  }
  drop_plans(Refusal::kReplaced);
  store_.retarget = plan;
  store_.retarget.moves[0].tag = request.tag;
  sampler_.start_in_motion(store_.retarget);
  under_way_ = true;
  number_ = 0;
  pins_.begin();
  progress_.begin();
  return true;
}

void PlanSource::start_next_plan(double share) noexcept {
  const Plan* plan = store_.plans.front();
  if (plan == nullptr) return;
  sampler_.start(*plan, is_dwell(*plan) ? 1.0 : share);
  take_next_plan();
  pins_.begin();
  progress_.begin();
  set_point_.wake = true;
}

// It becomes the active one.
void PlanSource::take_next_plan() noexcept {
  under_way_ = true;
  number_ = ++plans_taken_;
  stores_held_ = store_.plans.front()->stores();
  store_.plans.drop_front();
}

// The active plan is over.
void PlanSource::release_plan() noexcept {
  under_way_ = false;
  store_.release(std::exchange(stores_held_, 0));
}

void PlanSource::drop_next_plan() noexcept {
  ++plans_ended_;
  ++plans_taken_;
  const std::size_t stores = store_.plans.front()->stores();
  store_.plans.drop_front();
  if (stores_held_ > 0) {
    stores_held_ += stores;
  } else {
    store_.release(stores);
  }
}

void PlanSource::report_progress(const StepsAhead::Step& step, Ticks tick) noexcept {
  const bool ended = !step.busy;
  progress_.advance(sampler_.plan(), step.elapsed, ended, tick);
  if (!ended) return;
  ++plans_ended_;
  release_plan();
  set_point_.wake = true;
}

void PlanSource::cut_short(Ticks tick) noexcept {
  if (under_way_) progress_.cut_short(sampler_.plan(), tick);
}

void PlanSource::reset_to(const PerAxis<Radians>& position) noexcept {
  sampler_.reset_to(position);
  in_motion_.reset();
  if (under_way_) release_plan();
  under_way_ = stopping_ = false;
  stop_.reset();
  set_point_.position = position;
  set_point_.pins = {};
  set_point_.rate = 0.0;
}

void PlanSource::cancel(Ticks tick) noexcept {
  pins_.cancel();
  cancel_plan(tick);
  drop_all();
  plans_pulsing_ = plans_ended_;  // nothing is emitted in Fault
  store_.over.store(plans_ended_, std::memory_order_release);
}

void PlanSource::drop_plans(Refusal reason) noexcept {
  while (const Plan* plan = store_.plans.front()) {
    const CartesianPlan* path = plan->only_path();
    for (std::size_t move = path != nullptr ? path->known : 0; move < moves_in(*plan); ++move) {
      events_.on_event(dropped(*plan, move, reason));
    }
    drop_next_plan();
  }
}

// For a stop or a fault.
void PlanSource::drop_all() noexcept {
  drop_plans(Refusal::kNotReady);
  in_motion_.end();
  if (retarget_) refuse_retarget(*std::exchange(retarget_, std::nullopt));
}

void PlanSource::refuse_retarget(const RetargetRequest& request) noexcept {
  events_.on_event(refused(Refusal::kNotReady, request.tag));
  ++plans_ended_;
}

// In a Fault: nothing is emitted.
void PlanSource::drop(const Request& request) noexcept {
  if (request.kind != Request::Kind::kFeed) return;
  refuse_retarget(request.get<RetargetRequest>());
  plans_pulsing_ = plans_ended_;
  store_.over.store(plans_ended_, std::memory_order_release);
}

// Reports the moves of the active plan, which does not continue. `reason`: of those that have not started.
void PlanSource::end_plan(Ticks tick, Refusal reason) noexcept {
  ++plans_ended_;
  progress_.drop(sampler_.plan(), tick, reason);
}

void PlanSource::cancel_plan(Ticks tick) noexcept {
  if (under_way_) {
    end_plan(tick, Refusal::kNotReady);
    release_plan();
  }
  reset_to(set_point_.position);
}

}  // namespace armature
