// One operand of an encoded instruction, with all that the printer needs to write it as it was read.
#pragma once

#include <cstddef>
#include <cstdint>

namespace armature::job {

// The form of a number in the text: decimals in bits 0..3, an explicit plus in bit 4, leading zeros in bits 5..7.
using NumberForm = std::uint8_t;

enum class OperandKind : std::uint8_t {
  kNumber,
  kVariable,  // `what`: a VariableType. With kIndexed the next operand is the index in brackets
  kPosition,  // of the job: C, BC or EC; `what`: a PositionLetter, `a`: its place in the memory after linking
  kIo,        // IN#(n), UF#(n), ...; `what`: an IoType. With kIndexed the next operand is the number in brackets
  kWord,      // a keyword or an operator; `what`: a Word
  kTag,       // NAME=; `what`: a TagName. With kIndexed the next operand is the value, otherwise `number` is it
  kLabel,     // *NAME
  kJob,       // JOB:NAME; `number`: of the job after linking
  kQuoted,    // "text"
  kText,      // the rest of the line as it is
};

// A part of the pool of texts.
struct TextRef {
  std::uint16_t start = 0;
  std::uint16_t size = 0;
};

struct Operand {
  static constexpr std::uint8_t kIndexed = 1;      // the next operand belongs to this one
  static constexpr std::uint8_t kLocal = 2;        // a variable of the call: LB000
  static constexpr std::uint8_t kSystem = 4;       // $PX000
  static constexpr std::uint8_t kWithX = 8;        // PX000 for P000
  static constexpr std::uint8_t kBlankAfter = 16;  // kTag: a blank between `=` and its number

  OperandKind kind = OperandKind::kNumber;
  std::uint8_t what = 0;
  std::uint8_t flags = 0;
  std::uint8_t gap = 0;  // blanks before it
  std::uint16_t a = 0;   // number of a variable or of a position; start of a text; an exponent + 1000, or 0
  std::uint8_t b = 0;    // digits of `a` as written; form of an exponent
  NumberForm form = 0;   // of `number`
  double number = 0.0;
};
static_assert(sizeof(Operand) == 16);

// Where a text of the kinds kLabel, kJob, kQuoted and kText is.
[[nodiscard]] constexpr TextRef text_of(const Operand& operand) noexcept {
  return {operand.a, static_cast<std::uint16_t>(operand.b | operand.form << 8)};
}
constexpr void set_text(Operand& operand, TextRef text) noexcept {
  operand.a = text.start;
  operand.b = static_cast<std::uint8_t>(text.size & 0xFF);
  operand.form = static_cast<NumberForm>(text.size >> 8);
}

}  // namespace armature::job
