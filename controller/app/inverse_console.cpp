#include "controller/app/inverse_console.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "controller/base/angle_units.hpp"
#include "controller/base/rounding.hpp"

namespace armature {
namespace {

constexpr std::int64_t kPerDegree = 1'000'000'000;
constexpr int kDecimals = 9;

template <class Text>
void append_degrees(Text& text, Radians angle) noexcept {
  const std::int64_t parts = round_half_away(angle.value() * kDegPerRad * static_cast<double>(kPerDegree));
  if (parts < 0) text << '-';
  const auto size = static_cast<std::uint64_t>(parts < 0 ? -parts : parts);
  text << size / kPerDegree << '.';
  text.append_digits(size % kPerDegree, kDecimals);
}

}  // namespace

InverseConsole::Line InverseConsole::first_line(const IkSolutions& solutions) noexcept {
  Line line;
  line << "solutions " << solutions.count << " status " << static_cast<unsigned>(solutions.status) << " selected "
       << solutions.selected << "\r\n";
  return line;
}

InverseConsole::Line InverseConsole::branch_line(const IkSolutions& solutions, std::size_t branch,
                                                 std::size_t axes) noexcept {
  const IkBranch& b = solutions.branches[branch];
  Line line;
  line << "branch " << branch << " shoulder " << b.shoulder << " elbow " << b.elbow << " flip " << b.flip
       << " singular " << b.singular << " clamped " << (b.clamped ? 1 : 0);
  for (std::size_t axis = 0; axis < axes; ++axis) {
    line << " angle" << axis + 1 << '=';
    append_degrees(line, b.joints[axis]);
  }
  line << "\r\n";
  return line;
}

void InverseConsole::run() noexcept {
  if (!uart_.configure(task_.baud, {})) return;
  uart_.enable({.send_empty = true});
  const IkSolutions solutions = arm_.inverse(task_.base_T_flange, task_.previous);
  bus_.charge(Work::kInverse);
  if (!send(first_line(solutions).view())) return;
  for (std::size_t branch = 0; branch < solutions.count; ++branch) {
    if (!send(branch_line(solutions, branch, axes_).view())) return;
  }
  static_cast<void>(send(InverseTask::kEnd));
}

// False: the core must end.
bool InverseConsole::send(std::string_view text) noexcept {
  while (!text.empty()) {
    std::array<std::uint8_t, AxiUart16550::kFifoBytes> bytes{};
    const std::size_t size = std::min(text.size(), bytes.size());
    std::copy_n(text.begin(), size, bytes.begin());
    text.remove_prefix(uart_.send(std::span{bytes}.first(size)));
    if (text.empty()) break;
    if (bus_.wait_for_interrupt(Interrupts::kUart) == Interrupts::kNone) return false;
    static_cast<void>(uart_.pending());
  }
  return true;
}

}  // namespace armature
