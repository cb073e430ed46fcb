#include "cosim/recording/recorded_program.hpp"

#include <algorithm>
#include <filesystem>

#include "cosim/recording/recorded_input.hpp"
#include "cosim/text/json.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxShownBytes = 1U << 20U;

// Names of files are relative to the scenario, which is the first input.
RecordedProgram program_of(const Json& summary, const std::string& name) {
  const fs::path folder = fs::path{summary["inputs"][0].value("file", "")}.parent_path();
  RecordedInput input = recorded_input(summary, folder / name, kMaxShownBytes);
  return {.name = name, .text = std::move(input.content), .problem = std::move(input.problem)};
}

}  // namespace

std::vector<RecordedProgram> recorded_programs(const Json& summary) {
  std::vector<RecordedProgram> programs;
  const Json& result = summary["result"];
  if (!result.contains("program") || !summary.contains("inputs") || summary["inputs"].empty()) return programs;
  for (const Json& event : result["program"]) {
    const std::string name = event.value("file", "");
    if (name.empty() || std::ranges::find(programs, name, &RecordedProgram::name) != programs.end()) continue;
    programs.push_back(program_of(summary, name));
  }
  return programs;
}

}  // namespace armature::cosim
