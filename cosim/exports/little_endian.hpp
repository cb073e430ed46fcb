// Numbers and texts as bytes of files whose numbers are little-endian.
#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace armature::cosim {

static_assert(std::endian::native == std::endian::little, "bytes are copied as they are");

template <class Number>
requires std::integral<Number> || std::floating_point<Number>
void append_number(std::string& bytes, Number value) {
  std::array<char, sizeof(Number)> copy{};
  std::memcpy(copy.data(), &value, sizeof(Number));
  bytes.append(copy.data(), copy.size());
}

// Its length in four bytes, then the text.
inline void append_text(std::string& bytes, std::string_view text) {
  append_number(bytes, static_cast<std::uint32_t>(text.size()));
  bytes.append(text);
}

}  // namespace armature::cosim
