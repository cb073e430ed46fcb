#include "controller/activity/conveyor/conveyor_activity.hpp"

namespace armature {

ConveyorActivity::ConveyorActivity(const RobotModel& robot, const Arm& arm, const PlanningConfig& config,
                                   UserFrames& frames, ArmOwner& owner, MoveQueue& queue, PlanActivity& plans,
                                   Channel& channel, EventListener& events) noexcept
    : config_{config},
      frames_{frames},
      owner_{owner},
      queue_{queue},
      plans_{plans},
      path_{plans.path()},
      events_{events},
      part_{robot, arm, config, plans.outbox(), channel.part_store} {
  if (config.conveyor) frames_.back() = part_.base_T_part();
}

std::optional<MoveRefused> ConveyorActivity::accept(const ConveyorPart& part) noexcept {
  if (config_.conveyor) part_.add(part);
  return std::nullopt;
}

bool ConveyorActivity::work(RegisterBus& bus) noexcept {
  using Progress = PathStage::Progress;
  if (path_.planner().progress() == Progress::kIdle && !plans_.outbox().has_room()) return false;
  if (path_.start_planning(bus)) part_.restart_check();
  switch (path_.planner().progress()) {
    case Progress::kIdle:
    case Progress::kWorking:
      path_.work(bus);
      break;
    case Progress::kDone:
      check(bus);
      break;
    case Progress::kRefused:
      path_.refuse(path_.planner().problem());
      clear_path();
      break;
  }
  return true;
}

bool ConveyorActivity::execute(const CartesianMove& move, bool stands, RegisterBus& bus) noexcept {
  if (!stands) return false;
  PerAxis<Radians> end = owner_.end();
  const bool follows = owner_.has(ActivityId::kConveyor);
  const PartPlanning::Ready ready = follows ? part_.prepare_next(end) : part_.prepare_first();
  owner_.set_end(end);
  if (const std::optional<PartFollowed> missed = part_.pop_missed()) {
    events_.on_event(*missed);
    bus.charge(Work::kPlan);
    return true;
  }
  switch (ready) {
    case PartPlanning::Ready::kNotYet:
      return false;
    case PartPlanning::Ready::kTooFast:
      queue_.refuse_front(Refusal::kBeltTooFast);
      return true;
    case PartPlanning::Ready::kUnreachable:
      queue_.refuse_front(Refusal::kUnreachable);
      return true;
    case PartPlanning::Ready::kNow:
      break;
  }
  frames_.back() = part_.base_T_frame();
  path_.begin(move, true, bus);
  return true;
}

// The tool stands on the part for this time.
bool ConveyorActivity::execute(const Dwell& dwell, RegisterBus& bus) noexcept {
  if (!stands()) return false;
  bus.charge(Work::kPlan);
  part_.send_dwell(JointPlan{
      .start = owner_.end(), .target = owner_.end(), .duration = dwell.duration, .is_dwell = true, .tag = dwell.tag});
  queue_.drop_front();
  return true;
}

bool ConveyorActivity::release() noexcept {
  if (!stands()) return false;
  owner_.feed(ActivityId::kConveyor, PartRelease{});
  owner_.release();
  return true;
}

void ConveyorActivity::check(RegisterBus& bus) noexcept {
  const PartPlanning::Verdict verdict = part_.check(path_.planner().plan(), PathStage::kSlice);
  bus.charge(Work::kInverse, part_.take_inverses());
  switch (verdict) {
    case PartPlanning::Verdict::kWorking:
      return;
    case PartPlanning::Verdict::kSlower:
      path_.requests().slow_down(PartPlanning::slower_limits(path_.planner().plan()));
      path_.planner().cancel();
      return;  // it is planned again
    case PartPlanning::Verdict::kGood:
      owner_.set_end(path_.planner().plan().target);
      if (part_.send(path_.planner().plan())) owner_.begin(ActivityId::kConveyor, PartBegin{});
      break;
    case PartPlanning::Verdict::kTooFast:
      path_.refuse({.kind = PathProblem::Kind::kTooFast, .axis = part_.axis()});
      break;
    case PartPlanning::Verdict::kLeavesWindow:
      lose_part();
      break;
  }
  clear_path();
}

void ConveyorActivity::clear_path() noexcept {
  path_.cancel();
  path_.clear();
}

void ConveyorActivity::on_stop(StopKind how) noexcept {
  if (!owner_.has(ActivityId::kConveyor) && !plans()) return;
  owner_.drop(how == StopKind::kHold ? Refusal::kPartLost : Refusal::kNotReady);
}

// The moves of a part that the arm follows, or for which a path is planned, are not continued.
void ConveyorActivity::lose_part() noexcept {
  owner_.drop(Refusal::kPartLost);
  if (owner_.has(ActivityId::kConveyor)) owner_.stop(StopKind::kQuick);
}

}  // namespace armature
