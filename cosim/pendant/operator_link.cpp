#include "cosim/pendant/operator_link.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "controller/pendant/parts/estop_detector.hpp"
#include "controller/pendant/protocol/command_link.hpp"

namespace armature::cosim {

using pendant::Content;
using pendant::Frame;
using pendant::Opcode;
using pendant::Status;

namespace {

constexpr OperatorLink::Time kTryEvery{500'000};
// The text of a message is long and seldom new: it is read once.
constexpr std::uint8_t kGroups =
    pendant::kAllPageGroups & ~pendant::kPageGroups[static_cast<std::size_t>(pendant::Page::kMessageText)];

std::string_view command_name(Opcode opcode) {
  const pendant::OpcodeRule* rule = pendant::find_rule(static_cast<std::uint8_t>(opcode));
  return rule == nullptr ? "?" : rule->name;
}

// Commands that the person did not press one by one.
bool is_routine(Opcode opcode) {
  return opcode == Opcode::kHeartbeat || opcode == Opcode::kSetTelemetry || opcode == Opcode::kGetStatus ||
         opcode == Opcode::kJogContinuous || opcode == Opcode::kJogStop;
}

}  // namespace

void OperatorLink::receive(std::span<const std::uint8_t> bytes) {
  for (const std::uint8_t byte : bytes) {
    if (const auto frame = receiver_.push(byte)) on_frame(pendant::decode(*frame));
  }
}

void OperatorLink::on_frame(const Frame& frame) {
  if (frame.kind == pendant::Kind::kTelemetry) {
    if (frame.parameter >= pages_.size()) return;
    pages_[frame.parameter] = frame.payload;
    telemetry_came_ = telemetry_came_ || frame.parameter == static_cast<std::uint8_t>(pendant::Page::kState);
    if (frame.parameter == static_cast<std::uint8_t>(pendant::Page::kMessage)) reader_.on_telemetry(frame.payload);
    if (state() == pendant::State::kEstop) estop_pressed_ = false;
    return;
  }
  if (text_) text_->on_reply(frame, now_);
  if (sender_.on_reply(frame)) on_reply(frame);
}

void OperatorLink::on_reply(const Frame& reply) {
  const Status status = reply.status();
  if (!in_session_) {
    in_session_ = status == Status::kOk;
    if (in_session_) say("connected");
    return;
  }
  if (status == Status::kBadSequence) {
    say("the controller expected another command; pressed keys are dropped");
    return drop_everything();
  }
  if (status != Status::kOk && reply.opcode == Opcode::kJogContinuous) jog_.reset();
  if (status != Status::kOk || !is_routine(reply.opcode)) {
    const std::string detail = reply.payload != 0 ? fmt::format(" ({})", reply.payload) : std::string{};
    say(fmt::format("{}: {}{}", command_name(reply.opcode), pendant::kStatusNames[static_cast<std::size_t>(status)],
                    detail));
  }
  if (status == Status::kOk && reply.opcode == Opcode::kSetBreakpoint) remember_breakpoint();
  if (status == Status::kOk && reply.opcode == Opcode::kGetStatus) remember_page(reply);
  continue_transfer(reply);
}

void OperatorLink::remember_breakpoint() {
  switch (static_cast<pendant::BreakpointAction>(sent_.parameter)) {
    case pendant::BreakpointAction::kRemove:
      breakpoints_.erase(sent_.payload);
      break;
    case pendant::BreakpointAction::kSet:
      breakpoints_.insert(sent_.payload);
      break;
    case pendant::BreakpointAction::kRemoveAll:
      breakpoints_.clear();
      break;
  }
}

void OperatorLink::remember_page(const Frame& reply) {
  if (reader_.next() != sent_.parameter) return;
  const std::int64_t before = reader_.read();
  reader_.on_page(reply.payload);
  if (reader_.read() > before && reader_.message()) say(message_text(*reader_.message()));
}

void OperatorLink::continue_transfer(const Frame& reply) {
  if (reply.opcode == Opcode::kProgramBegin && reply.status() == Status::kOk && gcode_loaded_) forget_programs();
  if (reply.opcode == Opcode::kProgramCommit) remember_program(reply);
  if (transfer_ == Transfer::kBegin && reply.opcode == Opcode::kProgramBegin) {
    transfer_ = reply.status() == Status::kOk ? Transfer::kText : Transfer::kNone;
  } else if (transfer_ == Transfer::kCommit && reply.opcode == Opcode::kProgramCommit) {
    transfer_ = Transfer::kNone;
  }
  if (transfer_ == Transfer::kNone) text_.reset();
}

// Also of a transfer that was broken off here. The program stays as it is when the controller refuses the command.
void OperatorLink::remember_program(const Frame& reply) {
  const Status status = reply.status();
  if (status != Status::kOk && status != Status::kParseError && status != Status::kStoreFull) return;
  has_sent_ = true;
  breakpoints_.clear();
  if (status != Status::kOk || kind_ != Content::kFurtherJob) forget_programs();
  if (status != Status::kOk) return;
  const auto job = static_cast<std::size_t>(reply.payload);
  loaded_.resize(std::max(loaded_.size(), job + 1));
  loaded_[job] = name_;
  gcode_loaded_ = kind_ == Content::kGcode;
}

void OperatorLink::forget_programs() {
  loaded_.clear();
  breakpoints_.clear();
  gcode_loaded_ = false;
}

void OperatorLink::poll(Time now, std::vector<std::uint8_t>& out) {
  now_ = now;
  const auto put = [&out](const pendant::FrameBytes& bytes) { out.insert(out.end(), bytes.begin(), bytes.end()); };
  if (estop_pressed_) {
    if (now < estop_next_) return;
    estop_next_ = now + kEstopEvery;
    out.insert(out.end(), pendant::kEstopBytes, pendant::kEstopByte);
    return;
  }
  if (const auto again = sender_.poll(now)) put(*again);
  if (!sender_.idle()) return;
  if (sender_.lost() && std::exchange(in_session_, false)) {
    say("the controller does not answer");
    if (transfer_ == Transfer::kCommit) forget_programs();  // what it has now is not known
    drop_everything();
  }
  if (transfer_ == Transfer::kText) {
    while (const auto piece = text_->poll(now)) put(*piece);
    if (text_->complete()) {
      transfer_ = Transfer::kCommit;
      waiting_.push_front({.opcode = Opcode::kProgramCommit, .payload = text_->check()});
    }
  }
  if (const std::optional<Frame> command = next_command(now)) {
    sent_ = *command;
    sent_at_ = now;
    put(sender_.send(*command, now));
  }
}

std::optional<Frame> OperatorLink::next_command(Time now) {
  if (!in_session_) {
    if (now < next_try_) return std::nullopt;
    next_try_ = now + kTryEvery;
    session_ = (session_ + 1) & pendant::kLargestPayload;
    asked_for_telemetry_ = false;
    return Frame{.opcode = Opcode::kHeartbeat, .parameter = pendant::kBeginSession, .payload = session_};
  }
  if (!std::exchange(asked_for_telemetry_, true)) {
    return Frame{.opcode = Opcode::kSetTelemetry,
                 .parameter = kGroups,
                 .payload = static_cast<std::int32_t>(kTelemetryPeriod.count() / 1000)};
  }
  if (jog_ && now >= jog_until_) {
    jog_.reset();
    return Frame{.opcode = Opcode::kJogStop};
  }
  if (jog_ && now >= jog_next_) {
    jog_next_ = now + kJogEvery;
    return jog_;
  }
  if (!waiting_.empty()) {
    const Frame command = waiting_.front();
    waiting_.pop_front();
    return command;
  }
  if (const auto page = reader_.next()) return Frame{.opcode = Opcode::kGetStatus, .parameter = *page};
  if (now - sent_at_ >= kHeartbeatEvery) return Frame{.opcode = Opcode::kHeartbeat};
  return std::nullopt;
}

bool OperatorLink::press(const Frame& command) {
  if (!in_session_ || waiting_.size() >= kMaxWaiting) return false;
  waiting_.push_back(command);
  return true;
}

void OperatorLink::jog(std::uint8_t axis, std::int32_t velocity, Time until) {
  if (!in_session_) return;
  const Frame command{.opcode = Opcode::kJogContinuous, .parameter = axis, .payload = velocity};
  if (jog_ != command) jog_next_ = now_;
  jog_ = command;
  jog_until_ = until;
}

void OperatorLink::release_jog() {
  jog_until_ = now_;
}

void OperatorLink::press_estop() {
  drop_everything();
  estop_pressed_ = true;
  estop_next_ = now_;
  say("EMERGENCY STOP");
}

void OperatorLink::let_go() {
  drop_everything();
  if (!in_session_) return;
  if (state() != pendant::State::kRun) {
    waiting_.push_back({.opcode = Opcode::kStop});
  } else if (extended()) {
    waiting_.push_back({.opcode = Opcode::kHold});
  } else {
    press_estop();
  }
}

bool OperatorLink::download(Content kind, std::string name, std::string text) {
  if (downloading()) return false;
  const auto size = static_cast<std::int32_t>(text.size());
  if (!press({.opcode = Opcode::kProgramBegin, .parameter = static_cast<std::uint8_t>(kind), .payload = size}))
    return false;
  text_.emplace(std::move(text), kRepeatAfter);
  name_ = std::move(name);
  kind_ = kind;
  transfer_ = Transfer::kBegin;
  return true;
}

std::optional<std::size_t> OperatorLink::job_of(std::string_view name) const {
  if (!has_sent_) return 0;
  const auto job = std::ranges::find(loaded_, name);
  if (job == loaded_.end()) return std::nullopt;
  return static_cast<std::size_t>(job - loaded_.begin());
}

std::optional<pendant::State> OperatorLink::state() const {
  const auto number = static_cast<std::size_t>(pendant::kStateState.of(page(pendant::Page::kState)));
  if (!telemetry_came_ || number >= pendant::kStateNames.size()) return std::nullopt;
  return static_cast<pendant::State>(number);
}

void OperatorLink::say(std::string message) {
  messages_.push_back(std::move(message));
  if (messages_.size() > kMaxMessages) messages_.pop_front();
}

void OperatorLink::drop_everything() {
  waiting_.clear();
  jog_.reset();
  transfer_ = Transfer::kNone;
  text_.reset();
}

}  // namespace armature::cosim
