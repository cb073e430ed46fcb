#include "cosim/serve/command_words.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cosim/text/blanks.hpp"
#include "cosim/text/number_text.hpp"

namespace armature::cosim {

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kMaxWord = 40;
  std::string shown{text.substr(0, kMaxWord)};
  std::ranges::replace_if(
      shown, [](char c) { return c < ' ' || c > '~'; }, '?');
  return fmt::format("'{}{}'", shown, text.size() > kMaxWord ? "..." : "");
}

std::optional<std::uint64_t> protocol_number(std::string_view word) {
  const bool hex = word.starts_with("0x") || word.starts_with("0X");
  if (hex) word.remove_prefix(2);
  return parsed_number<std::uint64_t>(word, hex ? 16 : 10);
}

std::string_view CommandWords::word(std::string_view what) {
  if (empty()) refuse(fmt::format("{} is missing", what));
  const std::string_view word = rest_.substr(0, rest_.find_first_of(kBlanks));
  rest_.remove_prefix(word.size());
  skip_blanks();
  return word;
}

std::uint64_t CommandWords::number(std::string_view what, std::uint64_t max) {
  const std::string_view text = word(what);
  const std::optional<std::uint64_t> value = protocol_number(text);
  if (!value || *value > max) {
    refuse(fmt::format("{} must be 0..{} (0x{:X}), decimal or 0x..., found {}", what, max, max, in_quotes(text)));
  }
  return *value;
}

std::string_view CommandWords::rest() {
  const std::string_view all = rest_.substr(0, rest_.find_last_not_of(kBlanks) + 1);
  rest_ = {};
  return all;
}

void CommandWords::finish() const {
  if (!empty()) refuse(fmt::format("unexpected {}", in_quotes(rest_)));
}

void CommandWords::skip_blanks() {
  rest_.remove_prefix(std::min(rest_.find_first_not_of(kBlanks), rest_.size()));
}

void CommandWords::refuse(const std::string& why) const {
  throw CommandRefused{fmt::format("{}; usage: {}", why, usage_)};
}

}  // namespace armature::cosim
