#include "cosim/exports/crc32.hpp"

#include <array>
#include <cstddef>
#include <cstring>

namespace armature::cosim {
namespace {

constexpr std::size_t kAtOnce = 8;  // bytes
using Table = std::array<std::array<std::uint32_t, 256>, kAtOnce>;

// [n][b]: the sum of the byte b with n zeros behind it.
constexpr Table make_table() {
  constexpr std::uint32_t kPolynomial = 0xEDB88320U;  // its lowest power is the highest bit
  Table table{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t sum = byte;
    for (int bit = 0; bit < 8; ++bit) sum = (sum & 1U) != 0 ? sum >> 1U ^ kPolynomial : sum >> 1U;
    table[0][byte] = sum;
  }
  for (std::size_t zeros = 1; zeros < kAtOnce; ++zeros) {
    for (std::size_t byte = 0; byte < 256; ++byte) {
      const std::uint32_t sum = table[zeros - 1][byte];
      table[zeros][byte] = sum >> 8U ^ table[0][sum & 0xFFU];
    }
  }
  return table;
}

constexpr Table kTable = make_table();

}  // namespace

std::uint32_t crc32(std::string_view bytes, std::uint32_t before) {
  std::uint32_t sum = ~before;
  for (; bytes.size() >= kAtOnce; bytes.remove_prefix(kAtOnce)) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data(), kAtOnce);
    word ^= sum;
    sum = 0;
    for (std::size_t i = 0; i < kAtOnce; ++i) sum ^= kTable[kAtOnce - 1 - i][word >> 8U * i & 0xFFU];
  }
  for (const char c : bytes) sum = sum >> 8U ^ kTable[0][(sum ^ static_cast<unsigned char>(c)) & 0xFFU];
  return ~sum;
}

}  // namespace armature::cosim
