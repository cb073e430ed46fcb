#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>

#include "cosim/cli/command/command.hpp"
#include "cosim/cli/options/value_kinds.hpp"
#include "cosim/cli/texts/new_scenario.hpp"
#include "cosim/scenario/files/robot_loader.hpp"
#include "cosim/scenario/files/search_path.hpp"
#include "cosim/schema/file_kinds.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/shell_text.hpp"
#include "cosim/text/text_file.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

constexpr const char* kNewDetails = R"(Examples:
  armature new nod && armature run nod
  armature new pick_up --robot kuka_kr6_r900

Writes NAME/scenario.toml: a joint move, with comments that explain each key. It passes when it is run. The file is in the
first of your folders that 'armature list' shows, or in 'scenarios' in the current folder. If that folder has no
scenario.schema.json, it is written, too: an editor for TOML that knows schemas then completes the keys. Nothing is
overwritten.
Exit code: 0 ok, 2 bad input, 3 internal error.)";

constexpr const char* kDefaultRobot = "vo2021_6r";
constexpr const char* kNewFolder = "scenarios";

struct NewOptions {
  std::string name;
  std::string robot = kDefaultRobot;
};

void require_name(const std::string& name) {
  constexpr std::string_view kAllowed = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-";
  constexpr std::size_t kMaxCharacters = 100;
  const bool valid = !name.empty() && name.size() <= kMaxCharacters && name.front() != '-' &&
                     name.find_first_not_of(kAllowed) == std::string::npos;
  if (!valid) {
    throw InputError{"new", fmt::format("'{}' is no name of a scenario; expected letters, digits, '_' and '-', at "
                                        "most {} of them",
                                        name, kMaxCharacters)};
  }
  if (name == kRobotsFolder) {
    throw InputError{"new", fmt::format("'{}' is the folder of robots; expected another name", name)};
  }
}

// The folder of scenarios in which the new one is written.
fs::path new_folder(const SearchPath& path) {
  const auto own = std::ranges::find_if(path.folders(), &SearchFolder::own);
  return own == path.folders().end() ? fs::path{kNewFolder} : own->path;
}

int create(const NewOptions& given, const SearchPath& path) {
  require_name(given.name);
  const RobotSpec robot = find_robot(given.robot, path);
  const fs::path folder = new_folder(path) / given.name;
  std::error_code ignored;
  if (fs::exists(fs::symlink_status(folder, ignored))) {
    throw InputError{folder.string(), "exists already; expected the name of a new scenario"};
  }
  if (const auto other = path.find_scenario(given.name)) {
    throw InputError{given.name, "is the name of " + other->string() +
                                     ", which the new scenario would hide; expected "
                                     "another name"};
  }
  const std::string key = robot_key(given.robot, folder);
  const fs::path file = folder / kScenarioFile;
  replace_text_file(file, new_scenario(given.name, key, robot, "../" + std::string{kScenarioFiles.schema}));
  const fs::path schema = folder.parent_path() / kScenarioFiles.schema;
  if (!fs::exists(fs::symlink_status(schema, ignored))) replace_text_file(schema, schema_text(kScenarioFiles));
  std::cout << fmt::format("{}\nrun it with: armature run {}\n", printable(file.string(), kShowAll),
                           shell_word(given.name));
  return kExitOk;
}

CommandAction declare_new(CLI::App& app) {
  const auto options = std::make_shared<NewOptions>();
  app.add_option("name", options->name, "Name of the new scenario")->required();
  app.add_option("--robot", options->robot, "Name from 'armature list', or a path ending in .toml")
      ->type_name(kRobotValue)
      ->capture_default_str();
  return [options](const CommonOptions& common) { return create(*options, common.search_path()); };
}

}  // namespace

Subcommand new_command() {
  return {.name = "new",
          .order = 11,
          .summary = "Write a first scenario, with comments",
          .details = kNewDetails,
          .declare = declare_new};
}

}  // namespace armature::cosim
