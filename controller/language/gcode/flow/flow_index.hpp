// The O-words of a program, found and matched before it runs: subroutines, conditions and loops.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "controller/language/gcode/flow/o_word_text.hpp"
#include "controller/language/gcode/reader/error.hpp"
#include "controller/language/gcode/reader/source_line.hpp"

namespace armature::gcode {

// A program may have the files of its subroutines behind it: `text` has all of them, one behind the other.
struct ProgramText {
  std::string_view text{};
  // Where each file ends in `text`; the first one is the main program. Empty: there is only that.
  std::span<const std::uint32_t> ends{};

  // Whether a file ends at `at`, which is the start of a line or the end of the text.
  [[nodiscard]] bool file_ends(std::size_t at) const noexcept;
  [[nodiscard]] bool in_main(std::size_t at) const noexcept { return ends.empty() || at < ends.front(); }
};

struct OWord {
  std::size_t start = 0;  // of its line in the program
  std::size_t next = 0;   // of the line behind
  std::uint32_t line = 0;
  std::uint16_t name = 0;  // index of the number or name
  Keyword keyword{};
  // The next part of its block: of SUB its ENDSUB, of IF and ELSEIF the next branch or ENDIF, of a loop its end, of the
  // end of a loop its start, of BREAK and CONTINUE the start of their loop.
  std::uint16_t partner = 0;
};

class FlowIndex {
 public:
  static constexpr std::size_t kMaxWords = 1024;
  static constexpr std::size_t kMaxNames = 256;
  static constexpr std::size_t kMaxNameLength = kMaxOWordName;
  static constexpr std::size_t kMaxDepth = 64;

  static constexpr std::uint16_t kComputed = 0xFFFF;  // instead of a name: an expression

  // Reads a whole program. `line` is scratch.
  [[nodiscard]] std::optional<Error> build(const ProgramText& program, SourceLine& line) noexcept;

  // The O-word of the line that begins at `start`; null: the line has none.
  [[nodiscard]] const OWord* at_line(std::size_t start) const noexcept;
  [[nodiscard]] const OWord& word(std::size_t index) const noexcept { return words_[index]; }
  [[nodiscard]] std::uint16_t index_of(const OWord& word) const noexcept {
    return static_cast<std::uint16_t>(&word - words_.data());
  }
  // The start of a subroutine (kSub) or a subprogram (kProgram); null if the program has none with this name.
  [[nodiscard]] const OWord* start_of(Keyword kind, std::uint16_t name) const noexcept;
  // The name of a number; nothing if no O-word has it.
  [[nodiscard]] std::optional<std::uint16_t> find_number(std::int32_t number) const noexcept;
  // All O-words, in the order of the program, and their names: "100" or "probe".
  [[nodiscard]] std::span<const OWord> words() const noexcept { return std::span(words_).first(count_); }
  [[nodiscard]] std::string_view name(std::uint16_t index) const noexcept {
    return {names_[index].text.data(), names_[index].length};
  }

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
  [[nodiscard]] std::optional<std::uint16_t> find_name(std::string_view name) const noexcept;

  std::array<OWord, kMaxWords> words_{};
  std::size_t count_ = 0;
  std::array<Name, kMaxNames> names_{};
  std::size_t name_count_ = 0;
};

}  // namespace armature::gcode
