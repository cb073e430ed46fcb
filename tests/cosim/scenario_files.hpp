// Scenario files written by tests, read beside the shipped ones.
#pragma once

#include <filesystem>
#include <string>

#include "cosim/scenario/scenario_loader.hpp"

namespace armature::cosim::test {

inline const std::filesystem::path kScenarios = std::filesystem::path{ARMATURE_SOURCE_DIR} / "scenarios";

inline LoadOptions shipped() {
  return {.scenarios_dir = kScenarios, .overrides = {}};
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
