// Reads and checks a robot file (scenarios/robots/<name>.toml).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cosim/scenario/scenario.hpp"
#include "cosim/text/input_error.hpp"

namespace armature::cosim {

// Throws InputError with every problem of the file.
[[nodiscard]] RobotSpec load_robot(const std::filesystem::path& file);

// The same, adding the problems to a list; the result is usable only when none was added.
[[nodiscard]] RobotSpec load_robot(const std::filesystem::path& file, std::vector<Problem>& problems);

// A robot by what the user calls it: a path that ends in `.toml`, or a name of `folder`. Throws InputError.
[[nodiscard]] RobotSpec find_robot(const std::string& name, const std::filesystem::path& folder);

// Names of the robots of a folder (`*.toml` without the ending), sorted. Empty when there is no such folder.
[[nodiscard]] std::vector<std::string> list_robots(const std::filesystem::path& folder);

}  // namespace armature::cosim
