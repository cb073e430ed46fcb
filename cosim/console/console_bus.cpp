#include "cosim/console/console_bus.hpp"

#include <algorithm>

namespace armature::cosim {

std::uint32_t ConsoleBus::access(const BusRequest& request) {
  const Cycles last = soc_.now() + soc_.access_timeout();
  soc_.start(request);
  while (!soc_.has_response() && soc_.now() < last) step(last);
  const auto response = soc_.pop_response();
  failures_ += response && response->error == BusError::kNone ? 0 : 1;
  latest_access_ = {.instructions = instructions_(), .clocks = soc_.now()};
  return response ? response->data : 0;
}

Interrupts ConsoleBus::wait_for_interrupt(Interrupts mask) noexcept {
  const auto lines = static_cast<std::uint32_t>(mask & (Interrupts::kTimer | Interrupts::kUart | Interrupts::kGpio));
  while (lines != 0 && soc_.now() < longest_) {
    const std::uint32_t active = soc_.interrupts() & lines;
    if (active != 0) return static_cast<Interrupts>(active);
    step(longest_);
  }
  return Interrupts::kNone;
}

void ConsoleBus::charge(Work work, std::int64_t /*times*/) noexcept {
  if (work != Work::kInverse || measured_) return;
  measured_ = true;
  inverse_ = {.instructions = instructions_() - latest_access_.instructions,
              .clocks = soc_.now() - latest_access_.clocks};
}

void ConsoleBus::pass(Cycles duration) noexcept {
  const Cycles end = soc_.now() + duration;
  while (soc_.now() < end) step(end);
}

bool ConsoleBus::receive_until(std::string_view end) {
  while (!text_.ends_with(end) && soc_.now() < longest_) step(longest_);
  return text_.ends_with(end);
}

// Up to `limit`, to a change of a pin or to the end of a character or an access.
void ConsoleBus::step(Cycles limit) {
  const Cycles next = std::min(limit, receiver_.next_event().value_or(limit));
  const bool changed = soc_.advance(next, StopOn::kPinChange);
  if (changed && soc_.outputs().uart_txd != txd_) {
    txd_ = !txd_;
    receiver_.on_level(soc_.now(), txd_);
    take_character();
  }
  if (const auto due = receiver_.next_event(); due && *due <= soc_.now()) {
    receiver_.advance(soc_.now());
    take_character();
  }
}

void ConsoleBus::take_character() {
  const auto received = receiver_.pop();
  if (!received) return;
  failures_ += received->is_break || received->framing_error || received->parity_error ? 1 : 0;
  text_ += static_cast<char>(received->data);
}

}  // namespace armature::cosim
