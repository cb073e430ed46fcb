#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "cosim/cli/command/command.hpp"
#include "cosim/cli/options/output_files.hpp"
#include "cosim/cli/options/output_options.hpp"
#include "cosim/cli/options/value_kinds.hpp"
#include "cosim/cli/run/failure_text.hpp"
#include "cosim/cli/run/file_changes.hpp"
#include "cosim/cli/run/folder_run.hpp"
#include "cosim/cli/run/interrupt.hpp"
#include "cosim/cli/run/report_file.hpp"
#include "cosim/golden/golden.hpp"
#include "cosim/report/format/summary_text.hpp"
#include "cosim/scenario/files/scenario_loader.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/text_file.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

constexpr const char* kWatchDetails = R"(Examples:
  armature watch fig9_joint_move
  armature watch scenarios/draw_line --set controller.feedback=false --out out/open_loop

Runs the scenario and writes its report, report.html in --out. Whenever the scenario, its golden or another file that it
reads changes, it runs again, also in the middle of a run. A report that is open in a browser reloads itself and keeps the
shown part of the run. If a file is wrong, the report shows the error, and the next change runs again.
The report finds reload.js beside it. Without this file it is a page as 'armature report' writes it.
Ctrl-C ends it.
Exit code: 2 there is no such scenario, 3 internal error, 130 interrupted.)";

struct WatchOptions {
  std::string scenario;
  std::optional<fs::path> out;
  std::vector<std::string> set;
};

class Watch {
 public:
  Watch(const WatchOptions& given, const SearchPath& path) : given_{given}, path_{path} {
    file_ = find_scenario_files(given.scenario, path).front();
    files_.add(file_);
  }

  void run_until_interrupted() {
    while (!interrupted()) {
      files_.restart();
      run_once();
      while (!interrupted() && !files_.changed()) std::this_thread::sleep_for(FileChanges::kPause);
      while (!interrupted() && !files_.settled()) {
      }
    }
  }

 private:
  void run_once() {
    try {
      Scenario scenario = load();
      out_ = given_.out.value_or(default_folder(scenario));
      OutputFiles outputs;
      outputs.reads(scenario);
      claim_results(outputs, out_);
      for (const char* name : {kReportFile, kReloadFile}) outputs.writes(out_ / name, "the report", Writing::kInPlace);
      FolderRunOptions options{.out = out_, .stop_requested = [this] { return files_.changed(); }};
      if (!given_.set.empty()) options.why_not_compared = "the run has --set";
      const RunSummary summary = run_into_folder(scenario, options);
      if (summary.interrupted) return;
      std::string report = kNoReport;
      if (can_be_shown(summary)) {
        digest_ = write_reloading_report(out_, out_ / kReportFile);
        report = fmt::format("report         {}\n", printable((out_ / kReportFile).string(), kShowAll));
      }
      std::cout << with_color(verdict_line(summary)) << printable_lines(failure_reasons(scenario, summary))
                << engine_waves_text(summary, out_) << report << std::flush;
    } catch (const InputError& error) {
      for (const Problem& problem : error.problems()) files_.add(problem.file);
      std::cerr << error.what() << '\n';
      if (!digest_.empty()) replace_text_file(out_ / kReloadFile, reload_script(digest_, error.what()));
    }
  }

  // A file that is read for the first time counts from before it is read: it is loaded a second time.
  Scenario load() {
    for (const bool again : {false, true}) {
      Scenario scenario = load_scenario(file_, {.search_path = path_, .overrides = given_.set});
      if (again) return scenario;
      for (const InputFile& source : scenario.sources) files_.add(source.file);
      files_.add(golden_file(scenario));
    }
    return {};
  }

  const WatchOptions& given_;
  const SearchPath& path_;
  fs::path file_;
  FileChanges files_;
  fs::path out_;        // of the latest run
  std::string digest_;  // of the report that is there; empty: none
};

CommandAction declare_watch(CLI::App& app) {
  const auto options = std::make_shared<WatchOptions>();
  app.add_option("scenario", options->scenario, "Scenario folder, scenario.toml, or a name from 'armature list'")
      ->required()
      ->type_name(kScenarioValue);
  app.add_option("--out", options->out, "Folder for the results (default out/<scenario>)")->type_name(kFolderValue);
  app.add_option("--set", options->set, "Override a key of the scenario, as in 'armature run'. May be repeated")
      ->allow_extra_args(false);
  return [options](const CommonOptions& common) {
    const SearchPath path = common.search_path();
    Watch watch{*options, path};
    catch_interrupts();
    watch.run_until_interrupted();
    return kExitInterrupted;
  };
}

}  // namespace

Subcommand watch_command() {
  return {.name = "watch",
          .order = 12,
          .summary = "Run a scenario again whenever its files change",
          .details = kWatchDetails,
          .declare = declare_watch};
}

}  // namespace armature::cosim
