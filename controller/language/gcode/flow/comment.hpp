// A comment of a program: plain text, or a message in which parameters are replaced by their values.
#pragma once

#include <cstddef>
#include <string_view>

#include "controller/language/gcode/canon/canon.hpp"
#include "controller/language/gcode/reader/parameters.hpp"
#include "controller/language/text/fixed_text.hpp"

namespace armature::gcode {

class ExpandedComment {
 public:
  // "msg,text", "debug,text", "print,text", "log,text" and "abort,text" are messages. All but the first replace #n and
  // #<name>, in the form of the last "%d", "%f" or "%.nf" before them.
  void expand(std::string_view comment, const Parameters& parameters) noexcept;
  [[nodiscard]] Text::Kind kind() const noexcept { return kind_; }
  // "abort,text": the program must not continue.
  [[nodiscard]] bool aborts() const noexcept { return aborts_; }
  // Cut off if it is too long.
  [[nodiscard]] std::string_view text() const noexcept { return text_.view(); }

 private:
  static constexpr int kDigits = 6;  // without a format

  [[nodiscard]] std::size_t read_format(std::string_view text) noexcept;
  void add_number(double value) noexcept;
  // The parameter behind '#'; returns its length in the text.
  [[nodiscard]] std::size_t add_parameter(std::string_view text, const Parameters& parameters) noexcept;

  FixedText<512> text_{};
  Text::Kind kind_ = Text::Kind::kComment;
  bool aborts_ = false;
  int digits_ = kDigits;  // behind the point of the numbers that follow
};

}  // namespace armature::gcode
