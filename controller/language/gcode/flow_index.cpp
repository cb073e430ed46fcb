#include "controller/language/gcode/flow_index.hpp"

#include <algorithm>

namespace armature::gcode {
namespace {

struct KeywordText {
  std::string_view text;
  Keyword keyword;
};
// A keyword comes before those that it begins with.
constexpr std::array kKeywords{KeywordText{"endsub", Keyword::kEndSub},
                               KeywordText{"sub", Keyword::kSub},
                               KeywordText{"return", Keyword::kReturn},
                               KeywordText{"call", Keyword::kCall},
                               KeywordText{"elseif", Keyword::kElseIf},
                               KeywordText{"else", Keyword::kElse},
                               KeywordText{"endif", Keyword::kEndIf},
                               KeywordText{"if", Keyword::kIf},
                               KeywordText{"endwhile", Keyword::kEndWhile},
                               KeywordText{"while", Keyword::kWhile},
                               KeywordText{"do", Keyword::kDo},
                               KeywordText{"endrepeat", Keyword::kEndRepeat},
                               KeywordText{"repeat", Keyword::kRepeat},
                               KeywordText{"break", Keyword::kBreak},
                               KeywordText{"continue", Keyword::kContinue}};

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

std::size_t line_head(std::string_view text) noexcept {
  std::size_t at = !text.empty() && text.front() == '/' ? 1 : 0;
  if (at < text.size() && text[at] == 'n') {
    std::size_t end = at + 1;
    while (end < text.size() && (is_digit(text[end]) || text[end] == '.')) ++end;
    if (end > at + 1) at = end;
  }
  return at;
}

std::optional<OWordText> read_o_word(std::string_view text, ErrorCode& problem) noexcept {
  OWordText word;
  std::size_t end = 1;
  if (end < text.size() && text[end] == '<') {
    const std::size_t close = index_of(text, '>');
    if (close == text.size()) {
      problem = ErrorCode::kNameNotClosed;
      return std::nullopt;
    }
    end = close + 1;
  } else {
    while (end < text.size() && is_digit(text[end])) ++end;
    if (end == 1) {
      problem = ErrorCode::kNumberExpected;
      return std::nullopt;
    }
  }
  word.name = text.substr(1, end - 1);
  if (word.name.size() > FlowIndex::kMaxNameLength) {
    problem = ErrorCode::kNameTooLong;
    return std::nullopt;
  }
  const std::string_view rest = text.substr(end);
  const auto* const found =
      std::ranges::find_if(kKeywords, [rest](const KeywordText& one) { return rest.starts_with(one.text); });
  if (found == kKeywords.end()) {
    problem = ErrorCode::kUnknownKeyword;
    return std::nullopt;
  }
  word.keyword = found->keyword;
  word.length = end + found->text.size();
  return word;
}

std::optional<Error> FlowIndex::build(std::string_view program, SourceLine& line) noexcept {
  count_ = 0;
  name_count_ = 0;
  Open open;
  std::uint32_t number = 0;
  for (std::size_t begin = 0; begin < program.size();) {
    const LineSpan span = line_at(program, begin);
    ++number;
    begin = span.next;
    // A line that cannot be read is an error when it is executed. It may stand behind the end of the program.
    if (line.read(program.substr(span.begin, span.end - span.begin))) continue;
    const std::size_t head = line_head(line.text());
    const std::string_view text = line.text().substr(head);
    if (!text.empty() && text.front() == 'o') {
      if (const std::optional<Error> error = add(text, span, number, line, open)) return error;
    }
  }
  if (open.count == 0) return std::nullopt;
  return Error{.code = ErrorCode::kBlockNotClosed, .line = words_[open.list[open.count - 1]].line};
}

std::optional<Error> FlowIndex::add(std::string_view text, const LineSpan& span, std::uint32_t line,
                                    const SourceLine& source, Open& open) noexcept {
  Error error{.line = line, .column = source.column(source.text().size() - text.size())};
  const std::optional<OWordText> read = read_o_word(text, error.code);
  if (!read) return error;
  const std::optional<std::uint16_t> name = name_index(read->name);
  error.code = ErrorCode::kTooManyOWords;
  if (!name || count_ == kMaxWords) return error;
  const auto index = static_cast<std::uint16_t>(count_++);
  words_[index] = {.begin = span.begin, .next = span.next, .line = line, .name = *name, .keyword = read->keyword};
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
      if (const OWord* first = subroutine(word.name); first != &word) return ErrorCode::kSubroutineTwice;
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
  OWord& begin = words_[top];
  if (begin.name != word.name || !follows(begin.keyword, word.keyword)) return ErrorCode::kBlockMismatch;
  begin.partner = index;
  word.partner = top;
  if (word.keyword == Keyword::kElseIf || word.keyword == Keyword::kElse) {
    top = index;
  } else {
    --open.count;
  }
  return std::nullopt;
}

const OWord* FlowIndex::at_line(std::size_t begin) const noexcept {
  const auto end = words_.begin() + static_cast<std::ptrdiff_t>(count_);
  const auto found = std::lower_bound(words_.begin(), end, begin,
                                      [](const OWord& word, std::size_t place) { return word.begin < place; });
  return found != end && found->begin == begin ? &*found : nullptr;
}

const OWord* FlowIndex::subroutine(std::uint16_t name) const noexcept {
  for (std::size_t i = 0; i < count_; ++i) {
    if (words_[i].keyword == Keyword::kSub && words_[i].name == name) return &words_[i];
  }
  return nullptr;
}

std::optional<std::uint16_t> FlowIndex::name_index(std::string_view name) noexcept {
  for (std::size_t i = 0; i < name_count_; ++i) {
    if (std::string_view(names_[i].text.data(), names_[i].length) == name) return static_cast<std::uint16_t>(i);
  }
  if (name_count_ == kMaxNames) return std::nullopt;
  Name& added = names_[name_count_];
  std::ranges::copy(name, added.text.begin());
  added.length = static_cast<std::uint8_t>(name.size());
  return static_cast<std::uint16_t>(name_count_++);
}

}  // namespace armature::gcode
