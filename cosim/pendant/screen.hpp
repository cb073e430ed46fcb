// The screen of the terminal pendant as text.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cosim/pendant/operator_desk.hpp"

namespace armature::cosim {

struct TerminalLine {
  enum class Style : std::uint8_t { kPlain, kTitle, kAlarm, kMarked, kSelected, kDim };
  std::string text;
  Style style = Style::kPlain;
};

inline constexpr char kQuitKey = 'Q';  // ends the program; no key of the desk
inline constexpr std::size_t kLeastRows = 24, kLeastColumns = 80;

// `line_name`: of the line, for the title. A screen below kLeastRows or kLeastColumns says so. No line is longer than
// `columns`, and there are at most `rows`.
[[nodiscard]] std::vector<TerminalLine> screen_lines(const OperatorDesk& desk, const std::string& line_name,
                                                     std::size_t rows, std::size_t columns);

}  // namespace armature::cosim
