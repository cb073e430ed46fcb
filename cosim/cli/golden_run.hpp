// A run whose trace is compared with, or becomes, the scenario's golden.
#pragma once

#include <filesystem>
#include <string>

#include "cosim/cli/scenario_run.hpp"

namespace armature::cosim {

// A folder of its own that disappears with the object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

// Runs the scenario and writes its trace at the rate of goldens to `trace`.
[[nodiscard]] RunSummary run_for_golden(const Scenario& scenario, const std::filesystem::path& trace,
                                        bool show_progress);

}  // namespace armature::cosim
