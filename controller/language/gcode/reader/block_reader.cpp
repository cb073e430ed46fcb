#include <cmath>

#include "controller/base/rounding.hpp"
#include "controller/language/gcode/reader/block.hpp"

namespace armature::gcode {
namespace {

constexpr std::string_view kWordLetters = "abcdefhijklpqrstxyz@^";
constexpr double kMaxCode = 999.0;

// #...=value
bool read_assignment(ValueReader& reader, Assignments& assignments) noexcept {
  const std::size_t start = reader.position();
  reader.skip(1);
  Assignments::One one{.position = start};
  if (reader.peek() == '<') {
    const std::optional<std::string_view> name = reader.name();
    if (!name) return false;
    one.name = *name;
  } else {
    const std::optional<std::int32_t> number = reader.whole();
    if (!number) return false;
    one.number = *number;
  }
  if (!reader.accept("=")) {
    reader.fail(ErrorCode::kEqualSignExpected);
    return false;
  }
  const std::optional<double> value = reader.value();
  if (!value) return false;
  one.value = *value;
  if (assignments.count == Assignments::kMax) {
    reader.fail(ErrorCode::kTooManyAssignments, start);
    return false;
  }
  assignments.list[assignments.count++] = one;
  return true;
}

bool fail_word(ValueReader& reader, ErrorCode code, std::size_t start) noexcept {
  reader.fail(code, start);
  return false;
}

// A G or M word.
bool read_code(ValueReader& reader, Block& block) noexcept {
  const std::size_t start = reader.position();
  const char letter = reader.peek();
  reader.skip(1);
  const std::optional<double> value = reader.value();
  if (!value) return false;
  if (*value < 0.0 || *value > kMaxCode) return fail_word(reader, ErrorCode::kUnknownCode, start);
  const auto tenths = static_cast<std::int32_t>(round_half_away(10.0 * *value));
  const bool exact = std::fabs(10.0 * *value - tenths) <= 10.0 * kEqual;
  const CodeInfo* info = exact ? find_code(letter, tenths) : nullptr;
  ErrorCode problem{};
  if (info == nullptr) {
    problem = ErrorCode::kUnknownCode;
  } else if (info->group == Group::kUnsupported) {
    problem = ErrorCode::kUnsupportedCode;
  } else if (info->group == Group::kFlow) {
    problem = ErrorCode::kCodeNotFirst;
  } else {
    const CodeInfo*& slot = block.codes[static_cast<std::size_t>(info->group)];
    // G80 may stand beside another motion code, which then holds: the usual first line of a program.
    if (slot == nullptr || is_no_motion(*slot)) slot = info;
    if (slot == info || is_no_motion(*info)) return true;
    problem = ErrorCode::kSameGroup;
  }
  reader.fail(problem, start);
  reader.name_code(letter, tenths);
  return false;
}

bool read_word(ValueReader& reader, Block& block) noexcept {
  const std::size_t start = reader.position();
  const char letter = reader.peek();
  if (index_of(kWordLetters, letter) == kWordLetters.size()) {
    if (is_letter(letter)) return fail_word(reader, ErrorCode::kUnsupportedWord, start);
    fail_word(reader, ErrorCode::kBadCharacter, start);
    reader.name_code(letter, -1);
    return false;
  }
  reader.skip(1);
  const std::optional<double> value = reader.value();
  if (!value) return false;
  if (block.words.has(letter)) {
    reader.fail(ErrorCode::kWordTwice, start);
    reader.name_code(letter, -1);
    return false;
  }
  block.words.set(letter, *value);
  return true;
}

}  // namespace

bool read_block(ValueReader& reader, Block& block, Assignments& assignments) noexcept {
  while (!reader.at_end()) {
    const char c = reader.peek();
    bool ok = false;
    if (c == '#') {
      ok = read_assignment(reader, assignments);
    } else if (c == 'g' || c == 'm') {
      ok = read_code(reader, block);
    } else {
      ok = read_word(reader, block);
    }
    if (!ok) return false;
  }
  return true;
}

}  // namespace armature::gcode
