// Reads values of a line: numbers, parameters, functions and expressions in brackets.
//
// Recursion is limited: a program cannot exhaust the stack.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "controller/language/gcode/reader/error.hpp"
#include "controller/language/gcode/reader/parameters.hpp"
#include "controller/language/gcode/reader/source_line.hpp"

namespace armature::gcode {

class ValueReader {
 public:
  static constexpr int kMaxDepth = 32;

  ValueReader(const SourceLine& line, const Parameters& parameters) noexcept : line_(line), parameters_(parameters) {}

  // What follows. Each returns nothing after an error; error() then has it.
  [[nodiscard]] std::optional<double> value() noexcept;           // number, #..., function[...], [...], with signs
  [[nodiscard]] std::optional<double> expression() noexcept;      // [...]
  [[nodiscard]] std::optional<std::int32_t> whole() noexcept;     // a value that is a whole number
  [[nodiscard]] std::optional<std::string_view> name() noexcept;  // <...>

  [[nodiscard]] bool at_end() const noexcept { return at_ == line_.text().size(); }
  [[nodiscard]] char peek() const noexcept { return at_end() ? '\0' : line_.text()[at_]; }
  [[nodiscard]] std::string_view rest() const noexcept { return line_.text().substr(at_); }
  void skip(std::size_t count) noexcept { at_ += count; }
  // Skips `text` if it follows.
  [[nodiscard]] bool accept(std::string_view text) noexcept;
  [[nodiscard]] std::size_t position() const noexcept { return at_; }

  // Records an error at a position; the first one stays. Returns nothing, for any result.
  std::nullopt_t fail(ErrorCode code, std::size_t position) noexcept;
  std::nullopt_t fail(ErrorCode code) noexcept { return fail(code, at_); }
  // Adds a code to the error, or a word with negative `tenths`.
  void name_code(char letter, std::int32_t tenths) noexcept {
    error_->letter = to_upper(letter);
    error_->tenths = tenths;
  }
  [[nodiscard]] const std::optional<Error>& error() const noexcept { return error_; }

 private:
  [[nodiscard]] std::optional<double> number() noexcept;
  [[nodiscard]] std::optional<double> parameter() noexcept;
  [[nodiscard]] std::optional<double> function() noexcept;
  [[nodiscard]] std::optional<double> arc_tangent() noexcept;
  [[nodiscard]] std::optional<double> exists() noexcept;
  [[nodiscard]] std::optional<double> operation(int precedence) noexcept;

  const SourceLine& line_;
  const Parameters& parameters_;
  std::size_t at_ = 0;
  int depth_ = 0;
  std::optional<Error> error_{};
};

}  // namespace armature::gcode
