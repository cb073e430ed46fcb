#include "cosim/serial/serial_format.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace armature::cosim {

SerialFormat SerialFormat::from(const SerialSpec& spec) {
  const auto name = std::find(kSerialParityNames.begin(), kSerialParityNames.end(), spec.parity);
  return {.baud = spec.baud,
          .data_bits = static_cast<int>(spec.data_bits),
          .parity = static_cast<SerialParity>(name - kSerialParityNames.begin()),
          .stop_half_bits = static_cast<int>(std::lround(2 * spec.stop_bits))};
}

bool SerialFormat::parity_bit(unsigned data) const {
  const bool odd_ones = std::popcount(data & mask()) % 2 == 1;
  switch (parity) {
    case SerialParity::kEven:
      return odd_ones;
    case SerialParity::kOdd:
      return !odd_ones;
    case SerialParity::kMark:
      return true;
    case SerialParity::kSpace:
    case SerialParity::kNone:
      break;
  }
  return false;
}

}  // namespace armature::cosim
