#include "controller/language/job/machine.hpp"

#include <algorithm>

namespace armature::job {

void Machine::select(std::size_t job, std::uint32_t line) noexcept {
  first_job_ = job;
  first_line_ = line;
}

void Machine::start() noexcept {
  variables_.reset();
  for (std::size_t i = 0; i < memory_.position_count; ++i) {
    const Position& position = memory_.positions[i];
    if (position.letter != PositionLetter::kP) continue;
    PositionValue* variable = variables_.position({VariableType::kP, false, static_cast<double>(position.number)});
    if (variable != nullptr) *variable = PositionValue::of(position);
  }
  depth_ = 0;
  calls_[depth_++] = {};
  alarm_ = enter_job(first_job_);
  while (pc_ + 1U < memory_.jobs[job_].record_count && here().line < first_line_) ++pc_;
  returned_ = 0.0;
  begun_ = pause_when_done_ = paused_here_ = waits_for_time_ = needs_joints_ = false;
  joint_speed_ = setup_.settings.joint_speed;
  speed_mm_s_ = setup_.settings.speed_mm_s;
  turn_speed_rad_s_ = setup_.settings.turn_speed_rad_s;
  base_shift_ = tool_shift_ = std::nullopt;
  shift_mm_.reset();
  tool_.reset();
  arm_tool_.reset();
  planned_ = {};
  until_ = Until::kNone;
  wait_began_.reset();
  group_bit_ = 0;
  outputs_.reset();
}

Alarm Machine::enter_job(std::size_t job) noexcept {
  job_ = job;
  pc_ = 0;
  return variables_.enter(memory_.jobs[job]);
}

std::uint32_t Machine::line() const noexcept {
  return here().line;
}

bool Machine::select_line(std::uint32_t line) noexcept {
  if (line > memory_.records_of(memory_.jobs[first_job_]).back().line) return false;
  return select(first_job_, line), true;
}

bool Machine::has_line(ProgramPlace place) const noexcept {
  if (job_of(place) >= memory_.job_count) return false;
  const std::span records = memory_.records_of(memory_.jobs[job_of(place)]);
  return std::ranges::any_of(records, [place](const Record& one) { return one.line == line_of(place); });
}

Interpreter::Progress Machine::step(ProgramPort& port) noexcept {
  port_ = &port;
  waits_for_time_ = false;
  if (pause_when_done_) {
    if (!port.done()) return Progress::kWaiting;
    pause_when_done_ = false;
    return Progress::kPaused;
  }
  operands_ = memory_.operands_of(here());
  if (!begun_) {
    if (!paused_here_ && port.breakpoint_at(place())) {
      if (!port.done()) return Progress::kWaiting;
      paused_here_ = true;
      return Progress::kPaused;
    }
    begun_ = true;
    const Op op = here().op;
    if (op != Op::kBlank && op != Op::kComment && op != Op::kComm)
      note(ProgramNote::Kind::kLine, instruction_of(op).name);
  }
  return finish(alarm_ == Alarm::kNone ? execute() : Outcome::kAlarm);
}

Interpreter::Progress Machine::finish(Outcome outcome) noexcept {
  switch (outcome) {
    case Outcome::kWait:
      return Progress::kWaiting;
    case Outcome::kEnd:
      return Progress::kEnded;
    case Outcome::kAlarm:
      if (alarm_ != Alarm::kUser)
        note(ProgramNote::Kind::kAlarm, instruction_of(here().op).name, text_of_alarm(alarm_));
      return Progress::kAlarm;
    case Outcome::kNext:
      ++pc_;
      break;
    case Outcome::kJumped:
      break;
    case Outcome::kPause:
      ++pc_;
      pause_when_done_ = true;
      break;
  }
  begun_ = needs_joints_ = false;
  wait_began_.reset();
  group_bit_ = 0;
  if (single_step_) pause_when_done_ = true;
  paused_here_ = pause_when_done_;
  return Progress::kWorking;
}

void Machine::note(ProgramNote::Kind kind, std::string_view first, std::string_view second) noexcept {
  ProgramNote note{.kind = kind, .place = place(), .text = first};
  if (!second.empty()) note.text << ": " << second;
  port_->note(note);
}

bool Machine::fail(Alarm alarm) noexcept {
  alarm_ = alarm;
  outcome_ = Outcome::kAlarm;
  return false;
}

bool Machine::wait_until_done(bool timed) noexcept {
  if (port_->done()) return true;
  waits_for_time_ = timed;
  outcome_ = Outcome::kWait;
  return false;
}

}  // namespace armature::job
