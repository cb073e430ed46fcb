#include "controller/drivers/axi_uart16550.hpp"

#include <algorithm>

#include "controller/regs/axi_uart16550_regs.hpp"

namespace armature {
namespace {

using namespace regs::axi_uart16550;
using regs::extract;
using regs::insert;

// Registers that share an offset (LCR.dlab, or read and write).
constexpr std::uint32_t kThrOffset = kRbrOffset, kDllOffset = kRbrOffset, kDlmOffset = kIerOffset,
                        kFcrOffset = kIirOffset;
constexpr std::uint32_t kSlowestDivisor = 0xFF;

// FCR, which the register description lists as one value.
constexpr std::uint32_t kFcrEnable = 1u << 0, kFcrFlushReceive = 1u << 1, kFcrFlushSend = 1u << 2,
                        kFcrTrigger8 = 2u << 6;
constexpr std::uint32_t kIirSourceMask = 0xF;

constexpr std::uint32_t kErrorMask = kLsrOeMask | kLsrPeMask | kLsrFeMask | kLsrBiMask;

std::uint32_t lcr_of(const AxiUart16550::Format& format) {
  using Parity = AxiUart16550::Parity;
  std::uint32_t lcr = insert(0, kLcrLength, format.data_bits - 5u);
  if (format.long_stop) lcr |= kLcrStopMask;
  if (format.parity != Parity::kNone) lcr |= kLcrParityMask;
  if (format.parity == Parity::kEven || format.parity == Parity::kSpace) lcr |= kLcrEvenMask;
  if (format.parity == Parity::kMark || format.parity == Parity::kSpace) lcr |= kLcrStickMask;
  return lcr;
}

AxiUart16550::Errors errors_of(std::uint32_t lsr) {
  return {.overrun = (lsr & kLsrOeMask) != 0,
          .parity = (lsr & kLsrPeMask) != 0,
          .framing = (lsr & kLsrFeMask) != 0,
          .line_break = (lsr & kLsrBiMask) != 0};
}

}  // namespace

bool AxiUart16550::configure(std::int32_t baud, const Format& format) noexcept {
  const std::uint32_t ratio = divisor(baud);
  if (ratio == 0 || format.data_bits < 5 || format.data_bits > 8) return false;
  const std::uint32_t lcr = lcr_of(format);
  bus_.write32(base_ + kIerOffset, 0);
  bus_.write32(base_ + kLcrOffset, lcr | kLcrDlabMask);
  // The high byte is written while the low byte is 0xFF: a divisor of 1 would receive noise as characters.
  bus_.write32(base_ + kDllOffset, kSlowestDivisor);
  bus_.write32(base_ + kDlmOffset, ratio >> 8);
  bus_.write32(base_ + kDllOffset, ratio & 0xFFu);
  bus_.write32(base_ + kLcrOffset, lcr);
  bus_.write32(base_ + kFcrOffset, kFcrEnable | kFcrFlushReceive | kFcrFlushSend | kFcrTrigger8);
  static_cast<void>(bus_.read32(base_ + kLsrOffset));  // clears old errors
  kept_errors_ = 0;
  return true;
}

std::size_t AxiUart16550::send(std::span<const std::uint8_t> bytes) noexcept {
  if (bytes.empty() || (line_status() & kLsrThreMask) == 0) return 0;
  const std::size_t count = std::min(bytes.size(), kFifoBytes);
  for (const std::uint8_t byte : bytes.first(count)) bus_.write32(base_ + kThrOffset, byte);
  return count;
}

bool AxiUart16550::sent() noexcept {
  return (line_status() & kLsrTemtMask) != 0;
}

AxiUart16550::Received AxiUart16550::receive(std::span<std::uint8_t> bytes) noexcept {
  Received received;
  while (received.count < bytes.size() && (line_status() & kLsrDrMask) != 0) {
    bytes[received.count++] = static_cast<std::uint8_t>(extract(bus_.read32(base_ + kRbrOffset), kRbrValue));
    // The status bits describe the oldest character.
    if ((kept_errors_ & kErrorMask & ~kLsrOeMask) != 0) break;
  }
  received.errors = errors_of(kept_errors_);
  kept_errors_ = 0;
  return received;
}

void AxiUart16550::enable(const InterruptEnables& enables) noexcept {
  bus_.write32(base_ + kIerOffset, (enables.received ? kIerRxDataMask : 0) |
                                       (enables.send_empty ? kIerTxEmptyMask : 0) |
                                       (enables.line_status ? kIerLineStatusMask : 0));
}

AxiUart16550::Source AxiUart16550::pending() noexcept {
  return static_cast<Source>(bus_.read32(base_ + kIirOffset) & kIirSourceMask);
}

std::uint32_t AxiUart16550::line_status() noexcept {
  const std::uint32_t lsr = bus_.read32(base_ + kLsrOffset);
  kept_errors_ |= lsr & kErrorMask;
  return lsr;
}

}  // namespace armature
