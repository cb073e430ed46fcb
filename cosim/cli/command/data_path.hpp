// The search path of this process for scenarios and robots. It depends on the command line, the environment, the
// current folder and the path of the program.
#pragma once

#include <string>
#include <vector>

#include "cosim/scenario/files/search_path.hpp"

namespace armature::cosim {

inline constexpr const char* kPathVariable = "ARMATURE_PATH";

// In this order: `named`, the folders of --path; those of ARMATURE_PATH, separated by colons; the folder `scenarios` of
// the current folder or of the nearest above it; the current folder when it has a folder `robots`; what is installed
// with the program, or the checkout that contains the program. Throws InputError when a folder of the first two is
// missing.
[[nodiscard]] SearchPath data_path(const std::vector<std::string>& named);

}  // namespace armature::cosim
