// Where scenarios and robots are looked up by their bare names: a row of folders, the first that has the name wins.
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
  std::string origin{};  // why it is searched: `--path`, ...
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

  // The next folder to search; nothing happens when it is searched already.
  void add(SearchFolder folder);
  // Where a folder to search was looked for and not found, for messages.
  void add_missing(std::string place) { searched_.push_back(std::move(place)); }

  [[nodiscard]] const std::vector<SearchFolder>& folders() const { return folders_; }

  // The file that a name stands for; nothing when no folder has it.
  [[nodiscard]] std::optional<std::filesystem::path> find_scenario(std::string_view name) const;
  [[nodiscard]] std::optional<std::filesystem::path> find_robot(const std::string& name) const;

  // Every name that can be found, once, in the order of the folders.
  [[nodiscard]] std::vector<std::string> scenario_names() const;
  [[nodiscard]] std::vector<std::string> robot_names() const;

  // The files of the scenarios of either the user's folders or the program's, without those that a name never finds.
  [[nodiscard]] std::vector<std::filesystem::path> scenarios(bool own) const;

  // Where was searched, for messages: `mine, /usr/local/share/armature/scenarios`.
  [[nodiscard]] std::string searched() const;

 private:
  std::vector<SearchFolder> folders_;
  std::vector<std::string> searched_;
};

}  // namespace armature::cosim
