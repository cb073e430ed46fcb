// The table of all codes: group, meaning and words. The decoder and the documentation are made from it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace armature::gcode {

// A line has at most one code of each group.
enum class Group : std::uint8_t {
  kOnce,  // G4 G10 G28 G30 G52 G53 G92: for their own line only
  kMotion,
  kPlane,
  kDistance,
  kArcDistance,
  kFeedMode,
  kUnits,
  kCutter,
  kToolLength,
  kRetract,
  kCoordinates,
  kControl,
  kStop,
  kOutputs,
  kToolChange,
  kSpindle,
  kSpindleMode,
  kCoolant,
  kOverride,
  kState,
  kUnsupported,  // known, but an error
  kFlow,         // M98 M99: at the start of a line, as O-words (flow_index.hpp)
};
// Those of which a block holds codes.
inline constexpr std::size_t kGroups = static_cast<std::size_t>(Group::kUnsupported);

// What a code does with the axis words X Y Z A B C of its line.
enum class AxisUse : std::uint8_t { kNone, kMoves, kValues };

struct CodeInfo {
  char letter;          // 'g' or 'm'
  std::int16_t tenths;  // ten times its number: 921 for G92.1
  Group group;
  AxisUse axes;
  std::string_view words;    // the other words that it uses, as letters in lower case
  std::string_view meaning;  // for the documentation
};

[[nodiscard]] std::span<const CodeInfo> code_table() noexcept;

// Nothing for a code that is not in the table.
[[nodiscard]] const CodeInfo* find_code(char letter, std::int32_t tenths) noexcept;

// The name of a group for the documentation.
[[nodiscard]] std::string_view name_of(Group group) noexcept;

}  // namespace armature::gcode
