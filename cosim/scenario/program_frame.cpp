#include "cosim/scenario/program_frame.hpp"

#include <charconv>
#include <cstddef>
#include <string_view>

#include "cosim/programs/program_name.hpp"
#include "cosim/scenario/moves/pose.hpp"
#include "cosim/text/csv_line.hpp"

namespace armature::cosim {
namespace {

// What follows this word in the first line of a job that begins with it; nothing if there is none.
std::optional<std::string_view> value_in_job(std::string_view text, std::string_view word) {
  while (!text.empty()) {
    std::string_view line = pop_line(text);
    if (line.starts_with(word)) return line.substr(word.size());
  }
  return std::nullopt;
}

std::size_t number_of(std::string_view text) {
  std::size_t number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

std::optional<std::string> frame_of_job(const Scenario& scenario, std::string_view job) {
  const auto type = value_in_job(job, "///POSTYPE ");
  if (type && (type->starts_with("PULSE") || type->starts_with("ANGLE"))) return std::nullopt;
  const std::size_t user = number_of(value_in_job(job, "///USER ").value_or(""));
  const bool in_user_frame = type && type->starts_with("USER") && user >= 1 && user <= scenario.frames.size();
  return in_user_frame ? scenario.frames[user - 1].name : std::string{kBaseFrameName};
}

}  // namespace

std::optional<std::string> program_frame(const Scenario& scenario) {
  if (!scenario.program || scenario.program_files.empty()) return std::nullopt;
  if (program_language(*scenario.program) == ProgramLanguage::kGcode) return scenario.gcode.frame_name;
  return frame_of_job(scenario, scenario.program_files.front().text);
}

}  // namespace armature::cosim
