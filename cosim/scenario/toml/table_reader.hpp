// Reads one TOML table key by key: each key is declared once, with its rule, and every problem is reported.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cosim/scenario/toml/config_value.hpp"
#include "cosim/scenario/toml/toml_limits.hpp"
#include "cosim/scenario/toml/value_rule.hpp"

namespace armature::cosim {

// A required key that is missing in a table.
struct MissingKey {
  Origin table;
  std::string path;      // the full key
  std::string_view key;  // within the table; must outlive this
  std::string message;
};

class TableReader {
 public:
  // `path` is the table's full key, empty for the root. Table and list of problems must outlive the reader. A value
  // that is no table is reported here, and then read as an empty table without further problems.
  TableReader(const ConfigValue& table, std::string path, ProblemList& problems);

  // Keys that are missing in this table are read from `defaults`. The reader of `defaults` reports its problems.
  void inherit(const ConfigValue* defaults) { defaults_ = defaults; }
  // No key is required: this is itself a table of defaults.
  void allow_missing() { allow_missing_ = true; }
  // Missing required keys are added to this list and not reported. This does not apply to sub-tables.
  void collect_missing(std::vector<MissingKey>& missing) { missing_ = &missing; }

  // Reads a key into a double, std::int64_t, std::int32_t, std::uint64_t, bool, std::string, std::array, std::vector or
  // std::optional of these. Returns whether `out` was set; it keeps its value when the key is absent or wrong.
  template <class T>
  bool read(std::string_view key, T& out, const Rule& rule, Need need = Need::kOptional);

  // Calls visit(TableReader&) for a sub-table that is present here or in the defaults, then reports unknown keys.
  template <std::invocable<TableReader&> Visit>
  void table(std::string_view key, Visit visit);

  // Calls visit(TableReader&) for every element of an array of tables, then reports unknown keys. Returns the
  // number of elements. More than `most` elements are a problem, and then none is visited.
  template <std::invocable<TableReader&> Visit>
  std::size_t tables(std::string_view key, Visit visit, std::size_t most = kMaxTables);

  // A key that is not allowed here. It is reported with `why` if it is written.
  void reject(std::string_view key, const std::string& why);
  // A key that is known here, although it is not read.
  void declare(std::string_view key);
  // Reports every key that was not declared, with a suggestion.
  void finish();
  // The kind of the table is unknown, so finish() does not report unknown keys.
  void ignore_rest() { ignore_rest_ = true; }

  // A problem of this table that is best shown at `key` (or at the table when the key is not written).
  void problem(std::string_view key, std::string message);
  // Whether there is a key that is not declared by now.
  [[nodiscard]] bool has_unknown() const;
  [[nodiscard]] bool has(std::string_view key) const { return table_->find(key) != nullptr; }
  // The string of a key of this table; nullptr when it is missing or no string.
  [[nodiscard]] const std::string* string(std::string_view key) const;
  [[nodiscard]] std::size_t problem_count() const { return problems_->size(); }
  [[nodiscard]] int line() const { return table_->origin.line; }
  [[nodiscard]] std::string path_of(std::string_view key) const;
  // The origin of each key of this table. For a key that a `--set` gave or changed in part, it is the `--set`.
  [[nodiscard]] std::map<std::string, Origin, std::less<>> origins() const;

 private:
  struct Found {
    const ConfigValue* value = nullptr;
    bool inherited = false;
  };
  Found find(std::string_view key, Need need, const std::string& expected);
  const ConfigValue::Array* array_of_tables(std::string_view key, std::size_t most);
  [[nodiscard]] bool is_declared(const ConfigEntry& entry) const;

