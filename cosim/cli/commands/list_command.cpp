#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cosim/cli/command/command.hpp"
#include "cosim/cli/options/output_options.hpp"
#include "cosim/scenario/files/robot_loader.hpp"
#include "cosim/scenario/files/scenario_loader.hpp"
#include "cosim/text/json.hpp"
#include "cosim/text/printable.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

constexpr const char* kListDetails = R"(Examples:
  armature list
  armature list --path scenarios
  armature list --names robots
  armature list --json

Lists the folders in the order in which they are searched (see 'armature --help'). If an earlier folder has the same
name, the entry is shown as shadowed. It can then be used by its path only. --names prints the names alone, each once,
and reads no file.
Exit code: 0 ok, 2 a file cannot be read, or nothing is found.)";

// A name in a folder: its file there, and the file that a search on the whole path finds.
struct Entry {
  std::string name;
  fs::path file;
  fs::path found;
};

class Listing {
 public:
  // `describe` returns the text after the name. A file that it cannot read is reported on standard error. The other
  // files are still listed.
  void print(const std::string& title, const std::vector<Entry>& entries,
             const std::function<std::string(const fs::path&)>& describe) {
    if (entries.empty()) return;
    std::cout << (anything_ ? "\n" : "") << title << '\n';
    anything_ = true;
    for (const Entry& entry : entries)
      std::cout << fmt::format("{:<24} {}\n", printable(entry.name), text_of(entry, describe));
  }

  [[nodiscard]] bool anything() const { return anything_; }
  [[nodiscard]] bool all_read() const { return all_read_; }

 private:
  std::string text_of(const Entry& entry, const std::function<std::string(const fs::path&)>& describe) {
    if (entry.found != entry.file) return "shadowed by " + printable(entry.found.string(), kShowAll);
    try {
      return describe(entry.file);
    } catch (const InputError& error) {
      std::cerr << error.what() << '\n';
      all_read_ = false;
      return "cannot be read";
    }
  }

  bool anything_ = false;
  bool all_read_ = true;
};

// What `describe` adds about the file of an entry. A file that cannot be read has the key `error` instead.
template <class Describe>
Json entry_json(const Entry& entry, bool& all_read, const Describe& describe) {
  Json json = {{"name", entry.name}, {"file", entry.file.string()}};
  json["shadowed_by"] = entry.found == entry.file ? Json(nullptr) : Json(entry.found.string());
  try {
    json.update(describe(entry.file));
  } catch (const InputError& error) {
    json["error"] = error.what();
    all_read = false;
  }
  return json;
}

int list_as_json(const SearchPath& path) {
  Json folders = Json::array();
  bool all_read = true;
  for (const SearchFolder& folder : path.folders()) {
    Json scenarios = Json::array();
    for (const std::string& name : list_scenarios(folder.path)) {
      const Entry entry{name, folder.scenario(name), path.find_scenario(name).value_or("")};
      scenarios.push_back(entry_json(entry, all_read, [&](const fs::path& file) -> Json {
        const Scenario scenario = load_scenario(file, {.search_path = path});
        return {{"robot", scenario.robot_name},
                {"duration_s", scenario.ends_with_program ? Json(nullptr) : Json(scenario.duration_s)},
                {"description", scenario.description}};
      }));
    }
    Json robots = Json::array();
    for (const std::string& name : list_robots(folder.robots())) {
      const Entry entry{name, folder.robot(name), path.find_robot(name).value_or("")};
      robots.push_back(entry_json(entry, all_read, [](const fs::path& file) -> Json {
        const RobotSpec robot = load_robot(file);
        return {{"axes", robot.axis_count},
                {"kinematics", robot.kinematics ? Json(robot.kinematics->family) : Json(nullptr)},
                {"description", robot.description}};
      }));
    }
    folders.push_back({{"path", folder.path.string()},
                       {"origin", folder.origin},
                       {"scenarios", std::move(scenarios)},
                       {"robots", std::move(robots)}});
  }
  print_json({{"folders", std::move(folders)}});
  return all_read ? kExitOk : kExitBadInput;
}

int list(const SearchPath& path) {
  Listing listing;
  for (const SearchFolder& folder : path.folders()) {
    std::vector<Entry> scenarios;
    for (const std::string& name : list_scenarios(folder.path)) {
      scenarios.push_back({name, folder.scenario(name), path.find_scenario(name).value_or("")});
    }
    listing.print(fmt::format("scenarios in {} ({})", printable(folder.path.string(), kShowAll), folder.origin),
                  scenarios, [&](const fs::path& file) {
                    const Scenario scenario = load_scenario(file, {.search_path = path});
                    const std::string duration =
                        scenario.ends_with_program ? "program" : fmt::format("{:>5.2f} s", scenario.duration_s);
                    return fmt::format("{:<20} {}  {}", printable(scenario.robot_name), duration,
                                       printable(scenario.description));
                  });
    std::vector<Entry> robots;
    for (const std::string& name : list_robots(folder.robots())) {
      robots.push_back({name, folder.robot(name), path.find_robot(name).value_or("")});
    }
    listing.print(fmt::format("robots in {} ({})", printable(folder.robots().string(), kShowAll), folder.origin),
                  robots, [](const fs::path& file) {
                    const RobotSpec robot = load_robot(file);
                    return fmt::format("{:<20} {}", robot.kinematics ? robot.kinematics->family : "joint moves only",
                                       printable(robot.description));
                  });
    if (scenarios.empty() && robots.empty()) {
      std::cout << fmt::format("nothing in {} ({})\n", printable(folder.path.string(), kShowAll), folder.origin);
    }
  }
  if (!listing.anything()) {
    throw InputError{"list", "no scenarios and no robots (searched: " + path.searched() +
                                 "); name their folder with --path DIR or in ARMATURE_PATH"};
  }
  return listing.all_read() ? kExitOk : kExitBadInput;
}

// As scripts and the completion of shells need them.
constexpr const char* kScenarioNames = "scenarios";
constexpr const char* kRobotNames = "robots";

int print_names(const std::string& of, const SearchPath& path) {
  for (const std::string& name : of == kRobotNames ? path.robot_names() : path.scenario_names()) {
    std::cout << printable(name, kShowAll) << '\n';
  }
  return kExitOk;
}

CommandAction declare_list(CLI::App& app) {
  const auto names = std::make_shared<std::string>();
  CLI::Option* const only = app.add_option("--names", *names, "Print only the names of these")
                                ->check(CLI::IsMember({kScenarioNames, kRobotNames}));
  const auto output = std::make_shared<OutputOptions>();
  add_json_option(app, *output);
  only->excludes("--json");
  return [names, output](const CommonOptions& common) {
    if (output->json) return list_as_json(common.search_path());
    return names->empty() ? list(common.search_path()) : print_names(*names, common.search_path());
  };
}

}  // namespace

Subcommand list_command() {
  return {.name = "list",
          .order = 80,
          .summary = "List the scenarios and robots",
          .details = kListDetails,
          .declare = declare_list};
}

}  // namespace armature::cosim
