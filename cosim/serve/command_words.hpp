// Parses the words after a command's name, one after the other.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace armature::cosim {

// The reason why a command is refused: the text after `error `.
struct CommandRefused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// `text` between quotes, cut after 40 bytes, with `?` for what is not printable ASCII.
[[nodiscard]] std::string in_quotes(std::string_view text);

// A number in decimal or, after 0x, in hexadecimal digits of either case; no sign, no other base.
[[nodiscard]] std::optional<std::uint64_t> protocol_number(std::string_view word);

class CommandWords {
 public:
  // Blanks are spaces and tabs. `usage` is the end of every refusal text.
  CommandWords(std::string_view text, std::string_view usage) : rest_{text}, usage_{usage} { skip_blanks(); }

  [[nodiscard]] bool empty() const { return rest_.empty(); }

  // All of them throw CommandRefused. `what` is the name of the argument in its text. A number is 0..`max`.
  std::string_view word(std::string_view what);
  std::uint64_t number(std::string_view what, std::uint64_t max);
  // The remaining text without blanks at its end.
  std::string_view rest();
  // Checks that no text remains.
  void finish() const;

 private:
  void skip_blanks();
  [[noreturn]] void refuse(const std::string& why) const;

  std::string_view rest_;
  std::string_view usage_;
};

}  // namespace armature::cosim
