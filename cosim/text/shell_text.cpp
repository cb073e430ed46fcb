#include "cosim/text/shell_text.hpp"

#include "cosim/text/printable.hpp"

namespace armature::cosim {

std::string shell_word(std::string_view word) {
  constexpr std::string_view kPlain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-./:=,@%+";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string_view::npos) return std::string{word};
  // Control characters must not be in a message. They are written as escapes, which bash reads back.
  if (const std::string shown = printable(word, kShowAll); shown != word) {
    std::string escaped = "$'";
    for (const char c : word) {
      const auto byte = static_cast<unsigned char>(c);
      if (c == '\'' || c == '\\') {
        escaped += {'\\', c};
      } else if (byte < 0x20 || byte >= 0x7F) {
        constexpr std::string_view kDigits = "0123456789ABCDEF";
        escaped += {'\\', 'x', kDigits[byte >> 4U], kDigits[byte & 0xFU]};
      } else {
        escaped += c;
      }
    }
    return escaped += '\'';
  }
  std::string quoted = "'";
  for (const char c : word) {
    if (c == '\'') {
      quoted += "'\\''";
    } else {
      quoted += c;
    }
  }
  return quoted += '\'';
}

}  // namespace armature::cosim
