// One line of a program as the parser reads it: without comments and blanks, in lower case.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "controller/language/gcode/reader/error.hpp"

namespace armature::gcode {

class SourceLine {
 public:
  static constexpr std::size_t kMaxLength = 255;

  // Reads a line without its line end. The error has no line number.
  [[nodiscard]] std::optional<Error> read(std::string_view source) noexcept;

  [[nodiscard]] std::string_view text() const noexcept { return {text_.data(), length_}; }
  // The column in the source of text()[index], from 1; for index == text().size() that behind the line.
  [[nodiscard]] std::uint16_t column(std::size_t index) const noexcept { return columns_[index]; }
  // The last comment in parentheses, without them, as a part of the source; nothing if there is none. Text behind ';'
  // is no such comment.
  [[nodiscard]] std::optional<std::string_view> comment() const noexcept { return comment_; }

 private:
  std::array<char, kMaxLength> text_{};
  std::array<std::uint16_t, kMaxLength + 1> columns_{};
  std::size_t length_ = 0;
  std::optional<std::string_view> comment_{};
};

// Splits a program into lines that end with LF, CR or CR LF.
struct LineSpan {
  std::size_t begin = 0;
  std::size_t end = 0;   // behind the last character
  std::size_t next = 0;  // start of the next line; the size of the program: there is none
};
[[nodiscard]] LineSpan line_at(std::string_view program, std::size_t start) noexcept;

// Index of the first `c`; text.size() if there is none. (std::string_view::find would call the C library.)
[[nodiscard]] constexpr std::size_t index_of(std::string_view text, char c) noexcept {
  std::size_t index = 0;
  while (index < text.size() && text[index] != c) ++index;
  return index;
}

[[nodiscard]] constexpr char to_lower(char c) noexcept {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}
[[nodiscard]] constexpr char to_upper(char c) noexcept {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}
[[nodiscard]] constexpr bool is_blank(char c) noexcept {
  return c == ' ' || c == '\t';
}
[[nodiscard]] constexpr bool is_digit(char c) noexcept {
  return c >= '0' && c <= '9';
}
[[nodiscard]] constexpr bool is_letter(char c) noexcept {
  return c >= 'a' && c <= 'z';
}

}  // namespace armature::gcode
