#include "controller/language/program/program_client.hpp"

#include <utility>
#include <variant>

#include "controller/base/timebase.hpp"

namespace armature {

void ProgramClient::set(Program& program, std::optional<Ticks> start) noexcept {
  program_ = &program;
  start_at_ = start.value_or(Ticks{});
  state_ = start ? State::kPending : State::kReady;
  started_ = false;
  forget_lines();
  breakpoints_.clear();
}

void ProgramClient::clear() noexcept {
  program_ = nullptr;
  state_ = State::kIdle;
  forget_lines();
  breakpoints_.clear();
}

bool ProgramClient::run(Mode mode, std::uint32_t line) noexcept {
  if (program_ == nullptr || active()) return false;
  if (!program_->select_line(line)) return false;
  program_->set_single_step(mode == Mode::kSingleSteps);
  mode_ = mode;
  forget_lines();
  start();
  return true;
}

void ProgramClient::forget_lines() noexcept {
  line_ = 0;
  sent_.forget_place();
  note_ = {};
}

bool ProgramClient::hold() noexcept {
  if (state_ != State::kRunning || !orders_.try_push(Hold{})) return false;
  state_ = State::kHeld;
  report(ProgramNote::Kind::kHeld, place());
  return true;
}

bool ProgramClient::resume() noexcept {
  return continue_lines(mode_ == Mode::kSingleSteps);
}

bool ProgramClient::step() noexcept {
  return continue_lines(true);
}

bool ProgramClient::abort() noexcept {
  return active() && stop_before(State::kAborted);
}

void ProgramClient::start() noexcept {
  state_ = State::kRunning;
  started_ = stopping_ = false;
  sent_.forget_failure();
  next_state_.reset();
}

bool ProgramClient::continue_lines(bool single_step) noexcept {
  if (state_ != State::kPaused && state_ != State::kHeld) return false;
  if (state_ == State::kHeld && !orders_.try_push(Resume{})) return false;
  program_->set_single_step(single_step);
  state_ = State::kRunning;
  report(ProgramNote::Kind::kResumed, place());
  return true;
}

// What was sent must not be executed from a wrong place, or after the end.
bool ProgramClient::stop_before(State state) noexcept {
  if (!orders_.try_push(Stop{.kind = Stop::Kind::kSoft})) return false;
  state_ = State::kRunning;
  next_state_ = state;
  stopping_ = true;
  return true;
}

bool ProgramClient::execute(RegisterBus& bus) noexcept {
  bus_ = &bus;
  if (pulses_.any()) pulses_.end_due(now(), tool_, bus);
  if (state_ == State::kPending && now() >= start_at_) start();
  if (state_ == State::kPaused && resume_after_ && now() >= resume_at_) static_cast<void>(resume());
  if (active() && sent_.failed() && !stopping_) {
    if (!stop_before(State::kFailed)) return false;
    report(ProgramNote::Kind::kStopped, *sent_.failed());
    return true;
  }
  if (state_ != State::kRunning) return false;
  if (!started_ && !next_state_) {
    if (!host_.empty() || !done()) return false;
    program_->start();
    started_ = true;
  }
  return next_state_ ? enter_next_state() : step_program();
}

bool ProgramClient::enter_next_state() noexcept {
  if (!sent_.over()) return false;
  state_ = *std::exchange(next_state_, std::nullopt);
  if (state_ == State::kEnded && mode_ == Mode::kAgain) {
    static_cast<void>(program_->select_line(0));
    start();
    return true;
  }
  if (state_ == State::kEnded) report(ProgramNote::Kind::kEnded, line_);
  if (state_ == State::kAborted) report(ProgramNote::Kind::kAborted, place());
  if (state_ == State::kFailed) report(ProgramNote::Kind::kOver, place());
  return false;
}

bool ProgramClient::step_program() noexcept {
  inputs_read_ = 0;
  const Program::Progress progress = program_->step(*this);
  bus_->charge(Work::kProgramStep);
  switch (progress) {
    case Program::Progress::kWorking:
      return true;
    case Program::Progress::kWaiting:
      return false;
    case Program::Progress::kPaused:
      state_ = State::kPaused;
      resume_at_ = now() + resume_after_.value_or(Ticks{});
      line_ = std::exchange(breakpoint_, std::nullopt).value_or(line_);
      report(ProgramNote::Kind::kPaused, line_);
      return false;
    case Program::Progress::kEnded:
      next_state_ = State::kEnded;
      return true;
    case Program::Progress::kAlarm:
      next_state_ = State::kFailed;
      return true;
  }
  return false;
}

bool ProgramClient::waits_for_time() const noexcept {
  const bool program_waits = state_ == State::kRunning && !next_state_ && (!started_ || program_->waits_for_time());
  const bool resumes = state_ == State::kPaused && resume_after_;
  return state_ == State::kPending || program_waits || resumes || pulses_.any();
}

void ProgramClient::on_event(const Event& event) noexcept {
  sent_.on_event(event);
  if (const auto* fault = std::get_if<Faulted>(&event)) on_fault(fault->cause);
}

// The arm may have stood, so no command tells of the fault. A program that has not begun waits for the drives.
void ProgramClient::on_fault(FaultCause cause) noexcept {
  if (!active() && state_ != State::kPending) return;
  if (cause == FaultCause::kDrivesOff && !started_) return;
  state_ = State::kRunning;
  next_state_ = State::kFailed;
  stopping_ = true;
  note({.kind = ProgramNote::Kind::kAlarm, .place = place(), .text = "a fault has stopped the arm"});
}

void ProgramClient::send(const Command& command, ProgramPlace place) noexcept {
  Command tagged = command;
  std::visit(
      [place](auto& one) {
        if constexpr (requires { one.tag; }) one.tag = Tag{Source::kProgram, place};
      },
      tagged);
  if (!inbox_.try_push(tagged)) return;
  sent_.send(place);
}

bool ProgramClient::stop() noexcept {
  const bool stopped = orders_.try_push(Stop{.kind = Stop::Kind::kSoft});
  sent_.set_stopped(stopped);
  return stopped;
}

bool ProgramClient::done() const noexcept {
  return sent_.over() && owner_.rest().has_value();
}

JointAngles ProgramClient::joints() const noexcept {
  return owner_.rest().value_or(JointAngles{});
}

bool ProgramClient::level(std::uint8_t pin, bool output) noexcept {
  if (!output) inputs_read_ = static_cast<std::uint16_t>(inputs_read_ | 1U << (pin - 1U));
  return tool_.level(pin, output, *bus_);
}

void ProgramClient::pulse(std::uint8_t pin, Ticks duration) noexcept {
  pulses_.begin(pin, now() + duration, tool_, *bus_);
}

bool ProgramClient::breakpoint_at(ProgramPlace place) noexcept {
  breakpoint_.reset();
  if (breakpoints_.contains(place)) breakpoint_ = place;
  return breakpoint_.has_value();
}

Ticks ProgramClient::now() noexcept {
  return Ticks{bus_->now().value() / kTickCycles.value()};
}

void ProgramClient::note(const ProgramNote& note) noexcept {
  using enum ProgramNoted::Kind;
  if (note.kind == kLine) {
    line_ = note.place;
  } else if (note.kind == kMessage || note.kind == kAlarm || note.kind == kStopped) {
    note_ = note;
    ++notes_;
  }
  ProgramNoted event{.place = note.place, .kind = note.kind};
  if (note.kind == kWaits || note.kind == kWaited) event.inputs = inputs_read_;
  event.set_text(note.text.view());
  events_.on_event(event);
}

}  // namespace armature
