// Limits of the size and depth of a TOML text. The TOML library needs a hundred times the memory of the text and
// recurses with its depth, so a text that is larger than any real file is refused before it is parsed.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace armature::cosim {

inline constexpr std::size_t kMaxTomlBytes = std::size_t{16} << 20U;
inline constexpr std::size_t kMaxTomlValues = 500'000;  // values and parts of keys, by the signs between them
inline constexpr std::size_t kMaxTables = 10'000;       // of one [[kind]]
inline constexpr std::size_t kMaxKeyParts = 16;         // of a dotted key
inline constexpr std::size_t kMaxNestedValues = 32;     // nested arrays and inline tables

// `expected at most 10000 tables [[move]]`
[[nodiscard]] std::string at_most_tables(std::size_t most, std::string_view kind);

// Throws InputError with the line at which the text exceeds a limit. Text that is not TOML passes, because the parser
// reports it.
void check_toml_limits(std::string_view text, const std::string& file);

}  // namespace armature::cosim
