#include "cosim/programs/gcode_files.hpp"

#include <algorithm>
#include <memory>
#include <string_view>

#include "controller/language/gcode/reader/source_line.hpp"

namespace armature::cosim {
namespace {

bool ends_line(std::string_view text) {
  return text.empty() || text.back() == '\n' || text.back() == '\r';
}

}  // namespace

JoinedGcode::JoinedGcode(std::span<const ProgramFile> files) {
  for (const ProgramFile& file : files) {
    text_ += file.text;
    if (files.size() > 1 && !ends_line(file.text)) text_ += '\n';
    ends_.push_back(static_cast<std::uint32_t>(text_.size()));
  }
}

void JoinedGcode::blank_line(std::uint32_t line) {
  std::size_t begin = 0;
  for (std::uint32_t before = 1; before < line; ++before) begin = gcode::line_at(text_, begin).next;
  const gcode::LineSpan span = gcode::line_at(text_, begin);
  std::fill(text_.begin() + static_cast<std::ptrdiff_t>(span.begin),
            text_.begin() + static_cast<std::ptrdiff_t>(span.end), ' ');
}

std::vector<std::string> missing_subroutines(std::span<const ProgramFile> files) {
  using gcode::Keyword;
  const JoinedGcode joined{files};
  const auto index = std::make_unique<gcode::FlowIndex>();
  const auto scratch = std::make_unique<gcode::SourceLine>();
  std::vector<std::string> names;
  if (index->build(joined.text(), *scratch)) return names;
  for (const gcode::OWord& word : index->words()) {
    if (word.keyword != Keyword::kCall && word.keyword != Keyword::kCallProgram) continue;
    if (word.name == gcode::FlowIndex::kComputed) continue;
    const bool found = index->start_of(Keyword::kSub, word.name) != nullptr ||
                       index->start_of(Keyword::kProgram, word.name) != nullptr;
    const std::string name{index->name(word.name)};
    if (!found && std::ranges::find(names, name) == names.end()) names.push_back(name);
  }
  return names;
}

GcodeLines::GcodeLines(std::span<const ProgramFile> files) {
  std::uint32_t lines = 0;
  for (const ProgramFile& file : files) {
    lines_before_.push_back(lines);
    for (std::size_t at = 0; at < file.text.size(); at = gcode::line_at(file.text, at).next) ++lines;
  }
}

GcodeLine GcodeLines::at(std::uint32_t line) const {
  std::size_t file = 0;
  while (file + 1 < lines_before_.size() && lines_before_[file + 1] < line) ++file;
  return {.file = file, .line = lines_before_.empty() ? line : line - lines_before_[file]};
}

}  // namespace armature::cosim
