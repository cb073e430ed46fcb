#include "controller/motion/plans_or_jog.hpp"

namespace armature {

PlansOrJog::PlansOrJog(const RobotModel& robot, const Arm& arm, const Transform& flange_T_tool, MotionMailbox& mailbox,
                       EventListener& events) noexcept
    : mailbox_{mailbox},
      events_{events},
      input_{mailbox},
      plans_{robot, arm, mailbox, events},
      velocity_{robot, arm, input_, {.time_out = Ticks{1}, .flange_T_tool = flange_T_tool}} {
  last_ = &plans_.last();
}

const SetPoint& PlansOrJog::advance(Ticks tick) noexcept {
  if (!jogging_ && !mailbox_.jogs.empty()) begin_jog(tick);
  if (!jogging_) return plans_.advance(tick);
  jog(tick);
  return set_point_;
}

// A command that only ends a jog can come after its end; it is answered without events.
void PlansOrJog::begin_jog(Ticks tick) noexcept {
  velocity_.reset_to(plans_.last().position);
  jogging_ = true;
  last_ = &set_point_;
  still_ticks_ = 0;
  const VelocityCommand& first = *mailbox_.jogs.front();
  if (first.kind >= VelocityCommand::Kind::kHalt) return;
  commands_before_ = mailbox_.jogs_accepted;
  last_step_ = tick;
  started_ = JogStarted{.tag = first.tag, .tick = tick};
  events_.on_event(*started_);
}

void PlansOrJog::jog(Ticks tick) noexcept {
  const std::uint32_t before = mailbox_.jogs_accepted;
  set_point_ = velocity_.advance(tick);
  set_point_.stopped = false;
  set_point_.wake = set_point_.wake || mailbox_.wake_each_tick.load(std::memory_order_relaxed);
  if (set_point_.state != MotionState::kIdle) last_step_ = tick;
  const bool still = velocity_.done() && mailbox_.jogs_accepted == before;
  still_ticks_ = still ? still_ticks_ + 1 : 0;
  if (still_ticks_ < kTicksToEmit) return;
  report_end(velocity_.ending(), last_step_);
  plans_.reset_to(set_point_.position);
  jogging_ = false;
  last_ = &plans_.last();
  set_point_.stopped = true;
}

void PlansOrJog::report_end(VelocitySource::Ending ending, Ticks last) noexcept {
  if (!started_) return;
  const std::uint32_t commands = mailbox_.jogs_accepted - commands_before_;
  const bool timed_out = ending.how == JogEnd::kDuration && commands > 1;
  events_.on_event(JogEnded{.tag = started_->tag,
                            .how = timed_out ? JogEnd::kTimeOut : ending.how,
                            .axis = ending.axis,
                            .tick = last,
                            .taken = last - started_->tick + Ticks{1},
                            .commands = commands});
  started_.reset();
}

void PlansOrJog::reset_to(const PerAxis<Radians>& position) noexcept {
  plans_.reset_to(position);
  jogging_ = false;
  last_ = &plans_.last();
}

void PlansOrJog::cut_short(Ticks tick) noexcept {
  if (!jogging_) return plans_.cut_short(tick);
  report_end({.how = JogEnd::kFault}, tick);
}

void PlansOrJog::cancel(Ticks tick) noexcept {
  (void)input_.latest();
  if (jogging_) reset_to(set_point_.position);
  plans_.cancel(tick);
}

Stopping PlansOrJog::stopping() const noexcept {
  return jogging_ ? velocity_.stopping() : plans_.stopping();
}

}  // namespace armature
