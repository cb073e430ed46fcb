// The part of the dispatcher for paths in the frame of a part on the conveyor.
#include "controller/command/dispatcher.hpp"

namespace armature {

void Dispatcher::accept(const ConveyorPart& part) noexcept {
  if (config_.conveyor) conveyor_.add(part);
}

// A move in another frame waits: the arm leaves the part when it has done all paths on it.
bool Dispatcher::release_part() noexcept {
  if (!stands()) return false;
  conveyor_.order(ConveyorOrder::Kind::kRelease);
  mode_ = Mode::kAwaitingRest;
  return true;
}

bool Dispatcher::plan_on_conveyor(const CartesianMove& move, RegisterBus& bus) noexcept {
  if (!stands()) return false;
  const bool following = mode_ == Mode::kFollowing;
  const ConveyorFeed::Ready ready = following ? conveyor_.prepare_next(planned_end_) : conveyor_.prepare_first();
  if (const std::optional<PartFollowed> missed = conveyor_.pop_missed()) {
    events_.on_event(*missed);
    bus.charge(Work::kPlan);
    return true;
  }
  switch (ready) {
    case ConveyorFeed::Ready::kNotYet:
      return false;
    case ConveyorFeed::Ready::kTooFast:
      drop_first_waiting(Refusal::kBeltTooFast);
      return true;
    case ConveyorFeed::Ready::kUnreachable:
      drop_first_waiting(Refusal::kUnreachable);
      return true;
    case ConveyorFeed::Ready::kNow:
      break;
  }
  frames_.back() = conveyor_.base_T_frame();
  plan(move, bus);
  chain_on_conveyor_ = true;
  return true;
}

// The tool stands on the part for this time.
bool Dispatcher::dwell_on_conveyor(const Dwell& dwell, RegisterBus& bus) noexcept {
  if (!stands()) return false;
  bus.charge(Work::kPlan);
  conveyor_.send_dwell(JointPlan{
      .start = planned_end_, .target = planned_end_, .duration = dwell.duration, .is_dwell = true, .tag = dwell.tag});
  waiting_.drop_front();
  return true;
}

void Dispatcher::check_on_conveyor(RegisterBus& bus) noexcept {
  const ConveyorFeed::Verdict verdict = conveyor_.check(planner_.plan(), kSlice);
  bus.charge(Work::kInverse, conveyor_.take_inverses());
  switch (verdict) {
    case ConveyorFeed::Verdict::kWorking:
      return;
    case ConveyorFeed::Verdict::kSlower:
      chain_.slow_down(ConveyorFeed::slower_limits(planner_.plan()));
      planner_.cancel();
      return;  // it is planned again
    case ConveyorFeed::Verdict::kGood:
      planned_end_ = planner_.plan().target;
      conveyor_.send(planner_.plan());
      mode_ = Mode::kFollowing;
      break;
    case ConveyorFeed::Verdict::kTooFast:
      refuse_chain({.kind = PathProblem::Kind::kTooFast, .axis = conveyor_.axis()});
      break;
    case ConveyorFeed::Verdict::kLeavesWindow:
      lose_part();
      break;
  }
  planner_.cancel();
  chain_.clear();
  chain_on_conveyor_ = false;
}

// The moves of a part that the arm follows, or for which a path is planned, are not continued.
void Dispatcher::lose_part(Refusal reason) noexcept {
  const bool following = mode_ == Mode::kFollowing;
  if (!following && !chain_on_conveyor_) return;
  drop_moves(reason);
  if (!following) return;
  conveyor_.order(ConveyorOrder::Kind::kStop);
  mode_ = Mode::kAwaitingRest;
}

}  // namespace armature
