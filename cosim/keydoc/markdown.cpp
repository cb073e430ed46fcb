#include "cosim/keydoc/markdown.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "cosim/report/facts/fact.hpp"
#include "cosim/schema/key_text.hpp"
#include "cosim/text/input_error.hpp"
#include "cosim/text/or_list.hpp"

namespace armature::cosim {
namespace {

std::string default_cell(const KeyInfo& key) {
  if (!key.spared_by.empty()) return fmt::format("required; with `{}` {}", key.spared_by, key.without);
  if (key.need == Need::kRequired) return "required";
  if (!key.default_text.empty()) return fmt::format("`{}`", key.default_text);
  return key.without.empty() ? "none" : std::string{key.without};
}

// A table of keys, without their first conditions, which hold for all of them.
std::string rows(std::span<const KeyInfo* const> keys, std::size_t conditions_in_title) {
  std::string text = "| key | type | default | range | meaning |\n|---|---|---|---|---|\n";
  for (const KeyInfo* key : keys) {
    const bool listed = !key->values.empty();
    text += fmt::format("| `{}` | {} | {} | {} | {}{}{} |\n", key->name, type_text(*key), default_cell(*key),
                        listed ? std::string{"see below"} : range_text(*key), key->text,
                        use_text(*key, std::span{key->conditions}.subspan(conditions_in_title)),
                        listed ? " The next table lists the values." : "");
  }
  return text;
}

std::string block(const TableInfo& table) {
  std::string text;
  if (!table.text.empty()) text.append(meaning_text(table)).append("\n");
  if (!table.same_as.empty()) return text;
  if (!text.empty()) text += "\n";

  // Keys that exist with some kinds only, by these kinds.
  const auto kind = std::ranges::find_if(table.keys, [](const KeyInfo& key) { return !key.values.empty(); });
  std::vector<const KeyInfo*> common;
  std::vector<std::pair<const Condition*, std::vector<const KeyInfo*>>> groups;
  for (const KeyInfo& key : table.keys) {
    if (!key.refused.empty()) continue;
    if (kind == table.keys.end() || key.conditions.empty() || key.conditions.front().key != kind->name) {
      common.push_back(&key);
      continue;
    }
    const Condition& kinds = key.conditions.front();
    const auto same = std::ranges::find_if(groups, [&](const auto& group) { return *group.first == kinds; });
    auto& group = same != groups.end() ? *same : groups.emplace_back(&kinds, std::vector<const KeyInfo*>{});
    group.second.push_back(&key);
  }
  if (!common.empty()) text += rows(common, 0);
  if (kind == table.keys.end()) return text;
  text += fmt::format("\n| `{}` | meaning |\n|---|---|\n", kind->name);
  for (const ValueInfo& value : kind->values) text += fmt::format("| `{}` | {} |\n", value.value, value.text);
  for (const auto& [kinds, keys] : groups) {
    text += fmt::format("\nWith `{}` = {}:\n\n", kinds->key, or_list(kinds->values, '`')) + rows(keys, 1);
  }
  return text;
}

// Adds the block of a table and those of the tables in it.
void collect(const TableInfo& table, const std::string& path, Blocks& blocks) {
  const std::string name = path.empty() ? "the file" : table.repeated ? "[[" + path + "]]" : "[" + path + "]";
  blocks["keys of " + name] = block(table);
  if (!table.same_as.empty()) return;
  for (const TableInfo& sub : table.tables) {
    collect(sub, (path.empty() ? "" : path + ".") + std::string{sub.name}, blocks);
  }
}

// The title in the line that begins a block; empty for any other line.
std::string title_of(std::string_view line) {
  constexpr std::string_view kOpen = "<!-- ";
  constexpr std::string_view kClose = " -->";
  if (!line.starts_with(kOpen) || !line.ends_with(kClose)) return {};
  line.remove_prefix(kOpen.size());
  line.remove_suffix(kClose.size());
  return line.starts_with("keys of ") || line.starts_with("facts of ") ? std::string{line} : std::string{};
}

bool is_end(std::string_view line) {
  return line == "<!-- end of keys -->" || line == "<!-- end of facts -->";
}

}  // namespace

Blocks key_blocks(const TableInfo& file) {
  Blocks blocks;
  collect(file, "", blocks);
  return blocks;
}

Blocks fact_blocks() {
  static constexpr std::array<std::pair<FactGroup, std::string_view>, 6> kTitles{{
      {FactGroup::kResult, "facts of every run"},
      {FactGroup::kPaper, "facts of the variant paper"},
      {FactGroup::kSerial, "facts of the serial line"},
      {FactGroup::kOutputs, "facts of the outputs"},
      {FactGroup::kProgram, "facts of the program"},
      {FactGroup::kInstructions, "facts of the instructions"},
  }};
  Blocks blocks;
  for (const auto& [group, title] : kTitles) {
    std::string& text = blocks[std::string{title}];
    text = "| key | unit | meaning |\n|---|---|---|\n";
    for (const Fact& fact : fact_list()) {
      if (fact.group != group) continue;
      text += fmt::format("| `{}` |{}{} | {} |\n", fact.name, fact.unit.empty() ? "" : " ", fact.unit, fact.meaning);
    }
  }
  return blocks;
}

std::string renew_document(std::string_view document, Blocks blocks, const std::string& name) {
  std::istringstream lines{std::string{document}};
  std::string renewed;
  bool in_block = false;
  for (std::string line; std::getline(lines, line);) {
    if (is_end(line)) in_block = false;
    if (!in_block) renewed += line + "\n";
    const std::string title = title_of(line);
    if (title.empty()) continue;
    const auto found = blocks.find(title);
    if (found == blocks.end()) throw InputError{name, "the block \"" + title + "\" is unknown or a second one"};
    renewed += found->second;
    blocks.erase(found);
    in_block = true;
  }
  if (in_block) throw InputError{name, "the last block has no end"};
  if (!blocks.empty()) throw InputError{name, "the block \"" + blocks.begin()->first + "\" is missing"};
  return renewed;
}

}  // namespace armature::cosim
