#include "controller/activity/conveyor/conveyor_activity.hpp"

namespace armature {

ConveyorActivity::ConveyorActivity(const ActivityContext& context, PlanActivity& plans) noexcept
    : context_{context},
      plans_{plans},
      path_{plans.path()},
      part_{context.robot, context.arm, context.config, plans.outbox(), context.channel.part_store} {
  if (context.config.conveyor) context.frames.back() = part_.base_T_part();
}

std::optional<MoveRefused> ConveyorActivity::accept(const ConveyorPart& part) noexcept {
  if (context_.config.conveyor) part_.add(part);
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
  PerAxis<Radians> end = context_.owner.end();
  const bool follows = context_.owner.has(ActivityId::kConveyor);
  const PartPlanning::Ready ready = follows ? part_.prepare_next(end) : part_.prepare_first();
  context_.owner.set_end(end);
  if (const std::optional<PartFollowed> missed = part_.pop_missed()) {
    context_.events.on_event(*missed);
    bus.charge(Work::kPlan);
    return true;
  }
  switch (ready) {
    case PartPlanning::Ready::kNotYet:
      return false;
    case PartPlanning::Ready::kTooFast:
      context_.queue.refuse_front(Refusal::kBeltTooFast);
      return true;
    case PartPlanning::Ready::kUnreachable:
      context_.queue.refuse_front(Refusal::kUnreachable);
      return true;
    case PartPlanning::Ready::kNow:
      break;
  }
  context_.frames.back() = part_.base_T_frame();
  path_.begin(move, true, bus);
  return true;
}

// The tool stands on the part for this time.
bool ConveyorActivity::execute(const Dwell& dwell, RegisterBus& bus) noexcept {
  if (!stands()) return false;
  bus.charge(Work::kPlan);
  part_.send_dwell(JointPlan{.start = context_.owner.end(),
                             .target = context_.owner.end(),
                             .duration = dwell.duration,
                             .is_dwell = true,
                             .tag = dwell.tag});
  context_.queue.drop_front();
  return true;
}

bool ConveyorActivity::release() noexcept {
  if (!stands()) return false;
  context_.owner.feed(ActivityId::kConveyor, PartRelease{});
  context_.owner.release();
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
      context_.owner.set_end(path_.planner().plan().target);
      if (part_.send(path_.planner().plan())) context_.owner.begin(ActivityId::kConveyor, PartBegin{});
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
  if (!context_.owner.has(ActivityId::kConveyor) && !plans()) return;
  context_.owner.drop(how == StopKind::kHold ? Refusal::kPartLost : Refusal::kNotReady);
}

// The moves of a part that the arm follows, or for which a path is planned, are not continued.
void ConveyorActivity::lose_part() noexcept {
  context_.owner.drop(Refusal::kPartLost);
  if (context_.owner.has(ActivityId::kConveyor)) context_.owner.stop(StopKind::kQuick);
}

}  // namespace armature
