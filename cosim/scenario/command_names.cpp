#include "cosim/scenario/command_names.hpp"

#include <fmt/format.h>

#include <cstddef>

#include "controller/language/job/execute/machine.hpp"
#include "cosim/programs/program_name.hpp"
#include "cosim/text/printable.hpp"

namespace armature::cosim {
namespace {

// The pendant numbers its commands from a base that no scenario reaches.
constexpr std::uint32_t kOwnNumber = 0x003F'FFFF;

}  // namespace

CommandNames::CommandNames(const Scenario& scenario) {
  const bool sent = scenario.pendant && sends_program(*scenario.pendant);
  has_program_ = sent || !scenario.program_files.empty();
  if (!sent) {
    for (const ProgramFile& file : scenario.program_files) files_.push_back(printable(file.name));
    gcode_lines_ = GcodeLines{scenario.program_files};
  } else if (scenario.program_files.empty()) {
    for (const std::string& file : files_of_sent_program(*scenario.pendant)) files_.push_back(printable(file));
  }
}

std::string CommandNames::of(Tag tag) const {
  switch (tag.source()) {
    case Source::kProgram:
      return line_text(tag.number());
    case Source::kPendant:
      return fmt::format("pendant[{}]", tag.number() & kOwnNumber);
    case Source::kScenario:
      break;
  }
  if (tag.number() >= kFirstStreamTag) return fmt::format("stream[{}]", tag.number() - kFirstStreamTag);
  return fmt::format("move[{}]", tag.number());
}

ProgramLine CommandNames::line(std::uint32_t place) const {
  if (!files_.empty() && program_language(files_.front()) == ProgramLanguage::kGcode) {
    const GcodeLine at = gcode_lines_.at(place);
    return {.file = files_[at.file], .line = at.line};
  }
  const std::size_t job = job::Machine::job_of(place);
  const std::string other = job == 0 ? std::string{} : fmt::format("job {}", job + 1);
  return {.file = job < files_.size() ? files_[job] : other, .line = job::Machine::line_of(place)};
}

std::string CommandNames::line_text(std::uint32_t place) const {
  const ProgramLine at = line(place);
  return at.file.empty() ? fmt::format("line {}", at.line) : fmt::format("line {} of {}", at.line, at.file);
}

std::optional<std::uint32_t> move_index(Tag tag) {
  if (tag.source() != Source::kScenario || tag.number() >= kFirstStreamTag) return std::nullopt;
  return tag.number();
}

}  // namespace armature::cosim
