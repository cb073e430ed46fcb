#include "cosim/scenario/toml/value_rule.hpp"

#include <algorithm>
#include <cmath>

#include "cosim/text/number_text.hpp"
#include "cosim/text/or_list.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/suggest.hpp"

namespace armature::cosim {
namespace {

std::string range_text(const Rule& rule) {
  std::string text;
  const bool lower = std::isfinite(rule.min);
  const bool upper = std::isfinite(rule.max);
  if (lower && rule.above_min) {
    text = " above " + number_text(rule.min);
    if (upper) text += " up to " + number_text(rule.max);
  } else if (lower && upper) {
    text = " from " + number_text(rule.min) + " to " + number_text(rule.max);
  } else if (lower) {
    text = " of at least " + number_text(rule.min);
  } else if (upper) {
    text = " up to " + number_text(rule.max);
  }
  if (!rule.unit.empty()) text.append(" (").append(rule.unit).append(")");
  return text;
}

bool inside(double value, const Rule& rule) {
  if (!rule.numbers.empty()) return std::ranges::find(rule.numbers, value) != rule.numbers.end();
  return (rule.above_min ? value > rule.min : value >= rule.min) && value <= rule.max;
}

bool refuse(const ConfigValue& value, const std::string& path, ValueKind kind, const Rule& rule,
            ProblemList& problems) {
  problems.add(value.origin, path, "expected " + expected_one(kind, rule) + ", found " + describe(value));
  return false;
}

}  // namespace

std::string quoted_list(const std::vector<std::string_view>& choices) {
  return or_list(choices, '"');
}

std::string expected_one(ValueKind kind, const Rule& rule) {
  if (!rule.numbers.empty()) {
    std::vector<std::string> texts;
    for (const double number : rule.numbers) texts.push_back(number_text(number));
    return or_list(texts);
  }
  switch (kind) {
    case ValueKind::kNumber:
      return "a number" + range_text(rule);
    case ValueKind::kInteger:
      return "an integer" + range_text(rule);
    case ValueKind::kBoolean:
      return "true or false";
    case ValueKind::kString:
      break;
  }
  return rule.choices.empty() ? "a string" : quoted_list(rule.choices);
}

std::string expected_array(ValueKind kind, const Rule& rule, std::size_t count) {
  static constexpr std::string_view kPlural[] = {"numbers", "integers", "booleans", "strings"};
  std::string text = "an array of ";
  if (count > 0) text += std::to_string(count) + " ";
  text += kPlural[static_cast<std::size_t>(kind)];
  if (!rule.unit.empty()) text.append(" (").append(rule.unit).append(")");
  return text;
}

std::string expected_rows(ValueKind kind, const Rule& rule, std::size_t count) {
  std::string text = expected_array(kind, rule, count);
  text.replace(0, std::string_view{"an array"}.size(), "arrays");
  return "an array of 1 to " + std::to_string(rule.most_rows) + " " + text;
}

std::string element_key(const std::string& array_key, std::size_t index) {
  std::string key = array_key;
  return key.append("[").append(std::to_string(index)).append("]");
}

bool convert(const ConfigValue& value, const std::string& path, const Rule& rule, ProblemList& problems, double& out) {
  double number = 0;
  if (const auto* integer = std::get_if<std::int64_t>(&value.data)) {
    number = static_cast<double>(*integer);
  } else if (const auto* real = std::get_if<double>(&value.data)) {
    number = *real;
  } else {
    return refuse(value, path, ValueKind::kNumber, rule, problems);
  }
  // NaN and infinity are refused even without bounds.
  if (!std::isfinite(number) || !inside(number, rule)) return refuse(value, path, ValueKind::kNumber, rule, problems);
  out = number;
  return true;
}

bool convert(const ConfigValue& value, const std::string& path, const Rule& rule, ProblemList& problems,
             std::int64_t& out) {
  const auto* integer = std::get_if<std::int64_t>(&value.data);
  if (integer == nullptr || !inside(static_cast<double>(*integer), rule)) {
    return refuse(value, path, ValueKind::kInteger, rule, problems);
  }
  out = *integer;
  return true;
}

bool convert(const ConfigValue& value, const std::string& path, const Rule& rule, ProblemList& problems, bool& out) {
  const auto* boolean = std::get_if<bool>(&value.data);
  if (boolean == nullptr) return refuse(value, path, ValueKind::kBoolean, rule, problems);
  out = *boolean;
  return true;
}

bool convert(const ConfigValue& value, const std::string& path, const Rule& rule, ProblemList& problems,
             std::string& out) {
  const auto* text = std::get_if<std::string>(&value.data);
  if (text == nullptr) return refuse(value, path, ValueKind::kString, rule, problems);
  if (!rule.choices.empty() && std::find(rule.choices.begin(), rule.choices.end(), *text) == rule.choices.end()) {
    std::string message = "expected " + expected_one(ValueKind::kString, rule) + ", found \"" + printable(*text) + "\"";
    const std::string_view near = nearest_name(*text, rule.choices);
    if (!near.empty()) message += ", did you mean \"" + std::string{near} + "\"?";
    if (near.empty() && !rule.otherwise.empty()) message.append("; ").append(rule.otherwise);
    problems.add(value.origin, path, std::move(message));
    return false;
  }
  out = *text;
  return true;
}

}  // namespace armature::cosim
