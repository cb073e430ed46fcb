// The entry of a key: its KeyInfo, and the member of the struct of its table that gets the value.
//
//   key("jerk_mm_s3", &PathSpec::jerk_mm_s3, above(0, kMaxJerk, "mm/s^3"), "Text.").only(when("profile", {"scurve"}))
//
// The type comes from the member, and the default from its initialiser. The templates here only add the type of the
// struct to what plain_key.hpp does, so that no table gets a key of another struct.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "cosim/scenario/keys/key_context.hpp"
#include "cosim/scenario/keys/key_info.hpp"
#include "cosim/scenario/keys/member_type.hpp"
#include "cosim/scenario/keys/plain_key.hpp"
#include "cosim/scenario/toml/table_reader.hpp"

namespace armature::cosim {

template <class Spec>
class Key {
 public:
  // The caller states that the entry is one of a Spec.
  explicit Key(PlainKey plain) : plain_(std::move(plain)) {}

  [[nodiscard]] const PlainKey& plain() const& { return plain_; }
  [[nodiscard]] PlainKey plain() && { return std::move(plain_); }

  Key&& required() && {
    plain_.info.need = Need::kRequired;
    plain_.info.default_text.clear();
    return std::move(*this);
  }
  Key&& only(Condition condition) && {
    plain_.info.conditions.push_back(std::move(condition));
    return std::move(*this);
  }
  Key&& needs(Needs what) && {
    plain_.info.needs = what;
    return std::move(*this);
  }
  // Excludes `other`. If this key is written, `other` is not required.
  Key&& replaces(std::string_view other) && {
    plain_.info.replaces = other;
    return std::move(*this);
  }
  // Required, but not beside `other`; `phrase` is the default then.
  Key&& required_without(std::string_view other, std::string_view phrase) && {
    plain_.info.spared_by = other;
    return std::move(*this).required().without(phrase);
  }
  // A phrase for the default, if the default of the member does not say it.
  Key&& without(std::string_view phrase) && {
    plain_.info.without = phrase;
    plain_.info.default_text.clear();
    return std::move(*this);
  }
  Key&& pattern(std::string_view regular_expression) && {
    plain_.info.pattern = regular_expression;
    return std::move(*this);
  }
  // An array with one element for each axis of the robot.
  Key&& per_axis() && {
    plain_.info.per_axis = true;
    return std::move(*this);
  }
  // All values of a key that names the kind of its table.
  Key&& values(std::vector<ValueInfo> all) && {
    plain_.info.values = std::move(all);
    return std::move(*this);
  }
  // function(spec, context) returns the message if a value does not fit, or an empty text. It may complete the struct,
  // and is called after all keys of the table were read.
  template <class Check>
  requires std::is_invocable_r_v<std::string, Check, Spec&, const KeyContext&> Key && checked(Check function) && {
    plain_.targets.front().check = [function](void* spec, const KeyContext& context) -> std::string {
      return function(*static_cast<Spec*>(spec), context);
    };
    return std::move(*this);
  }

 private:
  PlainKey plain_;
};

namespace key_detail {

// The values of keys that are not written. Not a local object: g++ 12 takes the destruction of its text for a use.
template <class Spec>
[[nodiscard]] const Spec& defaults() {
  static const Spec kDefaults{};
  return kDefaults;
}

// The distance of a member from the begin of its struct, in bytes.
template <class Spec, class Member>
[[nodiscard]] std::size_t place_of(Member Spec::*member) {
  const void* begin = std::addressof(defaults<Spec>());
  const void* place = std::addressof(defaults<Spec>().*member);
  return static_cast<std::size_t>(static_cast<const std::byte*>(place) - static_cast<const std::byte*>(begin));
}

}  // namespace key_detail

// Keys of one struct.
template <class Spec>
class Keys {
 public:
  Keys() = default;
  Keys(std::initializer_list<Key<Spec>> keys) {
    plain_.reserve(keys.size());
    for (const Key<Spec>& key : keys) plain_.push_back(key.plain());
  }

  [[nodiscard]] const std::vector<PlainKey>& plain() const { return plain_; }
  [[nodiscard]] std::vector<NamedValue> values(const Spec& spec) const { return values_of(plain_, &spec); }

  void push_back(Key<Spec> key) { plain_.push_back(std::move(key).plain()); }
  void append(const Keys& keys) { plain_.insert(plain_.end(), keys.plain_.begin(), keys.plain_.end()); }
  // Keys of a struct that is a member of this one.
  template <class Inner>
  void append_parts(Inner Spec::*member, const Keys<Inner>& keys) {
    const std::size_t place = key_detail::place_of(member);
    for (const PlainKey& key : keys.plain()) plain_.emplace_back(key).move_by(place);
  }
  // Keys of a Kind that is an alternative of the std::variant `kind`, see add_keys_of_kind().
  template <class Kind>
  void append_kind(std::string_view kind_key, std::string_view name, const Keys<Kind>& keys) {
    add_keys_of_kind(plain_, keys.plain(), kind_key, name,
                     [](void* spec) -> void* { return std::get_if<Kind>(&static_cast<Spec*>(spec)->kind); });
  }

 private:
  std::vector<PlainKey> plain_;
};

// A key of a member.
template <class Spec, class Member>
[[nodiscard]] Key<Spec> key(std::string_view name, Member Spec::*member, const Rule& rule, std::string_view text) {
  return Key<Spec>{key_detail::member_key<Member>(name, rule, text, key_detail::place_of(member),
                                                  key_detail::defaults<Spec>().*member)};
}

// A key whose value is the word of an enumerator: of `first` or one behind it.
template <class Spec, class Enum>
[[nodiscard]] Key<Spec> named_key(std::string_view name, Enum Spec::*member, std::string_view text,
                                  Enum first = Enum{}) {
  return Key<Spec>{key_detail::word_key<Enum>(name, first, text, key_detail::place_of(member),
                                              key_detail::defaults<Spec>().*member)};
}

// A key that is written as a T and stored in another form. set(spec, value) stores it and returns an empty text, or
// returns the message why it cannot.
template <class Spec, class T, class Set>
[[nodiscard]] Key<Spec> set_key(std::string_view name, Set set, const Rule& rule, std::string_view text) {
  PlainKey key{.info = key_detail::info_of<T>(name, rule, text)};
  key.targets.emplace_back().read = [set](TableReader& table, std::string_view read_name, const Rule& in, Need need,
                                          void* spec) {
    T value{};
    if (!table.read(read_name, value, in, need)) return false;
    const std::string why = set(*static_cast<Spec*>(spec), value);
    if (!why.empty()) table.problem(read_name, why);
    return why.empty();
  };
  return Key<Spec>{std::move(key)};
}

// A key of a struct that is a member of another one.
template <class Spec, class Inner>
[[nodiscard]] Key<Spec> part(Inner Spec::*member, Key<Inner> inner) {
  PlainKey key = std::move(inner).plain();
  key.move_by(key_detail::place_of(member));
  return Key<Spec>{std::move(key)};
}

// A name that resembles a key, with the message if it is written.
template <class Spec>
[[nodiscard]] Key<Spec> refused_key(std::string_view name, std::string_view why) {
  PlainKey key{.info = {.name = name, .text = {}}};
  key.info.refused = why;
  return Key<Spec>{std::move(key)};
}

}  // namespace armature::cosim
