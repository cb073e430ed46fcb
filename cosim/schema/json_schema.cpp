#include "cosim/schema/json_schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "cosim/robot/robot_spec.hpp"
#include "cosim/schema/key_text.hpp"
#include "cosim/text/json.hpp"

namespace armature::cosim {
namespace {

using Conditions = std::vector<Condition>;

Json number(double value) {
  constexpr double kExact = 1e15;
  if (std::trunc(value) == value && std::fabs(value) < kExact) return static_cast<std::int64_t>(value);
  return value;
}

// The value of a key: its type and what its rule allows.
Json value_schema(const KeyInfo& key) {
  static constexpr std::string_view kTypes[] = {"number", "integer", "boolean", "string"};
  Json schema;
  schema["type"] = kTypes[static_cast<std::size_t>(key.kind)];
  if (std::isfinite(key.rule.min)) schema[key.rule.above_min ? "exclusiveMinimum" : "minimum"] = number(key.rule.min);
  if (std::isfinite(key.rule.max)) schema["maximum"] = number(key.rule.max);
  if (!key.rule.choices.empty()) schema["enum"] = key.rule.choices;
  for (const double choice : key.rule.numbers) schema["enum"].push_back(number(choice));
  if (!key.pattern.empty()) schema["pattern"] = key.pattern;
  if (!key.is_array) return schema;
  Json array{{"type", "array"}, {"items", schema}};
  const bool any_robot = key.per_axis && key.rule.count == 0;
  if (any_robot || key.rule.count > 0) {
    array["minItems"] = any_robot ? joints_of(kFiveRFamily) : key.rule.count;
    array["maxItems"] = any_robot ? kAxes : key.rule.count;
  }
  if (key.has_rows) return {{"type", "array"}, {"items", array}, {"minItems", 1}, {"maxItems", key.rule.most_rows}};
  return array;
}

// A schema that is met where the condition holds.
Json condition_schema(const Condition& condition, const TableInfo& table) {
  if (condition.values.empty()) return {{"required", {condition.key}}};
  Json schema{{"properties", {{condition.key, {{"enum", condition.values}}}}}};
  const auto other = std::ranges::find(table.keys, condition.key, &KeyInfo::name);
  const bool by_default = std::ranges::any_of(
      condition.values, [&](std::string_view value) { return Json(value).dump() == other->default_text; });
  if (!by_default) schema["required"] = {condition.key};
  if (condition.excluded) return {{"not", schema}};
  return schema;
}

Json all_hold(const Conditions& conditions, const TableInfo& table) {
  Json all = Json::array();
  for (const Condition& condition : conditions) all.push_back(condition_schema(condition, table));
  return all.size() == 1 ? all[0] : Json{{"allOf", all}};
}

class TableSchema {
 public:
  explicit TableSchema(const TableInfo& table) : table_{table} {
    for (const KeyInfo& key : table.keys) {
      if (key.refused.empty()) keys_.push_back(&key);
    }
  }

  Json write() {
    Json schema{{"type", "object"}};
    if (!table_.text.empty()) schema["description"] = meaning_text(table_);
    for (const KeyInfo* key : keys_) add_property(*key);
    for (const KeyInfo* key : keys_) add_requirement(*key);
    for (const KeyInfo* key : keys_) add_refusal(*key);
    for (const TableInfo& sub : table_.tables) add_table(sub);
    schema["properties"] = properties_;
    schema["additionalProperties"] = false;
    if (!required_.empty()) schema["required"] = required_;
    for (const auto& [conditions, then] : when_) {
      rules_.push_back({{"if", all_hold(conditions, table_)}, {"then", then}});
    }
    for (const auto& [alternatives, names] : refused_) rules_.push_back(refusal(alternatives, names));
    if (!rules_.empty()) schema["allOf"] = rules_;
    return schema;
  }

 private:
  // All entries of a key, in their order.
  [[nodiscard]] std::vector<const KeyInfo*> entries_of(std::string_view name) const {
    std::vector<const KeyInfo*> entries;
    std::ranges::copy_if(keys_, std::back_inserter(entries), [&](const KeyInfo* key) { return key->name == name; });
    return entries;
  }
  [[nodiscard]] bool is_first(const KeyInfo& key) const { return entries_of(key.name).front() == &key; }
  // Whether all entries of the key allow the same values.
  [[nodiscard]] bool is_uniform(std::string_view name) const {
    const std::vector<const KeyInfo*> entries = entries_of(name);
    return std::ranges::all_of(entries,
                               [&](const KeyInfo* key) { return value_schema(*key) == value_schema(*entries[0]); });
  }

