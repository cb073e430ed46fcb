#include "cosim/keydoc/markdown.hpp"

#include <fmt/format.h>

#include <map>
#include <sstream>

#include "cosim/keydoc/key_text.hpp"
#include "cosim/text/input_error.hpp"

namespace armature::cosim {
namespace {

constexpr std::string_view kBegin = "<!-- keys of ";
constexpr std::string_view kBeginEnd = " -->";
constexpr std::string_view kEnd = "<!-- end of keys -->";

std::string default_cell(const KeyInfo& key) {
  if (key.need == Need::kRequired) return "required";
  if (!key.default_text.empty()) return fmt::format("`{}`", key.default_text);
  return key.without.empty() ? "none" : std::string{key.without};
}

std::string block(const TableInfo& table) {
  std::string text;
  if (!table.text.empty()) text.append(table.text).append("\n");
  if (!table.same_as.empty()) return text;
  if (!text.empty()) text += "\n";
  text += "| key | type | default | range | meaning |\n|---|---|---|---|---|\n";
  for (const KeyInfo& key : table.keys) {
    if (!key.refused.empty()) continue;
    text += fmt::format("| `{}` | {} | {} | {} | {} |\n", key.name, type_text(key), default_cell(key), range_text(key),
                        meaning_text(key));
  }
  return text;
}

// The blocks of a table and of those in it, by what they are called.
void collect(const TableInfo& table, const std::string& path, std::map<std::string, std::string>& blocks) {
  blocks[path.empty() ? "the file" : table.repeated ? "[[" + path + "]]" : "[" + path + "]"] = block(table);
  if (!table.same_as.empty()) return;
  for (const TableInfo& sub : table.tables) {
    collect(sub, (path.empty() ? "" : path + ".") + std::string{sub.name}, blocks);
  }
}

}  // namespace

std::string renew_document(std::string_view document, const TableInfo& file, const std::string& name) {
  std::map<std::string, std::string> blocks;
  collect(file, "", blocks);
  std::istringstream lines{std::string{document}};
  std::string renewed;
  bool in_block = false;
  for (std::string line; std::getline(lines, line);) {
    if (line == kEnd) in_block = false;
    if (!in_block) renewed += line + "\n";
    if (!line.starts_with(kBegin) || !line.ends_with(kBeginEnd)) continue;
    const std::string table = line.substr(kBegin.size(), line.size() - kBegin.size() - kBeginEnd.size());
    const auto found = blocks.find(table);
    if (found == blocks.end())
      throw InputError{name, "there is no table for the block of " + table + ", or it is the second one"};
    renewed += found->second;
    blocks.erase(found);
    in_block = true;
  }
  if (in_block) throw InputError{name, "the last block has no end"};
  if (!blocks.empty()) throw InputError{name, "there is no block for " + blocks.begin()->first};
  return renewed;
}

}  // namespace armature::cosim
