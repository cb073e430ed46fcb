#include "cosim/scenario/files/search_path.hpp"

#include <algorithm>
#include <system_error>

#include "cosim/text/text_file.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

bool same_folder(const fs::path& a, const fs::path& b) {
  std::error_code ignored;
  return a == b || fs::equivalent(a, b, ignored);
}

void add_new(std::vector<std::string>& names, std::vector<std::string> more) {
  for (std::string& name : more) {
    if (std::ranges::find(names, name) == names.end()) names.push_back(std::move(name));
  }
}

}  // namespace

std::vector<std::string> list_scenarios(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator{folder, missing}) {
    if (is_file(entry.path() / kScenarioFile)) names.push_back(entry.path().filename().string());
  }
  std::ranges::sort(names);
  return names;
}

std::vector<std::string> list_robots(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator{folder, missing}) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  }
  std::ranges::sort(names);
  return names;
}

void SearchPath::add(SearchFolder folder) {
  const auto known = [&](const SearchFolder& other) { return same_folder(other.path, folder.path); };
  if (std::ranges::any_of(folders_, known)) return;
  searched_.push_back(folder.path.string());
  folders_.push_back(std::move(folder));
}

std::optional<fs::path> SearchPath::find_scenario(std::string_view name) const {
  for (const SearchFolder& folder : folders_) {
    if (fs::path file = folder.scenario(name); is_file(file)) return file;
  }
  return std::nullopt;
}

std::optional<fs::path> SearchPath::find_robot(const std::string& name) const {
  for (const SearchFolder& folder : folders_) {
    if (fs::path file = folder.robot(name); is_file(file)) return file;
  }
  return std::nullopt;
}

std::vector<std::string> SearchPath::scenario_names() const {
  std::vector<std::string> names;
  for (const SearchFolder& folder : folders_) add_new(names, list_scenarios(folder.path));
  return names;
}

std::vector<std::string> SearchPath::robot_names() const {
  std::vector<std::string> names;
  for (const SearchFolder& folder : folders_) add_new(names, list_robots(folder.robots()));
  return names;
}

std::vector<fs::path> SearchPath::scenarios(bool own) const {
  std::vector<fs::path> files;
  for (const SearchFolder& folder : folders_) {
    if (folder.own != own) continue;
    for (const std::string& name : list_scenarios(folder.path)) {
      if (fs::path file = folder.scenario(name); find_scenario(name) == file) files.push_back(std::move(file));
    }
  }
  return files;
}

std::string SearchPath::searched() const {
  std::string text;
  for (const std::string& place : searched_) text.append(text.empty() ? "" : ", ").append(place);
  return text;
}

}  // namespace armature::cosim
