// The planning part of the dispatcher: from accepted moves to plans.
#include <algorithm>
#include <cassert>
#include <optional>
#include <type_traits>

#include "controller/command/dispatcher.hpp"
#include "controller/command/move_checks.hpp"
#include "controller/trajectory/plan/joint_move.hpp"
#include "controller/trajectory/plan/output_places.hpp"
#include "controller/trajectory/plan/path_reach.hpp"

namespace armature {

void Dispatcher::send_entries(std::size_t entries) noexcept {
  assert(mailbox_.plans.has_room(entries));  // the callers have checked, and only this core fills the queue
  mailbox_.plans.push_slots(entries);
  plans_queued_ += static_cast<std::uint32_t>(entries);
  ++plans_sent_;
  joined().begin_joined();
}

bool Dispatcher::execute_next(RegisterBus& bus) noexcept {
  if (mode_ != Mode::kReady && mode_ != Mode::kFollowing) return false;
  if (departure_ || arrival_) {
    work_on_corner(bus);
    return true;
  }
  if (window_ != Window::kNone) return execute_window(bus);
  drop_rest_of_chain();
  if (!chain_.empty()) {
    if (!has_room_for_chain()) return false;
    plan_chain(bus);
    return true;
  }
  if (joints_.count > 0) return extend_or_send_joints(bus);
  if (joined().parts() > 0) return extend_or_send_joined(bus);
  const WaitingMove* waiting = waiting_.front();
  if (waiting == nullptr) return false;
  return std::visit([&](const auto& move) { return execute(move, bus); }, waiting->move);
}

template <class Move>
bool Dispatcher::execute(const Move& move, RegisterBus& bus) noexcept {
  if (mode_ == Mode::kFollowing) return release_part();
  if (mailbox_.plans.full()) return false;
  plan(move, bus);
  return true;
}

bool Dispatcher::execute(const CartesianMove& move, RegisterBus& bus) noexcept {
  if (move.target.frame == kConveyorFrame) return plan_on_conveyor(move, bus);
  return execute<CartesianMove>(move, bus);
}

bool Dispatcher::execute(const Dwell& dwell, RegisterBus& bus) noexcept {
  return mode_ == Mode::kFollowing ? dwell_on_conveyor(dwell, bus) : execute<Dwell>(dwell, bus);
}

bool Dispatcher::execute(const SetOutput& output, RegisterBus& bus) noexcept {
  if (!stands()) return false;
  tool_.set(output, bus);
  events_.on_event(IoDone{.tag = output.tag, .pin = output.pin, .level = output.level});
  waiting_.drop_front();
  return true;
}

bool Dispatcher::execute(const WaitInput& wait, RegisterBus& bus) noexcept {
  if (!tool_.waiting()) {
    if (!stands()) return false;
    tool_.begin(wait, bus);
  }
  switch (tool_.sample(bus)) {
    case ToolIo::WaitState::kPending:
      return false;
    case ToolIo::WaitState::kReached:
      events_.on_event(IoDone{.tag = wait.tag, .pin = wait.pin, .level = wait.level});
      waiting_.drop_front();
      break;
    case ToolIo::WaitState::kTimedOut:
      drop_waiting(Refusal::kInputTimeout);
      break;
  }
  return true;
}

bool Dispatcher::stands() const noexcept {
  if (mode_ == Mode::kFollowing) return conveyor_.done();
  return mailbox_.plans_over.load(std::memory_order_acquire) == plans_sent_ && !mailbox_.control.view().hold;
}

std::optional<PerAxis<Radians>> Dispatcher::rest() const noexcept {
  const bool waits = !chain_.empty() || joined_moves() > 0 || !waiting_.empty();
  const bool ready = mode_ == Mode::kReady && !jogging_ && !stream_.active();
  if (!ready || waits || !stands()) return std::nullopt;
  return planned_end_;
}

void Dispatcher::plan(const JointMove& move, RegisterBus& bus, double residual_rad) noexcept {
  if (joints_.count > 0 || joined().parts() > 0 || move.blend.wanted()) return add_to_joints(move, bus, residual_rad);
  JointPlan plan =
      plan_joint_move(robot_, planned_end_, move.target, move.speed, config_.sync, move.profile, move.accel);
  plan.tag = move.tag;
  plan.residual_rad = residual_rad;
  waiting_.drop_front();
  bus.charge(Work::kPlan);
  if (plan.duration > kLongestMove) return refuse(Refusal::kInvalidTarget, plan.tag);
  if (!place_outputs(plan, move.outputs)) return refuse(Refusal::kOutputOutside, plan.tag);
  planned_end_ = plan.target;
  send_plan(plan);
}

void Dispatcher::plan(const PoseMove& move, RegisterBus& bus) noexcept {
  const Transform base_T_tool = resolve(move.target, frames_, planned_tool_pose(), plane_, false);
  const IkTracking solution =
      arm_.soonest(base_T_tool * inverse(config_.flange_T_tool), planned_end_, move.target.configuration);
  bus.charge(Work::kInverse, static_cast<std::int64_t>(IkSolutions::kMax));
  if (!solved(solution.status)) {
    MoveRefused refusal = refusal_of(robot_, solution);
    refusal.tag = move.tag;
    waiting_.drop_front();
    joints_open_ = false;
    path_blend_mm_ = 0.0;
    return events_.on_event(refusal);
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

void Dispatcher::plan(const Dwell& dwell, RegisterBus& bus) noexcept {
  waiting_.drop_front();
  bus.charge(Work::kPlan);
  send_plan(JointPlan{
      .start = planned_end_, .target = planned_end_, .duration = dwell.duration, .is_dwell = true, .tag = dwell.tag});
}

void Dispatcher::plan(const CartesianMove& move, RegisterBus& bus) noexcept {
  chain_.restart(planned_tool_pose());
  chain_.add(move, frames_, plane_);
  waiting_.drop_front();
  bus.charge(Work::kPlan);
}

void Dispatcher::plan_chain(RegisterBus& bus) noexcept {
  using Progress = CartesianPlanner::Progress;
  if (extend_chain() || planner_.progress() == Progress::kIdle) {
    // The others of a long chain continue this plan.
    const std::size_t most = CartesianPlan::kMaxFirstSegments;
    const auto first = chain_.requests().first(std::min(chain_.count_with_outputs(TimedOutputs::kMax), most));
    plan_begun_ = bus.now();
    planner_.begin(planned_end_, first, unasked_stop_);
    bus.charge(Work::kInverse, static_cast<std::int64_t>(IkSolutions::kMax * points_of(first)));
    conveyor_.restart_check();
  }
  switch (planner_.progress()) {
    case Progress::kIdle:
    case Progress::kWorking:
      work_on_chain(bus);
      return;  // the result is used after the commands that came meanwhile have been accepted
    case Progress::kDone:
      if (chain_on_conveyor_) return check_on_conveyor(bus);
      planned_end_ = planner_.plan().target;
      unasked_stop_ = false;
      measure_planning(bus);
      if (can_join_path()) return join_path();
      if (joints_.count > 0) send_joints();
      send_plan(planner_.plan());
      chain_.drop_front(planner_.plan().count);
      if (planner_.can_continue() && (!chain_.empty() || chain_.goes_on())) {
        open_window();
      } else {
        planner_.cancel();
      }
      return;
    case Progress::kRefused:
      refuse_chain(planner_.problem());
      planner_.cancel();
      unasked_stop_ = false;
      chain_.clear();
      joints_open_ = false;
      chain_on_conveyor_ = false;
      return;
  }
}

void Dispatcher::work_on_chain(RegisterBus& bus) noexcept {
  const std::int64_t before = planner_.inverses();
  planner_.work(kSlice);
  bus.charge(Work::kInverse, planner_.inverses() - before);
}

const CartesianMove* Dispatcher::next_of_chain() const noexcept {
  const WaitingMove* waiting = waiting_.front();
  if (waiting == nullptr || !waiting->follows) return nullptr;
  const auto* move = std::get_if<CartesianMove>(&waiting->move);
  return move != nullptr && (move->target.frame == kConveyorFrame) == chain_on_conveyor_ ? move : nullptr;
}

bool Dispatcher::extend_chain() noexcept {
  bool extended = false;
  while (true) {
    const CartesianMove* move = next_of_chain();
    if (move == nullptr || !chain_.accepts(*move, frames_, plane_)) break;
    chain_.add(*move, frames_, plane_);
    waiting_.drop_front();
    extended = true;
  }
  return extended;
}

void Dispatcher::refuse_chain(const PathProblem& problem) noexcept {
  for (std::size_t segment = 0; segment < chain_.requests().size(); ++segment) {
    const bool to_blame = segment == problem.segment;
    MoveRefused refusal = to_blame ? refusal_of(robot_, problem) : MoveRefused{.reason = Refusal::kChainRefused};
    refusal.tag = chain_.requests()[segment].tag;
    events_.on_event(refusal);
  }
  dropping_chain_ = chain_.blend_before_mm() > 0.0 && chain_.last_blend_mm() > 0.0;
}

Transform Dispatcher::planned_tool_pose() const noexcept {
  return arm_.forward(planned_end_) * config_.flange_T_tool;
}

}  // namespace armature
