#include "cosim/schema/key_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

#include "cosim/text/number_text.hpp"
#include "cosim/text/or_list.hpp"

namespace armature::cosim {
namespace {

std::string in_backticks(std::string_view text) {
  return fmt::format("`{}`", text);
}

std::string condition_sentence(const Condition& condition) {
  const std::string key = in_backticks(condition.key);
  if (condition.values.empty()) return " Only together with " + key + ".";
  return (condition.excluded ? " Not with " : " Only with ") + key + " = " + or_list(condition.values, '`') + ".";
}

std::string needs_sentence(Needs needs) {
  return needs == Needs::kNothing ? std::string{} : " It needs " + needs_text(needs, "the robot file", "`") + ".";
}

}  // namespace

std::string type_text(const KeyInfo& key) {
  static constexpr std::string_view kOne[] = {"number", "integer", "boolean", "string"};
  std::string text{kOne[static_cast<std::size_t>(key.kind)]};
  if (key.is_array && key.rule.count > 0) {
    text = fmt::format("{} {}s", key.rule.count, text);
  } else if (key.per_axis) {
    text += " per axis";
  } else if (key.is_array) {
    text += "s";
  }
  if (!key.rule.unit.empty()) text += fmt::format(" ({})", key.rule.unit);
  if (key.has_rows) text = fmt::format("1 to {} arrays of {}", key.rule.most_rows, text);
  return text;
}

std::string range_text(const KeyInfo& key) {
  const Rule& rule = key.rule;
  if (!rule.choices.empty()) return or_list(rule.choices, '`');
  std::vector<std::string> numbers;
  for (const double number : rule.numbers) numbers.push_back(number_text(number));
  std::string text = numbers.empty() ? std::string{} : or_list(numbers);
  if (std::isfinite(rule.min)) {
    const bool range = !rule.above_min && std::isfinite(rule.max);
    text = (rule.above_min ? "above " : range ? "" : "at least ") + number_text(rule.min);
    if (range) text += " to " + number_text(rule.max);
    if (rule.above_min && std::isfinite(rule.max)) text += ", up to " + number_text(rule.max);
  }
  return text;
}

std::string meaning_text(const KeyInfo& key) {
  std::string text{key.text};
  for (const ValueInfo& value : key.values) text += fmt::format(" `{}`: {}.", value.value, value.text);
  return text + use_text(key, key.conditions);
}

std::string use_text(const KeyInfo& key, std::span<const Condition> conditions) {
  std::string text;
  for (const Condition& condition : conditions) text += condition_sentence(condition);
  if (!key.replaces.empty()) text += " Use it instead of " + in_backticks(key.replaces) + ".";
  return text + needs_sentence(key.needs);
}

std::string meaning_text(const TableInfo& table) {
  return std::string{table.text} + needs_sentence(table.needs);
}

}  // namespace armature::cosim
