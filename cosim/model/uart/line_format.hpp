// The format of a character on a serial line, as LCR states it (rtl/REGISTERS.md).
#pragma once

#include <bit>
#include <cstdint>

#include "controller/regs/axi_uart16550_regs.hpp"

namespace armature::cosim::model {

struct LineFormat {
  int data_bits = 5;       // 5 to 8
  bool long_stop = false;  // two stop bits, or 1.5 with 5 data bits
  bool parity = false, even = false, stick = false;

  [[nodiscard]] static LineFormat of(std::uint32_t lcr) {
    namespace regs = armature::regs::axi_uart16550;
    return {.data_bits = 5 + static_cast<int>(armature::regs::extract(lcr, regs::kLcrLength)),
            .long_stop = (lcr & regs::kLcrStopMask) != 0,
            .parity = (lcr & regs::kLcrParityMask) != 0,
            .even = (lcr & regs::kLcrEvenMask) != 0,
            .stick = (lcr & regs::kLcrStickMask) != 0};
  }

  [[nodiscard]] int bits() const { return data_bits + (parity ? 1 : 0); }  // data and parity
  [[nodiscard]] std::uint32_t data_mask() const { return (1u << data_bits) - 1; }
  // Odd parity makes the number of ones odd; stick parity is the inverse of `even`.
  [[nodiscard]] bool parity_of(std::uint32_t data) const {
    return stick ? !even : (std::popcount(data) % 2 != 0) != !even;
  }
  [[nodiscard]] std::int64_t stop_ticks() const { return !long_stop ? 16 : data_bits == 5 ? 24 : 32; }
  // Four characters with start and one stop bit, and with half of a longer stop: the time-out of the receive FIFO.
  [[nodiscard]] std::int64_t timeout_ticks() const {
    return 64 * (2 + bits()) + (!long_stop ? 0 : data_bits == 5 ? 32 : 64);
  }
};

}  // namespace armature::cosim::model
