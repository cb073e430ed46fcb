#include "controller/activity/conveyor/part_planning.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "controller/activity/conveyor/conveyor_belt.hpp"
#include "controller/base/timebase.hpp"

namespace armature {
namespace {

// The time that planning may take before the path begins. A path that is late begins when it is ready, and the frame
// catches up with the part.
constexpr double kFirstAhead_s = 0.3;
constexpr double kNextAhead_s = 0.05;
// A plan is checked for this time after its end, if the frame has not reached the part before.
constexpr double kCatchUp_s = 2.0;
// A target that a camera sees as slow as this may rest, or come back: the path begins where it is.
constexpr double kRestSpeed = 20.0;  // mm/s
// The least change of the speed of the belt that a plan is checked for.
constexpr double kLeastSpeedTolerance = 1.0;  // mm/s
constexpr int kPasses = 2;

double slower(double speed, double change) noexcept {
  return std::copysign(std::max(0.0, std::fabs(speed) - change), speed);
}

}  // namespace

PartPlanning::PartPlanning(const RobotModel& robot, const Arm& arm, const PlanningConfig& config, PlanOutbox& outbox,
                           PartStore& store) noexcept
    : arm_{arm},
      conveyor_{config.conveyor.value_or(ConveyorConfig{})},
      outbox_{outbox},
      store_{store},
      motion_{robot, arm, conveyor_, config.flange_T_tool, kLimitShare} {}

void PartPlanning::add(const ConveyorPart& part) noexcept {
  if (parts_.full()) parts_.drop_front();
  [[maybe_unused]] const bool pushed = parts_.try_push(
      {.at_mm = ConveyorBelt::position_of(part.counts, conveyor_.mm_per_count), .number = parts_seen_++});
  assert(pushed);
}

PartPlanning::Ready PartPlanning::prepare_first() noexcept {
  approaching_ = false;
  speed_mm_s_ = belt_mm_s();
  while (const Part* part = parts_.front()) {
    rests_ = conveyor_.camera && std::fabs(speed_mm_s_) < kRestSpeed;
    const double now_mm = belt_mm() - part->at_mm, begin_mm = rests_ ? now_mm : now_mm + speed_mm_s_ * kFirstAhead_s;
    if (begin_mm > conveyor_.to_mm) {
      missed_ = PartFollowed{.phase = PartPhase::kMissed, .part = part->number, .displacement_mm = now_mm};
      parts_.drop_front();
      return Ready::kNotYet;
    }
    if (begin_mm < conveyor_.from_mm) {
      approaching_ = true;
      return Ready::kNotYet;
    }
    if (std::fabs(speed_mm_s_) > conveyor_.max_speed_mm_s) return Ready::kTooFast;
    part_ = *part;
    first_ = true;
    tries_ = 0;
    begin_mm_ = begin_mm;
    // While the frame takes up its velocity, the part comes nearer by this distance.
    planned_mm_ = begin_mm + stop_distance_mm(speed_mm_s_);
    return Ready::kNow;
  }
  return Ready::kNotYet;
}

PartPlanning::Ready PartPlanning::prepare_next(PerAxis<Radians>& joints) noexcept {
  speed_mm_s_ = belt_mm_s();
  first_ = false;
  tries_ = 0;
  const double next_mm = belt_mm() - part_.at_mm + speed_mm_s_ * kNextAhead_s;
  Transform pose = arm_.forward(joints);
  pose.position_mm += (next_mm - planned_mm_) * conveyor_.direction;
  const IkTracking found = arm_.soonest(pose, joints);
  inverses_ += static_cast<std::int64_t>(IkSolutions::kMax);
  if (!solved(found.status)) return Ready::kUnreachable;
  joints = found.joints;
  begin_mm_ = planned_mm_ = next_mm;
  return Ready::kNow;
}

std::optional<PartFollowed> PartPlanning::pop_missed() noexcept {
  return std::exchange(missed_, std::nullopt);
}

PartPlanning::Verdict PartPlanning::check(const CartesianPlan& plan, std::int64_t ticks) noexcept {
  if (!check_begun_) {
    pass_ = 0;
    begin_pass(plan);
    check_begun_ = true;
  }
  const auto most = plan.duration.value() + static_cast<std::int64_t>(kCatchUp_s / kTickSeconds);
  for (; ticks > 0; --ticks) {
    ++checked_ticks_;
    assumed_.position += assumed_.velocity * kTickSeconds;
    const double end_mm = assumed_.position + stop_distance_mm(assumed_.velocity);
    if (end_mm > conveyor_.to_mm || end_mm < conveyor_.from_mm) {
      if (!conveyor_.camera) {
        restart_check();
        return Verdict::kLeavesWindow;
      }
      assumed_.velocity = slower(assumed_.velocity, conveyor_.accel_mm_s2 * kTickSeconds);
    }
    const ConveyorMotion::Trouble trouble = motion_.advance(assumed_);
    ++inverses_;
    if (trouble.any || checked_ticks_ > most) {
      axis_ = trouble.axis;
      restart_check();
      return ++tries_ < kTries && !motion_.path_done() ? Verdict::kSlower : Verdict::kTooFast;
    }
    if (!motion_.path_done() || !motion_.synchronised()) continue;
    if (++pass_ == kPasses) return Verdict::kGood;
    begin_pass(plan);
  }
  return Verdict::kWorking;
}

void PartPlanning::begin_pass(const CartesianPlan& plan) noexcept {
  checked_ticks_ = 0;
  assumed_ = {.position = begin_mm_, .velocity = assumed_mm_s()};
  if (first_) {
    motion_.begin(plan.start, planned_mm_);
  } else {
    motion_.begin_moving(plan.start, {.position = planned_mm_, .velocity = assumed_.velocity});
  }
  motion_.start(plan, planned_mm_);
}

PathLimits PartPlanning::slower_limits(const CartesianPlan& plan) noexcept {
  double step_mm = 0.0, change_mm = 0.0;
  Eigen::Vector3d before = tool_pose(plan, 0.0).position_mm, last_step = Eigen::Vector3d::Zero();
  for (std::int64_t tick = 1; tick <= plan.duration.value(); ++tick) {
    const Eigen::Vector3d position = tool_pose(plan, seconds(Ticks{tick})).position_mm, step = position - before;
    step_mm = std::max(step_mm, step.norm());
    change_mm = std::max(change_mm, (step - last_step).norm());
    before = position;
    last_step = step;
  }
  PathLimits limits;
  limits.speed_mm_s = step_mm / kTickSeconds / kSlower;
  limits.accel_mm_s2 = change_mm / (kTickSeconds * kTickSeconds) / (kSlower * kSlower);
  return limits;
}

// Of the belt, at the begin of this pass.
double PartPlanning::assumed_mm_s() const noexcept {
  const double change = std::max(conveyor_.speed_tolerance * std::fabs(speed_mm_s_), kLeastSpeedTolerance);
  return pass_ == 0 ? speed_mm_s_ - change : speed_mm_s_ + change;
}

bool PartPlanning::send(const CartesianPlan& plan) noexcept {
  if (first_) parts_.drop_front();
  assert(plan.count <= CartesianPlan::kMaxFirstSegments);
  ConveyorRequest& request = next_request();
  request.plan = outbox_.store(plan);
  request.planned_mm = planned_mm_;
  request.first = first_;
  request.part_mm = part_.at_mm;
  request.begin_mm = rests_ ? conveyor_.from_mm : begin_mm_;
  request.part = part_.number;
  send_request();
  return first_;
}

ConveyorRequest& PartPlanning::next_request() noexcept {
  assert(!store_.request.full());  // the request before is over
  return store_.request.free_slot();
}

void PartPlanning::send_request() noexcept {
  store_.request.push_slot();
  ++sent_;
}

void PartPlanning::send_dwell(const JointPlan& dwell) noexcept {
  ConveyorRequest& request = next_request();
  request.plan = outbox_.store(dwell);
  request.first = false;
  send_request();
}

bool PartPlanning::done() const noexcept {
  return store_.over.load(std::memory_order_acquire) == sent_;
}

void PartPlanning::ended() noexcept {
  approaching_ = false;
}

std::int64_t PartPlanning::take_inverses() noexcept {
  return std::exchange(inverses_, 0);
}

Transform PartPlanning::at(double displacement_mm) const noexcept {
  Transform frame = conveyor_.base_T_part;
  frame.position_mm += displacement_mm * conveyor_.direction;
  return frame;
}

double PartPlanning::belt_mm() const noexcept {
  return store_.belt_mm.load(std::memory_order_relaxed);
}

double PartPlanning::belt_mm_s() const noexcept {
  return store_.belt_mm_s.load(std::memory_order_relaxed);
}

// With the acceleration of the frame, in the direction of the speed.
double PartPlanning::stop_distance_mm(double speed_mm_s) const noexcept {
  return 0.5 * speed_mm_s * std::fabs(speed_mm_s) / conveyor_.accel_mm_s2;
}

}  // namespace armature