  void add_property(const KeyInfo& key) {
    if (!is_first(key)) return;
    std::string description;
    std::string default_text;
    for (const KeyInfo* entry : entries_of(key.name)) {
      const std::string meaning = meaning_text(*entry);
      if (description.find(meaning) == std::string::npos) description += (description.empty() ? "" : " ") + meaning;
      if (default_text.empty()) default_text = entry->default_text;
    }
    if (!key.rule.unit.empty()) description += fmt::format(" Unit: {}.", key.rule.unit);
    Json property{{"description", description}};
    const Json value = value_schema(key);
    property.update(is_uniform(key.name) ? value : Json{{"type", value["type"]}});
    if (!default_text.empty()) property["default"] = Json::parse(default_text);
    properties_[std::string{key.name}] = property;
  }

  Json& then_of(const Conditions& conditions) {
    const auto found = std::ranges::find(when_, conditions, &std::pair<Conditions, Json>::first);
    return found != when_.end() ? found->second : when_.emplace_back(conditions, Json::object()).second;
  }

  void add_requirement(const KeyInfo& key) {
    const std::string name{key.name};
    if (!is_uniform(key.name)) then_of(key.conditions)["properties"][name] = value_schema(key);
    if (!key.replaces.empty()) rules_.push_back({{"not", {{"required", {key.name, key.replaces}}}}});
    if (key.need != Need::kRequired || table_.all_optional) return;
    Json alternatives = Json::array({{{"required", {name}}}});
    for (const KeyInfo* other : keys_) {
      if (other->replaces == key.name) alternatives.push_back({{"required", {other->name}}});
    }
    if (!key.spared_by.empty()) alternatives.push_back({{"required", {key.spared_by}}});
    if (alternatives.size() > 1 && key.conditions.empty()) {
      rules_.push_back({{"anyOf", alternatives}});
    } else if (alternatives.size() > 1) {
      then_of(key.conditions)["anyOf"] = alternatives;
    } else if (key.conditions.empty()) {
      required_.push_back(name);
    } else {
      then_of(key.conditions)["required"].push_back(name);
    }
  }

  void add_refusal(const KeyInfo& key) {
    if (!is_first(key)) return;
    std::vector<Conditions> alternatives;
    for (const KeyInfo* entry : entries_of(key.name)) {
      if (entry->conditions.empty()) return;
      alternatives.push_back(entry->conditions);
    }
    const auto found = std::ranges::find(refused_, alternatives, &Refusal::first);
    (found != refused_.end() ? found->second : refused_.emplace_back(alternatives, std::vector<std::string>{}).second)
        .emplace_back(key.name);
  }

  Json refusal(const std::vector<Conditions>& alternatives, const std::vector<std::string>& names) const {
    Json any = Json::array();
    for (const Conditions& conditions : alternatives) any.push_back(all_hold(conditions, table_));
    Json none = Json::object();
    for (const std::string& name : names) none[name] = false;
    return {{"if", {{"not", any.size() == 1 ? any[0] : Json{{"anyOf", any}}}}}, {"then", {{"properties", none}}}};
  }

  void add_table(const TableInfo& sub) {
    Json schema = TableSchema{sub}.write();
    if (sub.repeated) {
      schema = {{"type", "array"}, {"items", schema}};
      if (sub.least > 0) schema["minItems"] = sub.least;
      if (sub.most > 0) schema["maxItems"] = sub.most;
    }
    if (sub.least > 0) required_.emplace_back(sub.name);
    properties_[std::string{sub.name}] = schema;
  }

  using Refusal = std::pair<std::vector<Conditions>, std::vector<std::string>>;
  const TableInfo& table_;
  std::vector<const KeyInfo*> keys_;
  Json properties_ = Json::object();
  std::vector<std::string> required_;
  std::vector<std::pair<Conditions, Json>> when_;  // what holds where the conditions do
  std::vector<Refusal> refused_;                   // keys that exist under one of the conditions only
  Json rules_ = Json::array();
};

}  // namespace

std::string json_schema(const TableInfo& file, const std::string& id, const std::string& title) {
  Json schema{
      {"$schema", "http://json-schema.org/draft-07/schema#"},
      {"$id", id},
      {"$comment", "Written by 'armature schema' and keydoc from the entries in cosim/scenario/tables. Do not edit."},
      {"title", title}};
  schema.update(TableSchema{file}.write());
  return schema.dump(2) + "\n";
}

}  // namespace armature::cosim