  const ConfigValue* table_;
  const ConfigValue* defaults_ = nullptr;
  std::string path_;
  ProblemList* problems_;
  std::vector<std::string_view> declared_;
  std::vector<MissingKey>* missing_ = nullptr;
  bool allow_missing_ = false;
  bool ignore_rest_ = false;
};

namespace table_reader_detail {

// How a C++ type is written in TOML: a scalar, or an array of scalars (kCount 0 = any number).
template <class T>
struct Shape;

template <ValueKind kKindOf, class StoredT>
struct Scalar {
  using Stored = StoredT;  // what convert() reads
  static constexpr ValueKind kKind = kKindOf;
  static std::string expected(const Rule& rule) { return expected_one(kKind, rule); }
  template <class T>
  static bool read(const ConfigValue& value, const std::string& path, const Rule& rule, ProblemList& problems, T& out) {
    Stored stored{};
    if (!convert(value, path, rule, problems, stored)) return false;
    out = static_cast<T>(std::move(stored));
    return true;
  }
};

template <>
struct Shape<double> : Scalar<ValueKind::kNumber, double> {};
template <>
struct Shape<std::int64_t> : Scalar<ValueKind::kInteger, std::int64_t> {};
template <>
struct Shape<std::int32_t> : Scalar<ValueKind::kInteger, std::int64_t> {};  // the rule must stay inside 32 bits
template <>
struct Shape<std::uint64_t> : Scalar<ValueKind::kInteger, std::int64_t> {};  // the rule must exclude negative values
template <>
struct Shape<bool> : Scalar<ValueKind::kBoolean, bool> {};
template <>
struct Shape<std::string> : Scalar<ValueKind::kString, std::string> {};

template <class Element, std::size_t kCount>
struct Elements {
  static std::size_t count(const Rule& rule) { return kCount > 0 ? kCount : rule.count; }
  static std::string expected(const Rule& rule) { return expected_array(Shape<Element>::kKind, rule, count(rule)); }
  // Calls put(index, element) for each good element; false when the value or an element is wrong.
  template <class Put>
  static bool read_each(const ConfigValue& value, const std::string& path, const Rule& rule, ProblemList& problems,
                        Put put) {
    const ConfigValue::Array* array = value.array();
    if (array == nullptr || (count(rule) > 0 && array->size() != count(rule))) {
      const std::string found = array == nullptr ? describe(value) : std::to_string(array->size());
      problems.add(value.origin, path, "expected " + expected(rule) + ", found " + found);
      return false;
    }
    bool good = true;
    for (std::size_t i = 0; i < array->size(); ++i) {
      Element element{};
      if (Shape<Element>::read((*array)[i], element_key(path, i), rule, problems, element)) {
        put(i, std::move(element));
      } else {
        good = false;
      }
    }
    return good;
  }
};

template <class Element, std::size_t kCount>
struct Shape<std::array<Element, kCount>> : Elements<Element, kCount> {
  static bool read(const ConfigValue& value, const std::string& path, const Rule& rule, ProblemList& problems,
                   std::array<Element, kCount>& out) {
    std::array<Element, kCount> elements{};
    if (!Elements<Element, kCount>::read_each(value, path, rule, problems,
                                              [&](std::size_t i, Element e) { elements[i] = std::move(e); })) {
      return false;
    }
    out = std::move(elements);
    return true;
  }
};

template <class Element>
struct Shape<std::vector<Element>> : Elements<Element, 0> {
  static bool read(const ConfigValue& value, const std::string& path, const Rule& rule, ProblemList& problems,
                   std::vector<Element>& out) {
    std::vector<Element> elements;
    if (!Elements<Element, 0>::read_each(value, path, rule, problems,
                                         [&](std::size_t, Element e) { elements.push_back(std::move(e)); })) {
      return false;
    }
    out = std::move(elements);
    return true;
  }
};

// An array of 1..Rule::most_rows arrays.
template <class Element, std::size_t kCount>
struct Shape<std::vector<std::array<Element, kCount>>> {
  using Row = std::array<Element, kCount>;
  static std::string expected(const Rule& rule) { return expected_rows(Shape<Element>::kKind, rule, kCount); }
  static bool read(const ConfigValue& value, const std::string& path, const Rule& rule, ProblemList& problems,
                   std::vector<Row>& out) {
    const ConfigValue::Array* array = value.array();
    if (array == nullptr || array->empty() || array->size() > rule.most_rows) {
      const std::string found = array == nullptr ? describe(value) : std::to_string(array->size());
      problems.add(value.origin, path, "expected " + expected(rule) + ", found " + found);
      return false;
    }
    std::vector<Row> rows(array->size());
    bool good = true;
    for (std::size_t i = 0; i < array->size(); ++i) {
      good = Shape<Row>::read((*array)[i], element_key(path, i), rule, problems, rows[i]) && good;
    }
    if (good) out = std::move(rows);
    return good;
  }
};

template <class T>
struct Shape<std::optional<T>> : Shape<T> {
  static bool read(const ConfigValue& value, const std::string& path, const Rule& rule, ProblemList& problems,
                   std::optional<T>& out) {
    T present{};
    if (!Shape<T>::read(value, path, rule, problems, present)) return false;
    out = std::move(present);
    return true;
  }
};

}  // namespace table_reader_detail

template <class T>
bool TableReader::read(std::string_view key, T& out, const Rule& rule, Need need) {
  using Shape = table_reader_detail::Shape<T>;
  const Found found = find(key, need, Shape::expected(rule) + rule.when_missing);
  if (found.value == nullptr) return false;
  ProblemList reported_already{""};
  return Shape::read(*found.value, path_of(key), rule, found.inherited ? reported_already : *problems_, out);
}

template <std::invocable<TableReader&> Visit>
void TableReader::table(std::string_view key, Visit visit) {
  declare(key);
  static const ConfigValue kEmpty{ConfigValue::Table{}, {}};
  const ConfigEntry* own = table_->find(key);
  const ConfigEntry* inherited = defaults_ == nullptr ? nullptr : defaults_->find(key);
  if (own == nullptr && inherited == nullptr) return;
  TableReader reader{own == nullptr ? kEmpty : own->value, path_of(key), *problems_};
  if (inherited != nullptr) reader.inherit(&inherited->value);
  if (allow_missing_) reader.allow_missing();
  visit(reader);
  reader.finish();
}

template <std::invocable<TableReader&> Visit>
std::size_t TableReader::tables(std::string_view key, Visit visit, std::size_t most) {
  const ConfigValue::Array* array = array_of_tables(key, most);
  if (array == nullptr) return 0;
  for (std::size_t i = 0; i < std::min(array->size(), most); ++i) {
    TableReader reader{(*array)[i], element_key(path_of(key), i), *problems_};
    visit(reader);
    reader.finish();
  }
  return array->size();
}

}  // namespace armature::cosim
