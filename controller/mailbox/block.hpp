// Blocks of fixed layout, the contents of the memory that the controller shares with its host.
//
// A block is declared by one list of its fields: F(offset, type, name, "meaning"). The list generates three things: the
// struct; its checks at compile time (every offset is the written one, no byte is hidden padding); the table of the
// layout that tests/controller/mailbox/mailbox_test.cpp compares with LAYOUT.md. Numbers are little-endian; floating
// point is IEEE 754 binary64; a flag is 0 or 1.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <type_traits>

namespace armature::mailbox {

static_assert(std::endian::native == std::endian::little);
static_assert(std::numeric_limits<double>::is_iec559 && sizeof(double) == 8);

using u8 = std::uint8_t;
using u16 = std::uint16_t;
using u32 = std::uint32_t;
using i64 = std::int64_t;
using f64 = double;
using u8x2 = std::array<u8, 2>;
using u8x3 = std::array<u8, 3>;
using u8x4 = std::array<u8, 4>;
using u8x5 = std::array<u8, 5>;
using u8x6 = std::array<u8, 6>;
using u8x7 = std::array<u8, 7>;
using u8x64 = std::array<u8, 64>;
using i64x6 = std::array<i64, 6>;
using f64x3 = std::array<f64, 3>;
using f64x4 = std::array<f64, 4>;
using f64x6 = std::array<f64, 6>;
using f64x3x15 = std::array<f64x3, 15>;
using f64x9 = std::array<f64, 9>;  // a 3 x 3 matrix, row by row

struct Field {
  std::size_t offset, bytes;
  std::size_t written_offset;  // in the list
  const char* type;
  const char* name;
  const char* meaning;
};

// Name and fields of a block.
template <class Block>
struct LayoutOf;

template <class Block>
[[nodiscard]] consteval bool is_exact() {
  std::size_t end = 0;
  for (const Field& field : LayoutOf<Block>::kFields) {
    if (field.offset != end || field.written_offset != end) return false;
    end += field.bytes;
  }
  return end == sizeof(Block) && std::is_standard_layout_v<Block> && std::is_trivially_copyable_v<Block>;
}

#define ARMATURE_BLOCK_MEMBER(offset, type, name, meaning) type name{};
#define ARMATURE_BLOCK_FIELD(offset, type, name, meaning) \
  ::armature::mailbox::Field{offsetof(Self, name), sizeof(type), offset, #type, #name, meaning},
#define ARMATURE_BLOCK(Name, FIELDS)                                   \
  struct Name {                                                        \
    FIELDS(ARMATURE_BLOCK_MEMBER)                                      \
  };                                                                   \
  template <>                                                          \
  struct LayoutOf<Name> {                                              \
    using Self = Name;                                                 \
    static constexpr const char* kName = #Name;                        \
    static constexpr Field kFields[] = {FIELDS(ARMATURE_BLOCK_FIELD)}; \
  };                                                                   \
  static_assert(is_exact<Name>())

}  // namespace armature::mailbox
