#include "controller/activity/plans/stages/joint_stage.hpp"

#include <algorithm>
#include <cstddef>

#include "controller/trajectory/joint/joint_retarget.hpp"
#include "controller/trajectory/plan/output_places.hpp"

namespace armature {

bool JointStage::has_outputs() const noexcept {
  return std::any_of(outputs_.begin(), outputs_.begin() + static_cast<std::ptrdiff_t>(chain_.count),
                     [](const PathOutputs& outputs) { return outputs.count > 0; });
}

void JointStage::send_alone(const JointMove& move, RegisterBus& bus, double residual_rad) noexcept {
  JointPlan plan = plan_joint_move(context_.robot, context_.owner.end(), move.target, move.speed, context_.config.sync,
                                   move.profile, move.accel);
  plan.tag = move.tag;
  plan.residual_rad = residual_rad;
  bus.charge(Work::kPlan);
  const auto refuse_it = [&](Refusal why) { context_.events.on_event(refused(why, plan.tag)); };
  if (plan.duration > kLongestMove) return refuse_it(Refusal::kInvalidTarget);
  if (!place_outputs(plan, move.outputs)) return refuse_it(Refusal::kOutputOutside);
  context_.owner.set_end(plan.target);
  outbox_.send(plan);
}

bool JointStage::plan(const JointMove& move, RegisterBus& bus) noexcept {
  const JointRequest request{.target = move.target, .speed = move.speed, .accel = move.accel, .kind = move.profile};
  const PerAxis<Radians>& from = context_.owner.end();
  bool planned = true;
  if (empty()) {
    start_ = from;
    const auto rest = [&](std::size_t axis) { return AxisState{.position = from[axis].value()}; };
    chain_ =
        plan_retarget(context_.robot, make_per_axis(rest), request.target, request.speed, request.kind, request.accel);
    if (chain_.duration > kLongestMove) {
      clear();
      planned = false;
    }
    bus.charge(Work::kPlan);
  } else {
    const double ways_rad = std::min(largest_difference(via_, from), largest_difference(from, move.target));
    blend_rad_ = std::max(last_.blend.rad, 0.5 * last_.blend.share * ways_rad);
    const int trials = append(chain_, context_.robot, request, blend_rad_);
    planned = trials > 0;
    bus.charge(Work::kCorner, std::max(trials, 1));
  }
  return planned;
}

void JointStage::begin(const Departure& departure) noexcept {
  start_ = context_.owner.end();
  chain_ = departure.plan;
  chain_.passed = departure.passed;
}

void JointStage::add(const JointMove& move, double residual_rad, bool open) noexcept {
  outputs_[chain_.count - 1] = move.outputs;
  chain_.moves[chain_.count - 1].tag = move.tag;
  chain_.moves[chain_.count - 1].residual_rad = residual_rad;
  via_ = context_.owner.end();
  context_.owner.set_end(move.target);
  last_ = move;
  open_ = open;
}

void JointStage::send() noexcept {
  if (chain_.count == 1) {
    JointPlan only = only_move();
    if (place_outputs(only, outputs_[0])) {
      outbox_.send(only);
    } else {
      refuse(0);
    }
  } else if (const std::optional<std::size_t> outside = place_outputs(chain_, outputs_)) {
    refuse(*outside);
  } else {
    outbox_.send(chain_);
  }
  clear();
}

// Without a corner it is an ordinary move.
JointPlan JointStage::only_move() const noexcept {
  const RetargetPlan& only = chain_.moves[0];
  JointPlan plan = plan_joint_move(context_.robot, start_, only.target, last_.speed, context_.config.sync,
                                   last_.profile, last_.accel);
  plan.tag = only.tag;
  plan.residual_rad = only.residual_rad;
  return plan;
}

// An output of move `to_blame` is outside of the chain.
void JointStage::refuse(std::size_t to_blame) noexcept {
  for (std::size_t i = 0; i < chain_.count; ++i) {
    const Refusal why = i == to_blame ? Refusal::kOutputOutside : Refusal::kChainRefused;
    context_.events.on_event(refused(why, chain_.moves[i].tag));
  }
  context_.owner.set_end(start_);
}

void JointStage::drop(Refusal why) noexcept {
  for (std::size_t i = 0; i < chain_.count; ++i) {
    context_.events.on_event(refused(why, chain_.moves[i].tag));
  }
  clear();
}

}  // namespace armature
