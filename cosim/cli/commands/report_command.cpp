#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

#include "cosim/cli/command/command.hpp"
#include "cosim/cli/options/output_files.hpp"
#include "cosim/cli/options/value_kinds.hpp"
#include "cosim/cli/run/followed_report.hpp"
#include "cosim/cli/run/interrupt.hpp"
#include "cosim/cli/run/recorded_run.hpp"
#include "cosim/cli/run/report_file.hpp"
#include "cosim/text/printable.hpp"

namespace armature::cosim {
namespace {

constexpr const char* kReportDetails = R"(Examples:
  armature run draw_line && armature report out/draw_line
  armature report out/draw_line -o line.html

Writes one HTML page that shows a run: curves of the joints, states and events, the arm with the path of its tool, and
the expectations with their margins. Any browser opens it, also without a network. If the run was compared with its
golden, the page shows the difference.
--follow is for a run that another process is still writing: the page is written again while the run continues, and a page
that is open in a browser reloads itself. It ends with the run.
Exit code: 0 ok, 2 bad input, 3 internal error, 130 interrupted.)";

struct ReportOptions {
  std::filesystem::path folder;
  std::optional<std::filesystem::path> out;  // default FOLDER/report.html
  bool follow = false;
};

int report(const ReportOptions& given) {
  const std::filesystem::path out = given.out.value_or(given.folder / kReportFile);
  OutputFiles files;
  reads_results(files, given.folder);
  files.writes(out, "-o", Writing::kInPlace);
  if (given.follow) {
    files.writes(out.parent_path() / kReloadFile, "the script of --follow", Writing::kInPlace);
    catch_interrupts();
    if (!follow_report(given.folder, out)) return kExitInterrupted;
  } else {
    write_report(given.folder, out);
  }
  std::cout << printable(out.string(), kShowAll) << '\n';
  return kExitOk;
}

CommandAction declare_report(CLI::App& app) {
  const auto options = std::make_shared<ReportOptions>();
  app.add_option("folder", options->folder, "Folder with the results of a run")->required()->type_name(kFolderValue);
  app.add_option("-o,--output", options->out, "The page (default FOLDER/report.html)")->type_name(kFileValue);
  app.add_flag("--follow", options->follow, "Write the page again and again while the run continues");
  return [options](const CommonOptions&) { return report(*options); };
}

}  // namespace

Subcommand report_command() {
  return {.name = "report",
          .order = 32,
          .summary = "Write a page that shows a run",
          .details = kReportDetails,
          .declare = declare_report};
}

}  // namespace armature::cosim
