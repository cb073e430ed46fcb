#include "controller/activity/plans/retarget_in_motion.hpp"

namespace armature {

static_assert(RetargetPlanner::kParts == StepsAhead::kMost, "it is planned when the steps ahead are over");

void RetargetInMotion::begin(const RetargetGoal& goal) noexcept {
  goal_ = goal;
  phase_ = Phase::kLooksAhead;
}

void RetargetInMotion::work() noexcept {
  if (phase_ == Phase::kLooksAhead) {
    look_ahead();
  } else if (phase_ == Phase::kPlans && !planner_.done()) {
    planner_.step();
    worked_ = true;
  }
}

// At the present rate, which can always be kept.
void RetargetInMotion::look_ahead() noexcept {
  while (!ahead_.full() && (inverses_ == 0 || inverses_ < kMostInverses)) {
    sampler_.advance(sampler_.rate());
    inverses_ += sampler_.inverses();
    ahead_.push(StepsAhead::step_of(sampler_));
  }
  if (!ahead_.full()) return;
  planner_.begin(sampler_.state(), goal_);
  phase_ = Phase::kPlans;
}

}  // namespace armature
