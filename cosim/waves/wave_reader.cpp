#include "cosim/waves/wave_reader.hpp"

#include <fmt/format.h>

#include <array>
#include <limits>
#include <utility>

#include "cosim/text/input_error.hpp"
#include "cosim/text/number_text.hpp"

namespace armature::cosim {
namespace {

constexpr std::string_view kEnd = "$end";
constexpr std::string_view kUnknown = "x";

// Two texts of one value are equal afterwards: digits in front that VCD lets a writer leave out are left out.
std::string_view shortest(std::string_view digits) {
  while (digits.size() > 1 && digits[0] == digits[1] && digits[0] != '1') digits.remove_prefix(1);
  if (digits.size() > 1 && digits[0] == '0' && digits[1] == '1') digits.remove_prefix(1);
  return digits;
}

std::optional<std::int64_t> whole_number(std::string_view digits) {
  const auto number = parsed_number<std::int64_t>(digits);
  return number && *number >= 0 ? number : std::nullopt;
}

}  // namespace

WaveReader::WaveReader(const std::filesystem::path& file) : input_{file} {
  read_declarations();
  values_.assign(codes_.size(), std::string{kUnknown});
  read_first_time();
}

bool WaveReader::next() {
  changed_.clear();
  const std::int64_t at_ps = next_ps_.value();
  next_ps_.reset();
  for (std::string_view word = input_.word(); !word.empty(); word = input_.word()) {
    if (read_change(word)) continue;
    read_time(word.substr(1));
    if (*next_ps_ < at_ps) refuse("times in ascending order", word_);
    if (*next_ps_ > at_ps) break;
    next_ps_.reset();
  }
  if (!next_ps_ && (ends_early_ || input_.ends_early())) return false;
  now_ps_ = at_ps;
  return true;
}

// Values in front of the first time are those at that time.
void WaveReader::read_first_time() {
  for (std::string_view word = input_.word(); !word.empty(); word = input_.word()) {
    if (read_change(word)) continue;
    read_time(word.substr(1));
    return;
  }
}

// A change of a value or a word without a meaning. Returns false for a time.
bool WaveReader::read_change(std::string_view word) {
  switch (word[0]) {
    case '#':
      return false;
    case '0':
    case '1':
    case 'x':
    case 'X':
    case 'z':
    case 'Z':
      set(word.substr(1), word.substr(0, 1));
      return true;
    case 'b':
    case 'B':
      word_ = word.substr(1);
      set_next(shortest(word_));
      return true;
    case 'r':
    case 'R':
    case 's':
    case 'S':
      word_ = word;
      set_next(word_);
      return true;
    case '$':
      if (word == "$comment") skip_section();
      return true;  // $dumpvars and its $end
    default:
      refuse("a time or the change of a value", word);
  }
}

void WaveReader::read_time(std::string_view digits) {
  word_ = digits;
  const std::optional<std::int64_t> units = whole_number(digits);
  if (!units || *units > std::numeric_limits<std::int64_t>::max() / unit_ps_) refuse("a time after #", digits);
  next_ps_ = *units * unit_ps_;
}

// The next word is the code.
void WaveReader::set_next(std::string_view value) {
  const std::string_view code = input_.word();
  if (code.empty()) {
    ends_early_ = true;
  } else {
    set(code, value);
  }
}

void WaveReader::set(std::string_view code, std::string_view value) {
  const std::uint32_t number = codes_.find(code);
  if (number == WaveCodes::kNone) refuse("the code of a signal", code);
  values_[number] = value;
  changed_.push_back(number);
}

void WaveReader::read_declarations() {
  std::vector<std::size_t> outer;  // lengths of the scopes around
  std::string scope;
  for (bool more = true; more;) {
    const std::string_view word = declaration_word();
    more = word != "$enddefinitions";
    if (word == "$scope") {
      declaration_word();  // its kind
      outer.push_back(scope.size());
      scope += scope.empty() ? "" : ".";
      scope += declaration_word();
    } else if (word == "$upscope") {
      if (outer.empty()) refuse("$scope before $upscope", word);
      scope.resize(outer.back());
      outer.pop_back();
    } else if (word == "$var") {
      declare_signal(scope);
      continue;
    } else if (word == "$timescale") {
      read_timescale();
      continue;
    } else if (!word.starts_with('$')) {
      refuse("a waveform in the form of VCD", word);
    }
    skip_section();
  }
}

// kind, bits, code, name, bit range
void WaveReader::declare_signal(const std::string& scope) {
  declaration_word();
  WaveSignal signal;
  const std::string_view bits = declaration_word();
  const std::optional<std::int64_t> number = whole_number(bits);
  if (!number || *number > std::numeric_limits<int>::max()) refuse("a number of bits", bits);
  signal.bits = static_cast<int>(*number);
  signal.value = codes_.add(declaration_word());
  signal.name = scope + (scope.empty() ? "" : ".") + std::string{declaration_word()};
  for (std::string_view word = declaration_word(); word != kEnd; word = declaration_word()) signal.range += word;
  signals_.push_back(std::move(signal));
}

void WaveReader::read_timescale() {
  std::string text;
  for (std::string_view word = declaration_word(); word != kEnd; word = declaration_word()) text += word;
  constexpr std::array<std::pair<std::string_view, std::int64_t>, 4> kUnits{
      {{"ps", 1}, {"ns", 1'000}, {"us", 1'000'000}, {"ms", 1'000'000'000}}};
  const std::size_t digits = text.find_first_not_of("0123456789");
  const std::optional<std::int64_t> number = whole_number(std::string_view{text}.substr(0, digits));
  for (const auto& [name, ps] : kUnits) {
    if (number && *number >= 1 && *number <= 100 && digits != std::string::npos && text.substr(digits) == name) {
      unit_ps_ = *number * ps;
      return;
    }
  }
  refuse("a $timescale from 1 ps to 100 ms", text);
}

void WaveReader::skip_section() {
  while (declaration_word() != kEnd) {
  }
}

std::string_view WaveReader::declaration_word() {
  const std::string_view word = input_.word();
  if (word.empty()) throw InputError{file(), "is no complete waveform: its declarations do not end"};
  return word;
}

void WaveReader::refuse(std::string_view expected, std::string_view found) const {
  constexpr std::size_t kMaxFound = 40;
  throw InputError{file(), fmt::format("expected {}, found '{}'", expected, found.substr(0, kMaxFound))};
}

}  // namespace armature::cosim
