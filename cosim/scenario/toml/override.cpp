#include "cosim/scenario/toml/override.hpp"

#include <cstddef>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "cosim/scenario/toml/toml_document.hpp"
#include "cosim/scenario/toml/toml_limits.hpp"
#include "cosim/scenario/toml/value_rule.hpp"
#include "cosim/text/number_text.hpp"

namespace armature::cosim {
namespace {

using Step = std::variant<std::string, std::size_t>;  // a key of a table or an element of an array

bool is_bare_key(std::string_view key) {
  return !key.empty() && key.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-") ==
                             std::string_view::npos;
}

// Splits `move[0].at_s`. Nothing if the text is no dotted key.
std::optional<std::vector<Step>> parse_path(std::string_view text) {
  std::vector<Step> steps;
  while (true) {
    const std::string_view key = text.substr(0, text.find_first_of(".["));
    if (!is_bare_key(key)) return std::nullopt;
    if (steps.size() >= kMaxKeyParts) return std::nullopt;
    steps.emplace_back(std::string{key});
    text.remove_prefix(key.size());
    while (text.starts_with('[')) {
      const std::size_t close = text.find(']');
      if (close == std::string_view::npos) return std::nullopt;
      const auto index = parsed_number<std::size_t>(text.substr(1, close - 1));
      if (!index) return std::nullopt;
      steps.emplace_back(*index);
      text.remove_prefix(close + 1);
    }
    if (text.empty()) return steps;
    if (!text.starts_with('.')) return std::nullopt;
    text.remove_prefix(1);
  }
}

void set_origin(ConfigValue& value, const Origin& origin) {
  value.origin = origin;
  if (auto* array = value.array()) {
    for (ConfigValue& element : *array) set_origin(element, origin);
  }
  if (auto* table = value.table()) {
    for (ConfigEntry& entry : *table) {
      entry.origin = origin;
      set_origin(entry.value, origin);
    }
  }
}

ConfigValue parse_value(const std::string& text) {
  try {
    // The text must be one line, so that a value cannot add further keys.
    if (text.find('\n') == std::string::npos) {
      ConfigValue document = parse_toml("value = " + text, "--set");
      return std::move(document.find("value")->value);
    }
  } catch (const InputError&) {
    // Not TOML: a bare word.
  }
  return ConfigValue{text, {}};
}

}  // namespace

void apply_override(ConfigValue& root, const std::string& assignment, ProblemList& problems) {
  const Origin origin{0, 0, assignment};
  const std::size_t equals = assignment.find('=');
  const auto path = parse_path(std::string_view{assignment}.substr(0, equals));
  if (equals == std::string::npos || !path) {
    problems.add(origin, "", "expected key=value with a dotted key, such as controller.feedback=false");
    return;
  }
  ConfigValue* place = &root;
  std::string so_far;
  for (const Step& step : *path) {
    if (const auto* key = std::get_if<std::string>(&step)) {
      auto* table = place->table();
      if (table == nullptr) {
        problems.add(origin, so_far, "expected a table to set a key of, found " + describe(*place));
        return;
      }
      if (place->find(*key) == nullptr) table->push_back({*key, origin, ConfigValue{ConfigValue::Table{}, origin}});
      place = &place->find(*key)->value;
      if (!so_far.empty()) so_far += '.';
      so_far += *key;
    } else {
      const std::size_t index = std::get<std::size_t>(step);
      auto* array = place->array();
      const std::size_t size = array == nullptr ? 0 : array->size();
      if (index >= size) {
        problems.add(origin, element_key(so_far, index), "no such element, " + so_far + " has " + std::to_string(size));
        return;
      }
      place = &(*array)[index];
      so_far = element_key(so_far, index);
    }
  }
  *place = parse_value(assignment.substr(equals + 1));
  set_origin(*place, origin);
}

}  // namespace armature::cosim
