#include "controller/pendant/parts/programs.hpp"

#include <algorithm>

namespace armature::pendant {
namespace {

// A program is loaded in slices, because an emergency stop must not wait for it.
constexpr std::int64_t kLinesOfSlice = 50;

using Mode = ProgramClient::Mode;
constexpr bool equal(RunMode mode, Mode other) noexcept {
  return static_cast<int>(mode) == static_cast<int>(other);
}
static_assert(equal(RunMode::kOnce, Mode::kOnce) && equal(RunMode::kSingleSteps, Mode::kSingleSteps) &&
              equal(RunMode::kAgain, Mode::kAgain));

}  // namespace

Answer Programs::begin(Content content, std::int32_t size) noexcept {
  const Answer answer = store_.begin(content, size);
  use_store(false);
  return answer;
}

Answer Programs::commit(std::int32_t check, PendantLine& line, RegisterBus& bus) noexcept {
  const Answer answer = store_.commit(check);
  for (std::int64_t left = store_.lines_read(); left > 0; left -= kLinesOfSlice) {
    bus.charge(Work::kProgramStep, std::min(left, kLinesOfSlice));
    line.poll(bus);
  }
  if (answer.status != Status::kCheckFail) use_store(true);
  return answer;
}

// `loaded`: another one than before, or none because of an error.
void Programs::use_store(bool loaded) noexcept {
  Program* program = store_.program();
  if (program == nullptr && (from_store_ || loaded)) client_.clear();
  if (program != nullptr && loaded) client_.set(*program, std::nullopt);
  from_store_ = program != nullptr;
}

Status Programs::may_run(const Coordinates& selected) const noexcept {
  if (client_.state() == ProgramClient::State::kIdle) return Status::kCheckFail;
  return store_.has_gcode() && !selected.defined() ? Status::kRange : Status::kOk;
}

Answer Programs::run(RunMode mode, std::uint32_t line, std::optional<FrameId> user) noexcept {
  store_.set_gcode_frame(user);
  started_here_ = client_.run(static_cast<Mode>(mode), line);
  return {.status = started_here_ ? Status::kOk : Status::kRange};
}

Answer Programs::set_breakpoint(BreakpointAction action, ProgramPlace line) noexcept {
  Breakpoints& all = client_.breakpoints();
  if (client_.state() == ProgramClient::State::kIdle) return {.status = Status::kCheckFail};
  if (action == BreakpointAction::kRemoveAll) {
    all.clear();
  } else {
    if (!client_.has_line(line)) return {.status = Status::kRange};
    if (action == BreakpointAction::kRemove) all.remove(line);
    if (action == BreakpointAction::kSet && !all.add(line)) {
      return {Status::kStoreFull, static_cast<std::int32_t>(Breakpoints::kMax)};
    }
  }
  return {.payload = static_cast<std::int32_t>(all.size())};
}

}  // namespace armature::pendant
