#include "controller/activity/plans/stages/path_stage.hpp"

#include <algorithm>

#include "controller/activity/move_checks.hpp"
#include "controller/trajectory/plan/path_reach.hpp"

namespace armature {

PathStage::PathStage(const ActivityContext& context) noexcept
    : context_{context},
      plane_{context.robot.arm, context.config.flange_T_tool},
      planner_{context.robot, context.arm, context.config.flange_T_tool, context.config.max_stretch} {}

Transform PathStage::tool_at_end() const noexcept {
  return context_.arm.forward(context_.owner.end()) * context_.config.flange_T_tool;
}

Transform PathStage::resolve(const FramedPose& pose) const noexcept {
  return armature::resolve(pose, context_.frames, tool_at_end(), plane_, false);
}

void PathStage::begin(const CartesianMove& move, bool on_part, RegisterBus& bus) noexcept {
  requests_.restart(tool_at_end());
  take(move);
  on_part_ = on_part;
  bus.charge(Work::kPlan);
}

const CartesianMove* PathStage::next() const noexcept {
  const auto* move = context_.queue.next_if<CartesianMove>();
  return move != nullptr && (move->target.frame == kConveyorFrame) == on_part_ ? move : nullptr;
}

void PathStage::take(const CartesianMove& move) noexcept {
  requests_.add(move, context_.frames, plane_);
  context_.queue.drop_front();
}

bool PathStage::start_planning(RegisterBus& bus) noexcept {
  bool extended = false;
  for (const CartesianMove* move = next(); move != nullptr && requests_.accepts(*move, context_.frames, plane_);
       move = next()) {
    take(*move);
    extended = true;
  }
  if (!extended && planner_.progress() != Progress::kIdle) return false;
  // The others of a long chain continue this plan.
  const std::size_t most = CartesianPlan::kMaxFirstSegments;
  const auto first = requests_.requests().first(std::min(requests_.count_with_outputs(TimedOutputs::kMax), most));
  start_clock(bus);
  planner_.begin(context_.owner.end(), first, unasked_stop_);
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
    MoveRefused refusal = to_blame ? refusal_of(context_.robot, problem) : refused(Refusal::kChainRefused);
    refusal.tag = requests_.requests()[segment].tag;
    context_.events.on_event(refusal);
  }
  dropping_rest_ = requests_.blend_before_mm() > 0.0 && requests_.last_blend_mm() > 0.0;
}

void PathStage::drop_rest() noexcept {
  while (dropping_rest_) {
    const CartesianMove* move = next();
    if (move == nullptr) {
      dropping_rest_ = context_.queue.empty() && context_.queue.more_wait();
      return;
    }
    dropping_rest_ = move->blend_mm > 0.0;
    context_.queue.refuse_front(Refusal::kChainRefused);
  }
}

void PathStage::drop(Refusal why, std::size_t sent) noexcept {
  for (const SegmentRequest& request : requests_.requests().subspan(sent)) {
    context_.events.on_event(refused(why, request.tag));
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
