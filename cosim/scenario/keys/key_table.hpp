// The entries of a table, in the order of the documents. A table reads itself from a file with them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cosim/scenario/keys/key.hpp"
#include "cosim/scenario/keys/table_keys.hpp"

namespace armature::cosim {

// A table within the table of a Spec.
template <class Spec>
struct SubTable {
  TableInfo info;
  std::function<void(TableReader& parent, const KeyContext&, Spec&)> read;

  SubTable needing(Needs what) && {
    info.needs = what;
    return std::move(*this);
  }
};

// A check of several keys of a table.
template <class Spec>
struct TableCheck {
  std::vector<std::string_view> keys;  // the check is called if each of these is valid by itself
  std::function<void(TableReader&, const KeyContext&, Spec&)> check;
};

template <class Spec>
struct KeyTable {
  std::string_view text;  // what the table is for: sentences in Markdown
  std::vector<Key<Spec>> keys;
  std::vector<SubTable<Spec>> tables{};
  std::vector<TableCheck<Spec>> checks{};

  void read(TableReader& table, const KeyContext& context, Spec& spec) const {
    if constexpr (requires { spec.line = table.line(); }) spec.line = table.line();
    const std::vector<std::string_view> bad = read_keys(table, context, spec);
    read_tables(table, context, spec);
    for (const TableCheck<Spec>& one : checks) {
      if (std::ranges::find_first_of(one.keys, bad) == one.keys.end()) one.check(table, context, spec);
    }
  }

  // The two parts of read(), for a file whose tables depend on what its keys name. Returns the keys that are missing or
  // wrong.
  std::vector<std::string_view> read_keys(TableReader& table, const KeyContext& context, Spec& spec) const;
  void read_tables(TableReader& table, const KeyContext& context, Spec& spec) const;

  [[nodiscard]] TableInfo info() const {
    TableInfo all;
    all.text = text;
    for (const Key<Spec>& key : keys) all.keys.push_back(key.info);
    for (const SubTable<Spec>& table : tables) all.tables.push_back(table.info);
    return all;
  }
};

template <class Spec>
std::vector<std::string_view> KeyTable<Spec>::read_keys(TableReader& table, const KeyContext& context,
                                                        Spec& spec) const {
  std::vector<const KeyInfo*> entries;
  for (const Key<Spec>& key : keys) entries.push_back(&key.info);
  TableKeys rules{table, std::move(entries), context};
  std::vector<const Key<Spec>*> set;
  std::vector<std::string_view> bad;
  for (const Key<Spec>& key : keys) {
    if (!key.read || !rules.exists(key.info)) continue;
    const Need need = rules.need(key.info);
    if (key.read(table, rules.rule(key.info), need, spec)) {
      set.push_back(&key);
    } else if (table.has(key.info.name) || need == Need::kRequired) {
      bad.push_back(key.info.name);
    }
  }
  rules.report();
  for (const Key<Spec>* key : set) {
    const std::string why = key->check ? key->check(spec, context) : std::string{};
    if (!why.empty()) table.problem(key->info.name, why);
  }
  return bad;
}

template <class Spec>
void KeyTable<Spec>::read_tables(TableReader& table, const KeyContext& context, Spec& spec) const {
  for (const SubTable<Spec>& sub : tables) {
    sub.read(table, context, spec);
    if (!table.has(sub.info.name)) continue;
    if (const std::string lack = context.lack_of(sub.info.needs); !lack.empty()) table.problem(sub.info.name, lack);
  }
}

namespace key_detail {

template <class T>
T& emplaced(T& value) {
  return value;
}
template <class T>
T& emplaced(std::optional<T>& value) {
  return value ? *value : value.emplace();
}

template <class Inner>
[[nodiscard]] TableInfo named_info(const KeyTable<Inner>& keys, std::string_view name) {
  TableInfo info = keys.info();
  info.name = name;
  return info;
}

}  // namespace key_detail

// [name], into a member that is an Inner or an optional one.
template <class Spec, class Member, class Inner>
[[nodiscard]] SubTable<Spec> table(std::string_view name, Member Spec::*member, const KeyTable<Inner>& keys) {
  return {key_detail::named_info(keys, name),
          [name, member, &keys](TableReader& parent, const KeyContext& context, Spec& spec) {
            parent.table(name,
                         [&](TableReader& reader) { keys.read(reader, context, key_detail::emplaced(spec.*member)); });
          }};
}

// [[name]], into a member that is a vector or an optional one; at most `most` tables where it is not 0.
template <class Spec, class Member, class Inner>
[[nodiscard]] SubTable<Spec> tables(std::string_view name, Member Spec::*member, const KeyTable<Inner>& keys,
                                    std::size_t most = 0) {
  SubTable<Spec> sub{key_detail::named_info(keys, name),
                     [name, member, &keys, most](TableReader& parent, const KeyContext& context, Spec& spec) {
                       if (!parent.has(name)) {
                         parent.declare(name);
                         return;
                       }
                       auto& list = key_detail::emplaced(spec.*member);  // also when the array is empty
                       parent.tables(
                           name, [&](TableReader& reader) { keys.read(reader, context, list.emplace_back()); },
                           most == 0 ? kMaxTables : most);
                     }};
  sub.info.repeated = true;
  sub.info.most = most;
  return sub;
}

}  // namespace armature::cosim
