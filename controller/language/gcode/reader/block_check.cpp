#include <algorithm>
#include <cmath>

#include "controller/base/rounding.hpp"
#include "controller/language/gcode/reader/block.hpp"

namespace armature::gcode {
namespace {

constexpr std::string_view kCentreLetters = "ijk";
constexpr std::string_view kArgumentLetters = "dehijklpqr";  // each needs a code that uses it

bool is_line(const CodeInfo& info) noexcept {
  return info.tenths == 0 || info.tenths == 10;
}
bool is_arc(const CodeInfo& info) noexcept {
  return info.tenths == 20 || info.tenths == 30;
}
bool goes_home(const CodeInfo& info) noexcept {
  return info.letter == 'g' && (info.tenths == 280 || info.tenths == 300);
}
bool changes_offset(const CodeInfo& info) noexcept {
  return info.letter == 'g' && (info.tenths == 520 || info.tenths == 920);
}

// The code of the line, other than a motion, that uses its axis words.
const CodeInfo* value_user(const Block& block) noexcept {
  for (const CodeInfo* code : block.codes) {
    if (code != nullptr && code->axes == AxisUse::kValues) return code;
  }
  return nullptr;
}

bool uses(const Block& block, char letter) noexcept {
  const auto has = [letter](const CodeInfo* code) {
    return code != nullptr && index_of(code->words, letter) < code->words.size();
  };
  return has(block.motion) || std::ranges::any_of(block.codes, has);
}

// Finds the motion of the line: its own code, or the active one where the line has axis words for it.
Failure choose_motion(Block& block, const CodeInfo* active) noexcept {
  const bool axes = block.words.any_axis();
  const CodeInfo* const values = value_user(block);
  const CodeInfo* const own = block.code(Group::kMotion);
  const bool centre = std::ranges::any_of(kCentreLetters, [&](char letter) { return block.words.has(letter); });

  block.motion = nullptr;
  if (own != nullptr && own->axes == AxisUse::kMoves) {
    if (values != nullptr && (axes || goes_home(*values) || changes_offset(*values))) {
      return error_of(ErrorCode::kTwoAxisUsers, *values);
    }
    block.motion = own;
  } else if (values != nullptr) {
    if (!axes && changes_offset(*values)) return error_of(ErrorCode::kAxesMissing, *values);
  } else if (own != nullptr) {  // G80
    if (axes) return error_of(ErrorCode::kNoMotionMode, *own);
  } else if (axes || (centre && active != nullptr && is_arc(*active))) {
    if (active == nullptr) return Error{.code = ErrorCode::kNoMotionMode};
    block.motion = active;
  }
  return std::nullopt;
}

}  // namespace

Failure check_block(Block& block, const CodeInfo* active) noexcept {
  if (const Failure failure = choose_motion(block, active)) return failure;
  if (block.is(Group::kOnce, 530) && (block.motion == nullptr || !is_line(*block.motion))) {
    return error_of(ErrorCode::kG53WithoutLine, *block.code(Group::kOnce));
  }
  for (const char letter : kArgumentLetters) {
    if (block.words.has(letter) && !uses(block, letter)) return error_of(ErrorCode::kWordNotUsed, letter);
  }
  return std::nullopt;
}

Failure read_whole(const Words& words, char letter, int min, int max, int& value) noexcept {
  if (!words.has(letter)) return error_of(ErrorCode::kWordMissing, letter);
  const double given = words.get(letter);
  if (given < min - 0.5 || given > max + 0.5) return error_of(ErrorCode::kWordRange, letter);
  const auto nearest = static_cast<int>(round_half_away(given));
  if (std::fabs(given - nearest) > kEqual) return error_of(ErrorCode::kNotAnInteger, letter);
  value = nearest;
  return std::nullopt;
}

}  // namespace armature::gcode
