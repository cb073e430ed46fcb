#include "controller/activity/plans/stages/path_stage.hpp"

#include <algorithm>

#include "controller/activity/move_checks.hpp"
#include "controller/trajectory/plan/path_reach.hpp"

namespace armature {

PathStage::PathStage(const RobotModel& robot, const Arm& arm, const PlanningConfig& config, const UserFrames& frames,
                     ArmOwner& owner, MoveQueue& queue, EventListener& events) noexcept
    : robot_{robot},
      arm_{arm},
      config_{config},
      frames_{frames},
      owner_{owner},
      queue_{queue},
      events_{events},
      plane_{robot.arm, config.flange_T_tool},
      planner_{robot, arm, config.flange_T_tool, config.max_stretch} {}

Transform PathStage::tool_at_end() const noexcept {
  return arm_.forward(owner_.end()) * config_.flange_T_tool;
}

Transform PathStage::resolve(const FramedPose& pose) const noexcept {
  return armature::resolve(pose, frames_, tool_at_end(), plane_, false);
}

void PathStage::begin(const CartesianMove& move, bool on_part, RegisterBus& bus) noexcept {
  requests_.restart(tool_at_end());
  take(move);
  on_part_ = on_part;
  bus.charge(Work::kPlan);
}

const CartesianMove* PathStage::next() const noexcept {
  const auto* move = queue_.next_if<CartesianMove>();
  return move != nullptr && (move->target.frame == kConveyorFrame) == on_part_ ? move : nullptr;
}

void PathStage::take(const CartesianMove& move) noexcept {
  requests_.add(move, frames_, plane_);
  queue_.drop_front();
}

bool PathStage::start_planning(RegisterBus& bus) noexcept {
  bool extended = false;
  for (const CartesianMove* move = next(); move != nullptr && requests_.accepts(*move, frames_, plane_);
       move = next()) {
    take(*move);
    extended = true;
  }
  if (!extended && planner_.progress() != Progress::kIdle) return false;
  // The others of a long chain continue this plan.
  const std::size_t most = CartesianPlan::kMaxFirstSegments;
  const auto first = requests_.requests().first(std::min(requests_.count_with_outputs(TimedOutputs::kMax), most));
  start_clock(bus);
  planner_.begin(owner_.end(), first, unasked_stop_);
  bus.charge(Work::kInverse, static_cast<std::int64_t>(IkSolutions::kMax * points_of(first)));
  return true;
}

void PathStage::work(RegisterBus& bus) noexcept {
  const std::int64_t before = planner_.inverses();
  planner_.work(kSlice);
  bus.charge(Work::kInverse, planner_.inverses() - before);
}

void PathStage::measure(std::size_t added, RegisterBus& bus) noexcept {
  const auto cycles = static_cast<double>((bus.now() - began_).value());
  cost_.measure(cycles / static_cast<double>(kTickCycles.value()), planner_, added);
}

void PathStage::refuse(const PathProblem& problem) noexcept {
  for (std::size_t segment = 0; segment < requests_.requests().size(); ++segment) {
    const bool to_blame = segment == problem.segment;
    MoveRefused refusal = to_blame ? refusal_of(robot_, problem) : MoveRefused{.reason = Refusal::kChainRefused};
    refusal.tag = requests_.requests()[segment].tag;
    events_.on_event(refusal);
  }
  dropping_rest_ = requests_.blend_before_mm() > 0.0 && requests_.last_blend_mm() > 0.0;
}

void PathStage::drop_rest() noexcept {
  while (dropping_rest_) {
    const CartesianMove* move = next();
    if (move == nullptr) {
      dropping_rest_ = queue_.empty() && queue_.more_wait();
      return;
    }
    dropping_rest_ = move->blend_mm > 0.0;
    queue_.refuse_front(Refusal::kChainRefused);
  }
}

void PathStage::drop(Refusal why, std::size_t sent) noexcept {
  for (const SegmentRequest& request : requests_.requests().subspan(sent)) {
    events_.on_event(MoveRefused{.reason = why, .tag = request.tag});
  }
}

void PathStage::cancel() noexcept {
  planner_.cancel();
  unasked_stop_ = false;
}

void PathStage::clear() noexcept {
  requests_.clear();
  on_part_ = false;
}

}  // namespace armature
