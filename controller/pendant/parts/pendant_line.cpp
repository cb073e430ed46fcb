#include "controller/pendant/parts/pendant_line.hpp"

#include <array>
#include <cassert>
#include <span>
#include <utility>

#include "controller/drivers/pulse_train.hpp"
#include "controller/drivers/pulse_width.hpp"

namespace armature::pendant {

void PendantLine::start(RegisterBus& bus) noexcept {
  uart_.emplace(bus);
  [[maybe_unused]] const bool configured = uart_->configure(kBaud, {});
  assert(configured);
  uart_->enable({.received = true, .send_empty = true, .line_status = true});
}

void PendantLine::on_interrupt(RegisterBus& bus) noexcept {
  bus.charge(Work::kInterruptEntry);
  poll(bus);
}

void PendantLine::poll(RegisterBus& bus) noexcept {
  using Source = AxiUart16550::Source;
  for (Source source = uart_->pending(); source != Source::kNone; source = uart_->pending()) {
    if (source == Source::kSendEmpty) {
      flush();
    } else {
      read(bus, source == Source::kReceiveTimeout);
    }
  }
}

void PendantLine::read(RegisterBus& bus, bool silent) noexcept {
  std::array<std::uint8_t, AxiUart16550::kFifoBytes> bytes{};
  const AxiUart16550::Received received = uart_->receive(bytes);
  for (const std::uint8_t byte : std::span{bytes}.first(received.count)) {
    if (detector_.push(byte)) stop_pulses(bus);
    static_cast<void>(in_.try_push(byte));  // without room the frame is damaged, and the pendant repeats it
  }
  if (silent || received.errors.any()) static_cast<void>(in_.try_push(kGap));
}

void PendantLine::stop_pulses(RegisterBus& bus) noexcept {
  if (paper_logic_) {
    PulseWidth{bus}.emergency_stop();
  } else {
    PulseTrain{bus}.emergency_stop();
  }
  estop_ = true;
}

bool PendantLine::take_estop() noexcept {
  return std::exchange(estop_, false);
}

std::optional<FrameBytes> PendantLine::next_frame() noexcept {
  while (const std::optional<std::uint16_t> next = in_.try_pop()) {
    if (*next == kGap) {
      receiver_.discard();
    } else if (const std::optional<FrameBytes> frame = receiver_.push(static_cast<std::uint8_t>(*next))) {
      return frame;
    }
  }
  return std::nullopt;
}

void PendantLine::send(const FrameBytes& frame) noexcept {
  if (!has_room(1)) return;
  for (const std::uint8_t byte : frame) static_cast<void>(out_.try_push(byte));
}

void PendantLine::flush() noexcept {
  std::array<std::uint8_t, AxiUart16550::kFifoBytes> bytes{};
  std::size_t count = 0;
  while (count < bytes.size()) {
    const std::uint8_t* next = out_.peek(count);
    if (next == nullptr) break;
    bytes[count++] = *next;
  }
  for (std::size_t sent = uart_->send(std::span{bytes}.first(count)); sent > 0; --sent) out_.drop_front();
}

}  // namespace armature::pendant
