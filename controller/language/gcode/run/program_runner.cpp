#include "controller/language/gcode/run/program_runner.hpp"

#include "controller/language/gcode/reader/source_line.hpp"
#include "controller/language/text/parts.hpp"

namespace armature::gcode {
namespace {

constexpr int kSlice = 100;  // inverse kinematics of a step

// A message without the blanks before it.
std::string_view without_blanks(std::string_view text) noexcept {
  std::size_t start = 0;
  while (start < text.size() && is_blank(text[start])) ++start;
  return part(text, start);
}

}  // namespace

void ProgramRunner::load(const ProgramText& program) noexcept {
  program_ = program;
  lines_ = 0;
  for (std::size_t at = 0; at < program.text.size(); at = line_at(program.text, at).next) ++lines_;
}

// What was executed before counts no more.
void ProgramRunner::set_single_step(bool on) noexcept {
  single_step_ = on;
  stepped_ = false;
}

void ProgramRunner::start() noexcept {
  phase_ = Phase::kStart;
  paused_ = stepped_ = paused_here_ = false;
  wait_.cancel();
}

Program::Progress ProgramRunner::step(ProgramPort& port) noexcept {
  port_ = &port;
  Progress progress = Progress::kWorking;
  switch (phase_) {
    case Phase::kStart:
      progress = begin(port);
      break;
    case Phase::kCheck:
      progress = check_step(port);
      break;
    case Phase::kRun:
      progress = run_step(port);
      break;
  }
  port_ = nullptr;
  return progress;
}

Program::Progress ProgramRunner::begin(ProgramPort& port) noexcept {
  if (!port.done()) return Progress::kWaiting;
  start_joints_ = port.joints();
  const Transform base_T_tool = setup_.cell.arm.forward(start_joints_) * setup_.cell.flange_T_tool;
  const Transform base_T_user = base_T_frame(setup_.settings.frame, setup_.cell.base_T_user, base_T_tool);
  const Eigen::Vector3d place = inverse(base_T_user) * base_T_tool.position_mm;
  start_ = {place.x(), place.y(), place.z(), 0.0, 0.0, 0.0};
  interpreter_.executor().save(stored_);
  checked_ = 0;
  check_.begin(start_joints_);
  restart(Phase::kCheck);
  return Progress::kWorking;
}

// Begins the program, without or with the arm.
void ProgramRunner::restart(Phase phase) noexcept {
  phase_ = phase;
  queue_begin_ = queue_end_ = sent_ = 0;
  noted_line_ = 0;
  interpreter_.executor().restore(stored_);
  commands_.begin(start_);
  interpreter_.begin(program_, {.start = start_});
}

void ProgramRunner::note_line(ProgramPort& port, std::uint32_t line) noexcept {
  if (line == noted_line_) return;
  noted_line_ = line;
  port.note({.kind = ProgramNote::Kind::kLine, .place = line});
}

void ProgramRunner::on_call(const CanonCall& call, std::uint32_t line) noexcept {
  if (const auto* text = std::get_if<Text>(&call)) {
    // The text is gone after this call, so it is shown ahead of the arm.
    if (phase_ == Phase::kRun && port_ != nullptr && text->kind != Text::Kind::kComment) {
      note_line(*port_, line);
      port_->note({.kind = ProgramNote::Kind::kMessage, .place = line, .text = without_blanks(text->text)});
    }
    return;
  }
  if (const auto* mode = std::get_if<SetSpindleMode>(&call); mode != nullptr && mode->max_rpm > 0.0) {
    if (phase_ == Phase::kRun && port_ != nullptr) {
      port_->note({.kind = ProgramNote::Kind::kMessage, .place = line, .text = "G96: the speed of the spindle stays"});
    }
    return;
  }
  if (queue_end_ < queue_.size()) queue_[queue_end_++] = {.call = call, .line = line};
}

Program::Progress ProgramRunner::check_step(ProgramPort& port) noexcept {
  if (check_.busy()) {
    const std::optional<ReachCheck::Problem> problem = check_.work(kSlice);
    port.charge_inverses(check_.inverses());
    if (problem) return alarm(port, line_, check_.text_of(*problem).view());
    return Progress::kWorking;
  }
  while (sent_ < commands_.commands().size()) {
    const auto* move = std::get_if<CartesianMove>(&commands_.commands()[sent_++]);
    if (move == nullptr) continue;
    check_.add(*move);
    return Progress::kWorking;
  }
  if (queue_begin_ < queue_end_) return convert_next(port);
  queue_begin_ = queue_end_ = 0;
  switch (interpreter_.state()) {
    case CanonInterpreter::State::kRunning:
      if (++checked_ > kMaxChecked) break;
      interpreter_.step();
      return Progress::kWorking;
    case CanonInterpreter::State::kStopped:
      interpreter_.resume();
      return Progress::kWorking;
    case CanonInterpreter::State::kFailed:
      // What the program does up to where it stops itself is right.
      if (interpreter_.error().code == ErrorCode::kAborted) break;
      return fail(port);
    case CanonInterpreter::State::kWaitsForInput:
    case CanonInterpreter::State::kEnded:
      break;
  }
  restart(Phase::kRun);
  return Progress::kWorking;
}

Program::Progress ProgramRunner::run_step(ProgramPort& port) noexcept {
  if (paused_) {  // the operator has resumed the program
    paused_ = false;
    interpreter_.resume();
  }
  if (wait_.active()) return wait_step(port);
  if (sent_ < commands_.commands().size()) {
    if (!port.has_room()) return Progress::kWaiting;
    port.send(commands_.commands()[sent_++], line_);
    return Progress::kWorking;
  }
  if (queue_begin_ < queue_end_) return execute_next(port);
  queue_begin_ = queue_end_ = 0;
  if (pauses_here(port)) {
    if (!port.done()) return Progress::kWaiting;
    stepped_ = false;
    paused_here_ = true;
    return Progress::kPaused;
  }
  switch (interpreter_.state()) {
    case CanonInterpreter::State::kRunning: {
      stepped_ = true;
      paused_here_ = false;
      interpreter_.step();
      note_line(port, interpreter_.line());
      return Progress::kWorking;
    }
    case CanonInterpreter::State::kStopped:
      if (!port.done()) return Progress::kWaiting;
      stepped_ = false;
      paused_ = paused_here_ = true;
      return Progress::kPaused;
    case CanonInterpreter::State::kWaitsForInput:
      return Progress::kWaiting;
    case CanonInterpreter::State::kEnded:
      note_end(port);
      return Progress::kEnded;
    case CanonInterpreter::State::kFailed:
      return fail(port);
  }
  return Progress::kWorking;
}

// Between two lines. A stop of the program (M0) is no line that pauses twice.
bool ProgramRunner::pauses_here(ProgramPort& port) const noexcept {
  using State = CanonInterpreter::State;
  const bool runs = interpreter_.state() == State::kRunning;
  if (interpreter_.state() == State::kStopped || (runs && interpreter_.next_line() == 0)) return false;
  if (stepped_ && single_step_) return true;
  return runs && !paused_here_ && port.breakpoint_at(interpreter_.next_line());
}

Program::Progress ProgramRunner::execute_next(ProgramPort& port) noexcept {
  const auto* wait = std::get_if<WaitInput>(&queue_[queue_begin_].call);
  if (wait == nullptr) return convert_next(port);
  line_ = queue_[queue_begin_].line;
  if (!port.done()) return Progress::kWaiting;
  if (wait->analog) return alarm(port, line_, "the arm has no analog inputs");
  if (wait->index >= MotionCommands::kPins) return alarm(port, line_, "the tool has the inputs 0 to 15");
  ++queue_begin_;
  wait_.begin(*wait, line_, port.now());
  return wait_step(port);
}

Program::Progress ProgramRunner::convert_next(ProgramPort& port) noexcept {
  const Queued& queued = queue_[queue_begin_++];
  line_ = queued.line;
  sent_ = 0;
  if (const auto problem = commands_.convert(queued.call)) return alarm(port, line_, text_of(*problem));
  return Progress::kWorking;
}

Program::Progress ProgramRunner::wait_step(ProgramPort& port) noexcept {
  const std::optional<double> value = wait_.step(port);
  if (!value) return Progress::kWaiting;
  interpreter_.give_input(*value);
  return Progress::kWorking;
}

void ProgramRunner::note_end(ProgramPort& port) noexcept {
  if (!interpreter_.ended_without_code()) return;
  port.note({.kind = ProgramNote::Kind::kMessage, .place = interpreter_.line(), .text = CanonInterpreter::kNoEndCode});
}

Program::Progress ProgramRunner::fail(ProgramPort& port) noexcept {
  const Error& error = interpreter_.error();
  return alarm(port, error.line, message_of(error).view());
}

Program::Progress ProgramRunner::alarm(ProgramPort& port, std::uint32_t line, std::string_view text) noexcept {
  port.note({.kind = ProgramNote::Kind::kAlarm, .place = line, .text = text});
  return Progress::kAlarm;
}

}  // namespace armature::gcode
