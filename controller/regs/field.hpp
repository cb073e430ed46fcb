// A bit field of a 32-bit register: the helpers behind the generated headers of this folder.
#pragma once

#include <cstdint>

namespace armature::regs {

struct Field {
  std::uint32_t lsb;    // 0..31
  std::uint32_t width;  // 1..32, lsb + width <= 32

  [[nodiscard]] constexpr std::uint32_t mask() const noexcept { return (~std::uint32_t{0} >> (32 - width)) << lsb; }
};

// The value of the field in a register word.
[[nodiscard]] constexpr std::uint32_t extract(std::uint32_t word, Field field) noexcept {
  return (word & field.mask()) >> field.lsb;
}

// The value of a field in two's complement.
[[nodiscard]] constexpr std::int32_t extract_signed(std::uint32_t word, Field field) noexcept {
  const std::uint32_t at_top = word << (32 - field.lsb - field.width);
  return static_cast<std::int32_t>(at_top) >> (32 - field.width);
}

// The value of a field with one bit for each axis.
[[nodiscard]] constexpr std::uint8_t extract_axes(std::uint32_t word, Field field) noexcept {
  return static_cast<std::uint8_t>(extract(word, field));
}

// The word with the field replaced. Bits of the value beyond the width of the field are dropped.
[[nodiscard]] constexpr std::uint32_t insert(std::uint32_t word, Field field, std::uint32_t value) noexcept {
  return (word & ~field.mask()) | ((value << field.lsb) & field.mask());
}

// The word with a field in two's complement replaced.
[[nodiscard]] constexpr std::uint32_t insert_signed(std::uint32_t word, Field field, std::int32_t value) noexcept {
  return insert(word, field, static_cast<std::uint32_t>(value));
}

}  // namespace armature::regs
