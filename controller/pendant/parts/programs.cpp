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
  if (!receiver_.begin(size)) return {Status::kStoreFull, static_cast<std::int32_t>(kMaxCharacters)};
  content_ = content;
  if (store_.drop_sent_gcode()) client_.clear();  // its text is overwritten
  return {};
}

Answer Programs::commit(std::int32_t check, PendantLine& line, RegisterBus& bus) noexcept {
  const bool good = receiver_.complete() && receiver_.check() == check;
  const std::string_view text{receiver_.text().data(), receiver_.text().size()};
  receiver_.cancel();
  if (!good) return {.status = Status::kCheckFail};
  Answer answer;
  if (content_ == Content::kGcode) {
    store_.load_sent_gcode(text);
  } else {
    answer = load_job(text);
    std::int64_t left = std::count(text.begin(), text.end(), '\n') + 1;
    for (; left > 0; left -= kLinesOfSlice) {
      bus.charge(Work::kProgramStep, std::min(left, kLinesOfSlice));
      line.poll(bus);
    }
  }
  if (Program* program = store_.program()) {
    client_.set(*program, std::nullopt);
  } else {
    client_.clear();
  }
  return answer;
}

Answer Programs::load_job(std::string_view text) noexcept {
  switch (store_.load_sent_job(text, content_ == Content::kFurtherJob)) {
    case ProgramStore::Loaded::kYes:
      return {.payload = static_cast<std::int32_t>(store_.last_job())};
    case ProgramStore::Loaded::kFull:
      return {Status::kStoreFull, static_cast<std::int32_t>(store_.error_line())};
    case ProgramStore::Loaded::kError:
      break;
  }
  return {Status::kParseError, static_cast<std::int32_t>(store_.error_line())};
}

Answer Programs::select(std::size_t job) noexcept {
  if (!store_.select(job)) return {.status = Status::kRange};
  return {.payload = static_cast<std::int32_t>(job)};
}

Status Programs::may_run(const Coordinates& selected) const noexcept {
  if (client_.state() == ProgramClient::State::kIdle) return Status::kCheckFail;
  return store_.has_sent_gcode() && !selected.defined() ? Status::kRange : Status::kOk;
}

Answer Programs::run(RunMode mode, std::uint32_t line, std::optional<FrameId> user) noexcept {
  store_.set_sent_gcode_frame(user);
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
