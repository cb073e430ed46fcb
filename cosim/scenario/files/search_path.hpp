// The folders in which scenarios and robots are searched by name. The first folder that has the name is used.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace armature::cosim {

inline constexpr const char* kScenarioFile = "scenario.toml";
inline constexpr const char* kRobotsFolder = "robots";

// Names of the folders in `folder` that hold a scenario.toml, sorted. Empty when there is no such folder.
[[nodiscard]] std::vector<std::string> list_scenarios(const std::filesystem::path& folder);

// Names of the robots of a folder (`*.toml` without the ending), sorted. Empty when there is no such folder.
[[nodiscard]] std::vector<std::string> list_robots(const std::filesystem::path& folder);

// A folder of scenarios: NAME/scenario.toml, robots/NAME.toml.
struct SearchFolder {
  std::filesystem::path path;
  std::string origin{};  // why the folder is in the path: `--path`, ...
  bool own = true;       // the user's; false: it came with the program

  [[nodiscard]] std::filesystem::path scenario(std::string_view name) const { return path / name / kScenarioFile; }
  [[nodiscard]] std::filesystem::path robots() const { return path / kRobotsFolder; }
  [[nodiscard]] std::filesystem::path robot(const std::string& name) const { return robots() / (name + ".toml"); }
};

class SearchPath {
 public:
  SearchPath() = default;
  // This folder alone.
  SearchPath(std::filesystem::path folder) { add({.path = std::move(folder)}); }

  // Adds a folder to the end of the path. A folder that is already in it is not added again.
  void add(SearchFolder folder);
  // Adds a place where no folder was found, for messages.
  void add_missing(std::string place) { searched_.push_back(std::move(place)); }

  [[nodiscard]] const std::vector<SearchFolder>& folders() const { return folders_; }

  // The file for a name. Nothing if no folder has it.
  [[nodiscard]] std::optional<std::filesystem::path> find_scenario(std::string_view name) const;
  [[nodiscard]] std::optional<std::filesystem::path> find_robot(const std::string& name) const;

  // Every name that can be found, each once, in the order of the folders.
  [[nodiscard]] std::vector<std::string> scenario_names() const;
  [[nodiscard]] std::vector<std::string> robot_names() const;

  // The files of the scenarios in the folders of the user (`own`) or of the program. Shadowed files are left out.
  [[nodiscard]] std::vector<std::filesystem::path> scenarios(bool own) const;

  // The searched places, for messages: `mine, /usr/local/share/armature/scenarios`.
  [[nodiscard]] std::string searched() const;

 private:
  std::vector<SearchFolder> folders_;
  std::vector<std::string> searched_;
};

}  // namespace armature::cosim
