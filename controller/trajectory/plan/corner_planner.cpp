#include "controller/trajectory/plan/corner_planner.hpp"

#include <cassert>
#include <cstddef>

#include "controller/trajectory/joint/joint_passage.hpp"

namespace armature {
namespace {

// Where the corner before a move must be planned again, so many ends on the path are tried.
constexpr int kMaxEntries = 4;
// A plan between two states of motion takes the time of so many plans to rest (measured: 11 and 13).
constexpr std::int64_t kPassageRetargets = 12;
static_assert(kPassageRetargets <= kMaxOfStep.retargets);

bool executable(const RetargetPlan& plan, const RobotModel& robot) {
  return plan.duration <= kLongestMove && !axis_outside(plan, robot);
}

[[maybe_unused]] bool is_allowed(const CornerWork& work) {
  return work.inverses <= kMaxOfStep.inverses && work.retargets <= kMaxOfStep.retargets;
}

}  // namespace

DeparturePlanner::DeparturePlanner(const RobotModel& robot, const Arm& arm, const PathBefore& before,
                                   const JointRequest& request) noexcept
    : robot_{robot},
      exit_{robot, arm, *before.path, before.from, before.blend_mm},
      request_{request},
      search_{exit_.early(), exit_.end()} {}

void DeparturePlanner::step() noexcept {
  const std::int64_t inverses = exit_.inverses();
  work_ = {};
  switch (stage_) {
    case Stage::kStop:
      stop_ = {.at = Ticks{exit_.end()}, .plan = plan_from(exit_.end())};
      best_ = stop_;
      stage_ = Stage::kPlan;
      if (search_.done()) end();
      break;
    case Stage::kPlan:
      plan();
      break;
    case Stage::kCheck:
      check();
      break;
    case Stage::kDone:
      break;
  }
  work_.inverses = exit_.inverses() - inverses;
  assert(is_allowed(work_));
}

RetargetPlan DeparturePlanner::plan_from(std::int64_t tick) noexcept {
  ++work_.retargets;
  return plan_retarget(robot_, exit_.state_at(tick), request_.target, request_.speed, request_.kind, request_.accel);
}

void DeparturePlanner::plan() noexcept {
  if (!exit_.approach(search_.trial())) return;
  trial_ = plan_from(search_.trial());
  stage_ = Stage::kCheck;
}

void DeparturePlanner::check() noexcept {
  const std::int64_t tick = search_.trial();
  const bool fits = executable(trial_, robot_) && exit_.keeps(trial_, tick);
  if (fits) best_ = {.at = Ticks{tick}, .plan = trial_, .passed = exit_.passed()};
  search_.set(fits);
  stage_ = Stage::kPlan;
  if (search_.done()) end();
}

void DeparturePlanner::end() noexcept {
  const bool gains = best_.at + best_.plan.duration < stop_.at + stop_.plan.duration;
  if (!gains) best_ = stop_;
  stage_ = Stage::kDone;
}

ArrivalPlanner::ArrivalPlanner(const RobotModel& robot, const Arm& arm, JointChain& chain, const CartesianPlan& path,
                               const ArrivalRequest& request) noexcept
    : robot_{robot},
      chain_{chain},
      request_{request},
      entry_{robot, arm, path, request.blend_rad, request.blend_share, request.half_way_rad},
      exit_at_{request.exit_at} {
  const std::size_t move = chain.count - 1;
  if (move > 0) {
    before_ = &chain.moves[move - 1];
    begin_alone_ = (chain.starts[move] - chain.starts[move - 1]).value();
    rest_before_ = before_->duration.value();
  } else if (request.before) {
    exit_.emplace(robot, arm, *request.before->path, request.before->from, request.before->blend_mm);
    begin_alone_ = request.exit_at.value();
    rest_before_ = exit_->end();
  }
  begin_ = begin_alone_;
}

void ArrivalPlanner::step() noexcept {
  const auto inverses = [this] { return entry_.inverses() + (exit_ ? exit_->inverses() : 0); };
  const std::int64_t before = inverses();
  work_ = {};
  switch (stage_) {
    case Stage::kPrepare:
      if (entry_.prepare()) search_end();
      break;
    case Stage::kPlan:
      plan();
      break;
    case Stage::kCheck:
      check();
      break;
    case Stage::kCheckBegin:
      check_begin();
      break;
    case Stage::kDone:
      break;
  }
  work_.inverses = inverses() - before;
  assert(is_allowed(work_));
}

// The latest end, from the state in which the move begins now. Its search runs in reversed time.
void ArrivalPlanner::search_end() noexcept {
  search_ = EarliestFit{0, entry_.late()};
  stage_ = Stage::kPlan;
  if (search_.done()) end();
}

// The earliest begin that keeps the corner before, with the end that was found.
void ArrivalPlanner::search_begin() noexcept {
  search_ = EarliestFit{begin_alone_, rest_before_};
  searches_begin_ = true;
  stage_ = Stage::kPlan;
}

PerAxis<AxisState> ArrivalPlanner::start_at(std::int64_t begin) noexcept {
  if (!searches_begin_) return state_at(chain_.moves[chain_.count - 1], 0.0);
  return before_ != nullptr ? state_at_tick(*before_, begin) : exit_->state_at(begin);
}

bool ArrivalPlanner::keeps_before(const RetargetPlan& plan, std::int64_t begin) noexcept {
  if (before_ != nullptr) return closest_to(before_->target, plan).distance <= request_.blend_before_rad;
  return exit_->keeps(plan, begin);
}

void ArrivalPlanner::plan() noexcept {
  trial_begin_ = searches_begin_ ? search_.trial() : begin_alone_;
  trial_end_ = searches_begin_ ? at_ : entry_.late() - search_.trial();
  if (!entry_.approach(trial_end_)) return;
  if (searches_begin_ && exit_ && !exit_->approach(trial_begin_)) return;
  const RetargetPlan& alone = chain_.moves[chain_.count - 1];
  trial_ = plan_passage(robot_, start_at(trial_begin_), entry_.state_at(trial_end_), request_.speed, alone.kind,
                        request_.accel);
  work_.retargets += kPassageRetargets;
  stage_ = Stage::kCheck;
}

void ArrivalPlanner::check() noexcept {
  const bool fits = executable(trial_, robot_) && (!searches_begin_ || keeps_before(trial_, trial_begin_)) &&
                    entry_.keeps(trial_, trial_end_);
  if (fits) {
    best_ = trial_;
    begin_ = trial_begin_;
    at_ = trial_end_;
    found_ = true;
  }
  search_.set(fits);
  stage_ = Stage::kPlan;
  if (search_.done()) end_search();
}

// The corner before may be missed by more than without this one.
void ArrivalPlanner::check_begin() noexcept {
  if (exit_ && !exit_->approach(begin_)) return;
  if (keeps_before(best_, begin_)) return end();
  search_begin();
}

void ArrivalPlanner::end_search() noexcept {
  if (!searches_begin_) {
    if (!found_ || begin_ >= rest_before_) return end();
    found_ = false;
    stage_ = Stage::kCheckBegin;
    return;
  }
  if (found_) return end();
  at_ = at_ * 3 / 4;
  if (++entries_ < kMaxEntries) return search_begin();
  at_ = 0;
  end();
}

void ArrivalPlanner::end() noexcept {
  stage_ = Stage::kDone;
  const std::size_t move = chain_.count - 1;
  const RetargetPlan& alone = chain_.moves[move];
  const bool gains = at_ > 0 && begin_ + best_.duration.value() < begin_alone_ + alone.duration.value() + at_;
  if (!gains) {
    at_ = 0;
    return;
  }
  best_.tag = alone.tag;
  best_.residual_rad = alone.residual_rad;
  chain_.moves[move] = best_;
  if (before_ != nullptr) chain_.starts[move] = chain_.starts[move - 1] + Ticks{begin_};
  if (exit_) exit_at_ = Ticks{begin_};
  chain_.target = best_.target;
  chain_.duration = chain_.starts[move] + best_.duration;
}

}  // namespace armature
