#include "cosim/scenario/toml/table_reader.hpp"

#include <algorithm>

#include "cosim/text/suggest.hpp"

namespace armature::cosim {
namespace {

// The first override in a value. nullptr: the value is as in the file.
const Origin* overridden(const ConfigValue& value) {
  if (!value.origin.override_text.empty()) return &value.origin;
  if (const ConfigValue::Array* array = value.array()) {
    for (const ConfigValue& element : *array) {
      if (const Origin* origin = overridden(element)) return origin;
    }
  }
  if (const ConfigValue::Table* table = value.table()) {
    for (const ConfigEntry& entry : *table) {
      if (const Origin* origin = overridden(entry.value)) return origin;
    }
  }
  return nullptr;
}

}  // namespace

TableReader::TableReader(const ConfigValue& table, std::string path, ProblemList& problems)
    : table_{&table}, path_{std::move(path)}, problems_{&problems} {
  if (table.table() != nullptr) return;
  problems.add(table.origin, path_, "expected a table, found " + describe(table));
  allow_missing_ = true;
}

std::string TableReader::path_of(std::string_view key) const {
  return path_.empty() ? std::string{key} : path_ + "." + std::string{key};
}

TableReader::Found TableReader::find(std::string_view key, Need need, const std::string& expected) {
  declare(key);
  if (const ConfigEntry* entry = table_->find(key)) return {&entry->value, false};
  if (const ConfigEntry* entry = defaults_ == nullptr ? nullptr : defaults_->find(key)) return {&entry->value, true};
  if (need == Need::kRequired && !allow_missing_) {
    const std::string message = "missing, expected " + expected;
    if (missing_ != nullptr) {
      missing_->push_back({table_->origin, path_of(key), key, message});
    } else {
      problems_->add(table_->origin, path_of(key), message);
    }
  }
  return {};
}

const ConfigValue::Array* TableReader::array_of_tables(std::string_view key, std::size_t most) {
  declare(key);
  const ConfigEntry* entry = table_->find(key);
  if (entry == nullptr) return nullptr;
  if (entry->value.array() == nullptr) {
    problems_->add(entry->origin, path_of(key),
                   "expected an array of tables ([[" + path_of(key) + "]]), found " + describe(entry->value));
  }
  const ConfigValue::Array* array = entry->value.array();
  if (array != nullptr && array->size() > most) {
    problems_->add((*array)[most].origin, element_key(path_of(key), most),
                   "expected " + at_most_tables(most, path_of(key)) + ", found " + std::to_string(array->size()));
  }
  return array;
}

void TableReader::reject(std::string_view key, const std::string& why) {
  const ConfigEntry* entry = table_->find(key);
  if (entry == nullptr) return;
  declare(key);
  problems_->add(entry->origin, path_of(key), why);
}

const std::string* TableReader::string(std::string_view key) const {
  const ConfigEntry* entry = table_->find(key);
  return entry == nullptr ? nullptr : std::get_if<std::string>(&entry->value.data);
}

void TableReader::finish() {
  if (ignore_rest_ || table_->table() == nullptr) return;
  for (const ConfigEntry& entry : *table_->table()) {
    if (problems_->is_full()) return;  // a suggestion takes time
    if (is_declared(entry)) continue;
    problems_->add(entry.origin, path_of(entry.key), "unknown key" + suggestion(entry.key, declared_));
  }
}

bool TableReader::is_declared(const ConfigEntry& entry) const {
  return std::ranges::find(declared_, entry.key) != declared_.end();
}

bool TableReader::has_unknown() const {
  const ConfigValue::Table* entries = table_->table();
  return entries != nullptr && !std::ranges::all_of(*entries, [&](const ConfigEntry& e) { return is_declared(e); });
}

std::map<std::string, Origin, std::less<>> TableReader::origins() const {
  std::map<std::string, Origin, std::less<>> places;
  if (const ConfigValue::Table* entries = table_->table()) {
    for (const ConfigEntry& entry : *entries) {
      const Origin* changed = overridden(entry.value);
      places.emplace(entry.key, changed == nullptr ? entry.origin : *changed);
    }
  }
  return places;
}

// A key may be read twice.
void TableReader::declare(std::string_view key) {
  if (std::find(declared_.begin(), declared_.end(), key) == declared_.end()) declared_.push_back(key);
}

void TableReader::problem(std::string_view key, std::string message) {
  const ConfigEntry* entry = table_->find(key);
  if (entry == nullptr && defaults_ != nullptr) entry = defaults_->find(key);
  problems_->add(entry == nullptr ? table_->origin : entry->value.origin, path_of(key), std::move(message));
}

}  // namespace armature::cosim
