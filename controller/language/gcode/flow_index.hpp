// The O-words of a program, found and matched before it runs: subroutines, conditions and loops.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "controller/language/gcode/error.hpp"
#include "controller/language/gcode/source_line.hpp"

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
};

struct OWord {
  std::size_t begin = 0;  // of its line in the program
  std::size_t next = 0;   // of the line behind
  std::uint32_t line = 0;
  std::uint16_t name = 0;  // index of the number or name
  Keyword keyword{};
  // The next part of its block: of SUB its ENDSUB, of IF and ELSEIF the next branch or ENDIF, of a loop its end, of the
  // end of a loop its begin, of BREAK and CONTINUE the begin of their loop.
  std::uint16_t partner = 0;
};

class FlowIndex {
 public:
  static constexpr std::size_t kMaxWords = 1024;
  static constexpr std::size_t kMaxNames = 256;
  static constexpr std::size_t kMaxNameLength = 31;
  static constexpr std::size_t kMaxDepth = 64;

  // Reads a whole program. `line` is scratch.
  [[nodiscard]] std::optional<Error> build(std::string_view program, SourceLine& line) noexcept;

  // The O-word whose line begins at `begin`; null: the line has none.
  [[nodiscard]] const OWord* at_line(std::size_t begin) const noexcept;
  [[nodiscard]] const OWord& word(std::size_t index) const noexcept { return words_[index]; }
  [[nodiscard]] std::uint16_t index_of(const OWord& word) const noexcept {
    return static_cast<std::uint16_t>(&word - words_.data());
  }
  // The begin of a subroutine; null if the program has none with this name.
  [[nodiscard]] const OWord* subroutine(std::uint16_t name) const noexcept;

 private:
  struct Open {
    std::array<std::uint16_t, kMaxDepth> list{};
    std::size_t count = 0;
  };
  struct Name {
    std::array<char, kMaxNameLength> text{};
    std::uint8_t length = 0;
  };
  [[nodiscard]] std::optional<Error> add(std::string_view text, const LineSpan& span, std::uint32_t line,
                                         const SourceLine& source, Open& open) noexcept;
  [[nodiscard]] std::optional<ErrorCode> link(std::uint16_t index, Open& open) noexcept;
  [[nodiscard]] std::optional<ErrorCode> close(std::uint16_t index, Open& open) noexcept;
  [[nodiscard]] std::optional<std::uint16_t> name_index(std::string_view name) noexcept;

  std::array<OWord, kMaxWords> words_{};
  std::size_t count_ = 0;
  std::array<Name, kMaxNames> names_{};
  std::size_t name_count_ = 0;
};

// An O-word at the begin of a line without blanks: "o100sub" or "o<name>call[1]".
struct OWordText {
  std::string_view name{};  // "100" or "<name>"
  Keyword keyword{};
  std::size_t length = 0;  // of all of it
};
[[nodiscard]] std::optional<OWordText> read_o_word(std::string_view text, ErrorCode& problem) noexcept;

// Length of block delete '/' and N word at the begin of a line.
[[nodiscard]] std::size_t line_head(std::string_view text) noexcept;

}  // namespace armature::gcode
