#include "controller/activity/jog/jog_source.hpp"

#include <utility>

namespace armature {

JogSource::JogSource(const RobotModel& robot, const Arm& arm, const Transform& flange_T_tool,
                     EventListener& events) noexcept
    : events_{events}, velocity_{robot, arm, commands_, {.time_out = Ticks{1}, .flange_T_tool = flange_T_tool}} {}

void JogSource::begin(const Request& first, const PerAxis<Radians>& stand, Ticks tick) noexcept {
  const auto& command = first.get<VelocityCommand>();
  velocity_.reset_to(stand);
  commands_.clear();
  commands_.add(command);
  still_ticks_ = 0;
  last_step_ = tick;
  started_ = JogStarted{.tag = command.tag, .tick = tick};
  events_.on_event(started_);
}

void JogSource::stop(StopKind how) noexcept {
  using Kind = VelocityCommand::Kind;
  commands_.add({.kind = how == StopKind::kHold   ? Kind::kHalt
                         : how == StopKind::kSoft ? Kind::kSoftStop
                                                  : Kind::kStop});
}

SetPoint& JogSource::advance(Ticks tick, const RunControl::View&) noexcept {
  const bool commanded = !commands_.empty();
  set_point_ = velocity_.advance(tick);
  set_point_.stopped = false;
  if (set_point_.state != MotionState::kIdle) last_step_ = tick;
  still_ticks_ = velocity_.done() && !commanded ? still_ticks_ + 1 : 0;
  if (over()) report_end(velocity_.ending(), last_step_);
  return set_point_;
}

void JogSource::report_end(VelocitySource::Ending ending, Ticks last) noexcept {
  const bool timed_out = ending.how == JogEnd::kDuration && commands_.count() > 1;
  events_.on_event(JogEnded{.tag = started_.tag,
                            .how = timed_out ? JogEnd::kTimeOut : ending.how,
                            .axis = ending.axis,
                            .tick = last,
                            .taken = last - started_.tick + Ticks{1},
                            .commands = commands_.count()});
}

void JogSource::Commands::clear() noexcept {
  latest_.reset();
  count_ = 0;
}

void JogSource::Commands::add(const VelocityCommand& command) noexcept {
  ++count_;
  if (!latest_ || latest_->kind < VelocityCommand::Kind::kHalt || command.kind > latest_->kind) latest_ = command;
}

std::optional<VelocityCommand> JogSource::Commands::latest() noexcept {
  return std::exchange(latest_, std::nullopt);
}

}  // namespace armature
