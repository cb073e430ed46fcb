// Scenario files written by tests, read beside the shipped ones.
#pragma once

#include <filesystem>
#include <string>

#include "cosim/scenario/files/scenario_loader.hpp"
#include "tests/cosim/support/temp_folder.hpp"

namespace armature::cosim::test {

inline const std::filesystem::path kScenarios = std::filesystem::path{ARMATURE_SOURCE_DIR} / "scenarios";

inline LoadOptions shipped() {
  return {.search_path = kScenarios, .overrides = {}};
}

// A scenario of one second that has these tables besides the keys that every scenario has.
inline Scenario scenario_with(const std::string& tables, const std::string& robot = "vo2021_6r") {
  const TempFolder folder;
  const std::string keys = "description = \"test\"\nrobot = \"" + robot + "\"\nduration_s = 1\n";
  return load_scenario(folder.write("s/scenario.toml", keys + tables), shipped());
}

// The message of a scenario that cannot be loaded; empty when it can.
inline std::string error_of(const std::filesystem::path& where, const LoadOptions& options = shipped()) {
  try {
    (void)load_scenario(where, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace armature::cosim::test
