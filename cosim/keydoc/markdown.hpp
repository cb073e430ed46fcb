// Documents with tables that are generated: KEYS.md has keys, RESULTS.md has facts. The text around the tables is
// written by hand.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "cosim/scenario/keys/key_info.hpp"

namespace armature::cosim {

// The text of each generated block, by its title.
using Blocks = std::map<std::string, std::string>;

// The tables of keys of a kind of file. Titles: `keys of [TABLE]`, `keys of [[TABLE]]` for an array of tables, and
// `keys of the file` for the keys outside of tables.
[[nodiscard]] Blocks key_blocks(const TableInfo& file);
// The tables of the facts of a run. Titles: `facts of every run`, `facts of the variant paper`,
// `facts of the serial line`, `facts of the outputs`.
[[nodiscard]] Blocks fact_blocks();

// The document with its blocks renewed. A block begins with the line `<!-- TITLE -->` and ends with the line
// `<!-- end of keys -->` or `<!-- end of facts -->`. Throws InputError when the document has an unknown block, or has
// not each of `blocks` exactly once; `name` is that of the document.
[[nodiscard]] std::string renew_document(std::string_view document, Blocks blocks, const std::string& name);

}  // namespace armature::cosim
