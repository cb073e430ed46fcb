#include "cosim/scenario/scenario_loader.hpp"

#include <algorithm>
#include <optional>
#include <system_error>
#include <utility>

#include "cosim/scenario/override.hpp"
#include "cosim/scenario/robot_loader.hpp"
#include "cosim/scenario/scenario_tables.hpp"
#include "cosim/scenario/table_reader.hpp"
#include "cosim/scenario/toml_document.hpp"
#include "cosim/text/suggest.hpp"
#include "cosim/text/text_file.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

constexpr const char* kScenarioFile = "scenario.toml";
constexpr const char* kRobotsFolder = "robots";

std::string suggest_from(const std::string& typed, const std::vector<std::string>& known) {
  const std::vector<std::string_view> views{known.begin(), known.end()};
  return suggestion(typed, views);
}

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

fs::path find_scenario_file(const fs::path& where, const fs::path& scenarios_dir) {
  std::error_code ignored;
  if (is_file(where)) return where;
  if (fs::is_directory(where, ignored)) {
    if (is_file(where / kScenarioFile)) return where / kScenarioFile;
    throw InputError{where.string(), std::string{"this folder holds no "} + kScenarioFile};
  }
  if (!where.has_parent_path() && where.extension() != ".toml") {
    if (is_file(scenarios_dir / where / kScenarioFile)) return scenarios_dir / where / kScenarioFile;
    throw InputError{where.string(), "no such scenario in " + scenarios_dir.string() +
                                         suggest_from(where.string(), list_scenarios(scenarios_dir))};
  }
  throw InputError{where.string(), "no such file or folder"};
}

// The file of the robot that the scenario names; nothing, and a problem at the `robot` key, when there is none.
std::optional<fs::path> find_robot_file(const Scenario& scenario, const LoadOptions& options, TableReader& root) {
  const fs::path scenario_folder = fs::path{scenario.file}.parent_path();
  const std::string& name = scenario.robot_name;
  if (name.ends_with(".toml")) {
    const fs::path file = scenario_folder / name;
    if (is_file(file)) return file;
    root.problem("robot", "no such file: " + file.lexically_normal().string());
    return std::nullopt;
  }
  const fs::path beside = (scenario_folder.empty() ? fs::path{".."} : scenario_folder / "..") / kRobotsFolder;
  std::vector<std::string> known;
  for (const fs::path& folder : {beside.lexically_normal(), options.scenarios_dir / kRobotsFolder}) {
    const fs::path file = folder / (name + ".toml");
    if (is_file(file)) return file;
    for (std::string& robot : list_robots(folder)) {
      if (std::find(known.begin(), known.end(), robot) == known.end()) known.push_back(std::move(robot));
    }
  }
  root.problem("robot", "unknown robot \"" + name + "\"" + suggest_from(name, known));
  return std::nullopt;
}

// Loads the robot that the scenario names; its problems go to `all`.
ScenarioRobot load_named_robot(Scenario& scenario, const LoadOptions& options, TableReader& root,
                               std::vector<Problem>& all) {
  if (scenario.robot_name.empty()) return {};
  const std::optional<fs::path> file = find_robot_file(scenario, options, root);
  if (!file) return {};
  scenario.robot = load_robot(*file, all);
  return {.spec = all.empty() ? &scenario.robot : nullptr, .file = file->string()};
}

}  // namespace

Scenario load_scenario(const fs::path& where, const LoadOptions& options) {
  const fs::path file = find_scenario_file(where, options.scenarios_dir);
  ConfigValue document = parse_toml(read_text_file(file), file.string());

  Scenario scenario;
  scenario.file = file.string();
  scenario.directory = fs::absolute(file).lexically_normal().parent_path().string();
  scenario.name = (file.filename() == kScenarioFile ? fs::path{scenario.directory}.filename() : file.stem()).string();

  ProblemList problems{scenario.file};
  for (const std::string& assignment : options.overrides) apply_override(document, assignment, problems);
  TableReader root{document, "", problems};
  read_identity(root, scenario);
  std::vector<Problem> robot_problems;
  const ScenarioRobot robot = load_named_robot(scenario, options, root, robot_problems);
  read_scenario(root, robot, options.fabric, scenario);

  std::vector<Problem> all;
  problems.move_to(all);
  std::move(robot_problems.begin(), robot_problems.end(), std::back_inserter(all));
  if (!all.empty()) throw InputError{std::move(all)};
  return scenario;
}

std::vector<std::string> list_scenarios(const fs::path& scenarios_dir) {
  std::vector<std::string> names;
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator{scenarios_dir, missing}) {
    if (is_file(entry.path() / kScenarioFile)) names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace armature::cosim
