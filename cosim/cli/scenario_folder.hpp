// Where the scenarios are when the user gives a bare name.
#pragma once

#include <filesystem>

namespace armature::cosim {

// The folder `scenarios` of the current folder or the nearest one above it, else of the checkout that this program was
// built in. "scenarios" when there is none.
[[nodiscard]] std::filesystem::path scenario_folder();

}  // namespace armature::cosim
