#include "cosim/serial/serial_line.hpp"

#include <algorithm>
#include <utility>

namespace armature::cosim {

SerialLine::SerialLine(const SerialFormat& format, std::vector<ScriptedItem> script, Listener listener,
                       SerialPeer* peer)
    : format_{format},
      sender_{format},
      receiver_{format},
      script_{std::move(script)},
      listener_{std::move(listener)},
      peer_{peer} {}

std::optional<Cycles> SerialLine::next_event() const {
  std::optional<Cycles> next = sender_.next_event();
  const auto consider = [&next](std::optional<Cycles> event) {
    if (event && (!next || *event < *next)) next = event;
  };
  consider(receiver_.next_event());
  if (next_in_script_ < script_.size()) consider(script_[next_in_script_].at);
  if (peer_ != nullptr) consider(next_poll_);
  return next;
}

void SerialLine::advance(Cycles now) {
  while (next_in_script_ < script_.size() && script_[next_in_script_].at <= now) {
    sender_.push(script_[next_in_script_++].item, now);
  }
  if (peer_ != nullptr && next_poll_ <= now) poll(now);
  sender_.advance(now);
  receiver_.advance(now);
  report();
}

void SerialLine::on_level(Cycles now, bool txd) {
  if (std::exchange(txd_, txd) == txd) return;
  receiver_.on_level(now, txd);
  report();
}

void SerialLine::poll(Cycles now) {
  from_peer_.clear();
  peer_->exchange(now, kMaxWaiting - std::min(kMaxWaiting, sender_.waiting()), from_peer_);
  for (const std::uint8_t byte : from_peer_) sender_.push({.data = byte}, now);
  next_poll_ = now + kPollCycles;
}

void SerialLine::report() {
  while (const auto started = sender_.pop_started()) {
    const LineItem& item = started->item;
    if (item.kind == LineItem::Kind::kGap) continue;
    SerialEvent event;
    event.at = started->at;
    event.is_break = item.kind == LineItem::Kind::kBreak;
    event.byte = event.is_break ? std::uint8_t{0} : static_cast<std::uint8_t>(item.data & format_.mask());
    event.parity_error = item.wrong_parity && format_.has_parity();
    event.framing_error = item.no_stop;
    event.baud_error_ppm = item.baud_error_ppm;
    event.break_duration = item.duration;
    listener_(event);
  }
  if (const auto received = receiver_.pop()) {
    SerialEvent event;
    event.at = received->end;
    event.direction = SerialDirection::kTx;
    event.byte = received->data;
    event.parity_error = received->parity_error;
    event.framing_error = received->framing_error;
    event.is_break = received->is_break;
    listener_(event);
    if (peer_ != nullptr && !event.is_break) peer_->send(event.byte);
  }
}

}  // namespace armature::cosim
