#include "cosim/scenario/files/program_file.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "cosim/programs/gcode_files.hpp"
#include "cosim/programs/job_check.hpp"
#include "cosim/programs/program_name.hpp"
#include "cosim/scenario/files/gcode_check.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/text_file.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxProgramBytes = std::size_t{64} << 20U;

// Reads a file in the folder of the scenario. `name` is relative to that folder.
void read_program(Scenario& scenario, const std::string& name) {
  const fs::path file = (fs::path{scenario.file}.parent_path() / name).lexically_normal();
  std::size_t left = kMaxProgramBytes;
  for (const ProgramFile& before : scenario.program_files) left -= before.text.size();
  std::string text = read_text_file(file, left);
  scenario.sources.push_back(input_file(file, text));
  scenario.program_files.push_back({.name = name, .file = file.string(), .text = std::move(text)});
}

// The file of a job that the program calls, beside the program; nothing if there is none.
std::optional<std::string> file_of_job(const Scenario& scenario, std::string_view job) {
  const fs::path beside = fs::path{*scenario.program}.parent_path();
  const auto found = find_program(fs::path{scenario.file}.parent_path() / beside, job, ProgramLanguage::kJob);
  return found ? std::optional{(beside / found->filename()).string()} : std::nullopt;
}

}  // namespace

void load_program(Scenario& scenario, TableReader& root, std::vector<Problem>& all) {
  if (!scenario.program) return;
  if (!scenario.robot.kinematics) {
    return root.problem("program", "needs [kinematics] in the file of the robot");
  }
  const fs::path file = fs::path{scenario.file}.parent_path() / *scenario.program;
  if (!is_file(file)) {
    return root.problem("program", "no such file: " + printable(file.lexically_normal().string()));
  }
  try {
    read_program(scenario, *scenario.program);
    if (program_language(*scenario.program) == ProgramLanguage::kGcode) {
      const fs::path folder = fs::path{*scenario.program}.parent_path();
      const fs::path root_folder = fs::path{scenario.file}.parent_path();
      read_subroutines(scenario.program_files, root_folder / folder,
                       [&](const fs::path& found) { read_program(scenario, (folder / found.filename()).string()); });
      return check_gcode(scenario, all);
    }
    JobCheck check;
    for (std::size_t i = 0; i < scenario.program_files.size(); ++i) {
      check.load(scenario.program_files[i]);
      for (const std::string& job : check.new_missing_jobs()) {
        if (const auto called = file_of_job(scenario, job)) read_program(scenario, *called);
      }
    }
    check.finish(all);
  } catch (const InputError& error) {
    all.insert(all.end(), error.problems().begin(), error.problems().end());
  }
}

}  // namespace armature::cosim
