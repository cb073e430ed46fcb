#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include "cosim/cli/command/command.hpp"
#include "cosim/cli/options/output_files.hpp"
#include "cosim/cli/options/output_options.hpp"
#include "cosim/cli/options/value_kinds.hpp"
#include "cosim/cli/run/interrupt.hpp"
#include "cosim/cli/run/scenario_run.hpp"
#include "cosim/cli/run/temporary_folder.hpp"
#include "cosim/golden/golden.hpp"
#include "cosim/report/format/summary_text.hpp"
#include "cosim/scenario/files/scenario_loader.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/text_file.hpp"

namespace armature::cosim {
namespace {

constexpr const char* kBlessDetails = R"(Example:
  armature bless fig9_joint_move

Runs the scenario, writes golden.csv and the hash in scenario.toml, and prints what changed. It refuses to do so if the
run does not pass.
Exit code: 0 blessed, 1 refused, 2 bad input, 3 internal error, 130 interrupted.)";

int bless(const std::string& name, const OutputOptions& output, const SearchPath& path) {
  const Scenario scenario = load_scenario(name, {.search_path = path});
  OutputFiles files;
  files.reads(scenario.robot.source.file);
  files.writes(scenario.file, "the digest of the golden", Writing::kInPlace);
  const auto golden = std::filesystem::path{scenario.directory} / kGoldenFile;
  require_regular_file(golden);  // the command also reads it
  files.writes(golden, "the golden", Writing::kInPlace);
  catch_interrupts();
  const TemporaryFolder folder;
  const auto trace = folder.path() / "trace.csv";
  ScenarioRunOptions options;
  options.traces = {{trace, kGoldenEveryTicks}};
  options.show_progress = !output.quiet;
  const RunSummary summary = run_scenario(scenario, options);
  if (summary.interrupted) return kExitInterrupted;
  if (!summary.passed()) {
    std::cout << with_color(summary_text(summary))
              << "not blessed: the run itself did not pass; the golden is unchanged\n";
    return kExitCheckFailed;
  }
  const std::string changes = bless_golden(scenario, trace, summary.facts.sha256);
  if (!output.quiet) std::cout << printable_lines(changes);
  return kExitOk;
}

CommandAction declare_bless(CLI::App& app) {
  const auto scenario = std::make_shared<std::string>();
  app.add_option("scenario", *scenario, "Scenario folder or name")->required()->type_name(kScenarioValue);
  const auto output = std::make_shared<OutputOptions>();
  add_quiet_option(app, *output);
  return [scenario, output](const CommonOptions& common) { return bless(*scenario, *output, common.search_path()); };
}

}  // namespace

Subcommand bless_command() {
  return {.name = "bless",
          .order = 40,
          .summary = "Make the present result of a scenario its golden",
          .details = kBlessDetails,
          .declare = declare_bless};
}

}  // namespace armature::cosim
