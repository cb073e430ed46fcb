// The commands for programs.
#include <algorithm>

#include "controller/pendant/pendant_client.hpp"

namespace armature::pendant {
namespace {

// A program is loaded in slices, because an emergency stop must not wait for it.
constexpr std::int64_t kLinesOfSlice = 50;

template <class One, class Other>
constexpr bool equal(One one, Other other) noexcept {
  return static_cast<int>(one) == static_cast<int>(other);
}
using Mode = ProgramClient::Mode;
static_assert(equal(RunMode::kOnce, Mode::kOnce) && equal(RunMode::kSingleSteps, Mode::kSingleSteps) &&
              equal(RunMode::kAgain, Mode::kAgain));

constexpr Answer accepted(bool order) noexcept {
  return {.status = order ? Status::kOk : Status::kBusy};
}

}  // namespace

Answer PendantClient::program_command(const Frame& command, RegisterBus& bus) noexcept {
  gave_ = true;
  switch (command.opcode) {
    case Opcode::kProgramBegin: {
      const Answer answer = store_.begin(static_cast<Content>(command.parameter), command.payload);
      use_stored_program(false);
      return answer;
    }
    case Opcode::kProgramCommit:
      return load_program(command.payload, bus);
    case Opcode::kProgramCancel:
      store_.cancel();
      return {};
    case Opcode::kProgramSelect:
      return store_.select(command.parameter);
    case Opcode::kRun:
      return run(static_cast<Mode>(command.parameter), static_cast<std::uint32_t>(command.payload));
    case Opcode::kHold:
      return accepted(program_.hold());
    case Opcode::kResume:
      return accepted(program_.resume());
    case Opcode::kStep:
      return accepted(program_.step());
    case Opcode::kAbort:
      return accepted(program_.abort());
    case Opcode::kSetBreakpoint:
      return set_breakpoint(static_cast<BreakpointAction>(command.parameter),
                            static_cast<ProgramPlace>(command.payload));
    default:
      return {.status = Status::kUnknown};
  }
}

Answer PendantClient::set_breakpoint(BreakpointAction action, ProgramPlace line) noexcept {
  Breakpoints& all = program_.breakpoints();
  if (program_.state() == ProgramClient::State::kIdle) return {.status = Status::kCheckFail};
  if (action == BreakpointAction::kRemoveAll) {
    all.clear();
  } else {
    if (!program_.has_line(line)) return {.status = Status::kRange};
    if (action == BreakpointAction::kRemove) all.remove(line);
    if (action == BreakpointAction::kSet && !all.add(line)) {
      return {Status::kStoreFull, static_cast<std::int32_t>(Breakpoints::kMax)};
    }
  }
  return {.payload = static_cast<std::int32_t>(all.size())};
}

Answer PendantClient::load_program(std::int32_t check, RegisterBus& bus) noexcept {
  const Answer answer = store_.commit(check);
  for (std::int64_t left = store_.lines_read(); left > 0; left -= kLinesOfSlice) {
    bus.charge(Work::kProgramStep, std::min(left, kLinesOfSlice));
    line_.poll(bus);
  }
  if (answer.status != Status::kCheckFail) use_stored_program(true);
  return answer;
}

// `loaded`: another one than before, or none because of an error.
void PendantClient::use_stored_program(bool loaded) noexcept {
  Interpreter* program = store_.program();
  if (program == nullptr && (stored_program_ || loaded)) program_.clear();
  if (program != nullptr && loaded) program_.set(*program, std::nullopt);
  stored_program_ = program != nullptr;
}

Answer PendantClient::run(ProgramClient::Mode mode, std::uint32_t line) noexcept {
  if (program_.state() == ProgramClient::State::kIdle) return {.status = Status::kCheckFail};
  if (store_.has_gcode() && !coordinates_.defined()) return {.status = Status::kRange};
  store_.set_gcode_frame(coordinates_.user_frame());
  mine_ = false;
  runs_ = program_.run(mode, line);
  return {.status = runs_ ? Status::kOk : Status::kRange};
}

// With the profile `extended` a program that the pendant runs is held when the line is silent.
bool PendantClient::watches_program() const noexcept {
  return runs_ && config_.profile == Profile::kExtended && program_.state() == ProgramClient::State::kRunning;
}

}  // namespace armature::pendant
