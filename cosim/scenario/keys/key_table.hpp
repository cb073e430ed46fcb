// The entries of a table, in the order of the documents. A table reads itself from a file with them. As in key.hpp, the
// templates only add the type of the struct.
#pragma once

#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "cosim/scenario/keys/key.hpp"
#include "cosim/scenario/keys/plain_table.hpp"

namespace armature::cosim {

// A table within the table of a Spec.
template <class Spec>
class SubTable {
 public:
  // The caller states that the entry is one of a Spec.
  explicit SubTable(PlainSubTable plain) : plain_(std::move(plain)) {}

  [[nodiscard]] const PlainSubTable& plain() const { return plain_; }

  SubTable&& needing(Needs what) && {
    plain_.info.needs = what;
    return std::move(*this);
  }

 private:
  PlainSubTable plain_;
};

// A check of several keys of a table.
template <class Spec>
class TableCheck {
 public:
  // check(reader, context, spec) is called if each of the keys is valid by itself.
  template <class Check>
  requires std::invocable<Check, TableReader&, const KeyContext&, Spec&> TableCheck(
      std::initializer_list<std::string_view> keys, Check check)
      : plain_{keys, [check](TableReader& table, const KeyContext& context, void* spec) {
                 check(table, context, *static_cast<Spec*>(spec));
               }} {}

  [[nodiscard]] const PlainTableCheck& plain() const { return plain_; }

 private:
  PlainTableCheck plain_;
};

namespace key_detail {

// Entries of type Plain that belong to the struct of Entry.
template <class Entry, class Plain>
class Entries {
 public:
  Entries() = default;
  Entries(std::initializer_list<Entry> entries) {
    for (const Entry& entry : entries) plain_.push_back(entry.plain());
  }
  [[nodiscard]] const std::vector<Plain>& plain() const { return plain_; }

 private:
  std::vector<Plain> plain_;
};

}  // namespace key_detail

template <class Spec>
struct KeyTable {
  std::string_view text;  // what the table is for: sentences in Markdown
  Keys<Spec> keys;
  key_detail::Entries<SubTable<Spec>, PlainSubTable> tables{};
  key_detail::Entries<TableCheck<Spec>, PlainTableCheck> checks{};

  void read(TableReader& table, const KeyContext& context, Spec& spec) const {
    if constexpr (requires { spec.line = table.line(); }) spec.line = table.line();
    const std::vector<std::string_view> bad = read_keys(table, context, spec);
    read_tables(table, context, spec);
    check_plain_table(checks.plain(), bad, table, context, &spec);
  }

  // The two parts of read(), for a file whose tables depend on what its keys name. Returns the keys that are missing or
  // wrong.
  std::vector<std::string_view> read_keys(TableReader& table, const KeyContext& context, Spec& spec) const {
    return read_plain_keys(keys.plain(), table, context, &spec);
  }
  // After read_keys() without a robot, which has returned `bad`: reports arrays that have not an element for each axis.
  void count_elements(const std::vector<std::string_view>& bad, TableReader& table, const KeyContext& context,
                      Spec& spec) const {
    count_plain_keys(keys.plain(), bad, table, context, &spec);
  }
  void read_tables(TableReader& table, const KeyContext& context, Spec& spec) const {
    read_plain_tables(tables.plain(), table, context, &spec);
  }

  [[nodiscard]] TableInfo info() const { return plain_table_info(text, keys.plain(), tables.plain()); }
};

namespace key_detail {

template <class T>
T& emplaced(T& value) {
  return value;
}
template <class T>
T& emplaced(std::optional<T>& value) {
  return value ? *value : value.emplace();
}

// [name] with the keys of an Inner, into a member; without what depends on whether it is a list.
template <class Spec, class Member, class Inner>
[[nodiscard]] PlainSubTable sub_table(std::string_view name, Member Spec::*member, const KeyTable<Inner>& keys) {
  PlainSubTable sub{.info = keys.info(), .place = place_of(member), .keys = &keys};
  sub.info.name = name;
  sub.emplaced = [](void* place) -> void* { return &emplaced(*static_cast<Member*>(place)); };
  sub.read = [](const void* table, TableReader& reader, const KeyContext& context, void* spec) {
    static_cast<const KeyTable<Inner>*>(table)->read(reader, context, *static_cast<Inner*>(spec));
  };
  return sub;
}

}  // namespace key_detail

// [name], into a member that is an Inner or an optional one.
template <class Spec, class Member, class Inner>
requires std::same_as<Member, Inner> || std::same_as<Member, std::optional<Inner>>
[[nodiscard]] SubTable<Spec> table(std::string_view name, Member Spec::*member, const KeyTable<Inner>& keys) {
  return SubTable<Spec>{key_detail::sub_table(name, member, keys)};
}

// [[name]], into a member that is a vector or an optional one; at most `most` tables where it is not 0.
template <class Spec, class Member, class Inner>
requires std::same_as<Member, std::vector<Inner>> || std::same_as<Member, std::optional<std::vector<Inner>>>
[[nodiscard]] SubTable<Spec> tables(std::string_view name, Member Spec::*member, const KeyTable<Inner>& keys,
                                    std::size_t most = 0) {
  PlainSubTable sub = key_detail::sub_table(name, member, keys);
  sub.info.repeated = true;
  sub.info.most = most;
  sub.added = [](void* list) -> void* { return &static_cast<std::vector<Inner>*>(list)->emplace_back(); };
  return SubTable<Spec>{std::move(sub)};
}

}  // namespace armature::cosim
