#include "controller/language/gcode/flow/o_word_text.hpp"

#include <algorithm>
#include <array>

#include "controller/language/gcode/reader/source_line.hpp"

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

constexpr std::string_view kCallCode = "m98";
constexpr std::string_view kReturnCode = "m99";

// Whether a text begins with a code, and not with a longer one.
bool begins_with_code(std::string_view text, std::string_view code) noexcept {
  if (!text.starts_with(code)) return false;
  return text.size() == code.size() || !(is_digit(text[code.size()]) || text[code.size()] == '.');
}

std::string_view without_zeros(std::string_view digits) noexcept {
  while (digits.size() > 1 && digits.front() == '0') digits.remove_prefix(1);
  return digits;
}

std::size_t digits_at(std::string_view text, std::size_t start) noexcept {
  std::size_t end = start;
  while (end < text.size() && is_digit(text[end])) ++end;
  return end - start;
}

// The words of M98. Its P may be an expression.
OWordText read_call_code(std::string_view text) noexcept {
  OWordText word{.computed = true, .keyword = Keyword::kCallProgram, .length = kCallCode.size()};
  const std::size_t p = index_of(text, 'p');
  if (p == text.size()) return word;
  const std::size_t length = digits_at(text, p + 1);
  const std::size_t end = p + 1 + length;
  const bool whole = length > 0 && (end == text.size() || text[end] != '.');
  if (!whole) return word;
  word.computed = false;
  word.name = without_zeros(text.substr(p + 1, length));
  return word;
}

// "o#1call" or "o[#1+1]call": the keyword stands behind the expression, outside of brackets and names.
std::optional<OWordText> read_computed(std::string_view text, ErrorCode& problem) noexcept {
  int depth = 0;
  for (std::size_t i = 1; i < text.size(); ++i) {
    if (text[i] == '[') ++depth;
    if (text[i] == ']') --depth;
    if (text[i] == '<') i += index_of(text.substr(i), '>');
    if (depth == 0 && i < text.size() && text.substr(i).starts_with("call")) {
      return OWordText{.computed = true, .keyword = Keyword::kCall, .length = 1};
    }
  }
  problem = ErrorCode::kComputedLabel;
  return std::nullopt;
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

bool begins_o_word(std::string_view text) noexcept {
  return text.starts_with('o') || begins_with_code(text, kCallCode) || begins_with_code(text, kReturnCode);
}

std::optional<OWordText> read_o_word(std::string_view text, ErrorCode& problem) noexcept {
  if (begins_with_code(text, kCallCode)) return read_call_code(text);
  if (begins_with_code(text, kReturnCode)) {
    return OWordText{.keyword = Keyword::kEndProgram, .length = kReturnCode.size()};
  }
  OWordText word;
  std::size_t end = 1;
  const char first = text.size() > 1 ? text[1] : '\0';
  if (first == '#' || first == '[') return read_computed(text, problem);
  if (first == '<') {
    const std::size_t close = index_of(text, '>');
    if (close == text.size()) {
      problem = ErrorCode::kNameNotClosed;
      return std::nullopt;
    }
    end = close + 1;
    word.name = text.substr(2, close - 2);
  } else {
    end += digits_at(text, 1);
    if (end == 1) {
      problem = ErrorCode::kNumberExpected;
      return std::nullopt;
    }
    word.name = without_zeros(text.substr(1, end - 1));
  }
  if (word.name.size() > kMaxOWordName) {
    problem = ErrorCode::kNameTooLong;
    return std::nullopt;
  }
  const std::string_view rest = text.substr(end);
  if (rest.empty()) {
    word.keyword = Keyword::kProgram;
    word.length = end;
    return word;
  }
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

}  // namespace armature::gcode
