#include "controller/language/gcode/program_runner.hpp"

#include <cmath>

#include "controller/base/angle_units.hpp"
#include "controller/base/rounding.hpp"
#include "controller/base/timebase.hpp"
#include "controller/language/gcode/source_line.hpp"
#include "controller/language/text/parts.hpp"

namespace armature::gcode {
namespace {

constexpr int kSlice = 100;  // inverse kinematics of a step
constexpr double kTimedOut = -1.0;

// A message without the blanks before it.
std::string_view without_blanks(std::string_view text) noexcept {
  std::size_t start = 0;
  while (start < text.size() && is_blank(text[start])) ++start;
  return part(text, start);
}

// `-12.5` for -125.
void append_tenths(FixedText<64>& text, std::int64_t tenths) noexcept {
  const auto size = static_cast<std::uint64_t>(tenths < 0 ? -tenths : tenths);
  text << (tenths < 0 ? std::string_view{"-"} : std::string_view{});
  text.append_digits(size / 10, 1).operator<<('.').append_digits(size % 10, 1);
}

bool reached(WaitInput::Mode mode, bool before, bool level) noexcept {
  switch (mode) {
    case WaitInput::Mode::kImmediate:
      return true;
    case WaitInput::Mode::kRise:
      return !before && level;
    case WaitInput::Mode::kFall:
      return before && !level;
    case WaitInput::Mode::kHigh:
      return level;
    case WaitInput::Mode::kLow:
      return !level;
  }
  return true;
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
  waiting_ = {};
}

Interpreter::Progress ProgramRunner::step(ProgramPort& port) noexcept {
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

Interpreter::Progress ProgramRunner::begin(ProgramPort& port) noexcept {
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

Interpreter::Progress ProgramRunner::check_step(ProgramPort& port) noexcept {
  if (check_.busy()) {
    const std::optional<ReachCheck::Problem> problem = check_.work(kSlice);
    port.charge_inverses(check_.inverses());
    if (!problem) return Progress::kWorking;
    FixedText<64> text;
    if (problem->status == IkStatus::kOutsideLimits) {
      const double limit_rad = setup_.cell.robot.axes[problem->axis - 1U].nearer_limit_rad(problem->angle_rad);
      const auto up = static_cast<std::int64_t>(rounded_up(10.0 * kDegPerRad * std::fabs(problem->angle_rad)));
      text << "the path needs joint " << static_cast<std::uint32_t>(problem->axis) << " at ";
      append_tenths(text, problem->angle_rad < 0.0 ? -up : up);
      text << " deg, its limit is ";
      append_tenths(text, round_half_away(10.0 * kDegPerRad * limit_rad));
      text << " deg";
    } else if (problem->status == IkStatus::kOrientation) {
      text << "the arm cannot hold the tool in this orientation";
    } else {
      text << "the path leaves the reach of the arm by up to " << static_cast<int>(rounded_up(problem->margin_mm))
           << " mm";
    }
    return alarm(port, line_, text.view());
  }
  while (sent_ < commands_.commands().size()) {
    const auto* move = std::get_if<CartesianMove>(&commands_.commands()[sent_++]);
    if (move == nullptr) continue;
    check_.add(*move);
    return Progress::kWorking;
  }
  if (queue_begin_ < queue_end_) {
    const Queued& queued = queue_[queue_begin_++];
    line_ = queued.line;
    sent_ = 0;
    if (const auto problem = commands_.convert(queued.call)) return alarm(port, line_, text_of(*problem));
    return Progress::kWorking;
  }
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

Interpreter::Progress ProgramRunner::run_step(ProgramPort& port) noexcept {
  if (paused_) {  // the operator has resumed the program
    paused_ = false;
    interpreter_.resume();
  }
  if (waiting_.active) return wait_step(port);
  if (sent_ < commands_.commands().size()) {
    if (!port.has_room()) return Progress::kWaiting;
    port.send(commands_.commands()[sent_++], line_);
    return Progress::kWorking;
  }
  if (queue_begin_ < queue_end_) return execute(queue_[queue_begin_], port);
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

// Executes a call, which leaves the queue with it.
Interpreter::Progress ProgramRunner::execute(const Queued& queued, ProgramPort& port) noexcept {
  line_ = queued.line;
  if (const auto* wait = std::get_if<WaitInput>(&queued.call)) {
    if (!port.done()) return Progress::kWaiting;
    if (wait->analog) return alarm(port, line_, "the arm has no analog inputs");
    if (wait->index >= MotionCommands::kPins) return alarm(port, line_, "the tool has the inputs 0 to 15");
    ++queue_begin_;
    waiting_ = {.active = true, .wait = *wait, .began = port.now()};
    return wait_step(port);
  }
  ++queue_begin_;
  sent_ = 0;
  if (const auto problem = commands_.convert(queued.call)) return alarm(port, line_, text_of(*problem));
  return Progress::kWorking;
}

Interpreter::Progress ProgramRunner::wait_step(ProgramPort& port) noexcept {
  const bool level = port.level(static_cast<std::uint8_t>(waiting_.wait.index + 1), false);
  const bool begins = waiting_.first;
  const bool before = begins ? level : waiting_.last_level;
  waiting_.first = false;
  waiting_.last_level = level;
  const bool in_time = reached(waiting_.wait.mode, before, level);
  const Ticks timeout{round_half_away(waiting_.wait.timeout_s / kTickSeconds)};
  if (!in_time && port.now() - waiting_.began < timeout) {
    if (begins) port.note({.kind = ProgramNote::Kind::kWaits, .place = line_});
    return Progress::kWaiting;
  }
  waiting_.active = false;
  const std::string_view why = in_time ? std::string_view{} : kWaitTimeOver;
  port.note({.kind = ProgramNote::Kind::kWaited, .place = line_, .text = why});
  interpreter_.give_input(in_time ? (level ? 1.0 : 0.0) : kTimedOut);
  return Progress::kWorking;
}

void ProgramRunner::note_end(ProgramPort& port) noexcept {
  if (!interpreter_.ended_without_code()) return;
  port.note({.kind = ProgramNote::Kind::kMessage, .place = interpreter_.line(), .text = CanonInterpreter::kNoEndCode});
}

Interpreter::Progress ProgramRunner::fail(ProgramPort& port) noexcept {
  const Error& error = interpreter_.error();
  return alarm(port, error.line, message_of(error).view());
}

Interpreter::Progress ProgramRunner::alarm(ProgramPort& port, std::uint32_t line, std::string_view text) noexcept {
  port.note({.kind = ProgramNote::Kind::kAlarm, .place = line, .text = text});
  return Progress::kAlarm;
}

}  // namespace armature::gcode
