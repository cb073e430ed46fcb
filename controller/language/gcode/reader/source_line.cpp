#include "controller/language/gcode/reader/source_line.hpp"

namespace armature::gcode {
namespace {

Error error_at(ErrorCode code, std::size_t index) noexcept {
  return {.code = code, .column = static_cast<std::uint16_t>(index + 1)};
}

}  // namespace

std::optional<Error> SourceLine::read(std::string_view source) noexcept {
  length_ = 0;
  comment_.reset();
  if (source.size() > kMaxLength) return Error{.code = ErrorCode::kLineTooLong, .column = kMaxLength + 1};
  for (std::size_t i = 0; i < source.size(); ++i) {
    const char c = source[i];
    if (c == ';') break;
    if (is_blank(c)) continue;
    if (c == '(') {
      std::size_t end = i + 1;
      while (end < source.size() && source[end] != ')' && source[end] != '(') ++end;
      if (end == source.size()) return error_at(ErrorCode::kCommentNotClosed, i);
      if (source[end] == '(') return error_at(ErrorCode::kNestedComment, end);
      comment_ = source.substr(i + 1, end - i - 1);
      i = end;
      continue;
    }
    if (c < ' ' || c > '~' || c == ')') {
      Error error = error_at(ErrorCode::kBadCharacter, i);
      error.letter = c;
      return error;
    }
    text_[length_] = to_lower(c);
    columns_[length_] = static_cast<std::uint16_t>(i + 1);
    ++length_;
  }
  columns_[length_] = static_cast<std::uint16_t>(source.size() + 1);
  return std::nullopt;
}

LineSpan line_at(std::string_view program, std::size_t start) noexcept {
  LineSpan line{.begin = start, .end = start, .next = 0};
  while (line.end < program.size() && program[line.end] != '\n' && program[line.end] != '\r') ++line.end;
  line.next = line.end;
  if (line.next < program.size()) {
    const bool pair = program[line.next] == '\r' && line.next + 1 < program.size() && program[line.next + 1] == '\n';
    line.next += pair ? 2 : 1;
  }
  return line;
}

}  // namespace armature::gcode
