#include "controller/language/gcode/flow/o_word_values.hpp"

#include <optional>

#include "controller/language/gcode/flow/o_word_text.hpp"

namespace armature::gcode {
namespace {

// The number of values that a keyword needs and may have.
struct Arity {
  std::size_t min;
  std::size_t max;
};
constexpr Arity arity_of(Keyword keyword) noexcept {
  switch (keyword) {
    case Keyword::kCall:
      return {.min = 0, .max = Parameters::kLocals};
    case Keyword::kReturn:
    case Keyword::kEndSub:
      return {.min = 0, .max = 1};
    case Keyword::kIf:
    case Keyword::kElseIf:
    case Keyword::kWhile:
    case Keyword::kRepeat:
      return {.min = 1, .max = 1};
    default:
      return {.min = 0, .max = 0};
  }
}

Failure read_list(Keyword keyword, ValueReader& reader, OWordValues& values) noexcept {
  const Arity arity = arity_of(keyword);
  while (reader.peek() == '[' && (values.count < arity.max || keyword == Keyword::kCall)) {
    if (values.count == arity.max) {
      reader.fail(ErrorCode::kTooManyArguments);
      return reader.error();
    }
    const std::optional<double> value = reader.expression();
    if (!value) return reader.error();
    values.list[values.count++] = *value;
  }
  if (values.count < arity.min) {
    reader.fail(ErrorCode::kBracketExpected);
  } else if (!reader.at_end()) {
    reader.fail(ErrorCode::kLineAfterOWord);
  }
  return reader.error();
}

// The words of M98.
Failure read_call_words(const FlowIndex& index, ValueReader& reader, OWordValues& values) noexcept {
  std::optional<std::int32_t> turns;
  std::optional<std::int32_t> number;
  while (!reader.at_end()) {
    const std::size_t start = reader.position();
    const char letter = reader.peek();
    std::optional<std::int32_t>& value = letter == 'p' ? number : turns;
    const bool known = letter == 'p' || letter == 'l';
    reader.skip(1);
    if (!known || value) {
      reader.fail(known ? ErrorCode::kWordTwice : ErrorCode::kCodeNotFirst, start);
      return reader.error();
    }
    value = reader.whole();
    if (value && *value < 0) reader.fail(ErrorCode::kWordNegative, start);
    if (reader.error()) return reader.error();
  }
  if (!number) return Error{.code = ErrorCode::kWordMissing, .letter = 'P'};
  values.name = index.find_number(*number).value_or(FlowIndex::kComputed);
  values.turns = turns.value_or(1);
  return std::nullopt;
}

}  // namespace

Failure read_values(const OWord& word, const FlowIndex& index, ValueReader& reader, OWordValues& values) noexcept {
  ErrorCode problem{};
  const std::optional<OWordText> text = read_o_word(reader.rest(), problem);
  if (!text) return Error{.code = problem};
  reader.skip(text->length);
  if (word.keyword == Keyword::kCallProgram) return read_call_words(index, reader, values);
  values.name = word.name;
  if (text->computed) {
    const std::optional<std::int32_t> number = reader.whole();
    if (!number) return reader.error();
    values.name = index.find_number(*number).value_or(FlowIndex::kComputed);
    if (!reader.accept("call")) return Error{.code = ErrorCode::kComputedLabel};
  }
  return read_list(word.keyword, reader, values);
}

}  // namespace armature::gcode
