// [[fault]]: `at_s`, `kind`, and the keys of each kind, which exist with that kind only.
#include <algorithm>
#include <cassert>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "cosim/scenario/tables/fault_kinds.hpp"
#include "cosim/scenario/tables/tables.hpp"

namespace armature::cosim {
namespace {

constexpr std::string_view kKindKey = "kind";

// Makes `fault` one of the kind of that name.
std::string set_kind(FaultSpec& fault, const std::string& name) {
  for_each_fault_kind([&]<class Kind>(Kind kind) {
    if (fault_entry<Kind>().name == name) fault.kind = kind;
  });
  return {};
}

Key<FaultSpec> kind_key() {
  static const std::string kText = [] {
    std::string text;
    for_each_fault_kind([&]<class Kind>(Kind) {
      const FaultEntry<Kind>& entry = fault_entry<Kind>();
      text += fmt::format("{}`{}`: {}.", text.empty() ? "" : " ", entry.name, entry.text);
    });
    return text;
  }();
  Rule names;
  for_each_fault_kind([&]<class Kind>(Kind) { names.choices.push_back(fault_entry<Kind>().name); });
  return set_key<FaultSpec, std::string>(kKindKey, set_kind, names, kText).required();
}

// A key of one kind as a key of the table. `kind` stands before it, so that the variant holds that kind.
template <class Kind>
Key<FaultSpec> key_of_kind(const Key<Kind>& key) {
  Key<FaultSpec> entry{key.info, [read = key.read](TableReader& table, const Rule& rule, Need need, FaultSpec& fault) {
                         return read(table, rule, need, std::get<Kind>(fault.kind));
                       }};
  entry.info.conditions.insert(entry.info.conditions.begin(), when(kKindKey, {fault_entry<Kind>().name}));
  if (key.check) {
    entry.check = [check = key.check](FaultSpec& fault, const KeyContext& context) {
      return check(std::get<Kind>(fault.kind), context);
    };
  }
  return entry;
}

// Kinds may have a key of the same name with the same text. It is one key of the table.
template <class Kind>
void add_key(std::vector<Key<FaultSpec>>& keys, Key<FaultSpec> key) {
  const auto same = std::ranges::find(keys, key.info.name, [](const Key<FaultSpec>& other) { return other.info.name; });
  if (same == keys.end()) {
    keys.push_back(std::move(key));
    return;
  }
  assert(same->info.text == key.info.text && !same->check && !key.check);
  same->info.conditions.front().values.push_back(fault_entry<Kind>().name);
  same->read = [other = same->read, own = key.read](TableReader& table, const Rule& rule, Need need, FaultSpec& fault) {
    return (std::holds_alternative<Kind>(fault.kind) ? own : other)(table, rule, need, fault);
  };
}

}  // namespace

const KeyTable<FaultSpec>& fault_keys() {
  static const KeyTable<FaultSpec> kTable = [] {
    KeyTable<FaultSpec> table{
        .text = "Each table injects a fault.",
        .keys = {at_key<FaultSpec>("The fault begins at this time."), kind_key()},
    };
    for_each_fault_kind([&]<class Kind>(Kind) {
      for (const Key<Kind>& key : fault_entry<Kind>().keys) add_key<Kind>(table.keys, key_of_kind(key));
    });
    return table;
  }();
  return kTable;
}

}  // namespace armature::cosim
