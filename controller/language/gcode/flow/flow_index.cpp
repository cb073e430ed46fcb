#include "controller/language/gcode/flow/flow_index.hpp"

#include <algorithm>

#include "controller/language/text/fixed_text.hpp"

namespace armature::gcode {
namespace {

bool is_loop(Keyword keyword) noexcept {
  return keyword == Keyword::kWhile || keyword == Keyword::kDo || keyword == Keyword::kRepeat;
}

// Whether `part` may follow `open` in one block.
bool follows(Keyword open, Keyword part) noexcept {
  switch (part) {
    case Keyword::kEndSub:
      return open == Keyword::kSub;
    case Keyword::kElseIf:
    case Keyword::kElse:
      return open == Keyword::kIf || open == Keyword::kElseIf;
    case Keyword::kEndIf:
      return open == Keyword::kIf || open == Keyword::kElseIf || open == Keyword::kElse;
    case Keyword::kEndWhile:
      return open == Keyword::kWhile;
    case Keyword::kWhile:
      return open == Keyword::kDo;
    case Keyword::kEndRepeat:
      return open == Keyword::kRepeat;
    default:
      return false;
  }
}

}  // namespace

bool ProgramText::file_ends(std::size_t at) const noexcept {
  return at == text.size() || std::ranges::find(ends, at) != ends.end();
}

std::optional<Error> FlowIndex::build(const ProgramText& program, SourceLine& line) noexcept {
  count_ = 0;
  name_count_ = 0;
  Open open;
  std::uint32_t number = 0;
  for (std::size_t at = 0; at < program.text.size();) {
    const LineSpan span = line_at(program.text, at);
    ++number;
    at = span.next;
    // A line that cannot be read is an error when it is executed. It may stand behind the end of the program.
    if (!line.read(program.text.substr(span.begin, span.end - span.begin))) {
      const std::string_view text = line.text().substr(line_head(line.text()));
      if (begins_o_word(text)) {
        if (const std::optional<Error> error = add(text, span, number, line, open)) return error;
      }
    }
    if (open.count > 0 && program.file_ends(at)) {
      return Error{.code = ErrorCode::kBlockNotClosed, .line = words_[open.list[open.count - 1]].line};
    }
  }
  return std::nullopt;
}

std::optional<Error> FlowIndex::add(std::string_view text, const LineSpan& span, std::uint32_t line,
                                    const SourceLine& source, Open& open) noexcept {
  Error error{.line = line, .column = source.column(source.text().size() - text.size())};
  const std::optional<OWordText> read = read_o_word(text, error.code);
  if (!read) return error;
  const bool nameless = read->computed || read->keyword == Keyword::kEndProgram;
  const std::optional<std::uint16_t> name = nameless ? kComputed : name_index(read->name);
  error.code = ErrorCode::kTooManyOWords;
  if (!name || count_ == kMaxWords) return error;
  const auto index = static_cast<std::uint16_t>(count_++);
  words_[index] = {.start = span.begin, .next = span.next, .line = line, .name = *name, .keyword = read->keyword};
  if (const std::optional<ErrorCode> problem = link(index, open)) {
    error.code = *problem;
    return error;
  }
  return std::nullopt;
}

std::optional<ErrorCode> FlowIndex::link(std::uint16_t index, Open& open) noexcept {
  OWord& word = words_[index];
  switch (word.keyword) {
    case Keyword::kCall:
    case Keyword::kCallProgram:
    case Keyword::kEndProgram:
      return std::nullopt;
    case Keyword::kProgram:
      if (open.count > 0) return ErrorCode::kSubroutineNested;
      return std::nullopt;
    case Keyword::kReturn:
      if (open.count == 0 || words_[open.list[0]].keyword != Keyword::kSub) return ErrorCode::kReturnOutsideSubroutine;
      return std::nullopt;
    case Keyword::kBreak:
    case Keyword::kContinue:
      for (std::size_t i = open.count; i > 0; --i) {
        const OWord& candidate = words_[open.list[i - 1]];
        if (!is_loop(candidate.keyword) || candidate.name != word.name) continue;
        word.partner = open.list[i - 1];
        return std::nullopt;
      }
      return ErrorCode::kLoopUnknown;
    case Keyword::kSub:
      if (open.count > 0) return ErrorCode::kSubroutineNested;
      if (const OWord* first = start_of(Keyword::kSub, word.name); first != &word) return ErrorCode::kSubroutineTwice;
      break;
    case Keyword::kIf:
    case Keyword::kDo:
    case Keyword::kRepeat:
      break;
    case Keyword::kWhile: {
      const bool ends_do = open.count > 0 && words_[open.list[open.count - 1]].keyword == Keyword::kDo &&
                           words_[open.list[open.count - 1]].name == word.name;
      if (ends_do) return close(index, open);
      break;
    }
    default:
      return close(index, open);
  }
  if (open.count == kMaxDepth) return ErrorCode::kTooManyOWords;
  open.list[open.count++] = index;
  return std::nullopt;
}

std::optional<ErrorCode> FlowIndex::close(std::uint16_t index, Open& open) noexcept {
  OWord& word = words_[index];
  if (open.count == 0) return ErrorCode::kBlockMismatch;
  std::uint16_t& top = open.list[open.count - 1];
  OWord& start = words_[top];
  if (start.name != word.name || !follows(start.keyword, word.keyword)) return ErrorCode::kBlockMismatch;
  start.partner = index;
  word.partner = top;
  if (word.keyword == Keyword::kElseIf || word.keyword == Keyword::kElse) {
    top = index;
  } else {
    --open.count;
  }
  return std::nullopt;
}

const OWord* FlowIndex::at_line(std::size_t start) const noexcept {
  const auto end = words_.begin() + static_cast<std::ptrdiff_t>(count_);
  const auto found = std::lower_bound(words_.begin(), end, start,
                                      [](const OWord& word, std::size_t place) { return word.start < place; });
  return found != end && found->start == start ? &*found : nullptr;
}

const OWord* FlowIndex::start_of(Keyword kind, std::uint16_t name) const noexcept {
  for (const OWord& word : words()) {
    if (word.keyword == kind && word.name == name) return &word;
  }
  return nullptr;
}

std::optional<std::uint16_t> FlowIndex::find_number(std::int32_t number) const noexcept {
  if (number < 0) return std::nullopt;
  FixedText<12> digits;
  digits << static_cast<std::uint32_t>(number);
  return find_name(digits.view());
}

std::optional<std::uint16_t> FlowIndex::find_name(std::string_view name) const noexcept {
  for (std::size_t i = 0; i < name_count_; ++i) {
    if (this->name(static_cast<std::uint16_t>(i)) == name) return static_cast<std::uint16_t>(i);
  }
  return std::nullopt;
}

std::optional<std::uint16_t> FlowIndex::name_index(std::string_view name) noexcept {
  if (const std::optional<std::uint16_t> found = find_name(name)) return found;
  if (name_count_ == kMaxNames) return std::nullopt;
  Name& added = names_[name_count_];
  std::ranges::copy(name, added.text.begin());
  added.length = static_cast<std::uint8_t>(name.size());
  return static_cast<std::uint16_t>(name_count_++);
}

}  // namespace armature::gcode
