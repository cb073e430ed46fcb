// Reads and checks a robot file (scenarios/robots/<name>.toml).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cosim/scenario/files/search_path.hpp"
#include "cosim/scenario/scenario.hpp"
#include "cosim/text/input_error.hpp"

namespace armature::cosim {

// Throws InputError with every problem of the file.
[[nodiscard]] RobotSpec load_robot(const std::filesystem::path& file);

// The same, adding the problems to a list; the result is usable only when none was added.
[[nodiscard]] RobotSpec load_robot(const std::filesystem::path& file, std::vector<Problem>& problems);

// A robot by what the user calls it: a path that ends in `.toml`, or a name on the search path. Throws InputError.
[[nodiscard]] RobotSpec find_robot(const std::string& name, const SearchPath& search_path);

}  // namespace armature::cosim
