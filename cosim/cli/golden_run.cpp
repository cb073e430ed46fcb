#include "cosim/cli/golden_run.hpp"

#include <cerrno>
#include <cstdlib>
#include <system_error>

#include "cosim/trace/golden.hpp"

namespace armature::cosim {

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "armature-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::system_error(errno, std::generic_category(), name);
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

RunSummary run_for_golden(const Scenario& scenario, const std::filesystem::path& trace, bool show_progress) {
  ScenarioRunOptions options;
  options.traces = {{trace, kGoldenEveryTicks}};
  options.show_progress = show_progress;
  return run_scenario(scenario, options);
}

}  // namespace armature::cosim
