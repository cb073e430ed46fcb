#include "controller/language/gcode/reader/parameters.hpp"

#include <algorithm>

namespace armature::gcode {
namespace {

constexpr int kFirstReadOnly = 5400;
constexpr int kLastReadOnly = 5428;

}  // namespace

std::optional<double> find_value(std::string_view name, std::initializer_list<NamedValue> values) noexcept {
  for (const NamedValue& one : values) {
    if (one.name == name) return one.value;
  }
  return std::nullopt;
}

void Parameters::begin_program() noexcept {
  std::fill(numbers_.begin(), numbers_.begin() + kFirstStored, 0.0);
  named_count_ = 0;
  level_ = 0;
}

std::optional<double> Parameters::numbered(int number) const noexcept {
  if (number < 1 || number > kLast) return std::nullopt;
  if (const std::optional<double> value = computed_.computed(number)) return value;
  return at(number);
}

std::optional<double> Parameters::named(std::string_view name) const noexcept {
  if (const std::optional<double> value = computed_.computed(name)) return value;
  const std::size_t index = find(name);
  if (index == named_count_) return std::nullopt;
  return named_[index].value;
}

std::optional<ErrorCode> Parameters::set(int number, double value) noexcept {
  if (number < 1 || number > kLast) return ErrorCode::kParameterNumber;
  if (number >= kFirstReadOnly && number <= kLastReadOnly) return ErrorCode::kParameterReadOnly;
  at(number) = value;
  return std::nullopt;
}

std::optional<ErrorCode> Parameters::set(std::string_view name, double value) noexcept {
  if (name.size() > kMaxNameLength) return ErrorCode::kNameTooLong;
  if (computed_.computed(name)) return ErrorCode::kParameterReadOnly;
  const std::size_t index = find(name);
  if (index == kMaxNamed) return ErrorCode::kTooManyNames;
  if (index == named_count_) {
    Named& added = named_[named_count_++];
    std::ranges::copy(name, added.name.begin());
    added.length = static_cast<std::uint8_t>(name.size());
    added.level = static_cast<std::uint8_t>(is_global(name) ? 0 : level_);
  }
  named_[index].value = value;
  return std::nullopt;
}

bool Parameters::enter(std::span<const double> arguments) noexcept {
  if (level_ == kMaxCalls) return false;
  std::copy_n(numbers_.begin() + 1, kLocals, saved_[level_].begin());
  std::fill_n(numbers_.begin() + 1, kLocals, 0.0);
  std::copy_n(arguments.begin(), std::min<std::size_t>(arguments.size(), kLocals), numbers_.begin() + 1);
  ++level_;
  return true;
}

void Parameters::leave() noexcept {
  if (level_ == 0) return;
  // The names of the subroutine go; the order of the others stays.
  const auto leaves = [this](const Named& named) { return named.level == level_; };
  const auto end = named_.begin() + static_cast<std::ptrdiff_t>(named_count_);
  named_count_ = static_cast<std::size_t>(std::remove_if(named_.begin(), end, leaves) - named_.begin());
  --level_;
  std::copy_n(saved_[level_].begin(), kLocals, numbers_.begin() + 1);
}

std::size_t Parameters::find(std::string_view name) const noexcept {
  const std::size_t level = is_global(name) ? 0 : level_;
  for (std::size_t i = 0; i < named_count_; ++i) {
    if (named_[i].level == level && named_[i].view() == name) return i;
  }
  return named_count_;
}

}  // namespace armature::gcode
