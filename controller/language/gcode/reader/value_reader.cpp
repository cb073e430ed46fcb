#include "controller/language/gcode/reader/value_reader.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "controller/language/gcode/reader/operations.hpp"

namespace armature::gcode {
namespace {

constexpr double kLargestWhole = 2e9;

}  // namespace

std::nullopt_t ValueReader::fail(ErrorCode code, std::size_t position) noexcept {
  if (!error_) error_ = Error{.code = code, .column = line_.column(std::min(position, line_.text().size()))};
  return std::nullopt;
}

bool ValueReader::accept(std::string_view text) noexcept {
  if (!rest().starts_with(text)) return false;
  skip(text.size());
  return true;
}

std::optional<std::int32_t> ValueReader::whole() noexcept {
  const std::size_t start = at_;
  const std::optional<double> read = value();
  if (!read) return std::nullopt;
  if (std::fabs(*read) > kLargestWhole) return fail(ErrorCode::kValueTooLarge, start);
  const double nearest = rounded(*read);
  if (std::fabs(*read - nearest) > kEqual) return fail(ErrorCode::kNotAnInteger, start);
  return static_cast<std::int32_t>(nearest);
}

std::optional<std::string_view> ValueReader::name() noexcept {
  const std::size_t start = at_;
  skip(1);
  const std::size_t length = index_of(rest(), '>');
  if (length == rest().size()) return fail(ErrorCode::kNameNotClosed, start);
  const std::string_view found = rest().substr(0, length);
  if (length > Parameters::kMaxNameLength) return fail(ErrorCode::kNameTooLong, start);
  skip(length + 1);
  return found;
}

std::optional<double> ValueReader::value() noexcept {
  if (depth_ == kMaxDepth) return fail(ErrorCode::kTooDeep);
  ++depth_;
  const std::size_t start = at_;
  std::optional<double> read;
  const char c = peek();
  const bool sign = c == '-' || c == '+';
  const char next = sign && at_ + 1 < line_.text().size() ? line_.text()[at_ + 1] : c;
  if (is_digit(next) || next == '.') {
    read = number();
  } else if (sign) {
    skip(1);
    read = value();
    if (read && c == '-') read = -*read;
  } else if (c == '[') {
    read = expression();
  } else if (c == '#') {
    read = parameter();
  } else if (is_letter(c)) {
    read = function();
  } else {
    read = fail(ErrorCode::kValueExpected);
  }
  --depth_;
  if (read && !(std::fabs(*read) <= std::numeric_limits<double>::max())) return fail(ErrorCode::kValueTooLarge, start);
  return read;
}

std::optional<double> ValueReader::number() noexcept {
  constexpr int kMaxDigits = 18;  // fit into the integer
  const std::size_t start = at_;
  const bool negative = accept("-");
  if (!negative) static_cast<void>(accept("+"));
  std::int64_t digits = 0;
  int count = 0;
  bool any = false;
  bool fraction = false;
  double scale = 1.0;  // powers of ten up to 10^22 are exact
  for (; !at_end(); skip(1)) {
    if (peek() == '.' && !fraction) {
      fraction = true;
      continue;
    }
    if (!is_digit(peek())) break;
    any = true;
    if (count == kMaxDigits) return fail(ErrorCode::kNumberTooLong, start);
    digits = 10 * digits + (peek() - '0');
    if (digits != 0) ++count;
    if (fraction) scale *= 10.0;
  }
  if (!any) return fail(ErrorCode::kNumberExpected, start);
  const double magnitude = static_cast<double>(digits) / scale;
  return negative ? -magnitude : magnitude;
}

std::optional<double> ValueReader::parameter() noexcept {
  const std::size_t start = at_;
  skip(1);
  if (peek() == '<') {
    const std::optional<std::string_view> called = name();
    if (!called) return std::nullopt;
    const std::optional<double> found = parameters_.named(*called);
    if (!found) return fail(ErrorCode::kParameterUndefined, start);
    return found;
  }
  const std::optional<std::int32_t> number = whole();
  if (!number) return std::nullopt;
  const std::optional<double> found = parameters_.numbered(*number);
  if (!found) return fail(ErrorCode::kParameterNumber, start);
  return found;
}

std::optional<double> ValueReader::function() noexcept {
  const std::size_t start = at_;
  if (accept("atan[")) {
    at_ -= 1;
    return arc_tangent();
  }
  if (accept("exists")) return exists();
  const Function* const found = find_function(rest());
  if (found == nullptr) return fail(ErrorCode::kUnknownFunction, start);
  skip(found->name.size());
  if (peek() != '[') return fail(ErrorCode::kBracketExpected);
  const std::optional<double> argument = expression();
  if (!argument) return std::nullopt;
  const Outcome outcome = found->apply(*argument);
  if (!outcome.ok) return fail(outcome.error, start);
  return outcome.value;
}

std::optional<double> ValueReader::arc_tangent() noexcept {
  const std::optional<double> y = expression();
  if (!y) return std::nullopt;
  if (!accept("/")) return fail(ErrorCode::kSlashExpected);
  if (peek() != '[') return fail(ErrorCode::kBracketExpected);
  const std::optional<double> x = expression();
  if (!x) return std::nullopt;
  return arc_tangent_deg(*y, *x);
}

std::optional<double> ValueReader::exists() noexcept {
  if (!accept("[#")) return fail(ErrorCode::kBracketExpected);
  if (peek() != '<') {
    const std::optional<std::int32_t> number = whole();
    if (!number) return std::nullopt;
    if (!accept("]")) return fail(ErrorCode::kBracketNotClosed);
    return parameters_.numbered(*number) ? 1.0 : 0.0;
  }
  const std::optional<std::string_view> called = name();
  if (!called) return std::nullopt;
  if (!accept("]")) return fail(ErrorCode::kBracketNotClosed);
  return parameters_.named(*called) ? 1.0 : 0.0;
}

std::optional<double> ValueReader::expression() noexcept {
  if (!accept("[")) return fail(ErrorCode::kBracketExpected);
  const std::optional<double> result = operation(kLowestPrecedence);
  if (!result) return std::nullopt;
  if (!accept("]")) return fail(at_end() ? ErrorCode::kBracketNotClosed : ErrorCode::kOperatorExpected);
  return result;
}

std::optional<double> ValueReader::operation(int precedence) noexcept {
  if (precedence > kHighestPrecedence) return value();
  std::optional<double> left = operation(precedence + 1);
  while (left) {
    const std::size_t start = at_;
    const OperatorWord* const found = find_operator(rest());
    if (found == nullptr || found->precedence != precedence) return left;
    skip(found->text.size());
    const std::optional<double> right = operation(precedence + 1);
    if (!right) return std::nullopt;
    const Outcome outcome = apply(found->op, *left, *right);
    if (!outcome.ok) return fail(outcome.error, start);
    if (!(std::fabs(outcome.value) <= std::numeric_limits<double>::max()))
      return fail(ErrorCode::kValueTooLarge, start);
    left = outcome.value;
  }
  return left;
}

}  // namespace armature::gcode
