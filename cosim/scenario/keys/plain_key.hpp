// The entry of a key without the type of its struct, which Key (key.hpp) adds. One type for all structs, because the
// compiler needs long for what it instantiates for each of them.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "cosim/scenario/keys/key_context.hpp"
#include "cosim/scenario/keys/key_info.hpp"
#include "cosim/scenario/keys/key_value.hpp"
#include "cosim/scenario/toml/table_reader.hpp"

namespace armature::cosim {

// Where the value of a key is, and how it gets there. `spec` is the struct of the table.
struct KeyTarget {
  // Sets the value at `place` and returns true, or reports a problem.
  using Read = std::function<bool(TableReader&, std::string_view name, const Rule&, Need, void* place)>;
  // Returns the message if a value does not fit, or an empty text. May complete `checked`.
  using Check = std::function<std::string(void* checked, const KeyContext&)>;

  Read read;
  Check check{};
  KeyValue (*value)(const void* place) = nullptr;  // of scalar values and words
  std::size_t place = 0;                           // distance from the begin of the struct, in bytes
  std::size_t checked = 0;                         // the same of the struct that is checked
  // The struct of a kind within that of the table, from whose begin the distances then are; nullptr when the table has
  // another kind.
  void* (*kind)(void* spec) = nullptr;
};

struct PlainKey {
  KeyInfo info;
  std::vector<KeyTarget> targets{};  // none: refused; several: of different kinds

  // Sets the value and returns true, or reports a problem. The key is not refused, and `spec` has one of its kinds.
  bool read(TableReader& table, const Rule& rule, Need need, void* spec) const;
  // The message if the value does not fit, or an empty text. Called after all keys of the table were read.
  [[nodiscard]] std::string check(void* spec, const KeyContext& context) const;
  // Of a key that is of no kind and has a scalar value or a word.
  [[nodiscard]] KeyValue value(const void* spec) const;

  // The struct is now a member of another one, so many bytes behind its begin.
  void move_by(std::size_t distance);

 private:
  // The target of the kind that `spec` has, and the begin of its distances.
  struct Found {
    const KeyTarget* target;
    void* begin;
  };
  [[nodiscard]] Found find(void* spec) const;
};

// Their values in `spec`, in their order.
[[nodiscard]] std::vector<NamedValue> values_of(const std::vector<PlainKey>& keys, const void* spec);

// Adds the keys of the kind `name` to those of a table whose key `kind_key` names the kind. A key that other kinds have
// with the same text and the same further conditions becomes one with theirs.
void add_keys_of_kind(std::vector<PlainKey>& keys, const std::vector<PlainKey>& added, std::string_view kind_key,
                      std::string_view name, void* (*kind)(void* spec));

}  // namespace armature::cosim
