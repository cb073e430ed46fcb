// The properties of a key. The loader checks a file by them, and KEYS.md and the JSON Schemas are generated from them.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "cosim/scenario/toml/value_rule.hpp"

namespace armature::cosim {

// What a key or a table needs besides itself.
enum class Needs {
  kNothing,
  kKinematics,  // a robot with [kinematics]
  kPaper,       // variant = "paper"
  kSerial,      // a table [serial]
  kProgram,     // a program in any language
  kGcode,       // a program in G-code
  kJob,         // a robot program
  kFlops,       // engine = "rtl"
  kMemory,      // of the cores: processor = "a9" with cpi
};
// `[kinematics] in FILE`: what is needed. `robot_file` names the file of the robot, and `quote` is put around names
// that are written in a file. Empty for kNothing.
[[nodiscard]] std::string needs_text(Needs needs, std::string_view robot_file, std::string_view quote);

// When a key exists: a condition on another key of the same table, which is before this one in its KeyTable.
struct Condition {
  std::string_view key;
  std::vector<std::string_view> values{};  // the other key has one of these values; empty: it is written
  bool excluded = false;                   // instead: the other key has none of the values

  friend bool operator==(const Condition&, const Condition&) = default;
};
[[nodiscard]] inline Condition when(std::string_view key, std::initializer_list<std::string_view> values) {
  return {.key = key, .values = values};
}
[[nodiscard]] inline Condition unless(std::string_view key, std::initializer_list<std::string_view> values) {
  return {.key = key, .values = values, .excluded = true};
}
[[nodiscard]] inline Condition beside(std::string_view key) {
  return {.key = key};
}

// A value of a key, and what it means: a main clause in Markdown without its full stop.
struct ValueInfo {
  std::string_view value;
  std::string_view text;
};

struct KeyInfo {
  std::string_view name;
  std::string_view text;            // what it means: sentences in Markdown
  std::vector<ValueInfo> values{};  // of a key that names the kind of its table: all values
  ValueKind kind = ValueKind::kNumber;
  Rule rule{};
  bool is_array = false;
  bool has_rows = false;                // an array of such arrays
  bool per_axis = false;                // an array with one element for each axis of the robot
  Need need = Need::kOptional;          // kRequired: where the conditions hold
  std::vector<Condition> conditions{};  // all of them must hold
  std::string_view replaces{};          // a key that this one can be used instead of; they exclude each other
  std::string_view spared_by{};         // a key beside which this one is not required
  Needs needs = Needs::kNothing;
  std::string default_text{};  // TOML; empty: none
  std::string_view without{};  // a short phrase for the default, if it is no value
  std::string_view pattern{};  // regular expression of a string, for schemas
  std::string_view refused{};  // not a key: the message if it is written
};

struct TableInfo {
  std::string_view name{};     // of the key that holds it; empty for a file
  bool repeated = false;       // an array of tables
  std::size_t least = 0;       // tables that a file must have
  std::size_t most = 0;        // tables; 0: as many as a file may have
  bool all_optional = false;   // required keys may be missing, because another table can have them
  std::string_view same_as{};  // another table of the file that has the same keys and describes them
  Needs needs = Needs::kNothing;
  std::string_view text{};
  std::vector<KeyInfo> keys{};
  std::vector<TableInfo> tables{};
};

// `profile = "scurve"`, `type = "arc" or "circle"`; the key alone when the condition is that it is written. The
// text does not say whether the values are excluded.
[[nodiscard]] std::string condition_text(const Condition& condition);

}  // namespace armature::cosim
