// What a key needs to know of the type of its member: one set of functions for each type, whatever struct has it.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "controller/base/axes.hpp"
#include "controller/base/words.hpp"
#include "cosim/scenario/keys/key_info.hpp"
#include "cosim/scenario/keys/key_value.hpp"
#include "cosim/scenario/keys/plain_key.hpp"
#include "cosim/scenario/keys/toml_text.hpp"
#include "cosim/scenario/toml/table_reader.hpp"

namespace armature::cosim::key_detail {

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

// The entry of a T that is so many bytes behind the begin of its struct.
template <class T>
[[nodiscard]] PlainKey member_key(std::string_view name, const Rule& rule, std::string_view text, std::size_t place,
                                  const T& otherwise) {
  PlainKey key{.info = info_of<T>(name, rule, text)};
  key.info.default_text = toml_text(otherwise);
  KeyTarget& target = key.targets.emplace_back();
  target.place = place;
  target.read = [](TableReader& table, std::string_view read_name, const Rule& in, Need need, void* out) {
    return read_value(table, read_name, in, need, *static_cast<T*>(out));
  };
  if constexpr (requires { key_value(otherwise); }) {
    target.value = [](const void* value) { return key_value(*static_cast<const T*>(value)); };
  }
  return key;
}

// The same for an enumerator that is written as its word: `first` or one behind it.
template <class Enum>
[[nodiscard]] PlainKey word_key(std::string_view name, Enum first, std::string_view text, std::size_t place,
                                Enum otherwise) {
  const auto words = std::span{kWordsOf<Enum>}.subspan(static_cast<std::size_t>(first));
  PlainKey key{.info = info_of<std::string>(name, one_of(words), text)};
  if (otherwise >= first) key.info.default_text = toml_text(std::string{word_of(otherwise)});
  KeyTarget& target = key.targets.emplace_back();
  target.place = place;
  target.read = [](TableReader& table, std::string_view read_name, const Rule& in, Need need, void* out) {
    std::string word;
    if (!table.read(read_name, word, in, need)) return false;
    *static_cast<Enum*>(out) = enumerator_of<Enum>(word).value();
    return true;
  };
  target.value = [](const void* value) { return key_value(std::string{word_of(*static_cast<const Enum*>(value))}); };
  return key;
}

}  // namespace armature::cosim::key_detail
