// What documents and schemas say about a key and a table in words.
#pragma once

#include <span>
#include <string>

#include "cosim/scenario/keys/key_info.hpp"

namespace armature::cosim {

// `3 numbers (mm)`
[[nodiscard]] std::string type_text(const KeyInfo& key);
// `above 0, up to 100`; the choices in backticks; empty when everything is allowed.
[[nodiscard]] std::string range_text(const KeyInfo& key);
// The sentences about the key and its values, with those about its use.
[[nodiscard]] std::string meaning_text(const KeyInfo& key);
// The sentences about the use of the key: these conditions of it, the key that it replaces, and what it needs. Each
// begins with a space.
[[nodiscard]] std::string use_text(const KeyInfo& key, std::span<const Condition> conditions);
// The sentences about the table, with the one that follows from its needs.
[[nodiscard]] std::string meaning_text(const TableInfo& table);

}  // namespace armature::cosim
