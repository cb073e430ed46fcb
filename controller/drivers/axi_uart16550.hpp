// AXI UART 16550 v2.0: a serial line with two FIFOs of 16 bytes. All functions return without waiting for the line.
//
// Reading the line status clears its error bits. So the driver keeps the errors that send() has read until receive()
// returns them with their character. It has no other state.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "controller/base/timebase.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/regs/soc_map.hpp"

namespace armature {

class AxiUart16550 {
 public:
  static constexpr std::size_t kFifoBytes = 16;

  enum class Parity : std::uint8_t { kNone, kOdd, kEven, kMark, kSpace };
  struct Format {
    std::uint8_t data_bits = 8;  // 5..8
    Parity parity = Parity::kNone;
    bool long_stop = false;  // two stop bits; one and a half with five data bits
  };

  struct Errors {
    bool overrun = false;     // a character was lost: the receive FIFO was full
    bool parity = false;      // of the character, which is still received
    bool framing = false;     // the character had no stop bit
    bool line_break = false;  // no character: the line was low for its whole time
    [[nodiscard]] bool any() const noexcept { return overrun || parity || framing || line_break; }
    friend bool operator==(const Errors&, const Errors&) = default;
  };

  struct Received {
    std::size_t count = 0;
    Errors errors;  // parity, framing and break of the last byte; overrun at any time since the last call
  };

  // The pending interrupt source, coded as in IIR.
  enum class Source : std::uint8_t {
    kModem = 0x0,
    kNone = 0x1,
    kSendEmpty = 0x2,
    kReceived = 0x4,  // the FIFO has reached its trigger level
    kLineStatus = 0x6,
    kReceiveTimeout = 0xC,  // the FIFO is below its trigger level and nothing came for four character times
  };

  struct InterruptEnables {
    bool received = false;  // trigger and time-out
    bool send_empty = false;
    bool line_status = false;
  };

  // `base` is the vendor's base address, 0x1000 below the first register.
  explicit AxiUart16550(RegisterBus& bus, RegAddr base = {regs::soc::kAxiUart16550Base}) noexcept
      : bus_{bus}, base_{base} {}

  // The divisor nearest to clock / (16 * baud); 0 when the rate is not positive or its error would exceed 3 %. At 50
  // MHz 115200 gives 27 (0.5 % fast), 921600 gives none.
  [[nodiscard]] static constexpr std::uint32_t divisor(std::int32_t baud) noexcept {
    if (baud <= 0) return 0;
    const std::int64_t sixteenth = std::int64_t{16} * baud;
    const std::int64_t nearest = (kClkFreqHz + sixteenth / 2) / sixteenth;
    const std::int64_t error = kClkFreqHz - nearest * sixteenth;  // relative to the clock that this rate needs
    const bool good =
        nearest >= 1 && nearest <= 0xFFFF && (error < 0 ? -error : error) * 100 <= 3 * nearest * sixteenth;
    return good ? static_cast<std::uint32_t>(nearest) : 0;
  }

  // Sets rate and format, empties both FIFOs, disables all interrupts and sets the receive trigger: one interrupt for
  // eight bytes (Vo 2021, section 4.1). Returns false and accesses nothing when divisor(baud) is 0 or the format has
  // other than 5..8 data bits.
  [[nodiscard]] bool configure(std::int32_t baud, const Format& format) noexcept;

  // Writes up to kFifoBytes bytes when the send FIFO is empty, otherwise none. Returns the number of bytes written.
  [[nodiscard]] std::size_t send(std::span<const std::uint8_t> bytes) noexcept;

  // True when the last bit of the last byte has been sent.
  [[nodiscard]] bool sent() noexcept;

  // Reads received characters until there are none, `bytes` is full, or one has an error. A break is a byte 0.
  [[nodiscard]] Received receive(std::span<std::uint8_t> bytes) noexcept;

  void enable(const InterruptEnables& enables) noexcept;

  // The most urgent of the enabled sources. The call acknowledges kSendEmpty. The other sources end with their cause:
  // receive() removes kReceived, kReceiveTimeout and kLineStatus.
  [[nodiscard]] Source pending() noexcept;

 private:
  std::uint32_t line_status() noexcept;

  RegisterBus& bus_;
  RegAddr base_;
  std::uint32_t kept_errors_ = 0;  // of LSR, not returned by receive() yet
};

}  // namespace armature
