#include "cosim/scenario/keys/plain_table.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "cosim/scenario/keys/table_keys.hpp"

namespace armature::cosim {
namespace {

void read_one(const PlainSubTable& sub, TableReader& parent, const KeyContext& context, void* member) {
  parent.table(sub.info.name, [&](TableReader& reader) { sub.read(sub.keys, reader, context, sub.emplaced(member)); });
}

void read_list(const PlainSubTable& sub, TableReader& parent, const KeyContext& context, void* member) {
  if (!parent.has(sub.info.name)) {
    parent.declare(sub.info.name);
    return;
  }
  void* list = sub.emplaced(member);  // also when the array is empty
  parent.tables(
      sub.info.name, [&](TableReader& reader) { sub.read(sub.keys, reader, context, sub.added(list)); },
      sub.info.most == 0 ? kMaxTables : sub.info.most);
}

}  // namespace

std::vector<std::string_view> read_plain_keys(const std::vector<PlainKey>& keys, TableReader& table,
                                              const KeyContext& context, void* spec) {
  std::vector<const KeyInfo*> entries;
  entries.reserve(keys.size());
  for (const PlainKey& key : keys) entries.push_back(&key.info);
  TableKeys rules{table, std::move(entries), context};
  std::vector<const PlainKey*> set;
  std::vector<std::string_view> bad;
  for (const PlainKey& key : keys) {
    if (key.targets.empty() || !rules.exists(key.info)) continue;
    const Need need = rules.need(key.info);
    if (key.read(table, rules.rule(key.info), need, spec)) {
      set.push_back(&key);
    } else if (table.has(key.info.name) || need == Need::kRequired) {
      bad.push_back(key.info.name);
    }
  }
  rules.report();
  for (const PlainKey* key : set) {
    const std::string why = key->check(spec, context);
    if (!why.empty()) table.problem(key->info.name, why);
  }
  return bad;
}

void count_plain_keys(const std::vector<PlainKey>& keys, const std::vector<std::string_view>& bad, TableReader& table,
                      const KeyContext& context, void* spec) {
  const TableKeys rules{table, {}, context};
  for (const PlainKey& key : keys) {
    if (!key.info.per_axis || !table.has(key.info.name) || std::ranges::find(bad, key.info.name) != bad.end()) continue;
    (void)key.read(table, rules.rule(key.info), Need::kOptional, spec);
  }
}

void read_plain_tables(const std::vector<PlainSubTable>& tables, TableReader& table, const KeyContext& context,
                       void* spec) {
  for (const PlainSubTable& sub : tables) {
    void* member = static_cast<std::byte*>(spec) + sub.place;
    (sub.added == nullptr ? read_one : read_list)(sub, table, context, member);
    if (!table.has(sub.info.name)) continue;
    if (const std::string lack = context.lack_of(sub.info.needs); !lack.empty()) table.problem(sub.info.name, lack);
  }
}

void check_plain_table(const std::vector<PlainTableCheck>& checks, const std::vector<std::string_view>& bad,
                       TableReader& table, const KeyContext& context, void* spec) {
  for (const PlainTableCheck& one : checks) {
    if (std::ranges::find_first_of(one.keys, bad) == one.keys.end()) one.check(table, context, spec);
  }
}

TableInfo plain_table_info(std::string_view text, const std::vector<PlainKey>& keys,
                           const std::vector<PlainSubTable>& tables) {
  TableInfo all;
  all.text = text;
  for (const PlainKey& key : keys) all.keys.push_back(key.info);
  for (const PlainSubTable& table : tables) all.tables.push_back(table.info);
  return all;
}

}  // namespace armature::cosim
