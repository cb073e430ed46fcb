#include "cosim/iss/debug/protocol/stub.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "cosim/iss/debug/protocol/hex.hpp"
#include "cosim/iss/debug/protocol/packet.hpp"
#include "cosim/iss/debug/protocol/packet_words.hpp"

namespace armature::cosim::iss {
namespace {

constexpr std::string_view kOk = "OK";
constexpr std::string_view kUnknown;          // what gdb takes as `not supported`
constexpr std::string_view kWrong = "E01";    // the packet is not as the protocol says
constexpr std::string_view kRefused = "E02";  // the run cannot do it

constexpr std::uint32_t kMostBytes = (kLongestPayload - 16) / 2;  // of memory in a packet

std::string_view reason_word(StopPoint::Kind kind) {
  switch (kind) {
    case StopPoint::Kind::kWrite:
      return "watch";
    case StopPoint::Kind::kRead:
      return "rwatch";
    case StopPoint::Kind::kAccess:
      return "awatch";
    case StopPoint::Kind::kBreakpoint:
      break;
  }
  return "swbreak";
}

// A part of a long text, as qXfer asks for it.
std::string part_of(std::string_view text, std::string_view range_text) {
  const auto range = range_of(range_text);
  if (!range) return std::string{kWrong};
  if (range->address >= text.size()) return "l";
  const std::string_view part = text.substr(range->address, std::min<std::size_t>(range->bytes, kMostBytes));
  return (range->address + part.size() < text.size() ? "m" : "l") + std::string{part};
}

}  // namespace

std::optional<std::string> Stub::answer(std::string_view packet) {
  if (runs_) return std::nullopt;  // gdb waits for a stop
  if (packet.empty()) return std::string{};
  if (const auto actions = after(packet, "vCont;")) return resume_by_threads(*actions);
  if (packet == "vCont?") return "vCont;c;C;s;S;r";
  if (packet.starts_with("vKill")) {
    end_ = End::kKilled;
    return std::string{kOk};
  }
  if (packet == "QStartNoAckMode") {
    acknowledges_ = false;
    return std::string{kOk};
  }
  if (packet == "bc") return resume({.how = Resume::How::kBack});
  if (packet == "bs") return resume({.how = Resume::How::kStepBack, .core = core_});
  const std::string_view rest = packet.substr(1);
  switch (packet.front()) {
    case '?':
      return stop_reply();
    case 'g':
      return read_registers();
    case 'G':
      return write_registers(rest);
    case 'p':
      return read_register(rest);
    case 'P':
      return write_register(rest);
    case 'm':
      return read_memory(rest);
    case 'M':
      return write_memory(rest);
    case 'Z':
    case 'z':
      return change_point(packet);
    case 'c':
    case 'C':
      return resume({});
    case 's':
    case 'S':
      return resume({.how = Resume::How::kStep, .core = core_});
    case 'H':
      return select(rest);
    case 'T':
      return std::string{core_of(rest) ? kOk : kWrong};
    case 'D':
      end_ = End::kDetached;
      return std::string{kOk};
    case 'k':
      end_ = End::kKilled;
      return std::nullopt;
    case 'q':
      return query(packet);
    default:
      return std::string{kUnknown};
  }
}

std::string Stub::stopped(const Stop& stop) {
  runs_ = false;
  stop_ = stop;
  core_ = stop.core;
  return stop_reply();
}

void Stub::begin_session() {
  points_.clear();
  acknowledges_ = true;
  end_ = End::kNone;
  core_ = stop_.core;
}

std::string Stub::query(std::string_view packet) {
  if (packet.starts_with("qSupported")) {
    return fmt::format(
        "PacketSize={:x};QStartNoAckMode+;qXfer:features:read+;vContSupported+;swbreak+;hwbreak+;"
        "ReverseStep+;ReverseContinue+",
        kLongestPayload);
  }
  if (const auto range = after(packet, "qXfer:features:read:target.xml:")) return part_of(target_description(), *range);
  if (packet.starts_with("qXfer:")) return "E00";
  if (packet == "qC") return fmt::format("QC{}", core_ + 1);
  if (packet == "qAttached") return "0";  // when gdb quits, it ends the run
  if (packet == "qfThreadInfo") return "m1,2";
  if (packet == "qsThreadInfo") return "l";
  if (const auto thread = after(packet, "qThreadExtraInfo,")) {
    const auto core = core_of(*thread);
    return core ? to_hex(fmt::format("core {}: {}", *core, target_.state(*core))) : std::string{kWrong};
  }
  if (const auto digits = after(packet, "qRcmd,")) return monitor(*digits);
  return std::string{kUnknown};
}

std::string Stub::monitor(std::string_view digits) {
  const auto bytes = bytes_of_hex(digits);
  if (!bytes) return std::string{kWrong};
  const std::string answer = target_.monitor(std::string{bytes->begin(), bytes->end()});
  return answer.empty() ? std::string{kOk} : to_hex(answer);
}

// `gTHREAD` for what follows, `cTHREAD` for s.
std::string Stub::select(std::string_view packet) {
  if (packet.empty()) return std::string{kWrong};
  const std::string_view thread = packet.substr(1);
  if (thread == "0" || thread == "-1") return std::string{kOk};
  const auto core = core_of(thread);
  if (!core) return std::string{kWrong};
  core_ = *core;
  return std::string{kOk};
}

std::string Stub::read_registers() {
  const Registers all = target_.registers(core_);
  std::string text;
  for (int i = 0; i < kRegisters; ++i) text += to_hex(all.at(static_cast<std::size_t>(i)), bytes_of_register(i));
  return text;
}

std::string Stub::write_registers(std::string_view digits) {
  const auto bytes = bytes_of_hex(digits);
  std::size_t all = 0;
  for (int i = 0; i < kRegisters; ++i) all += static_cast<std::size_t>(bytes_of_register(i));
  if (!bytes || bytes->size() != all) return std::string{kWrong};
  std::span<const std::uint8_t> left{*bytes};
  for (int i = 0; i < kRegisters; ++i) {
    const auto size = static_cast<std::size_t>(bytes_of_register(i));
    if (!target_.write_register(core_, i, little_endian(left.first(size)))) return std::string{kRefused};
    left = left.subspan(size);
  }
  return std::string{kOk};
}

std::string Stub::read_register(std::string_view number) {
  const auto i = number_of_hex(number);
  if (!i || *i >= kRegisters) return std::string{kWrong};
  return to_hex(target_.registers(core_).at(*i), bytes_of_register(static_cast<int>(*i)));
}

std::string Stub::write_register(std::string_view assignment) {
  const auto [number, digits] = split(assignment, '=');
  const auto i = number_of_hex(number);
  const auto bytes = bytes_of_hex(digits);
  if (!i || *i >= kRegisters || !bytes) return std::string{kWrong};
  const auto which = static_cast<int>(*i);
  if (bytes->size() != static_cast<std::size_t>(bytes_of_register(which))) return std::string{kWrong};
  return std::string{target_.write_register(core_, which, little_endian(*bytes)) ? kOk : kRefused};
}

std::string Stub::read_memory(std::string_view text) {
  const auto range = range_of(text);
  if (!range) return std::string{kWrong};
  if (range->bytes == 0) return std::string{};
  const std::vector<std::uint8_t> bytes = target_.read_memory(range->address, std::min(range->bytes, kMostBytes));
  return bytes.empty() ? std::string{kRefused} : to_hex(bytes);
}

std::string Stub::write_memory(std::string_view arguments) {
  const auto [text, digits] = split(arguments, ':');
  const auto range = range_of(text);
  const auto bytes = bytes_of_hex(digits);
  if (!range || !bytes || bytes->size() != range->bytes) return std::string{kWrong};
  if (bytes->empty()) return std::string{kOk};
  return std::string{target_.write_memory(range->address, *bytes) ? kOk : kRefused};
}

// `Z0,ADDRESS,BYTES` adds one, z removes it.
std::string Stub::change_point(std::string_view packet) {
  const auto kind = packet.size() > 1 ? point_kind(packet[1]) : std::nullopt;
  if (!kind) return std::string{kUnknown};
  const auto [range_text, conditions] = split(packet.substr(2), ';');
  const auto range = range_text.starts_with(',') ? range_of(range_text.substr(1)) : std::nullopt;
  if (!range || range->bytes == 0 || !conditions.empty()) return std::string{kWrong};
  const StopPoint point{*kind, range->address, range->bytes};
  std::erase(points_, point);
  if (packet.front() == 'z') return std::string{kOk};
  if (points_.size() == kMostStopPoints) return std::string{kRefused};
  points_.push_back(point);
  return std::string{kOk};
}

// `ACTION[:THREAD];...`: for each thread the first one that names it, or that names none.
std::optional<std::string> Stub::resume_by_threads(std::string_view actions) {
  Resume how;
  bool found = false;
  while (!actions.empty()) {
    const auto [action, others] = split(actions, ';');
    actions = others;
    const auto [what, thread] = split(action, ':');
    if (what.empty() || std::string_view{"cCsSr"}.find(what.front()) == std::string_view::npos)
      return std::string{kWrong};
    if (!thread.empty() && thread != "0" && thread != "-1" && !core_of(thread)) return std::string{kWrong};
    const bool continues = what.front() == 'c' || what.front() == 'C';
    if (std::exchange(found, true) && (how.how == Resume::How::kStep || continues)) continue;
    if (continues) continue;
    how = {.how = Resume::How::kStep, .core = core_of(thread).value_or(core_)};
    if (what.front() != 'r') continue;
    const auto [first, last] = split(what.substr(1), ',');
    const auto from = word(first), to = word(last);
    if (!from || !to) return std::string{kWrong};
    how.first = *from;
    how.last = *to;
  }
  if (!found) return std::string{kWrong};
  return resume(how);
}

std::optional<std::string> Stub::resume(const Resume& how) {
  // gdb expects that a watched access of an ARM core is still to be executed, or taken back, and steps over it. Here
  // this has been done.
  const bool watched = stop_.why == Stop::Why::kPoint && stop_.point.kind != StopPoint::Kind::kBreakpoint;
  const bool steps = how.how == Resume::How::kStep || how.how == Resume::How::kStepBack;
  if (watched && steps && how.core == stop_.core && how.last == how.first) {
    return stopped({.why = Stop::Why::kStep, .core = stop_.core});
  }
  runs_ = true;
  target_.resume(how, points_);
  return std::nullopt;
}

std::string Stub::stop_reply() const {
  constexpr int kTrap = 5, kInterrupted = 2;
  switch (stop_.why) {
    case Stop::Why::kEnded:
      return fmt::format("W{:02x}", stop_.exit_code);
    case Stop::Why::kFailed:
      return "X06";
    default:
      break;
  }
  std::string text =
      fmt::format("T{:02x}thread:{};", stop_.why == Stop::Why::kInterrupt ? kInterrupted : kTrap, stop_.core + 1);
  if (stop_.why == Stop::Why::kBeginning) text += "replaylog:begin;";
  if (stop_.why == Stop::Why::kPoint) {
    text += fmt::format("{}:", reason_word(stop_.point.kind));
    if (stop_.point.kind != StopPoint::Kind::kBreakpoint) text += fmt::format("{:x}", stop_.data);
    text += ';';
  }
  return text;
}

}  // namespace armature::cosim::iss
