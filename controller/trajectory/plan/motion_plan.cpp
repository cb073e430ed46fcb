#include "controller/trajectory/plan/motion_plan.hpp"

#include <algorithm>
#include <cassert>

namespace armature {
namespace {

MoveSpan span_of(const JointChain& chain, std::size_t move) {
  return {.start = chain.starts[move], .end = chain.end_of(move)};
}

MoveSpan span_of(const CartesianPlan& path, std::size_t segment) {
  return {.start = path.segments[segment].start, .end = end_of(path.segments[segment])};
}

}  // namespace

MotionPlan& MotionPlan::operator=(const MotionPlan& other) noexcept {
  if (this == &other) return *this;
  kind_ = other.kind_;
  if (kind_ == Kind::kJoint) joint_ = other.joint_;
  if (kind_ == Kind::kJointChain) chain_ = other.chain_;
  if (kind_ == Kind::kPath) path_ = other.path_;
  if (kind_ != Kind::kJoined) return *this;
  parts_ = other.parts_;
  part_count_ = other.part_count_;
  next_ = other.next_;
  if (part_count_ > 1 || (part_count_ == 1 && parts_[0].is_path)) path_ = other.path_;
  if (part_count_ > 1 || (part_count_ == 1 && !parts_[0].is_path)) chain_ = other.chain_;
  return *this;
}

void MotionPlan::begin_joined() noexcept {
  kind_ = Kind::kJoined;
  part_count_ = 0;
  next_ = nullptr;
}

MotionPlan::Part MotionPlan::part(std::size_t index) const noexcept {
  const StoredPart& stored = parts_[index];
  Part part{.start = stored.start, .from = stored.from, .until = stored.until, .in_motion = stored.in_motion};
  const bool is_own = index + 1 < kMaxParts;
  if (stored.is_path) {
    part.path = is_own ? &path_ : next_->path();
  } else {
    part.chain = is_own ? &chain_ : next_->joint_chain();
  }
  return part;
}

MotionPlan::Part MotionPlan::part_at(double ticks) const noexcept {
  std::size_t index = part_count_ - 1;
  while (index > 0 && static_cast<double>(parts_[index].start.value()) > ticks) --index;
  return part(index);
}

void MotionPlan::add(const StoredPart& part) noexcept {
  assert(part_count_ == 0 || part.is_path != parts_[part_count_ - 1].is_path);
  StoredPart& added = parts_[part_count_] = part;
  if (part_count_ > 0) added.start = this->part(part_count_ - 1).end();
  ++part_count_;
}

void MotionPlan::add(const JointChain& chain, Ticks from, bool in_motion) noexcept {
  assert(part_count_ + 1 < kMaxParts);
  chain_ = chain;
  add(StoredPart{.is_path = false, .in_motion = in_motion, .from = from, .until = chain.duration});
}

void MotionPlan::add(const CartesianPlan& path, Ticks from, bool in_motion) noexcept {
  assert(part_count_ + 1 < kMaxParts);
  path_ = path;
  add(StoredPart{.is_path = true, .in_motion = in_motion, .from = from, .until = path.duration});
}

void MotionPlan::add_next_of_queue(const MotionPlan& plan, Ticks from, bool in_motion) noexcept {
  assert(part_count_ + 1 == kMaxParts);
  next_ = &plan;
  add(StoredPart{.is_path = plan.path() != nullptr, .in_motion = in_motion, .from = from, .until = duration(plan)});
}

Ticks duration(const MotionPlan& plan) noexcept {
  if (const JointPlan* joint = plan.joint()) return joint->duration;
  if (const JointChain* chain = plan.joint_chain()) return chain->duration;
  if (const CartesianPlan* path = plan.path()) return path->duration;
  return plan.parts() > 0 ? plan.part(plan.parts() - 1).end() : Ticks{};
}

const PerAxis<Radians>& target_of(const MotionPlan& plan) noexcept {
  if (const JointPlan* joint = plan.joint()) return joint->target;
  if (const JointChain* chain = plan.joint_chain()) return chain->target;
  if (const CartesianPlan* path = plan.path()) return path->target;
  const MotionPlan::Part last = plan.part(plan.parts() - 1);
  return last.path != nullptr ? last.path->target : last.chain->target;
}

std::span<const TimedOutput> outputs_of(const MotionPlan& plan) noexcept {
  if (const JointPlan* joint = plan.joint()) return joint->outputs.view();
  if (const JointChain* chain = plan.joint_chain()) return chain->outputs.view();
  if (const CartesianPlan* path = plan.path()) return path->outputs.view();
  return {};
}

std::size_t moves_in(const MotionPlan& plan) noexcept {
  if (const CartesianPlan* path = plan.path()) return path->count;
  if (const JointChain* chain = plan.joint_chain()) return chain->count;
  if (!plan.is_joined()) return 1;
  std::size_t moves = 0;
  for (std::size_t i = 0; i < plan.parts(); ++i) moves += plan.part(i).moves();
  return moves;
}

PartMove part_move(const MotionPlan& plan, std::size_t move) noexcept {
  std::size_t index = 0;
  while (index + 1 < plan.parts() && move >= plan.part(index).moves()) move -= plan.part(index++).moves();
  return {.part = plan.part(index), .move = move};
}

MoveSpan span_of(const MotionPlan& plan, std::size_t move) noexcept {
  if (const JointPlan* joint = plan.joint()) return {.end = joint->duration};
  if (const JointChain* chain = plan.joint_chain()) return span_of(*chain, move);
  if (const CartesianPlan* path = plan.path()) return span_of(*path, move);
  const auto [part, own] = part_move(plan, move);
  const MoveSpan span = part.path != nullptr ? span_of(*part.path, own) : span_of(*part.chain, own);
  const auto in_plan = [&part = part](Ticks ticks) {
    return part.start + (std::clamp(ticks, part.from, part.until) - part.from);
  };
  return {.start = in_plan(span.start), .end = in_plan(span.end)};
}

}  // namespace armature
