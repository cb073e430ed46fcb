// Which register of a block an address on the bus belongs to.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

namespace armature::cosim {

// Whether the block at `base`, `size` bytes long, has the address.
constexpr bool is_block(std::uint32_t addr, std::uint32_t base, std::uint32_t size) {
  return addr - base < size;  // an address below the base wraps to a large offset
}

// Index of the element of a register array at `offset`.
constexpr std::optional<std::size_t> element(std::uint32_t offset, std::uint32_t first, std::uint32_t stride,
                                             std::uint32_t count) {
  const std::uint32_t index = (offset - first) / stride;
  if (offset < first || index >= count) return std::nullopt;
  return index;
}

}  // namespace armature::cosim
