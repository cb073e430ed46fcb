#include "cosim/scenario/keys/table_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "cosim/scenario/keys/toml_text.hpp"

namespace armature::cosim {
namespace {

// The condition to report for a key: the first one that does not hold, of the entry with the most that hold before it.
// If several entries need other values of the same key, all these values.
class NearestCondition {
 public:
  void add(const Condition& failed, std::size_t held) {
    if (nearest_.key.empty() || held > held_) {
      nearest_ = failed;
      held_ = held;
    } else if (held == held_ && nearest_.key == failed.key && !nearest_.excluded) {
      nearest_.values.insert(nearest_.values.end(), failed.values.begin(), failed.values.end());
    }
  }
  [[nodiscard]] const Condition& get() const { return nearest_; }

 private:
  Condition nearest_;
  std::size_t held_ = 0;
};

}  // namespace

TableKeys::TableKeys(TableReader& table, std::vector<const KeyInfo*> entries, const KeyContext& context)
    : table_{&table}, entries_{std::move(entries)}, context_{&context} {}

const KeyInfo* TableKeys::entry_of(std::string_view key) const {
  const auto found = std::ranges::find(entries_, key, &KeyInfo::name);
  return found == entries_.end() ? nullptr : *found;
}

TableKeys::Holds TableKeys::holds(const Condition& condition) const {
  if (condition.values.empty()) {
    if (table_->has(condition.key)) return Holds::kYes;
    const auto is_missing = [&](const KeyInfo* entry) {
      return entry->name == condition.key && exists(*entry) && need(*entry) == Need::kRequired;
    };
    return std::ranges::any_of(entries_, is_missing) ? Holds::kUnknown : Holds::kNo;
  }
  const KeyInfo& other = *entry_of(condition.key);
  const std::string* value = table_->string(condition.key);
  if (value == nullptr && (table_->has(condition.key) || other.need == Need::kRequired)) return Holds::kUnknown;
  const auto is = [&](std::string_view one) {
    return value != nullptr ? *value == one : other.default_text == toml_text(std::string{one});
  };
  const std::vector<std::string_view>& choices = other.rule.choices;
  if (value != nullptr && std::ranges::none_of(choices, is)) return Holds::kUnknown;
  return std::ranges::any_of(condition.values, is) != condition.excluded ? Holds::kYes : Holds::kNo;
}

bool TableKeys::exists(const KeyInfo& entry) const {
  return std::ranges::all_of(entry.conditions, [&](const Condition& one) { return holds(one) == Holds::kYes; });
}

Rule TableKeys::rule(const KeyInfo& entry) const {
  Rule rule = entry.rule;
  if (entry.per_axis && rule.count == 0) rule.count = context_->robot.axis_count();
  if (!entry.spared_by.empty()) rule.when_missing.append(", needed without ").append(entry.spared_by);
  for (const KeyInfo* other : entries_) {
    if (other->replaces == entry.name && exists(*other)) rule.when_missing.append(" or ").append(other->name);
  }
  // The last condition is the most specific one.
  for (auto condition = entry.conditions.rbegin(); condition != entry.conditions.rend(); ++condition) {
    const std::string* value = table_->string(condition->key);
    if (condition->values.empty() || condition->excluded || value == nullptr) continue;
    rule.when_missing += ", needed with " + condition_text({condition->key, {*value}});
    break;
  }
  return rule;
}

Need TableKeys::need(const KeyInfo& entry) const {
  const bool replaced = std::ranges::any_of(
      entries_, [&](const KeyInfo* other) { return other->replaces == entry.name && table_->has(other->name); });
  const bool spared = !entry.spared_by.empty() && table_->has(entry.spared_by);
  return replaced || spared ? Need::kOptional : entry.need;
}

void TableKeys::report() {
  const bool has_unread = table_->has_unknown();  // otherwise no key needs a reason or a suggestion
  for (const KeyInfo* entry : entries_) {
    if (!entry->refused.empty() && exists(*entry)) {
      table_->reject(entry->name, std::string{entry->refused});
    } else if (exists(*entry)) {
      report_beside(*entry);
    } else if (has_unread && entry_of(entry->name) == entry) {
      report_absence_of(*entry);
    }
  }
}

// Called for the first entry of a key, if the conditions of that entry do not hold.
void TableKeys::report_absence_of(const KeyInfo& first) {
  std::vector<const KeyInfo*> all;
  for (const KeyInfo* entry : entries_) {
    if (entry->name == first.name) all.push_back(entry);
  }
  if (std::ranges::any_of(all, [&](const KeyInfo* entry) { return exists(*entry); })) return;
  NearestCondition nearest;
  for (const KeyInfo* entry : all) {
    const auto failed =
        std::ranges::find_if(entry->conditions, [&](const Condition& one) { return holds(one) != Holds::kYes; });
    if (holds(*failed) == Holds::kUnknown) {
      table_->declare(first.name);
      // The kind of the table is unknown.
      if (!failed->values.empty() && entry_of(failed->key)->need == Need::kRequired) table_->ignore_rest();
      return;
    }
    nearest.add(*failed, static_cast<std::size_t>(failed - entry->conditions.begin()));
  }
  if (!first.refused.empty()) return;
  Condition missing = nearest.get();
  if (!missing.values.empty()) {  // in the order of the other key's choices
    std::vector<std::string_view> ordered = entry_of(missing.key)->rule.choices;
    std::erase_if(ordered, [&](std::string_view choice) {
      return std::ranges::find(missing.values, choice) == missing.values.end();
    });
    missing.values = std::move(ordered);
  }
  table_->reject(first.name, (missing.excluded ? "not allowed with " : "allowed only with ") + condition_text(missing));
}

void TableKeys::report_beside(const KeyInfo& entry) {
  const bool written = table_->has(entry.name);
  if (written || need(entry) == Need::kRequired) {
    if (const std::string lack = context_->lack_of(entry.needs); !lack.empty()) table_->problem(entry.name, lack);
  }
  if (written && !entry.replaces.empty() && table_->has(entry.replaces)) {
    table_->problem(entry.name, fmt::format("cannot be used together with {}", entry.replaces));
  }
}

}  // namespace armature::cosim
