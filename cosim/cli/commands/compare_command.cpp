#include "cosim/cli/options/output_options.hpp"
#include "cosim/cli/options/value_kinds.hpp"
#include "cosim/trace/compare.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <system_error>

#include "cosim/cli/command/command.hpp"
#include "cosim/cli/options/output_files.hpp"
#include "cosim/cli/run/report_file.hpp"
#include "cosim/report/format/json/comparison_json.hpp"
#include "cosim/run/run_folder.hpp"
#include "cosim/scenario/files/search_path.hpp"
#include "cosim/text/printable.hpp"

namespace armature::cosim {
namespace {

constexpr const char* kCompareDetails = R"(Examples:
  armature compare scenarios/fig9_joint_move/golden.csv out/fig9_joint_move/trace.csv
  armature compare scenarios/fig9_joint_move/golden.csv out/fig9_joint_move/trace.csv --report both.html

With --report it writes a page that shows both: the second run, and its deviation from the first one. The second trace
must then be in a folder of results.
Integer columns must be equal. Other columns may differ by the tolerance of their unit.
Exit code: 0 equal, 1 different, 2 bad input, 3 internal error.)";

struct CompareOptions {
  std::filesystem::path a;
  std::filesystem::path b;
  std::optional<std::filesystem::path> report;
  OutputOptions output;
};

int compare(const CompareOptions& given) {
  for (const std::filesystem::path& file : {given.a, given.b}) {
    const auto folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path{"."};
    if (const auto why = why_unfinished(folder))
      std::cerr << fmt::format("{}: unfinished: {}\n", printable(file.string(), kShowAll), *why);
  }
  const auto folder_b = given.b.has_parent_path() ? given.b.parent_path() : std::filesystem::path{"."};
  if (given.report) {
    OutputFiles files;
    for (const std::filesystem::path& file : {given.a, given.b, folder_b / kSummaryFile}) files.reads(file);
    files.writes(*given.report, "--report", Writing::kInPlace);
  }
  Comparison comparison = compare_traces(given.a, given.b);
  // The folder of a golden is that of its scenario.
  const std::filesystem::path folder = given.a.parent_path();
  if (std::error_code ignored; std::filesystem::exists(folder / kScenarioFile, ignored)) {
    comparison.scenario = folder.empty() ? "." : folder.string();
  }
  if (given.output.json) {
    print_json(comparison_json(comparison));
  } else if (!given.output.quiet || !comparison.equal()) {
    std::cout << with_color(printable_lines(comparison.report()));
  }
  if (given.report) write_report(folder_b, *given.report, {.other = given.a});
  return comparison.equal() ? kExitOk : kExitCheckFailed;
}

CommandAction declare_compare(CLI::App& app) {
  const auto options = std::make_shared<CompareOptions>();
  app.add_option("a", options->a, "Reference trace")->required()->type_name(kFileValue);
  app.add_option("b", options->b, "Trace to compare with it")->required()->type_name(kFileValue);
  app.add_option("--report", options->report, "Write a page that shows both runs to this file")->type_name(kFileValue);
  add_quiet_option(app, options->output);
  add_json_option(app, options->output);
  return [options](const CommonOptions&) { return compare(*options); };
}

}  // namespace

Subcommand compare_command() {
  return {.name = "compare",
          .order = 30,
          .summary = "Compare two trace files",
          .details = kCompareDetails,
          .declare = declare_compare};
}

}  // namespace armature::cosim
