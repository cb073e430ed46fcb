// Bytes and numbers as the packets of gdb write them: two hexadecimal digits a byte.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace armature::cosim::iss {

[[nodiscard]] std::string to_hex(std::span<const std::uint8_t> bytes);
[[nodiscard]] std::string to_hex(std::string_view text);
// Of a number in the byte order of the target, which is little-endian. `bytes`: 1 to 8.
[[nodiscard]] std::string to_hex(std::uint64_t value, int bytes);

// Nothing: not digits, or not two a byte.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> bytes_of_hex(std::string_view digits);
// A number as gdb writes it, with the highest digit first. Nothing: not a number, or it has more than 64 bits.
[[nodiscard]] std::optional<std::uint64_t> number_of_hex(std::string_view digits);

}  // namespace armature::cosim::iss
