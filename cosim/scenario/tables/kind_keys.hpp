// The keys of a table with kinds, made from the entries of the kinds.
//
// `Spec::kind` is a std::variant of the structs of all kinds. entry_of(std::type_identity<Kind>{}) gives the entry of
// a kind: `name`, the value of the key that names the kind; `text`, a main clause in Markdown without its full stop;
// `keys`, those of this kind alone.
#pragma once

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
  return set_key<Spec, std::string>(name, set_kind, names, text).required().values(std::move(values));
}

// Adds the keys of all kinds. A key that several kinds have with the same text and the same further conditions becomes
// one key. `kind_key` is the name of the key that names the kind.
template <class Spec, class EntryOf>
void add_kind_keys(Keys<Spec>& keys, std::string_view kind_key, EntryOf entry_of) {
  for_each_kind<decltype(Spec::kind)>([&](auto kind) {
    const auto& entry = entry_of(kind);
    keys.append_kind(kind_key, entry.name, entry.keys);
  });
}

}  // namespace armature::cosim
