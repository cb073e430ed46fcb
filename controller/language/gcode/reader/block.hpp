// The words of one line, sorted by letter and by modal group.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "controller/language/gcode/reader/axes6.hpp"
#include "controller/language/gcode/reader/code_table.hpp"
#include "controller/language/gcode/reader/error.hpp"
#include "controller/language/gcode/reader/operations.hpp"
#include "controller/language/gcode/reader/parameters.hpp"
#include "controller/language/gcode/reader/source_line.hpp"
#include "controller/language/gcode/reader/value_reader.hpp"

namespace armature::gcode {

// Words except G, M, N and O: letters, and '@' and '^' of polar places.
class Words {
 public:
  [[nodiscard]] bool has(char letter) const noexcept { return (present_ & mask(letter)) != 0; }
  // 0 without the word.
  [[nodiscard]] double get(char letter) const noexcept { return values_[index(letter)]; }
  [[nodiscard]] double get_or(char letter, double fallback) const noexcept {
    return has(letter) ? get(letter) : fallback;
  }
  void set(char letter, double value) noexcept {
    present_ |= mask(letter);
    values_[index(letter)] = value;
  }
  [[nodiscard]] bool any_axis() const noexcept {
    bool any = false;
    for (const char letter : kAxisLetters) any = any || has(letter);
    return any;
  }

 private:
  static constexpr std::size_t index(char letter) noexcept {
    return letter == '@' ? 26 : letter == '^' ? 27 : static_cast<std::size_t>(letter - 'a');
  }
  static constexpr std::uint32_t mask(char letter) noexcept { return 1U << index(letter); }
  std::array<double, 28> values_{};
  std::uint32_t present_ = 0;
};

struct Block {
  Words words{};
  std::array<const CodeInfo*, kGroups> codes{};  // of the line, by group; null: none
  // The motion that the line executes: its own code or the active one; null: none.
  const CodeInfo* motion = nullptr;

  [[nodiscard]] const CodeInfo* code(Group group) const noexcept { return codes[static_cast<std::size_t>(group)]; }
  [[nodiscard]] bool is(Group group, int tenths) const noexcept {
    return code(group) != nullptr && code(group)->tenths == tenths;
  }
};

// Values that the line assigns to parameters. They take effect after the whole line is read.
struct Assignments {
  static constexpr std::size_t kMax = 50;
  struct One {
    std::string_view name{};  // empty: `number`
    int number = 0;
    double value = 0.0;
    std::size_t position = 0;
  };
  std::array<One, kMax> list{};
  std::size_t count = 0;
};

// Reads words and assignments up to the end of the line. On failure the error is in `reader`, and nothing is assigned.
[[nodiscard]] bool read_block(ValueReader& reader, Block& block, Assignments& assignments) noexcept;

// Finds the motion of the line, and checks that its codes and words belong together. `active`: the motion mode, null
// for none. The error has neither line nor column.
[[nodiscard]] Failure check_block(Block& block, const CodeInfo* active) noexcept;

// A word that a code needs, with a whole number from `min` to `max`.
[[nodiscard]] Failure read_whole(const Words& words, char letter, int min, int max, int& value) noexcept;

// G80, of the motion codes.
[[nodiscard]] inline bool is_no_motion(const CodeInfo& code) noexcept {
  return code.letter == 'g' && code.tenths == 800;
}
// The cycles, of the motion codes.
[[nodiscard]] inline bool is_cycle(const CodeInfo& motion) noexcept {
  return motion.tenths > 700 && !is_no_motion(motion);
}

// The error of a code.
[[nodiscard]] inline Error error_of(ErrorCode code, const CodeInfo& info) noexcept {
  return {.code = code, .letter = to_upper(info.letter), .tenths = info.tenths};
}
// The error of a word.
[[nodiscard]] inline Error error_of(ErrorCode code, char letter) noexcept {
  return {.code = code, .letter = to_upper(letter)};
}
// The error of a word with a whole number.
[[nodiscard]] inline Error error_of(ErrorCode code, char letter, int number) noexcept {
  return {.code = code, .letter = to_upper(letter), .tenths = 10 * number};
}

}  // namespace armature::gcode
