#include "cosim/pendant/operator_desk.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "controller/pendant/protocol/frame.hpp"

namespace armature::cosim {

using pendant::BreakpointAction;
using pendant::Content;
using pendant::Drives;
using pendant::Opcode;
using pendant::RunMode;
using pendant::State;

namespace {

constexpr std::array kJogPercents{1, 2, 5, 10, 25, 50, 100};
struct Step {
  double deg, mm;
};
constexpr std::array<Step, 4> kSteps{{{0, 0}, {0.01, 0.1}, {0.1, 1}, {1, 10}}};
constexpr int kOverrideStep = 10;
constexpr std::uint8_t kResetParameter = 0x5A;
constexpr std::int32_t kResetPayload = 0x0E'57'09;
constexpr std::size_t kFirstAngle = 3;  // of X Y Z Rx Ry Rz
constexpr int kFrames = 16;

template <class Enumerator>
constexpr int code(Enumerator one) {
  return static_cast<int>(one);
}

}  // namespace

std::span<const OperatorDesk::Key> OperatorDesk::keys() {
  using Desk = OperatorDesk;
  static constexpr std::array kKeys{
      Key{'q', "q a", "jog joint 1 / X", &Desk::jog, 0},
      Key{'a', "", "", &Desk::jog, 1},
      Key{'w', "w s", "joint 2 / Y", &Desk::jog, 2},
      Key{'s', "", "", &Desk::jog, 3},
      Key{'e', "e d", "joint 3 / Z", &Desk::jog, 4},
      Key{'d', "", "", &Desk::jog, 5},
      Key{'r', "r f", "joint 4 / Rx", &Desk::jog, 6},
      Key{'f', "", "", &Desk::jog, 7},
      Key{'t', "t g", "joint 5 / Ry", &Desk::jog, 8},
      Key{'g', "", "", &Desk::jog, 9},
      Key{'y', "y h", "joint 6 / Rz", &Desk::jog, 10},
      Key{'h', "", "", &Desk::jog, 11},
      Key{'c', "c u", "coordinates, frame", &Desk::change_coordinates, 0},
      Key{'u', "", "", &Desk::change_user_frame, 0},
      Key{'i', "i + -", "size, speed of jogs", &Desk::change_step, 0},
      Key{'+', "", "", &Desk::change_jog_speed, 1},
      Key{'-', "", "", &Desk::change_jog_speed, -1},
      Key{']', "] [", "speed override", &Desk::change_override, 1},
      Key{'[', "", "", &Desk::change_override, -1},
      Key{'o', "o", "drives on / off", &Desk::switch_drives, 0},
      Key{' ', "space", "stop", &Desk::stop, 0},
      Key{'!', "!", "EMERGENCY STOP", &Desk::estop, 0},
      Key{'z', "z", "reset the alarm", &Desk::reset, 0},
      Key{'0', "0", "home all axes", &Desk::home, 0},
      Key{'p', "p", "next program", &Desk::select_program, 0},
      Key{'l', "l L", "load, add as a job", &Desk::load_program, code(Content::kJob)},
      Key{'L', "", "", &Desk::load_program, code(Content::kFurtherJob)},
      Key{kEnter, "enter", "run", &Desk::run, code(RunMode::kOnce)},
      Key{'n', "n", "run one line", &Desk::step, 0},
      Key{kUp, "arrow", "go to a line", &Desk::move_cursor, -1},
      Key{kDown, "", "", &Desk::move_cursor, 1},
      Key{'j', "j", "run from that line", &Desk::run_from_cursor, 0},
      Key{'b', "b B", "breakpoint, drop all", &Desk::toggle_breakpoint, 0},
      Key{'B', "", "", &Desk::remove_breakpoints, 0},
      Key{'.', ". ,", "hold / resume", &Desk::command, code(Opcode::kHold)},
      Key{',', "", "", &Desk::command, code(Opcode::kResume)},
      Key{'k', "k", "abort the program", &Desk::command, code(Opcode::kAbort)},
  };
  return kKeys;
}

void OperatorDesk::press(int key, Time now) {
  for (const Key& known : keys()) {
    if (known.key == key) return (this->*known.act)(known.argument, now);
  }
}

void OperatorDesk::jog(int direction, Time now) {
  const auto axis = static_cast<std::size_t>(direction / 2);
  const int sign = direction % 2 == 0 ? 1 : -1;
  if (axis >= joints()) return;
  if (step_ != 0) {
    const std::optional<std::int32_t> distance = increment(axis);
    if (!distance) return link_.say("steps of joints need --robot");
    return send(Opcode::kJogIncrement, static_cast<std::uint8_t>(axis), sign * *distance);
  }
  const bool held = jog_key_ == direction && now - jog_pressed_ < kFirstPress;
  jog_key_ = direction;
  jog_pressed_ = now;
  link_.jog(static_cast<std::uint8_t>(axis), sign * 10'000, now + (held ? kHeld : kFirstPress));
}

void OperatorDesk::change_coordinates(int, Time) {
  send(Opcode::kSetCoordinates, static_cast<std::uint8_t>((link_.coordinates() + 1) % 4));
}

void OperatorDesk::change_step(int, Time) {
  step_ = (step_ + 1) % kSteps.size();
}

void OperatorDesk::change_user_frame(int, Time) {
  user_frame_ = user_frame_ % kFrames + 1;
  send(Opcode::kSetUserFrame, static_cast<std::uint8_t>(user_frame_));
}

void OperatorDesk::change_jog_speed(int by, Time) {
  const int last = static_cast<int>(kJogPercents.size()) - 1;
  jog_speed_ = static_cast<std::size_t>(std::clamp(static_cast<int>(jog_speed_) + by, 0, last));
  send(Opcode::kJogLimit, 0, jog_percent() * 100);
}

void OperatorDesk::change_override(int by, Time) {
  override_percent_ = std::clamp(override_percent_ + by * kOverrideStep, kOverrideStep, 100);
  send(Opcode::kSpeedOverride, 0, override_percent_ * 100);
}

void OperatorDesk::switch_drives(int, Time) {
  send(Opcode::kServo, static_cast<std::uint8_t>(link_.drives_on() ? Drives::kOff : Drives::kOn));
}

void OperatorDesk::stop(int, Time) {
  link_.release_jog();
  send(Opcode::kStop);
}

void OperatorDesk::estop(int, Time) {
  link_.press_estop();
}

void OperatorDesk::reset(int, Time) {
  if (link_.state() == State::kEstop) send(Opcode::kEstopReset, kResetParameter, kResetPayload);
  send(Opcode::kResetAlarm);
}

void OperatorDesk::home(int, Time) {
  send(Opcode::kHome, static_cast<std::uint8_t>((1u << joints()) - 1u));
}

void OperatorDesk::select_program(int, Time) {
  if (!programs_.empty()) selected_ = (selected_ + 1) % programs_.size();
  cursor_ = 0;
}

void OperatorDesk::load_program(int kind, Time) {
  if (program() == nullptr) return link_.say("no program: name its file with --program");
  const bool gcode = program()->kind == Content::kGcode;
  if (gcode && kind == code(Content::kFurtherJob)) return link_.say("a G-code program has no further jobs");
  if (!link_.download(gcode ? Content::kGcode : static_cast<Content>(kind), program()->name, program()->text))
    link_.say("the program cannot be sent now");
}

void OperatorDesk::run(int mode, Time) {
  start(static_cast<RunMode>(mode), 0);
}

void OperatorDesk::run_from_cursor(int, Time) {
  start(RunMode::kOnce, cursor_);
}

// The program on the screen, which may not be the one that was loaded last.
void OperatorDesk::start(RunMode mode, std::int32_t line) {
  if (program() != nullptr) {
    const std::optional<std::size_t> job = link_.job_of(program()->name);
    if (!job) return link_.say("load the program first");
    if (program()->kind == Content::kJob && link_.has_sent()) {
      send(Opcode::kProgramSelect, static_cast<std::uint8_t>(*job));
    }
  }
  cursor_ = 0;
  send(Opcode::kRun, static_cast<std::uint8_t>(mode), line);
}

void OperatorDesk::move_cursor(int by, Time) {
  if (program() == nullptr || program()->lines.empty()) return;
  const std::int32_t from = cursor_ > 0 ? cursor_ : std::max(current_line(), 1);
  cursor_ = std::clamp(from + by, 1, static_cast<std::int32_t>(program()->lines.size()));
}

void OperatorDesk::toggle_breakpoint(int, Time) {
  const std::int32_t line = cursor_ > 0 ? cursor_ : current_line();
  if (line == 0) return link_.say("go to a line of the program first");
  const std::optional<std::int32_t> place = place_of(line);
  if (!place) return link_.say("load the program first");
  const auto action = link_.has_breakpoint(*place) ? BreakpointAction::kRemove : BreakpointAction::kSet;
  send(Opcode::kSetBreakpoint, static_cast<std::uint8_t>(action), *place);
}

void OperatorDesk::remove_breakpoints(int, Time) {
  send(Opcode::kSetBreakpoint, static_cast<std::uint8_t>(BreakpointAction::kRemoveAll));
}

std::optional<std::int32_t> OperatorDesk::place_of(std::int32_t line) const {
  const std::optional<std::size_t> job = link_.job_of(program()->name);
  if (!job) return std::nullopt;
  return program()->kind == Content::kGcode ? line : pendant::kLineJob.with(static_cast<std::int32_t>(*job)) | line;
}

std::int32_t OperatorDesk::current_line() const {
  if (program() == nullptr) return 0;
  const std::int32_t page = link_.page(pendant::Page::kLine);
  const std::int32_t line = program()->kind == Content::kGcode ? page : pendant::kLineLine.of(page);
  return place_of(line) == page ? line : 0;
}

bool OperatorDesk::has_breakpoint(std::int32_t line) const {
  const std::optional<std::int32_t> place = place_of(line);
  return place && link_.has_breakpoint(*place);
}

void OperatorDesk::step(int, Time) {
  if (link_.state() == State::kHold) return send(Opcode::kStep);
  start(RunMode::kSingleSteps, 0);
}

void OperatorDesk::command(int opcode, Time) {
  send(static_cast<Opcode>(opcode));
}

void OperatorDesk::send(Opcode opcode, std::uint8_t parameter, std::int32_t payload) {
  if (!link_.press({.opcode = opcode, .parameter = parameter, .payload = payload})) {
    link_.say(link_.connected() ? "too many commands wait" : "no connection");
  }
}

int OperatorDesk::jog_percent() const {
  return kJogPercents[jog_speed_];
}

std::optional<std::int32_t> OperatorDesk::increment(std::size_t axis) const {
  const Step& step = kSteps[step_];
  const bool joint = link_.coordinates() == code(pendant::System::kJoints);
  if (joint && robot_ == nullptr) return std::nullopt;
  const double units = joint                 ? pulses_of(robot_->axes[axis], step.deg)
                       : axis >= kFirstAngle ? step.deg * 1e4
                                             : step.mm * 1e3;
  return std::max(1, static_cast<std::int32_t>(std::lround(units)));
}

std::string OperatorDesk::step_text() const {
  return step_ == 0 ? std::string{"continuous"} : fmt::format("{} deg / {} mm", kSteps[step_].deg, kSteps[step_].mm);
}

std::string OperatorDesk::joint_text(std::size_t joint) const {
  const std::int32_t pulses = link_.page(pendant::Page::kJoint, joint);
  return robot_ == nullptr ? fmt::format("{}", pulses)
                           : fmt::format("{:.4f}", pulses / pulses_of(robot_->axes[joint], 1.0));
}

}  // namespace armature::cosim
