// The check value of a program or of staged targets: CRC-32 as in zlib, modulo 2^26 so that it fits a payload.
#pragma once

#include <cstdint>
#include <span>

namespace armature::pendant {

class Crc32 {
 public:
  static constexpr std::uint32_t kCheckMask = (1u << 26) - 1u;

  constexpr void add(std::uint8_t byte) noexcept {
    constexpr std::uint32_t kReversedPolynomial = 0xEDB8'8320u;
    rest_ ^= byte;
    for (int bit = 0; bit < 8; ++bit) rest_ = (rest_ & 1u) != 0 ? (rest_ >> 1) ^ kReversedPolynomial : rest_ >> 1;
  }
  // Lowest byte first.
  constexpr void add(std::int32_t value) noexcept {
    for (int shift = 0; shift < 32; shift += 8) {
      add(static_cast<std::uint8_t>(static_cast<std::uint32_t>(value) >> shift));
    }
  }

  [[nodiscard]] constexpr std::uint32_t value() const noexcept { return ~rest_; }
  [[nodiscard]] constexpr std::int32_t check() const noexcept {
    return static_cast<std::int32_t>(value() & kCheckMask);
  }

 private:
  std::uint32_t rest_ = 0xFFFF'FFFFu;
};

}  // namespace armature::pendant
