// The entry of a key: its KeyInfo, and the member of the struct of its table that gets the value.
//
//   key("jerk_mm_s3", &PathSpec::jerk_mm_s3, above(0, kMaxJerk, "mm/s^3"), "Text.").only(when("profile", {"scurve"}))
//
// The type comes from the member, and the default from its initialiser.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "controller/base/words.hpp"
#include "cosim/scenario/keys/key_context.hpp"
#include "cosim/scenario/keys/key_info.hpp"
#include "cosim/scenario/keys/key_value.hpp"
#include "cosim/scenario/keys/toml_text.hpp"
#include "cosim/scenario/toml/table_reader.hpp"

namespace armature::cosim {

template <class Spec>
struct Key {
  // Sets the value and returns true, or reports a problem.
  using Read = std::function<bool(TableReader&, const Rule&, Need, Spec&)>;
  // Returns the message if a value does not fit, or an empty text. May complete the struct. Called after all keys of
  // the table were read.
  using Check = std::function<std::string(Spec&, const KeyContext&)>;

  // The value in the struct.
  using Value = std::function<KeyValue(const Spec&)>;

  KeyInfo info;
  Read read;
  Check check{};
  Value value{};  // of named_key() and of key() with a scalar member

  Key required() && {
    info.need = Need::kRequired;
    info.default_text.clear();
    return std::move(*this);
  }
  Key only(Condition condition) && {
    info.conditions.push_back(std::move(condition));
    return std::move(*this);
  }
  Key needs(Needs what) && {
    info.needs = what;
    return std::move(*this);
  }
  // Excludes `other`. If this key is written, `other` is not required.
  Key replaces(std::string_view other) && {
    info.replaces = other;
    return std::move(*this);
  }
  // Required, but not beside `other`; `phrase` is the default then.
  Key required_without(std::string_view other, std::string_view phrase) && {
    info.spared_by = other;
    return std::move(*this).required().without(phrase);
  }
  // A phrase for the default, if the default of the member does not say it.
  Key without(std::string_view phrase) && {
    info.without = phrase;
    info.default_text.clear();
    return std::move(*this);
  }
  Key pattern(std::string_view regular_expression) && {
    info.pattern = regular_expression;
    return std::move(*this);
  }
  // An array with one element for each axis of the robot.
  Key per_axis() && {
    info.per_axis = true;
    return std::move(*this);
  }
  Key checked(Check function) && {
    check = std::move(function);
    return std::move(*this);
  }
};

namespace key_detail {

template <class T>
struct Form {
  static constexpr ValueKind kKind = table_reader_detail::Shape<T>::kKind;
  static constexpr bool kIsArray = false;
  static constexpr bool kHasRows = false;
  static constexpr std::size_t kCount = 0;
};
template <class Element, std::size_t kElements>
struct Form<std::array<Element, kElements>> : Form<Element> {
  static constexpr bool kIsArray = true;
  static constexpr std::size_t kCount = kElements;
};
template <class Element>
struct Form<std::vector<Element>> : Form<Element> {
  static constexpr bool kIsArray = true;
};
template <class Element, std::size_t kElements>
struct Form<std::vector<std::array<Element, kElements>>> : Form<std::array<Element, kElements>> {
  static constexpr bool kHasRows = true;
};
template <class T>
struct Form<std::optional<T>> : Form<T> {};

template <class T>
[[nodiscard]] KeyInfo info_of(std::string_view name, const Rule& rule, std::string_view text) {
  KeyInfo info{.name = name, .text = text, .kind = Form<T>::kKind, .rule = rule};
  info.is_array = Form<T>::kIsArray;
  info.has_rows = Form<T>::kHasRows;
  info.per_axis = Form<T>::kCount == kAxes;
  if (Form<T>::kCount > 0 && !info.per_axis) info.rule.count = Form<T>::kCount;
  return info;
}

template <class T>
bool read_value(TableReader& table, std::string_view name, const Rule& rule, Need need, T& out) {
  return table.read(name, out, rule, need);
}
// The rule gives the number of elements. Axes that the robot does not have keep their value.
template <class T>
bool read_value(TableReader& table, std::string_view name, const Rule& rule, Need need, PerAxis<T>& out) {
  std::vector<T> elements;
  if (!table.read(name, elements, rule, need)) return false;
  std::copy_n(elements.begin(), std::min(elements.size(), kAxes), out.begin());
  return true;
}
template <class T>
bool read_value(TableReader& table, std::string_view name, const Rule& rule, Need need,
                std::optional<PerAxis<T>>& out) {
  PerAxis<T> elements{};
  if (!read_value(table, name, rule, need, elements)) return false;
  out = elements;
  return true;
}

// The values of keys that are not written. Not a local object: g++ 12 takes the destruction of its text for a use.
template <class Spec>
[[nodiscard]] const Spec& defaults() {
  static const Spec kDefaults{};
  return kDefaults;
}

}  // namespace key_detail

// A key of a member.
template <class Spec, class Member>
[[nodiscard]] Key<Spec> key(std::string_view name, Member Spec::*member, Rule rule, std::string_view text) {
  Key<Spec> entry{key_detail::info_of<Member>(name, std::move(rule), text),
                  [name, member](TableReader& table, const Rule& in, Need need, Spec& spec) {
                    return key_detail::read_value(table, name, in, need, spec.*member);
                  }};
  entry.info.default_text = toml_text(key_detail::defaults<Spec>().*member);
  if constexpr (requires(const Member& value) { key_value(value); }) {
    entry.value = [member](const Spec& spec) { return key_value(spec.*member); };
  }
  return entry;
}

// A key whose value is the word of an enumerator: of `first` or one behind it.
template <class Spec, class Enum>
[[nodiscard]] Key<Spec> named_key(std::string_view name, Enum Spec::*member, std::string_view text,
                                  Enum first = Enum{}) {
  const auto words = std::span{kWordsOf<Enum>}.subspan(static_cast<std::size_t>(first));
  Key<Spec> entry{key_detail::info_of<std::string>(name, one_of(words), text),
                  [name, member](TableReader& table, const Rule& in, Need need, Spec& spec) {
                    std::string value;
                    if (!table.read(name, value, in, need)) return false;
                    spec.*member = enumerator_of<Enum>(value).value();
                    return true;
                  }};
  const Enum otherwise = key_detail::defaults<Spec>().*member;
  if (otherwise >= first) entry.info.default_text = toml_text(std::string{word_of(otherwise)});
  entry.value = [member](const Spec& spec) { return key_value(std::string{word_of(spec.*member)}); };
  return entry;
}

// A key that is written as a T and stored in another form. set(spec, value) stores it and returns an empty text, or
// returns the message why it cannot.
template <class Spec, class T, class Set>
[[nodiscard]] Key<Spec> set_key(std::string_view name, Set set, Rule rule, std::string_view text) {
  return {key_detail::info_of<T>(name, std::move(rule), text),
          [name, set](TableReader& table, const Rule& in, Need need, Spec& spec) {
            T value{};
            if (!table.read(name, value, in, need)) return false;
            const std::string why = set(spec, value);
            if (!why.empty()) table.problem(name, why);
            return why.empty();
          }};
}

// A key of a struct that is a member of another one.
template <class Spec, class Inner>
[[nodiscard]] Key<Spec> part(Inner Spec::*member, Key<Inner> inner) {
  Key<Spec> entry{inner.info, [member, read = inner.read](TableReader& table, const Rule& rule, Need need, Spec& spec) {
                    return read(table, rule, need, spec.*member);
                  }};
  if (inner.check) {
    entry.check = [member, check = inner.check](Spec& spec, const KeyContext& context) {
      return check(spec.*member, context);
    };
  }
  return entry;
}

// A name that resembles a key, with the message if it is written.
template <class Spec>
[[nodiscard]] Key<Spec> refused_key(std::string_view name, std::string_view why) {
  Key<Spec> entry{KeyInfo{.name = name, .text = {}}, nullptr};
  entry.info.refused = why;
  return entry;
}

}  // namespace armature::cosim
