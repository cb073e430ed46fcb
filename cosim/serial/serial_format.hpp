// Format of a serial line: rate, and data, parity and stop bits of a character. Both ends must use the same.
//
// On the line a character is a start bit (low), the data with the least significant bit first, the parity bit if there
// is one, and the stop time (high). An idle line is high.
#pragma once

#include <cstdint>

#include "cosim/serial/serial_spec.hpp"

namespace armature::cosim {

enum class SerialParity : std::uint8_t { kNone, kEven, kOdd, kMark, kSpace };

struct SerialFormat {
  std::int64_t baud = 115'200;  // bits a second
  int data_bits = 8;            // 5..8
  SerialParity parity = SerialParity::kNone;
  int stop_half_bits = 2;  // 2, 3 or 4: one, one and a half or two stop bits

  static SerialFormat from(const SerialSpec& spec);

  [[nodiscard]] bool has_parity() const { return parity != SerialParity::kNone; }
  [[nodiscard]] unsigned mask() const { return (1u << data_bits) - 1; }
  // The correct parity bit of `data`; false without parity.
  [[nodiscard]] bool parity_bit(unsigned data) const;
  // Number of start, data and parity bits.
  [[nodiscard]] int bits_before_stop() const { return 1 + data_bits + (has_parity() ? 1 : 0); }
  // Of a character, stop time included.
  [[nodiscard]] int half_bits() const { return 2 * bits_before_stop() + stop_half_bits; }
};

}  // namespace armature::cosim
