#include <iostream>

#include "cosim/cli/commands.hpp"
#include "cosim/cli/golden_run.hpp"
#include "cosim/cli/interrupt.hpp"
#include "cosim/cli/output_files.hpp"
#include "cosim/cli/scenario_run.hpp"
#include "cosim/report/format/summary_text.hpp"
#include "cosim/scenario/scenario_loader.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/text_file.hpp"
#include "cosim/trace/golden.hpp"

namespace armature::cosim {

int bless_command(const BlessArguments& arguments, const SearchPath& path) {
  const Scenario scenario = load_scenario(arguments.scenario, {.search_path = path});
  OutputFiles files;
  files.reads(scenario.robot.source.file);
  files.writes(scenario.file, "the digest of the golden", Writing::kInPlace);
  const auto golden = std::filesystem::path{scenario.directory} / kGoldenFile;
  require_regular_file(golden);  // it is read, too
  files.writes(golden, "the golden", Writing::kInPlace);
  catch_interrupts();
  const TemporaryFolder folder;
  const auto trace = folder.path() / "trace.csv";
  ScenarioRunOptions options;
  options.traces = {{trace, kGoldenEveryTicks}};
  options.show_progress = true;
  const RunSummary summary = run_scenario(scenario, options);
  if (summary.interrupted) return kExitInterrupted;
  if (!summary.passed()) {
    std::cout << summary_text(summary) << "not blessed: the run itself did not pass; the golden is unchanged\n";
    return kExitCheckFailed;
  }
  std::cout << printable_lines(bless_golden(scenario, trace, summary.sha256));
  return kExitOk;
}

}  // namespace armature::cosim
