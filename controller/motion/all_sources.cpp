#include "controller/motion/all_sources.hpp"

#include <optional>

namespace armature {

AllSources::AllSources(const RobotModel& robot, const Arm& arm, const Transform& flange_T_tool, MotionMailbox& mailbox,
                       EventListener& events, LogicPort& logic, const ConveyorConfig* conveyor,
                       BeltEncoder* encoder) noexcept
    : mailbox_{mailbox},
      events_{events},
      others_{robot, arm, flange_T_tool, mailbox, events},
      stream_{robot},
      homing_{robot, logic, events} {
  last_ = &others_.last();
  if (conveyor != nullptr && encoder != nullptr) {
    conveyor_.emplace(robot, arm, flange_T_tool, *conveyor, *encoder, mailbox, events);
  }
}

const SetPoint& AllSources::advance(Ticks tick) noexcept {
  if (conveyor_) {
    conveyor_->sample(tick);
    following_ = conveyor_->follows(last_->position);
    if (following_) return follow_part(tick);
  }
  read_homing();
  if (!homing_.over()) return home(tick);
  read_stream(tick);
  if (!streaming_) {
    last_ = &others_.advance(tick);
    return *last_;
  }
  last_ = &set_point_;
  set_point_ = stream_.advance(tick);
  set_point_.wake = set_point_.wake || mailbox_.wake_each_tick.load(std::memory_order_relaxed);
  if (!stream_.over()) return set_point_;
  streaming_ = false;
  others_.reset_to(set_point_.position);
  events_.on_event(stream_.result());
  set_point_.stopped = true;
  return set_point_;
}

const SetPoint& AllSources::follow_part(Ticks tick) noexcept {
  last_ = &set_point_;
  set_point_ = conveyor_->advance(tick);
  set_point_.wake = set_point_.wake || mailbox_.wake_each_tick.load(std::memory_order_relaxed);
  if (!conveyor_->over()) return set_point_;
  following_ = false;
  others_.reset_to(set_point_.position);
  set_point_.stopped = true;
  return set_point_;
}

// A stop that comes when homing is over has no effect.
void AllSources::read_homing() noexcept {
  while (const std::optional<HomingRequest> request = mailbox_.homings.try_pop()) {
    if (request->axes != 0) {
      homing_.begin(*request, last_->position);
    } else if (!homing_.over()) {
      homing_.stop();
    }
  }
}

const SetPoint& AllSources::home(Ticks tick) noexcept {
  last_ = &set_point_;
  set_point_ = homing_.advance(tick);
  set_point_.wake = set_point_.wake || mailbox_.wake_each_tick.load(std::memory_order_relaxed);
  if (!homing_.over()) return set_point_;
  others_.reset_to(set_point_.position);
  set_point_.stopped = true;
  return set_point_;
}

// Set-points of a stream that is over have no effect.
void AllSources::read_stream(Ticks tick) noexcept {
  while (const std::optional<StreamSample> sample = mailbox_.stream.try_pop()) {
    if (streaming_) {
      stream_.accept(*sample);
    } else if (sample->kind == StreamSample::Kind::kFirst) {
      stream_.begin(*sample, last_->position, tick);
      streaming_ = true;
    }
  }
}

void AllSources::reset_to(const PerAxis<Radians>& position) noexcept {
  others_.reset_to(position);
  if (conveyor_) conveyor_->reset_to(position);
  streaming_ = following_ = false;
  last_ = &others_.last();
}

void AllSources::cut_short(Ticks tick) noexcept {
  if (!homing_.over()) {
    homing_.cut_short(tick);
    return reset_to(set_point_.position);
  }
  if (following_) {
    conveyor_->cut_short(tick);
    return reset_to(set_point_.position);
  }
  if (!streaming_) return others_.cut_short(tick);
  stream_.cut_short(tick);
  events_.on_event(stream_.result());
  reset_to(set_point_.position);
}

void AllSources::cancel(Ticks tick) noexcept {
  while (mailbox_.stream.try_pop()) {
  }
  while (mailbox_.homings.try_pop()) {
  }
  if (conveyor_) conveyor_->cancel(tick);
  others_.cancel(tick);
  last_ = &others_.last();
}

Stopping AllSources::stopping() const noexcept {
  if (following_) return conveyor_->stopping();
  if (!homing_.over()) return homing_.stopping();
  return streaming_ ? stream_.stopping() : others_.stopping();
}

}  // namespace armature
