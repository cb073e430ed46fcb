// The O-word at the start of a line: its name and its keyword.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "controller/language/gcode/reader/error.hpp"

namespace armature::gcode {

enum class Keyword : std::uint8_t {
  kSub,
  kEndSub,
  kReturn,
  kCall,
  kIf,
  kElseIf,
  kElse,
  kEndIf,
  kWhile,
  kEndWhile,
  kDo,
  kRepeat,
  kEndRepeat,
  kBreak,
  kContinue,
  kProgram,      // "O1234" alone: the start of a main program or a subprogram
  kCallProgram,  // M98
  kEndProgram,   // M99
};

// An O-word at the start of a line without blanks: "o100sub", "o<name>call[1]", "o#1call", "o100", "m98p100" or "m99".
struct OWordText {
  std::string_view name{};  // without zeros before it, "100", or "name" of "<name>"
  bool computed = false;    // no name, but an expression that begins behind the 'o'
  Keyword keyword{};
  std::size_t length = 0;  // of all of it; computed: up to its expression; M98: up to its words
};
// Longest name.
inline constexpr std::size_t kMaxOWordName = 31;

// Whether a line, behind its head, begins with an O-word.
[[nodiscard]] bool begins_o_word(std::string_view text) noexcept;
[[nodiscard]] std::optional<OWordText> read_o_word(std::string_view text, ErrorCode& problem) noexcept;

// Length of block delete '/' and N word at the start of a line.
[[nodiscard]] std::size_t line_head(std::string_view text) noexcept;

}  // namespace armature::gcode
