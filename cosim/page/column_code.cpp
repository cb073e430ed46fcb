#include "cosim/page/column_code.hpp"

#include <cstddef>
#include <string_view>

namespace armature::cosim {
namespace {

// Seven bits a byte, the lowest first; the sign is the lowest bit.
std::string varints(const std::vector<std::int64_t>& values) {
  std::string bytes;
  for (const std::int64_t value : values) {
    const auto bits = static_cast<std::uint64_t>(value);
    std::uint64_t code = value < 0 ? ~(bits << 1U) : bits << 1U;
    while (code >= 0x80) {
      bytes += static_cast<char>(code | 0x80U);
      code >>= 7U;
    }
    bytes += static_cast<char>(code);
  }
  return bytes;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t digit = group >> (18U - 6U * k) & 0x3FU;
      text += i + k <= bytes.size() ? kDigits[digit] : '=';
    }
  }
  return text;
}

void take_differences(std::vector<std::int64_t>& values) {
  for (std::size_t i = values.size(); i-- > 1;) values[i] -= values[i - 1];
}

}  // namespace

ColumnCode column_code(const std::vector<std::int64_t>& values) {
  std::vector<std::int64_t> differences = values;
  ColumnCode best{.order = 0, .text = varints(differences)};
  for (int order = 1; order <= kMaxDifferences; ++order) {
    take_differences(differences);
    std::string bytes = varints(differences);
    if (bytes.size() < best.text.size()) best = {.order = order, .text = std::move(bytes)};
  }
  best.text = base64(best.text);
  return best;
}

}  // namespace armature::cosim
