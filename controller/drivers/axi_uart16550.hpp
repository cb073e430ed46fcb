// AXI UART 16550 v2.0: a serial line with two FIFOs of 16 bytes. No call waits for the line.
//
// Reading the line status clears the error bits, so the driver keeps those that send() has met until receive() tells
// them with their character; that is all it remembers of the block.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "controller/core/timebase.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/regs/soc_map.hpp"

namespace armature {

class AxiUart16550 {
 public:
  static constexpr std::size_t kFifoBytes = 16;
  static constexpr std::size_t kTriggerBytes = 8;  // Vo 2021, section 4.1: one interrupt for eight bytes

  enum class Parity : std::uint8_t { kNone, kOdd, kEven, kMark, kSpace };
  struct Format {
    std::uint8_t data_bits = 8;  // 5..8
    Parity parity = Parity::kNone;
    bool long_stop = false;  // two stop bits; one and a half with five data bits
  };

  struct Errors {
    bool overrun = false;     // a character was lost: the receive FIFO was full
    bool parity = false;      // of the character; the FIFO keeps it
    bool framing = false;     // it had no stop bit
    bool line_break = false;  // it is no character: the line was low all the time
    [[nodiscard]] bool any() const noexcept { return overrun || parity || framing || line_break; }
    friend bool operator==(const Errors&, const Errors&) = default;
  };

  struct Received {
    std::size_t count = 0;
    Errors errors;  // parity, framing and break of the last of them; overrun of any time since the last call
  };

  // What wants attention most, as IIR codes it.
  enum class Source : std::uint8_t {
    kModem = 0x0,
    kNone = 0x1,
    kSendEmpty = 0x2,
    kReceived = 0x4,  // the FIFO has reached its trigger
    kLineStatus = 0x6,
    kReceiveTimeout = 0xC,  // the FIFO has fewer, and nothing has come for four characters
  };

  struct InterruptEnables {
    bool received = false;  // trigger and time-out
    bool send_empty = false;
    bool line_status = false;
  };

  // `base` is the vendor's, 0x1000 below the first register.
  explicit AxiUart16550(RegisterBus& bus, RegAddr base = {regs::soc::kAxiUart16550Base}) noexcept
      : bus_{bus}, base_{base} {}

  // The divisor nearest to clock / (16 * baud); 0 when the rate would be wrong by more than 3 % or is not positive. At
  // 50 MHz 115200 gives 27 (0.5 % fast), 921600 gives none.
  [[nodiscard]] static constexpr std::uint32_t divisor(std::int32_t baud) noexcept {
    if (baud <= 0) return 0;
    const std::int64_t sixteenth = std::int64_t{16} * baud;
    const std::int64_t nearest = (kClkFreqHz + sixteenth / 2) / sixteenth;
    const std::int64_t error = kClkFreqHz - nearest * sixteenth;  // of the clock that the rate would need
    const bool good =
        nearest >= 1 && nearest <= 0xFFFF && (error < 0 ? -error : error) * 100 <= 3 * nearest * sixteenth;
    return good ? static_cast<std::uint32_t>(nearest) : 0;
  }

  // Sets rate and format, empties both FIFOs, sets the receive trigger to kTriggerBytes and disables all interrupts.
  // False, and nothing is touched, when divisor(baud) is 0 or the format has other than 5..8 data bits.
  [[nodiscard]] bool configure(std::int32_t baud, const Format& format) noexcept;

  // Hands over as many bytes as there is certainly room for: up to kFifoBytes when the FIFO is empty, else none.
  // Returns how many.
  [[nodiscard]] std::size_t send(std::span<const std::uint8_t> bytes) noexcept;

  // True when the last bit of everything has left.
  [[nodiscard]] bool sent() noexcept;

  // Takes waiting characters until there are none, `bytes` is full, or one has an error. A break is a byte 0.
  [[nodiscard]] Received receive(std::span<std::uint8_t> bytes) noexcept;

  void enable(const InterruptEnables& enables) noexcept;

  // The most urgent source among those enabled; kSendEmpty is thereby acknowledged, the others when their cause is
  // gone: receive() removes kReceived, kReceiveTimeout and kLineStatus.
  [[nodiscard]] Source pending() noexcept;

  // Holds the line low, at once and until called with false.
  void send_break(bool on) noexcept;

 private:
  std::uint32_t line_status() noexcept;

  RegisterBus& bus_;
  RegAddr base_;
  std::uint32_t kept_errors_ = 0;  // of LSR, not told yet
};

}  // namespace armature
