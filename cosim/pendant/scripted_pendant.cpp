#include "cosim/pendant/scripted_pendant.hpp"

#include <fmt/format.h>

#include "controller/base/timebase.hpp"
#include "controller/base/words.hpp"
#include "controller/pendant/parts/estop_detector.hpp"
#include "controller/pendant/protocol/command_link.hpp"
#include "cosim/pendant/step_frames.hpp"

namespace armature::cosim {
namespace {

using pendant::Frame;
using pendant::Opcode;
using pendant::Status;
using Time = ScriptedPendant::Time;

// The controller then has started its serial line.
constexpr Time kStart{1'000};
constexpr Time kJogEvery{40'000};
constexpr Time kAskEvery{10'000};
// Four characters without a byte end a frame; a poll takes 200 us.
constexpr int kSilentPolls = 3;

Time to_time(Cycles cycles) {
  return Time{cycles.value() / (kClkFreqHz / 1'000'000)};
}
Time of_seconds(double seconds) {
  return Time{static_cast<std::int64_t>(seconds * 1e6)};
}

// An act that reads only, and asks again when the line was cut.
bool only_asks(PendantAct act) {
  return act == PendantAct::kWait || act == PendantAct::kReadMessage;
}

std::string_view status_name(Status status) {
  return pendant::kStatusNames[static_cast<std::size_t>(status)];
}

}  // namespace

ScriptedPendant::ScriptedPendant(const PendantSpec& spec, const RobotSpec& robot, std::uint64_t seed, Listener listener)
    : spec_{spec}, robot_{robot}, random_{seed}, listener_{std::move(listener)} {}

void ScriptedPendant::exchange(Cycles now, std::size_t room, std::vector<std::uint8_t>& in) {
  now_ = to_time(now);
  if (++silent_polls_ > kSilentPolls) receiver_.discard();
  if (!failure_ && now_ >= kStart) act();
  for (; room > 0 && !out_.empty(); --room, out_.pop_front()) {
    if (const auto byte = through_the_line(out_.front())) in.push_back(*byte);
  }
}

void ScriptedPendant::send(std::uint8_t byte) {
  silent_polls_ = 0;
  const std::optional<std::uint8_t> received = through_the_line(byte);
  if (!received) return;
  if (const auto bytes = receiver_.push(*received)) on_frame(pendant::decode(*bytes));
}

std::optional<std::uint8_t> ScriptedPendant::through_the_line(std::uint8_t byte) {
  if (spec_.lost_percent > 0 && random_.chance(spec_.lost_percent / 100)) return std::nullopt;
  if (spec_.flipped_percent > 0 && random_.chance(spec_.flipped_percent / 100)) {
    return static_cast<std::uint8_t>(byte ^ 1u << random_.next() % 8);
  }
  return byte;
}

void ScriptedPendant::on_frame(const Frame& frame) {
  if (failure_) return;
  const PendantStepSpec* current = step();
  if (frame.opcode == Opcode::kEstop && begun_ && current != nullptr && current->act == PendantAct::kEstop) {
    return complete_step("acknowledged");
  }
  if (text_) text_->on_reply(frame, now_);
  if (sender_.on_reply(frame)) on_reply(frame);
}

void ScriptedPendant::on_reply(const Frame& reply) {
  if (!in_session_) {
    in_session_ = reply.status() == Status::kOk;
    return;
  }
  const PendantStepSpec* current = step();
  if (!of_step_ || current == nullptr) return;
  if (reply.status() == Status::kBadSequence) return fail("the controller expected another sequence number");
  const bool last = to_send_.empty() && (!text_ || reply.status() != Status::kOk);
  if (current->act == PendantAct::kWait) {
    if (reply.status() == Status::kOk &&
        pendant::kStateNames.at(static_cast<std::size_t>(pendant::kStateState.of(reply.payload))) == current->state) {
      complete_step(current->state);
    }
    return;
  }
  if (current->act == PendantAct::kReadMessage) return on_page(*current, reply);
  const std::string_view expected = last ? std::string_view{current->reply} : status_name(Status::kOk);
  if (status_name(reply.status()) != expected) {
    return fail(
        fmt::format("the reply is `{}` ({}), expected `{}`", status_name(reply.status()), reply.payload, expected));
  }
  if (current->act != PendantAct::kJog && last) complete_step(fmt::format("{} ({})", expected, reply.payload));
}

void ScriptedPendant::act() {
  if (sender_.idle() && sender_.lost() && in_session_) {
    in_session_ = false;
    if (of_step_ && step() != nullptr && !only_asks(step()->act)) {
      return fail("no reply after four transmissions");
    }
  }
  if (const auto again = sender_.poll(now_)) put(*again);
  if (!sender_.idle()) return;
  of_step_ = false;
  if (!in_session_) {
    return command({.opcode = Opcode::kHeartbeat, .parameter = pendant::kBeginSession, .payload = ++session_});
  }
  if (const PendantStepSpec* current = step(); current != nullptr && now_ >= of_seconds(current->at_s)) {
    if (!begun_) begin_step(*current);
    if (!failure_) continue_step(*current);
  }
  if (sender_.idle() && now_ - last_command_ >= kHeartbeatEvery) {
    of_step_ = false;
    command({.opcode = Opcode::kHeartbeat});
  }
}

void ScriptedPendant::begin_step(const PendantStepSpec& step) {
  begun_ = true;
  began_ = press_again_ = now_;
  to_send_.clear();
  text_.reset();
  for (const Frame& frame : frames_of(step, robot_)) to_send_.push_back(frame);
  if (step.act == PendantAct::kDownload) text_.emplace(step.text);
  if (step.act == PendantAct::kReadMessage) reader_.begin();
}

void ScriptedPendant::continue_step(const PendantStepSpec& step) {
  const double within_ms = step.within_ms.value_or(step.act == PendantAct::kDownload ? kDownloadWithinMs : kWithinMs);
  if (step.act != PendantAct::kJog && now_ - began_ > of_seconds(within_ms * 1e-3)) {
    return fail(too_late(step, within_ms));
  }
  switch (step.act) {
    case PendantAct::kSend:
    case PendantAct::kMove:
      return send_next();
    case PendantAct::kDownload:
      return continue_download();
    case PendantAct::kWait:
      if (now_ < press_again_) return;
      press_again_ = now_ + kAskEvery;
      of_step_ = true;
      return command({.opcode = Opcode::kGetStatus});
    case PendantAct::kJog:
      return continue_jog(step);
    case PendantAct::kEstop:
      return press_estop();
    case PendantAct::kReadMessage:
      return read_message();
  }
}

std::string ScriptedPendant::too_late(const PendantStepSpec& step, double within_ms) const {
  std::string text = fmt::format("not complete within {} ms", within_ms);
  if (step.act == PendantAct::kReadMessage) {
    text += fmt::format(": the controller has {}", message_text(reader_.message().value_or(PendantMessage{})));
  }
  return text;
}

void ScriptedPendant::read_message() {
  if (now_ < press_again_) return;
  const std::optional<std::uint8_t> page = reader_.next();
  if (!page) return;
  of_step_ = true;
  command({.opcode = Opcode::kGetStatus, .parameter = *page});
}

// Another message is read again until it is the expected one.
void ScriptedPendant::on_page(const PendantStepSpec& step, const Frame& reply) {
  reader_.on_page(reply.payload);
  if (reader_.next()) return;
  const PendantMessage& message = *reader_.message();
  const std::string_view kind = pendant::kMessageKindNames.at(static_cast<std::size_t>(message.header.kind));
  if (kind == step.kind && (step.message.empty() || message.text == step.message))
    return complete_step(message_text(message));
  press_again_ = now_ + kAskEvery;
  reader_.begin();
}

void ScriptedPendant::send_next() {
  if (to_send_.empty()) return;
  of_step_ = true;
  command(to_send_.front());
  to_send_.pop_front();
}

void ScriptedPendant::continue_download() {
  if (text_ && to_send_.empty()) {
    while (const auto piece = text_->poll(now_)) put(*piece);
    if (!text_->complete()) return;
    to_send_.push_back({.opcode = Opcode::kProgramCommit, .payload = text_->check()});
    text_.reset();
  }
  send_next();
}

void ScriptedPendant::continue_jog(const PendantStepSpec& step) {
  if (now_ < press_again_) return;
  press_again_ = now_ + kJogEvery;
  if (now_ - began_ < of_seconds(step.for_s)) {
    of_step_ = true;
    return command(jog_frame(step));
  }
  complete_step(step.release ? "released" : "silent");
  if (step.release) command({.opcode = Opcode::kJogStop});
}

void ScriptedPendant::press_estop() {
  if (now_ < press_again_) return;
  press_again_ = now_ + kEstopEvery;
  out_.insert(out_.end(), pendant::kEstopBytes, pendant::kEstopByte);
}

void ScriptedPendant::complete_step(const std::string& how) {
  listener_(
      fmt::format("{}: {} after {:.1f} ms", name_of_step(), how, static_cast<double>((now_ - began_).count()) * 1e-3));
  ++next_step_;
  begun_ = false;
  of_step_ = false;
}

void ScriptedPendant::fail(const std::string& why) {
  failure_ = fmt::format("{}: {}", name_of_step(), why);
}

std::optional<std::string> ScriptedPendant::unfinished() const {
  if (failure_ || step() == nullptr) return failure_;
  return fmt::format("{}: {} at the end of the run", name_of_step(), begun_ ? "not complete" : "not begun");
}

std::string ScriptedPendant::name_of_step() const {
  const PendantStepSpec& current = *step();
  const std::string_view act = word_of(current.act);
  const std::string& what = current.act == PendantAct::kWait          ? current.state
                            : current.act == PendantAct::kMove        ? current.path
                            : current.act == PendantAct::kDownload    ? current.file
                            : current.act == PendantAct::kReadMessage ? current.message
                                                                      : current.command;
  return fmt::format("pendant.step[{}] (line {}) {}{}{}", next_step_, current.line, act, what.empty() ? "" : " ", what);
}

void ScriptedPendant::command(const Frame& frame) {
  last_command_ = now_;
  put(sender_.send(frame, now_));
}

void ScriptedPendant::put(const pendant::FrameBytes& bytes) {
  out_.insert(out_.end(), bytes.begin(), bytes.end());
}

}  // namespace armature::cosim
