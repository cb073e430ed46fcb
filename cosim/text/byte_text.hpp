// Bytes as users write and read them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace armature::cosim {

// Pairs of hexadecimal digits, spaces between pairs allowed: "48 69 0d0a". Nothing for other texts.
[[nodiscard]] std::optional<std::string> bytes_of_hex(std::string_view text);

// "48 69 0D 0A"
[[nodiscard]] std::string hex_of_bytes(std::string_view bytes);

// In quotes, on one line: \r, \n, \t, \", \\ and \xNN for other characters that are not printable ASCII.
[[nodiscard]] std::string quoted_bytes(std::string_view bytes);

}  // namespace armature::cosim
