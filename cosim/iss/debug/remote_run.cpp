#include "cosim/iss/debug/remote_run.hpp"

#include <algorithm>

#include "cosim/snapshot/copied_process.hpp"

namespace armature::cosim::iss {
namespace {

std::string text_of(const DebugAnswer& answer) {
  return {answer.bytes.begin(), answer.bytes.begin() + answer.size};
}

}  // namespace

RemoteRun::RemoteRun(const Scenario& scenario, const DebuggedRunOptions& options) {
  auto [ours, of_run] = MessageChannel::pair();
  process_ = copy_this_process(of_run.descriptor());
  if (process_ == 0) serve_debugged_run(scenario, options, of_run);
  channel_ = std::move(ours);
  of_run.close();
}

RemoteRun::~RemoteRun() {
  channel_.close();
  wait_for_end(process_);
}

std::optional<Stop> RemoteRun::hear() {
  const std::optional<DebugAnswer> told = channel_.receive<DebugAnswer>();
  if (!told) {
    ended_ = true;
    if (end_text_.empty()) end_text_ = "the process of the run has ended\n";
    return Stop{.why = Stop::Why::kFailed};
  }
  if (told->kind == DebugAnswer::Kind::kText) end_text_ += text_of(*told);
  if (told->kind == DebugAnswer::Kind::kFound) continue_search(*told);
  if (told->kind != DebugAnswer::Kind::kStopped) return std::nullopt;
  position_ = told->position;
  before_ = told->before;
  ended_ = told->stop.is_last();
  return told->stop;
}

// A run that has ended has no more memory.
DebugAnswer RemoteRun::ask(const DebugRequest& request) {
  std::optional<DebugAnswer> answer;
  if (!ended_ && channel_.send(request)) answer = channel_.receive<DebugAnswer>();
  if (!answer) ended_ = true;
  return answer.value_or(DebugAnswer{.done = false});
}

Registers RemoteRun::registers(int core) {
  return ask({.kind = DebugRequest::Kind::kRegisters, .core = core}).registers;
}

bool RemoteRun::write_register(int core, int number, std::uint64_t value) {
  return ask({.kind = DebugRequest::Kind::kWriteRegister, .core = core, .number = number, .value = value}).done;
}

std::vector<std::uint8_t> RemoteRun::read_memory(std::uint32_t address, std::uint32_t bytes) {
  std::vector<std::uint8_t> read;
  while (read.size() < bytes) {
    const auto done = static_cast<std::uint32_t>(read.size());
    const std::uint32_t part = std::min<std::uint32_t>(bytes - done, kMessageBytes);
    const DebugAnswer answer = ask({.kind = DebugRequest::Kind::kRead, .address = address + done, .size = part});
    read.insert(read.end(), answer.bytes.begin(), answer.bytes.begin() + answer.size);
    if (answer.size < part) break;
  }
  return read;
}

bool RemoteRun::write_memory(std::uint32_t address, std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const auto part = bytes.first(std::min(bytes.size(), kMessageBytes));
    DebugRequest request{.kind = DebugRequest::Kind::kWrite, .address = address};
    request.size = static_cast<std::uint32_t>(part.size());
    std::ranges::copy(part, request.bytes.begin());
    if (!ask(request).done) return false;
    address += request.size;
    bytes = bytes.subspan(part.size());
  }
  return true;
}

std::string RemoteRun::state(int core) {
  return text_of(ask({.kind = DebugRequest::Kind::kState, .core = core}));
}

std::string RemoteRun::monitor(std::string_view command) {
  DebugRequest request{.kind = DebugRequest::Kind::kMonitor};
  request.size = static_cast<std::uint32_t>(std::min(command.size(), kMessageBytes));
  std::copy_n(command.begin(), request.size, request.bytes.begin());
  return text_of(ask(request));
}

void RemoteRun::resume(const Resume& how, std::span<const StopPoint> points) {
  wanted_ = {.how = how, .count = points.size()};
  std::ranges::copy(points, wanted_.points.begin());
  if (how.how == Resume::How::kStepBack) {
    const std::int64_t before = before_.at(static_cast<std::size_t>(how.core));
    go_back(std::max<std::int64_t>(before, 0), {.why = before < 0 ? Stop::Why::kBeginning : Stop::Why::kStep});
  } else if (how.how == Resume::How::kBack) {
    search_ends_ = false;
    search(position_);
  } else {
    tell({.kind = DebugRequest::Kind::kResume, .go_on = wanted_});
  }
}

// Before the position `end`.
void RemoteRun::search(std::int64_t end) {
  if (end == 0) return go_back(0, {.why = Stop::Why::kBeginning});
  tell({.kind = DebugRequest::Kind::kSearchBack, .go_on = wanted_, .position = end, .from = end - 1});
}

void RemoteRun::continue_search(const DebugAnswer& found) {
  if (found.done) return go_back(found.position, found.stop);
  if (search_ends_) return go_back(found.from, {.why = Stop::Why::kInterrupt});
  search(found.from);
}

void RemoteRun::go_back(std::int64_t position, const Stop& stop) {
  tell({.kind = DebugRequest::Kind::kGoBack, .position = position, .from = position, .stop = stop});
}

void RemoteRun::detach() {
  tell({.kind = DebugRequest::Kind::kDetach});
}

void RemoteRun::interrupt() {
  search_ends_ = true;
  if (wanted_.how.how == Resume::How::kBack || wanted_.how.how == Resume::How::kStepBack) return;
  tell({.kind = DebugRequest::Kind::kInterrupt});
}

}  // namespace armature::cosim::iss
