// CRC-32 as in zlib: reversed polynomial, begins with and is inverted by all ones.
#pragma once

#include <cstdint>

namespace armature {

class Crc32 {
 public:
  constexpr void add(std::uint8_t byte) noexcept {
    constexpr std::uint32_t kReversedPolynomial = 0xEDB8'8320u;
    rest_ ^= byte;
    for (int bit = 0; bit < 8; ++bit) rest_ = (rest_ & 1u) != 0 ? (rest_ >> 1) ^ kReversedPolynomial : rest_ >> 1;
  }
  // Lowest byte first.
  constexpr void add(std::uint32_t word) noexcept {
    for (int shift = 0; shift < 32; shift += 8) add(static_cast<std::uint8_t>(word >> shift));
  }
  constexpr void add(std::int32_t value) noexcept { add(static_cast<std::uint32_t>(value)); }

  [[nodiscard]] constexpr std::uint32_t value() const noexcept { return ~rest_; }

 private:
  std::uint32_t rest_ = 0xFFFF'FFFFu;
};

}  // namespace armature
