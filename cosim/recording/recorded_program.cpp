#include "cosim/recording/recorded_program.hpp"

#include <algorithm>
#include <filesystem>

#include "cosim/text/json.hpp"
#include "cosim/text/sha256.hpp"
#include "cosim/text/text_file.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxShownBytes = 1U << 20U;

RecordedProgram read_again(const std::string& name, const fs::path& file, const std::string& digest) {
  if (!is_file(file)) return {.name = name, .problem = "The file is no longer there."};
  if (fs::file_size(file) > kMaxShownBytes) return {.name = name, .problem = "The file is too long to be shown."};
  std::string text = read_text_file(file);
  if (sha256_hex(text) != digest) return {.name = name, .problem = "The file has changed since the run."};
  return {.name = name, .text = std::move(text)};
}

// Names of files are relative to the scenario, which is the first input.
RecordedProgram program_of(const Json& inputs, const std::string& name) {
  const fs::path folder = fs::path{inputs[0].value("file", "")}.parent_path();
  for (const Json& input : inputs) {
    const fs::path file = input.value("file", "");
    if (file.lexically_normal() == (folder / name).lexically_normal()) {
      return read_again(name, file, input.value("sha256", ""));
    }
  }
  return {.name = name, .problem = "The run does not say where the file was."};
}

}  // namespace

std::vector<RecordedProgram> recorded_programs(const Json& summary) {
  std::vector<RecordedProgram> programs;
  const Json& result = summary["result"];
  if (!result.contains("program") || !summary.contains("inputs") || summary["inputs"].empty()) return programs;
  for (const Json& event : result["program"]) {
    const std::string name = event.value("file", "");
    if (name.empty() || std::ranges::find(programs, name, &RecordedProgram::name) != programs.end()) continue;
    programs.push_back(program_of(summary["inputs"], name));
  }
  return programs;
}

}  // namespace armature::cosim
