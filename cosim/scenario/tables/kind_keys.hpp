// The keys of a table with kinds, made from the entries of the kinds.
//
// `Spec::kind` is a std::variant of the structs of all kinds. entry_of(std::type_identity<Kind>{}) gives the entry of
// a kind: `name`, the value of the key that names the kind; `text`, a main clause in Markdown without its full stop;
// `keys`, those of this kind alone.
#pragma once

#include <algorithm>
#include <cassert>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "cosim/scenario/keys/key.hpp"
#include "cosim/scenario/kinds.hpp"

namespace armature::cosim {

// The key that names the kind. It must be read before the keys of the kinds.
template <class Spec, class EntryOf>
[[nodiscard]] Key<Spec> kind_key(std::string_view name, std::string_view text, EntryOf entry_of) {
  using Kinds = decltype(Spec::kind);
  Rule names;
  std::vector<ValueInfo> values;
  for_each_kind<Kinds>([&](auto kind) {
    names.choices.push_back(entry_of(kind).name);
    values.push_back({.value = entry_of(kind).name, .text = entry_of(kind).text});
  });
  const auto set_kind = [entry_of](Spec& spec, const std::string& value) {
    for_each_kind<Kinds>([&]<class Kind>(std::type_identity<Kind> kind) {
      if (entry_of(kind).name == value) spec.kind.template emplace<Kind>();
    });
    return std::string{};
  };
  Key<Spec> key = set_key<Spec, std::string>(name, set_kind, names, text).required();
  key.info.values = std::move(values);
  return key;
}

namespace kind_detail {

// A key of one kind as a key of the table. The key that names the kind was read, so that the variant holds that kind.
template <class Spec, class Kind>
[[nodiscard]] Key<Spec> key_of_kind(const Key<Kind>& key, std::string_view kind_key, std::string_view kind_name) {
  Key<Spec> entry{key.info, [read = key.read](TableReader& table, const Rule& rule, Need need, Spec& spec) {
                    return read(table, rule, need, std::get<Kind>(spec.kind));
                  }};
  entry.info.conditions.insert(entry.info.conditions.begin(), when(kind_key, {kind_name}));
  if (key.check) {
    entry.check = [check = key.check](Spec& spec, const KeyContext& context) {
      return check(std::get<Kind>(spec.kind), context);
    };
  }
  return entry;
}

// Whether two keys differ only in their kinds.
[[nodiscard]] inline bool is_same_key(const KeyInfo& a, const KeyInfo& b) {
  return a.name == b.name && a.text == b.text &&
         std::equal(a.conditions.begin() + 1, a.conditions.end(), b.conditions.begin() + 1, b.conditions.end());
}

// Adds a key of the kind, or makes it one with the same key of other kinds.
template <class Kind, class Spec>
void add_key(std::vector<Key<Spec>>& keys, Key<Spec> key) {
  const auto same = std::ranges::find_if(keys, [&](const Key<Spec>& other) {
    return !other.info.conditions.empty() && is_same_key(other.info, key.info);
  });
  if (same == keys.end()) {
    keys.push_back(std::move(key));
    return;
  }
  assert(same->info.need == key.info.need && !same->check == !key.check);
  const std::string_view name = key.info.conditions.front().values.front();
  same->info.conditions.front().values.push_back(name);
  same->read = [other = same->read, own = key.read](TableReader& table, const Rule& rule, Need need, Spec& spec) {
    return (std::holds_alternative<Kind>(spec.kind) ? own : other)(table, rule, need, spec);
  };
  if (!key.check) return;
  same->check = [other = same->check, own = key.check](Spec& spec, const KeyContext& context) {
    return (std::holds_alternative<Kind>(spec.kind) ? own : other)(spec, context);
  };
}

}  // namespace kind_detail

// Adds the keys of all kinds. A key that several kinds have with the same text and the same further conditions becomes
// one key. `kind_key` is the name of the key that names the kind.
template <class Spec, class EntryOf>
void add_kind_keys(std::vector<Key<Spec>>& keys, std::string_view kind_key, EntryOf entry_of) {
  for_each_kind<decltype(Spec::kind)>([&]<class Kind>(std::type_identity<Kind> kind) {
    const auto& entry = entry_of(kind);
    for (const Key<Kind>& key : entry.keys) {
      kind_detail::add_key<Kind>(keys, kind_detail::key_of_kind<Spec>(key, kind_key, entry.name));
    }
  });
}

}  // namespace armature::cosim
