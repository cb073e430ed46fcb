// The check byte of a frame: CRC-8 with the polynomial 0x2F, start value 0xFF and final inversion (AUTOSAR). It detects
// every error of up to three bits in eight bytes.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace armature::pendant {

namespace detail {

[[nodiscard]] constexpr std::array<std::uint8_t, 256> crc8_table() noexcept {
  constexpr unsigned kPolynomial = 0x2F;
  std::array<std::uint8_t, 256> table{};
  for (unsigned byte = 0; byte < table.size(); ++byte) {
    unsigned rest = byte;
    for (int bit = 0; bit < 8; ++bit) rest = (rest & 0x80u) != 0 ? (rest << 1) ^ kPolynomial : rest << 1;
    table[byte] = static_cast<std::uint8_t>(rest);
  }
  return table;
}

inline constexpr std::array<std::uint8_t, 256> kCrc8Table = crc8_table();

}  // namespace detail

[[nodiscard]] constexpr std::uint8_t crc8(std::span<const std::uint8_t> bytes) noexcept {
  std::uint8_t rest = 0xFF;
  for (const std::uint8_t byte : bytes) rest = detail::kCrc8Table[static_cast<std::uint8_t>(rest ^ byte)];
  return static_cast<std::uint8_t>(~rest);
}

}  // namespace armature::pendant
