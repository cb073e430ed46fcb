// Makes text from files and arguments safe for a terminal, a log and a message.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace armature::cosim {

inline constexpr std::size_t kMaxShown = 200;  // characters of one text
inline constexpr std::size_t kShowAll = static_cast<std::size_t>(-1);

// On one line: \n, \r, \t, \xNN for other control characters and for bytes that are no UTF-8, \uNNNN for characters
// that control a terminal or its direction of writing, and for characters that XML does not allow. All other characters
// stay, so applying it twice changes nothing. Text of more than `most` characters is cut and ends with "[...]".
[[nodiscard]] std::string printable(std::string_view text, std::size_t most = kMaxShown);

// The same for each line of a text. The line ends stay, and nothing is cut.
[[nodiscard]] std::string printable_lines(std::string_view text);

}  // namespace armature::cosim
