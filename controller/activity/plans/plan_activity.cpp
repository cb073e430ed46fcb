#include "controller/activity/plans/plan_activity.hpp"

#include <type_traits>

#include "controller/activity/move_checks.hpp"

namespace armature {

PlanActivity::PlanActivity(const ActivityContext& context) noexcept
    : context_{context},
      outbox_{context.channel},
      path_{context},
      window_{context, path_, outbox_},
      joints_{context, outbox_},
      corner_{context, path_, joints_, outbox_},
      retarget_{context, outbox_} {}

template <QueuedMove Move>
std::optional<MoveRefused> PlanActivity::accept(const Move& move) noexcept {
  std::optional<MoveRefused> refusal;
  if (context_.owner.in_fault()) {
    refusal = refused(Refusal::kNotReady);
  } else if (!context_.owner.referenced() && !context_.owner.has(ActivityId::kHoming)) {
    refusal = refused(Refusal::kNotReferenced);
  } else if constexpr (std::is_same_v<Move, JointMove>) {
    refusal = find_refusal(context_.robot, move);
  } else if constexpr (requires { find_refusal(move); }) {
    refusal = find_refusal(move);
  } else {
    refusal = find_refusal(context_.robot, context_.frames, move);
  }
  bool now = false;
  if constexpr (std::is_same_v<Move, JointMove>) {
    now = move.now;
    if (now && !refusal) refusal = retarget_.accept(move);
  }
  if (!refusal && !now && !context_.queue.push(move)) refusal = refused(Refusal::kQueueFull);
  // The moves before and after a refused move must not be blended, nor those before and after a move that does not
  // wait.
  if (refusal || now) context_.queue.break_chain();
  return refusal;
}

template std::optional<MoveRefused> PlanActivity::accept(const JointMove&) noexcept;
template std::optional<MoveRefused> PlanActivity::accept(const PoseMove&) noexcept;
template std::optional<MoveRefused> PlanActivity::accept(const CartesianMove&) noexcept;
template std::optional<MoveRefused> PlanActivity::accept(const Dwell&) noexcept;
template std::optional<MoveRefused> PlanActivity::accept(const SetOutput&) noexcept;
template std::optional<MoveRefused> PlanActivity::accept(const WaitInput&) noexcept;

PlanActivity::Work PlanActivity::work(RegisterBus& bus) noexcept {
  const auto done = [](bool worked) { return worked ? Work::kDone : Work::kWaiting; };
  if (corner_.busy()) {
    corner_.work(bus);
    return Work::kDone;
  }
  if (window_.active()) return done(window_.work(bus));
  path_.drop_rest();
  if (!path_.empty()) {
    if (!has_room_for_path()) return Work::kWaiting;
    work_on_path(bus);
    return Work::kDone;
  }
  if (!joints_.empty()) return done(add_to_joints(bus));
  if (corner_.joining()) return done(add_to_joined(bus));
  return Work::kNothing;
}

bool PlanActivity::execute(const JointMove& move, RegisterBus& bus) noexcept {
  if (!outbox_.has_room()) return false;
  plan(move, bus);
  return true;
}

bool PlanActivity::execute(const PoseMove& move, RegisterBus& bus) noexcept {
  if (!outbox_.has_room()) return false;
  plan(move, bus);
  return true;
}

bool PlanActivity::execute(const CartesianMove& move, RegisterBus& bus) noexcept {
  if (!outbox_.has_room()) return false;
  path_.begin(move, false, bus);
  return true;
}

bool PlanActivity::execute(const Dwell& dwell, RegisterBus& bus) noexcept {
  if (!outbox_.has_room()) return false;
  const JointPlan plan{.start = context_.owner.end(),
                       .target = context_.owner.end(),
                       .duration = dwell.duration,
                       .is_dwell = true,
                       .tag = dwell.tag};
  context_.queue.drop_front();
  bus.charge(armature::Work::kPlan);
  outbox_.send(plan);
  return true;
}

void PlanActivity::plan(const JointMove& move, RegisterBus& bus, double residual_rad) noexcept {
  if (!joints_.empty() || corner_.joining() || move.blend.wanted()) return corner_.add(move, bus, residual_rad);
  const JointMove alone = move;
  context_.queue.drop_front();
  joints_.send_alone(alone, bus, residual_rad);
}

void PlanActivity::plan(const PoseMove& move, RegisterBus& bus) noexcept {
  const Transform base_T_flange = path_.resolve(move.target) * inverse(context_.config.flange_T_tool);
  const IkTracking solution = context_.arm.soonest(base_T_flange, context_.owner.end(), move.target.configuration);
  bus.charge(armature::Work::kInverse, static_cast<std::int64_t>(IkSolutions::kMax));
  if (!solved(solution.status)) {
    MoveRefused refusal = refusal_of(context_.robot, solution);
    refusal.tag = move.tag;
    context_.queue.drop_front();
    corner_.close();
    return context_.events.on_event(refusal);
  }
  plan(JointMove{.target = solution.joints,
                 .speed = move.speed,
                 .accel = move.accel,
                 .profile = move.profile,
                 .blend = move.blend,
                 .outputs = move.outputs,
                 .tag = move.tag},
       bus, solution.residual_rad);
}

// Until a path can be sent together with what comes before it: as two plans, or as one of three pieces.
bool PlanActivity::has_room_for_path() const noexcept {
  using Progress = PathStage::Progress;
  const Progress progress = path_.planner().progress();
  if (progress == Progress::kIdle) return outbox_.has_room();
  return progress != Progress::kDone || outbox_.has_room(joints_.empty() ? 1 : 2);
}

void PlanActivity::work_on_path(RegisterBus& bus) noexcept {
  using Progress = PathStage::Progress;
  (void)path_.start_planning(bus);
  switch (path_.planner().progress()) {
    case Progress::kIdle:
    case Progress::kWorking:
      path_.work(bus);
      return;  // the result is used after the commands that came meanwhile have been accepted
    case Progress::kDone:
      context_.owner.set_end(path_.planner().plan().target);
      path_.set_unasked_stop(false);
      path_.measure(0, bus);
      if (corner_.can_join_path()) return corner_.join_path();
      if (!joints_.empty()) corner_.send_joints();
      outbox_.send(path_.planner().plan());
      path_.requests().drop_front(path_.planner().plan().count);
      if (path_.planner().can_continue() && (!path_.empty() || path_.requests().continues())) {
        window_.open();
      } else {
        path_.cancel();
      }
      return;
    case Progress::kRefused:
      path_.refuse(path_.planner().problem());
      path_.cancel();
      path_.clear();
      joints_.close();
      return;
  }
}

// The front of the queue joins the joint moves, or they are sent.
bool PlanActivity::add_to_joints(RegisterBus& bus) noexcept {
  if (joints_.leads_on()) {
    const auto joins = [this](const auto* move) {
      return move != nullptr && joints_.open() && (!corner_.joining() || move->outputs.count == 0);
    };
    const auto* joint = context_.queue.next_if<JointMove>();
    const auto* pose = context_.queue.next_if<PoseMove>();
    const auto* path = context_.queue.next_if<CartesianMove>();
    if (joins(joint)) {
      plan(*joint, bus);
      return true;
    }
    if (joins(pose)) {
      plan(*pose, bus);
      return true;
    }
    const bool leads_to_path =
        path != nullptr && path->target.frame != kConveyorFrame && path->outputs.count == 0 && !joints_.has_outputs();
    if (leads_to_path && corner_.may_join_another_path()) {
      path_.begin(*path, false, bus);
      return true;
    }
  }
  if (!outbox_.has_room(corner_.stores())) return false;
  corner_.send_joints();
  return true;
}

// The front of the queue joins the plan, which ends with a path, or it is sent.
bool PlanActivity::add_to_joined(RegisterBus& bus) noexcept {
  if (corner_.path_leads_on()) {
    if (const auto* joint = context_.queue.next_if<JointMove>()) {
      plan(*joint, bus);
    } else {
      plan(*context_.queue.next_if<PoseMove>(), bus);
    }
    return true;
  }
  if (!outbox_.has_room()) return false;
  outbox_.send_unsent();
  return true;
}

bool PlanActivity::idle() const noexcept {
  return path_.empty() && corner_.moves() == 0 && outbox_.all_over();
}

void PlanActivity::drop(Refusal why) noexcept {
  path_.cancel();
  corner_.drop(why);
  joints_.drop(why);
  window_.drop(why);
  if (why == Refusal::kReplaced) window_.settle(why);
}

void PlanActivity::on_rest() noexcept {
  window_.settle(Refusal::kNotReady);
}

}  // namespace armature
