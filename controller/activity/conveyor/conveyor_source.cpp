#include "controller/activity/conveyor/conveyor_source.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "controller/activity/plans/move_events.hpp"
#include "controller/base/timebase.hpp"
#include "controller/trajectory/state/axis_reach.hpp"

namespace armature {

ConveyorSource::ConveyorSource(const RobotModel& robot, const Arm& arm, const Transform& flange_T_tool,
                               const ConveyorConfig& config, BeltSensor& sensor, Channel& channel,
                               EventListener& events, BeltCorrection* correction) noexcept
    : robot_{robot},
      config_{config},
      sensor_{sensor},
      store_{channel.part_store},
      plan_store_{channel.plan_store},
      events_{events},
      belt_{config.mm_per_count, kTicksToEmit * kTickSeconds + config.lead_s,
            ConveyorBelt::bandwidths_for(config.camera)},
      observation_{config.camera},
      correction_{correction},
      motion_{robot, arm, config, flange_T_tool, 1.0},
      progress_{events} {}

void ConveyorSource::observe(Ticks tick) noexcept {
  const double correction_mm = this->correction_mm();
  sample_belt(tick);
  belt_.expect(tick, correction_mm);
  store_.belt_mm.store(belt_.now_mm(), std::memory_order_relaxed);
  store_.belt_mm_s.store(belt_.velocity_mm_s(), std::memory_order_relaxed);
  // After that, so that core 1 gets the same whether core 0 computes the network or not.
  if (correction_ != nullptr) correction_->request(observation_.values());
  const ConveyorRequest* late = phase_ == Phase::kOff ? store_.request.front() : nullptr;
  if (late != nullptr && !late->first) drop_next(Ticks{0}, Refusal::kPartLost);
}

// An encoder is read in each tick, a camera when it has a new sample.
void ConveyorSource::sample_belt(Ticks tick) noexcept {
  const BeltSensor::Sample sample = sensor_.latest();
  if (config_.camera && std::exchange(samples_, sample.number) == sample.number) return;
  belt_.measure(sample.counts, config_.camera ? tick - config_.camera->dead_time : tick);
  if (correction_ != nullptr) observation_.add(belt_);
}

// Without new samples nobody knows where the target is.
bool ConveyorSource::is_seen(Ticks tick) const noexcept {
  if (!config_.camera) return true;
  const Ticks longest = config_.camera->dead_time + Ticks{(1 + kMostMissed) * config_.camera->period.value()};
  return belt_.measured() && tick - *belt_.measured() <= longest;
}

double ConveyorSource::correction_mm() noexcept {
  if (correction_ == nullptr) return 0.0;
  const std::uint32_t used = correction_->counts().used;
  const double correction_mm = correction_->collect();
  if (!withholds_) return correction_mm;
  withheld_ += correction_->counts().used - used;
  return 0.0;
}

void ConveyorSource::begin(const Request&, const PerAxis<Radians>& stand, Ticks) noexcept {
  request_ = store_.request.front();
  progress_.begin();
  phase_ = Phase::kWaiting;
  part_mm_ = request_->part_mm;
  begin_mm_ = request_->begin_mm;
  synchronised_ = request_done_ = release_ = stop_ = withholds_ = false;
  withheld_ = 0;
  result_ = {.part = request_->part, .tag = tag_of(request_->plan, 0)};
  if (correction_ != nullptr) counts_at_begin_ = correction_->counts();
  set_point_ = {.position = stand};
}

bool ConveyorSource::over() noexcept {
  if (still_ticks_ < kTicksToEmit) return false;
  phase_ = Phase::kOff;
  still_ticks_ = 0;
  return true;
}

SetPoint& ConveyorSource::advance(Ticks tick, const RunControl::View&) noexcept {
  set_point_.wake = false;
  set_point_.inverses = 0;
  if (request_done_) end_request();
  accept_orders(tick);
  const AxisState part = part_ahead();
  result_.displacement_mm = belt_.now_mm() - part_mm_;
  if ((phase_ == Phase::kWaiting || phase_ == Phase::kFollowing) && !is_seen(tick)) end(PartEnd::kUnseen, tick);
  if (phase_ == Phase::kWaiting) {
    if (part.position > config_.to_mm) {
      end(PartEnd::kWindow, tick);
    } else if (part.position >= begin_mm_) {
      follow_part(tick, part.position);
    }
  }
  if (phase_ == Phase::kFollowing && request_ == nullptr) {
    if (const ConveyorRequest* next = store_.request.front()) {
      request_ = next;
      progress_.begin();
      if (const CartesianPlan* path = next->plan.only_path()) {
        motion_.start(*path, next->planned_mm);
      } else {
        motion_.start_dwell(duration(next->plan));
      }
    }
  }
  if (phase_ == Phase::kFollowing || phase_ == Phase::kLeaving) follow(tick, part);
  if (phase_ == Phase::kStopping) brake();
  const bool moves = phase_ == Phase::kFollowing || phase_ == Phase::kLeaving;
  set_point_.rate = moves ? 1.0 : 0.0;
  set_point_.state = phase_ == Phase::kStopping  ? MotionState::kStopping
                     : phase_ == Phase::kWaiting ? MotionState::kIdle
                                                 : MotionState::kMoving;
  return set_point_;
}

void ConveyorSource::accept_orders(Ticks tick) noexcept {
  const bool release = std::exchange(release_, false), stop = std::exchange(stop_, false);
  if (release && phase_ == Phase::kFollowing) {
    motion_.release();
    phase_ = Phase::kLeaving;
    report(PartPhase::kLeaving, tick);
  }
  if (stop && phase_ != Phase::kStopping) end(PartEnd::kStopped, tick);
}

void ConveyorSource::follow_part(Ticks tick, double displacement_mm) noexcept {
  phase_ = Phase::kFollowing;
  motion_.begin(set_point_.position, request_->planned_mm);
  motion_.start(*request_->plan.only_path(), request_->planned_mm);
  result_.displacement_mm = displacement_mm;
  report(PartPhase::kBegun, tick);
}

void ConveyorSource::follow(Ticks tick, const AxisState& part) noexcept {
  if (phase_ == Phase::kFollowing) {
    const bool inside = part.position >= config_.from_mm && part.position <= config_.to_mm;
    if (!inside) return end(PartEnd::kWindow, tick);
    if (std::fabs(part.velocity) > config_.max_speed_mm_s) return end(PartEnd::kTooFast, tick);
  }
  const ConveyorMotion::Trouble trouble = motion_.advance(part);
  set_point_.inverses = 1;
  if (trouble.any) return end(PartEnd::kCannotFollow, tick, trouble.axis);
  set_point_.position = motion_.position();
  if (phase_ == Phase::kLeaving) {
    if (motion_.frame_at_rest()) end(PartEnd::kReleased, tick);
    return;
  }
  report_progress(tick);
  if (synchronised_) {
    result_.deviation_mm = std::max(result_.deviation_mm, std::fabs(motion_.deviation_mm()));
    if (config_.policy && std::fabs(motion_.deviation_mm()) > kMostDeviation_mm + config_.policy->full_mm) {
      withholds_ = true;
    }
  } else if (motion_.synchronised()) {
    synchronised_ = true;
    report(PartPhase::kSynchronised, tick);
  }
  request_done_ = request_ != nullptr && motion_.path_done() && synchronised_;
}

// The path in the event of a start is that on the part, not the one that was planned.
void ConveyorSource::report_progress(Ticks tick) noexcept {
  if (request_ == nullptr) return;
  const auto elapsed = static_cast<double>(motion_.elapsed().value());
  progress_.advance(request_->plan, elapsed, motion_.path_done(), tick, [this](MoveStarted& event) {
    const Eigen::Vector3d shift = request_->planned_mm * config_.direction;
    event.on_conveyor = request_->plan.only_path() != nullptr;
    event.path.start_mm -= shift;
    event.path.end_mm -= shift;
    event.path.center_mm -= shift;
  });
}

void ConveyorSource::end_request() noexcept {
  request_done_ = false;
  plan_store_.release(request_->plan.stores());
  request_ = nullptr;
  store_.request.drop_front();
  store_.over.fetch_add(1, std::memory_order_release);
  set_point_.wake = true;
}

void ConveyorSource::end(PartEnd end, Ticks tick, std::uint8_t axis) noexcept {
  const bool moves = phase_ == Phase::kFollowing || phase_ == Phase::kLeaving;
  result_.end = end;
  result_.axis = axis;
  phase_ = Phase::kStopping;
  if (request_ != nullptr) {
    if (request_done_) {
      end_request();
    } else {
      drop_request(tick, end == PartEnd::kStopped ? Refusal::kNotReady : Refusal::kPartLost);
    }
  }
  count_corrections();
  report(PartPhase::kEnded, tick);
  const PerAxis<AxisState> state = motion_.state();
  for (std::size_t i = 0; i < robot_.axis_count; ++i) {
    const TimeLawLimits limits{.speed = std::fabs(state[i].velocity) + 1.0, .accel = robot_.axes[i].max_accel_rad_s2};
    const bool rests = !moves || end == PartEnd::kReleased;
    stops_[i] = rests ? PhaseLaw{{.position = set_point_.position[i].value()}}
                      : plan_to_velocity(ProfileKind::kTrapezoid, state[i], 0.0, limits);
  }
  braked_ticks_ = 0;
  still_ticks_ = 0;
}

void ConveyorSource::count_corrections() noexcept {
  if (correction_ == nullptr) return;
  const PolicyGuard::Counts &now = correction_->counts(), &then = counts_at_begin_;
  result_.corrected = now.used - then.used - withheld_;
  result_.out_of_range = now.out_of_range - then.out_of_range;
  result_.no_result = now.late + now.invalid + withheld_ - then.late - then.invalid;
}

void ConveyorSource::drop_request(Ticks tick, Refusal reason) noexcept {
  progress_.drop(request_->plan, tick, reason);
  end_request();
}

// The one in the store has not begun.
void ConveyorSource::drop_next(Ticks tick, Refusal reason) noexcept {
  request_ = store_.request.front();
  progress_.begin();
  drop_request(tick, reason);
}

void ConveyorSource::brake() noexcept {
  const double t_s = seconds(Ticks{++braked_ticks_});
  bool moves = false;
  for (std::size_t i = 0; i < robot_.axis_count; ++i) {
    set_point_.position[i] = Radians{stops_[i].at(t_s).position};
    moves = moves || t_s < stops_[i].duration_s();
  }
  still_ticks_ = moves ? 0 : still_ticks_ + 1;
}

void ConveyorSource::report(PartPhase phase, Ticks tick) noexcept {
  result_.phase = phase;
  result_.tick = tick;
  events_.on_event(result_);
}

void ConveyorSource::reset_to(const PerAxis<Radians>& position) noexcept {
  set_point_.position = position;
  phase_ = Phase::kOff;
  still_ticks_ = 0;
}

void ConveyorSource::cut_short(Ticks tick) noexcept {
  if (phase_ == Phase::kOff) return;
  const bool ended = phase_ == Phase::kStopping;
  phase_ = Phase::kOff;
  if (request_ != nullptr) drop_request(tick, Refusal::kNotReady);
  result_.end = PartEnd::kFault;
  count_corrections();
  if (!ended) report(PartPhase::kEnded, tick);
}

void ConveyorSource::cancel(Ticks tick) noexcept {
  if (store_.request.front() != nullptr) drop_next(tick, Refusal::kNotReady);
  phase_ = Phase::kOff;
}

AxisState ConveyorSource::part_ahead() const noexcept {
  AxisState part = belt_.expected();
  part.position -= part_mm_;
  return part;
}

}  // namespace armature
