// KEYS.md: prose that is written by hand, and tables of keys that are written from the entries.
#pragma once

#include <string>
#include <string_view>

#include "cosim/scenario/keys/key_info.hpp"

namespace armature::cosim {

// The document with its blocks renewed. A block begins with a line `<!-- keys of [TABLE] -->` (`[[TABLE]]` for an array
// of tables, `the file` for the keys outside of tables) and ends with `<!-- end of keys -->`. Throws InputError when a
// block is of no table, or a table has no block; `name` is that of the document.
[[nodiscard]] std::string renew_document(std::string_view document, const TableInfo& file, const std::string& name);

}  // namespace armature::cosim
