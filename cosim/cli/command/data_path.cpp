#include "cosim/cli/command/data_path.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <sstream>
#include <system_error>

#include "cosim/text/input_error.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

constexpr const char* kScenarios = "scenarios";

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

// The folder `scenarios` in `folder` or in the nearest folder above. A folder of this name without robots and scenarios
// does not count.
std::optional<fs::path> search_upwards(fs::path folder) {
  for (;; folder = folder.parent_path()) {
    const fs::path found = folder / kScenarios;
    if (is_folder(found / kRobotsFolder) || !list_scenarios(found).empty()) return found;
    if (folder == folder.parent_path()) return std::nullopt;
  }
}

// `option`: the option or variable that names the folder.
void add_named(SearchPath& path, const std::string& folder, const std::string& option) {
  if (!is_folder(folder)) throw InputError{option, "no such folder: " + folder};
  path.add({.path = folder, .origin = option});
}

void add_environment(SearchPath& path) {
  const char* value = std::getenv(kPathVariable);
  std::istringstream folders{value == nullptr ? "" : value};
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (!folder.empty()) add_named(path, folder, kPathVariable);
  }
}

void add_current_folder(SearchPath& path) {
  std::error_code ignored;
  const fs::path here = fs::current_path(ignored);
  if (const auto found = search_upwards(here)) {
    path.add({.path = fs::proximate(*found, ignored), .origin = "current folder or above"});
  } else {
    path.add_missing(fmt::format("'{}' in {} and above", kScenarios, here.string()));
  }
  if (is_folder(kRobotsFolder)) path.add({.path = ".", .origin = "current folder"});
}

// Relative to the program, so that program and data can be moved together.
void add_program(SearchPath& path) {
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  const fs::path installed = (program / ARMATURE_DATA_FROM_PROGRAM / kScenarios).lexically_normal();
  if (is_folder(installed)) {
    path.add({.path = installed, .origin = "installed", .own = false});
  } else if (const auto found = search_upwards(program)) {
    path.add({.path = *found, .origin = "checkout of the program", .own = false});
  } else {
    path.add_missing(installed.string());
  }
}

}  // namespace

SearchPath data_path(const std::vector<std::string>& named) {
  SearchPath path;
  for (const std::string& folder : named) add_named(path, folder, "--path");
  add_environment(path);
  add_current_folder(path);
  add_program(path);
  return path;
}

}  // namespace armature::cosim
