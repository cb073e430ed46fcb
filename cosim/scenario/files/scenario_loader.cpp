#include "cosim/scenario/files/scenario_loader.hpp"

#include <algorithm>
#include <optional>
#include <system_error>
#include <utility>

#include "cosim/scenario/files/belt_policy_file.hpp"
#include "cosim/scenario/files/pendant_file.hpp"
#include "cosim/scenario/files/points_file.hpp"
#include "cosim/scenario/files/program_file.hpp"
#include "cosim/scenario/files/robot_loader.hpp"
#include "cosim/scenario/files/scenario_reader.hpp"
#include "cosim/scenario/files/stream_file.hpp"
#include "cosim/scenario/toml/old_logic_key.hpp"
#include "cosim/scenario/toml/override.hpp"
#include "cosim/scenario/toml/table_reader.hpp"
#include "cosim/scenario/toml/toml_document.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/suggest.hpp"
#include "cosim/text/text_file.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

// Whether this is a plain word. It is searched on the search path if the current folder does not have it.
bool is_bare_name(const fs::path& where) {
  return !where.has_parent_path() && where != "." && where != ".." && where.extension() != ".toml";
}

fs::path find_scenario_file(const fs::path& where, const SearchPath& search_path) {
  std::error_code ignored;
  if (is_file(where)) return where;
  if (is_file(where / kScenarioFile)) return where / kScenarioFile;
  const bool folder = fs::is_directory(where, ignored);
  if (is_bare_name(where)) {
    if (std::optional<fs::path> found = search_path.find_scenario(where.string())) return *std::move(found);
    if (!folder) {
      throw InputError{where.string(), "no such scenario" + suggestion(where.string(), search_path.scenario_names()) +
                                           " (searched: " + search_path.searched() + ")"};
    }
  }
  if (folder) {
    std::string in_it;
    for (const std::string& name : list_scenarios(where))
      in_it += (in_it.empty() ? "; scenarios in it: " : ", ") + name;
    throw InputError{where.string(), std::string{"this folder has no "} + kScenarioFile + in_it};
  }
  throw InputError{where.string(), "no such file or folder"};
}

// The file of the robot that the scenario names. If there is none, reports a problem at the key `robot` and returns
// nothing.
std::optional<fs::path> find_robot_file(const Scenario& scenario, const LoadOptions& options, TableReader& root) {
  const fs::path scenario_folder = fs::path{scenario.file}.parent_path();
  const std::string& name = scenario.robot_name;
  if (name.ends_with(".toml")) {
    const fs::path file = scenario_folder / name;
    if (is_file(file)) return file;
    root.problem("robot", "no such file: " + file.lexically_normal().string());
    return std::nullopt;
  }
  const fs::path beside = scenario_folder.empty() ? fs::path{".."} : scenario_folder / "..";
  SearchPath robots{beside.lexically_normal()};
  for (const SearchFolder& folder : options.search_path.folders()) robots.add(folder);
  if (std::optional<fs::path> file = robots.find_robot(name)) return file;
  root.problem("robot", "unknown robot \"" + printable(name) + "\"" + suggestion(name, robots.robot_names()));
  return std::nullopt;
}

// Loads the robot that the scenario names. Its problems are added to `all`.
ScenarioRobot load_named_robot(Scenario& scenario, const LoadOptions& options, TableReader& root,
                               std::vector<Problem>& all) {
  if (scenario.robot_name.empty()) return {};
  const std::optional<fs::path> file = find_robot_file(scenario, options, root);
  if (!file) return {};
  scenario.robot = load_robot(*file, all);
  return {.spec = all.empty() ? &scenario.robot : nullptr, .file = file->string()};
}

// Reads the files of the streams. Their problems are added to `all`.
void read_streams(Scenario& scenario, std::vector<Problem>& all) {
  constexpr std::size_t kMaxStreamBytes = 64u << 20;
  for (StreamSpec& stream : scenario.streams) {
    try {
      const fs::path file = fs::path{scenario.file}.parent_path() / stream.file_name;
      const std::string text = read_text_file(file, kMaxStreamBytes);
      parse_stream(text, file.string(), scenario.robot.axis_count, stream);
      if (stream.kind == StreamSpec::Kind::kTool && !scenario.robot.kinematics) {
        throw InputError{file.string(), "has poses of the tool, but the robot has no [kinematics]"};
      }
      scenario.sources.push_back(input_file(file, text));
    } catch (const InputError& error) {
      all.insert(all.end(), error.problems().begin(), error.problems().end());
    }
  }
}

}  // namespace

Scenario load_scenario(const fs::path& where, const LoadOptions& options) {
  const fs::path file = find_scenario_file(where, options.search_path);
  const std::string text = read_toml(file);
  ConfigValue document = parse_toml(text, file.string());

  Scenario scenario;
  scenario.file = file.string();
  scenario.directory = fs::absolute(file).lexically_normal().parent_path().string();
  scenario.name = (file.filename() == kScenarioFile ? fs::path{scenario.directory}.filename() : file.stem()).string();

  scenario.sources.push_back(input_file(file, text));
  scenario.overrides = options.overrides;

  ProblemList problems{scenario.file};
  for (const std::string& assignment : options.overrides) apply_override(document, assignment, problems);
  refuse_old_logic_key(document, problems);
  TableReader root{document, "", problems};
  const std::vector<std::string_view> bad = read_scenario_keys(root, scenario);
  std::vector<Problem> robot_problems;
  const ScenarioRobot robot = load_named_robot(scenario, options, root, robot_problems);
  read_scenario_tables(root, bad, robot, options.logic, options.processor, scenario);
  std::vector<Problem> program_problems;
  if (problems.size() == 0 && robot_problems.empty()) load_program(scenario, root, program_problems);

  std::vector<Problem> all;
  problems.move_to(all);
  std::move(robot_problems.begin(), robot_problems.end(), std::back_inserter(all));
  std::move(program_problems.begin(), program_problems.end(), std::back_inserter(all));
  if (all.empty()) read_streams(scenario, all);
  if (all.empty()) load_points(scenario, all);
  if (all.empty()) load_belt_policy(scenario, all);
  if (all.empty()) load_pendant_programs(scenario, all);
  if (!all.empty()) throw InputError{std::move(all)};
  scenario.sources.push_back(scenario.robot.source);
  scenario.sources.insert(scenario.sources.end(), scenario.robot.mesh_files.begin(), scenario.robot.mesh_files.end());
  return scenario;
}

std::vector<fs::path> find_scenario_files(const fs::path& where, const SearchPath& search_path) {
  std::vector<fs::path> files;
  if (!is_file(where / kScenarioFile)) {
    for (const std::string& name : list_scenarios(where)) files.push_back(where / name / kScenarioFile);
  }
  if (files.empty()) files.push_back(find_scenario_file(where, search_path));
  return files;
}

}  // namespace armature::cosim
