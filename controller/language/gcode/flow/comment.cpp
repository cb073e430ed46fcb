#include "controller/language/gcode/flow/comment.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "controller/base/rounding.hpp"
#include "controller/language/gcode/reader/source_line.hpp"

namespace armature::gcode {
namespace {

struct Prefix {
  std::string_view text;
  Text::Kind kind;
  bool expands;
  bool aborts = false;
};
constexpr std::array kPrefixes{Prefix{"msg,", Text::Kind::kMessage, false},
                               Prefix{"debug,", Text::Kind::kMessage, true}, Prefix{"print,", Text::Kind::kPrint, true},
                               Prefix{"log,", Text::Kind::kLog, true},
                               Prefix{.text = "abort,", .kind = Text::Kind::kMessage, .expands = true, .aborts = true}};

bool begins_with(std::string_view text, std::string_view prefix) noexcept {
  if (text.size() < prefix.size()) return false;
  for (std::size_t i = 0; i < prefix.size(); ++i) {
    if (to_lower(text[i]) != prefix[i]) return false;
  }
  return true;
}

}  // namespace

void ExpandedComment::expand(std::string_view comment, const Parameters& parameters) noexcept {
  text_.clear();
  kind_ = Text::Kind::kComment;
  aborts_ = false;
  digits_ = kDigits;
  std::size_t first = 0;
  while (first < comment.size() && is_blank(comment[first])) ++first;
  const auto* const prefix =
      std::ranges::find_if(kPrefixes, [&](const Prefix& one) { return begins_with(comment.substr(first), one.text); });
  if (prefix == kPrefixes.end()) {
    text_ << comment;
    return;
  }
  kind_ = prefix->kind;
  aborts_ = prefix->aborts;
  std::string_view rest = comment.substr(first + prefix->text.size());
  if (!prefix->expands) {
    text_ << rest;
    return;
  }
  while (!rest.empty()) {
    std::size_t length = 1;
    if (const std::size_t format = read_format(rest); format > 0) {
      length = format;
    } else if (rest.front() == '#') {
      length += add_parameter(rest.substr(1), parameters);
    } else {
      text_ << rest.front();
    }
    rest.remove_prefix(length);
  }
}

std::size_t ExpandedComment::add_parameter(std::string_view text, const Parameters& parameters) noexcept {
  std::optional<double> value;
  std::size_t length = 0;
  if (!text.empty() && text.front() == '<') {
    const std::size_t close = index_of(text, '>');
    if (close == text.size()) {
      text_ << '#';
      return 0;
    }
    std::array<char, Parameters::kMaxNameLength> name{};
    std::size_t size = 0;
    for (const char c : text.substr(1, close - 1)) {
      if (!is_blank(c) && size < name.size()) name[size++] = to_lower(c);
    }
    value = parameters.named({name.data(), size});
    length = close + 1;
  } else {
    int number = 0;
    while (length < text.size() && is_digit(text[length]) && number <= Parameters::kLast) {
      number = 10 * number + (text[length] - '0');
      ++length;
    }
    if (length > 0) value = parameters.numbered(number);
  }
  if (value) {
    add_number(*value);
  } else {
    text_ << "######";
  }
  return length;
}

// "%d": whole numbers from here on; "%f": four digits; "%.nf": n digits, 0 to 9. The length of it; 0: there is none.
std::size_t ExpandedComment::read_format(std::string_view text) noexcept {
  if (text.starts_with("%d")) {
    digits_ = 0;
    return 2;
  }
  if (text.starts_with("%f")) {
    digits_ = 4;
    return 2;
  }
  if (text.size() < 4 || !text.starts_with("%.") || !is_digit(text[2]) || text[3] != 'f') return 0;
  digits_ = text[2] - '0';
  return 4;
}

void ExpandedComment::add_number(double value) noexcept {
  constexpr double kMaxNumber = 9e12;  // its millionths fit into an integer
  if (!(std::fabs(value) < kMaxNumber)) {
    text_ << (value > 0.0 ? std::string_view{"above 9e12"} : std::string_view{"below -9e12"});
    return;
  }
  std::uint64_t scale = 1;
  for (int i = 0; i < digits_; ++i) scale *= 10;
  const double whole = std::floor(std::fabs(value));
  const double fraction = (std::fabs(value) - whole) * static_cast<double>(scale);
  auto parts = static_cast<std::uint64_t>(round_half_away(fraction));
  auto units = static_cast<std::uint64_t>(whole);
  if (digits_ == 0 && fraction == 0.5) parts = units % 2;  // halves to the even number
  if (parts == scale) {
    parts = 0;
    ++units;
  }
  if (value < 0.0) text_ << '-';
  text_.append_digits(units, 1);
  if (digits_ > 0) (text_ << '.').append_digits(parts, digits_);
}

}  // namespace armature::gcode
