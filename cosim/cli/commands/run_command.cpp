#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "cosim/cli/command/command.hpp"
#include "cosim/cli/options/logic_options.hpp"
#include "cosim/cli/options/output_files.hpp"
#include "cosim/cli/options/output_options.hpp"
#include "cosim/cli/options/serial_option.hpp"
#include "cosim/cli/options/value_kinds.hpp"
#include "cosim/cli/options/wave_options.hpp"
#include "cosim/cli/options/word_option.hpp"
#include "cosim/cli/run/failure_text.hpp"
#include "cosim/cli/run/folder_run.hpp"
#include "cosim/cli/run/interrupt.hpp"
#include "cosim/cli/run/report_file.hpp"
#include "cosim/cpu/make_processor.hpp"
#include "cosim/golden/golden.hpp"
#include "cosim/report/format/json/summary_json.hpp"
#include "cosim/report/format/moment_wave_text.hpp"
#include "cosim/report/format/summary_text.hpp"
#include "cosim/scenario/files/scenario_loader.hpp"
#include "cosim/text/input_error.hpp"
#include "cosim/text/names.hpp"
#include "cosim/text/printable.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

constexpr const char* kRunDetails = R"(Examples:
  armature run scenarios/fig9_joint_move
  armature run draw_line --report
  armature run fig9_joint_move --vcd fig9.vcd --from 0.1 --to 0.1002
  armature run estop_and_clear --wave-on fault   # writes out/estop_and_clear/failure.fst
  armature run late_core --vcd late.vcd --wave-on fault --before 1
  armature run fig9_joint_move --serial pty:/tmp/arm --pace 1
  armature run pulse_loss_recovered --set controller.feedback=false --out out/open_loop   # exits with 1
  armature run fig9_joint_move --variant paper --out out/paper   # exits with 1: its decoder sees one axis

The run writes trace.csv, summary.json and log.txt to --out, and serial.csv if the serial line is connected. With
--report it also writes report.html, as 'armature report' does; --from and --to are the part of the run that it shows
first. If the run fails, a command is printed that shows it. --json prints summary.json. scenarios/RESULTS.md describes
these files. Only one run at a time can write into a folder. During the run, and after it was killed, the folder has a
file 'unfinished'; 'armature report' and 'armature plot' show what there is.
--wave-on goes back when a moment has passed: its waveform lasts from --before ms before the moment to 1 ms after it, or
to --to. Without --vcd and --fst it is failure.fst in --out, or failure.vcd without the program vcd2fst. 'fault' is the
first fault that the controller reports; 'fail' the failure that ends the run, or the first expectation that fails;
'mismatch' the time from the last row of the golden that is equal to the first one that differs. With --from and --to
only the moments between them count. Going back needs no second run, except with --engine model, whose moment is run
again on the RTL because only the RTL has all signals, and with a program at --serial, which is replayed.
If a result or the file of --vcd is a device, a pipe or a link, the run writes into it. The file of --fst must be a
regular file. No output may be a file that the run reads.
GTKWave shows a waveform with the view tools/arm_soc.gtkw, or arm_soc_paper.gtkw of --variant paper: gtkwave fig9.vcd
tools/arm_soc.gtkw. scenarios/WAVEFORMS.md explains it.
The run is compared with golden.csv, except with --variant, --serial, or --set of other keys than expect. and
trace.every_ticks.
Ctrl-C ends the run and completes its files. The converter of --fst takes up to a second for that.
Exit code: 0 ok, 1 the golden, an expectation or an invariant failed, 2 bad input, 3 internal error,
130 interrupted.)";

struct RunOptions {
  std::string scenario;         // folder, scenario.toml, or a name from `armature list`
  std::optional<fs::path> out;  // default out/<scenario>
  WaveOptions wave;
  bool report = false;
  std::vector<std::string> set;  // key=value
  LogicChoice logic;
  std::optional<CpuKind> cpu;
  std::optional<std::string> serial;  // pty, pty:LINK, tcp:PORT, replay:FILE
  std::optional<double> pace;
  OutputOptions output;
};

// Why the run cannot be compared with the golden: an option changes the run. Empty if it can. A --set of [expect] or of
// trace.every_ticks does not change what is compared.
std::string why_not_comparable(const RunOptions& options) {
  for (const std::string& assignment : options.set) {
    if (assignment.starts_with("expect.") || assignment.starts_with("trace.every_ticks=")) continue;
    return "the run has --set " + printable(assignment);
  }
  if (const auto variant = options.logic.variant) return fmt::format("the run has --variant {}", word_of(*variant));
  if (options.serial) return "the run has --serial " + *options.serial;
  return {};
}

// `--wave-on mismatch` waits for a difference.
void require_golden(const Scenario& scenario, const std::string& why_not_compared) {
  if (!why_not_compared.empty()) {
    throw InputError{"--wave-on", "mismatch needs a run that is compared with its golden: " + why_not_compared};
  }
  std::error_code ignored;
  const fs::path golden = golden_file(scenario);
  if (fs::exists(golden, ignored)) return;
  throw InputError{"--wave-on", "mismatch needs a golden: there is no " + printable(golden.string(), kShowAll)};
}

// The options that a command must have to show this run again.
std::vector<std::string> repeated_options(const RunOptions& given) {
  std::vector<std::string> words;
  for (const std::string& assignment : given.set) words.insert(words.end(), {"--set", assignment});
  if (given.logic.variant) words.insert(words.end(), {"--variant", std::string{word_of(*given.logic.variant)}});
  if (given.logic.engine) words.insert(words.end(), {"--engine", std::string{word_of(*given.logic.engine)}});
  if (given.cpu) words.insert(words.end(), {"--cpu", std::string{word_of(*given.cpu)}});
  if (given.out) words.insert(words.end(), {"--out", given.out->string()});
  return words;
}

int exit_code(const RunSummary& summary) {
  if (summary.interrupted) return kExitInterrupted;
  return summary.passed() ? kExitOk : kExitCheckFailed;
}

int run(const RunOptions& given, const SearchPath& path) {
  Scenario scenario = load_scenario(
      given.scenario, {.search_path = path, .overrides = given.set, .logic = given.logic, .processor = given.cpu});
  require_processor(scenario.cpu);
  const fs::path out = given.out.value_or(default_folder(scenario));
  OutputFiles files;
  files.reads(scenario);
  if (given.serial) {
    if (const auto file = file_of_serial(*given.serial)) files.reads(*file);
  }
  claim_results(files, out);
  if (given.report) files.writes(out / kReportFile, "--report", Writing::kInPlace);
  FolderRunOptions options{.out = out, .wave = wave_request(given.wave, scenario.duration_s, files)};
  options.serial = given.serial;
  options.pace = given.pace;
  options.show_progress = !given.output.quiet;
  options.why_not_compared = why_not_comparable(given);
  if (given.wave.wave_on == WaveReason::kMismatch) require_golden(scenario, options.why_not_compared);
  options.moment_wave = moment_wave_request(given.wave, scenario.duration_s, out, files);
  catch_interrupts();  // from now on there are files to complete
  const RunSummary summary = run_into_folder(scenario, options);
  const bool reported = given.report && can_be_shown(summary);
  if (reported) write_report(out, out / kReportFile, {.page = {.shown = shown_part(given.wave, scenario)}});
  if (given.output.json) {
    std::cout << summary_json(summary);
    return exit_code(summary);
  }
  if (given.output.quiet && summary.passed()) return kExitOk;
  std::cout << with_color(summary_text(summary))
            << fmt::format("results        {}\n", printable(out.string(), kShowAll));
  std::cout << engine_waves_text(summary, out);
  if (reported) std::cout << fmt::format("report         {}\n", printable((out / kReportFile).string(), kShowAll));
  if (given.report && !reported) std::cout << kNoReport;
  if (summary.moment_wave) {
    const MomentWaveText wave = moment_wave_text(*summary.moment_wave);
    std::cout << fmt::format("{:<14} {}\n", wave.label, wave.text);
  }
  const bool shown = given.report && (options.wave || options.moment_wave);
  if (!summary.passed() && !summary.interrupted && !given.serial && !shown) {
    const NextCommand next = summary.engine_waves_written
                                 ? compare_engines_command(out)
                                 : next_command(scenario, summary, out.string(), repeated_options(given));
    std::cout << fmt::format("{:<14} {}\n", next.what, next.command);
  }
  if (options.wave && !summary.wave_written) std::cout << no_wave_text(*options.wave);
  return exit_code(summary);
}

CommandAction declare_run(CLI::App& app) {
  const auto options = std::make_shared<RunOptions>();
  app.add_option("scenario", options->scenario, "Scenario folder, scenario.toml, or a name from 'armature list'")
      ->required()
      ->type_name(kScenarioValue);
  app.add_option("--out", options->out, "Folder for the results (default out/<scenario>)")->type_name(kFolderValue);
  app.add_flag("--report", options->report, "Also write a page that shows the run: report.html in --out");
  add_wave_options(app, options->wave);
  app.add_option("--set", options->set,
                 "Override a key of the scenario: --set controller.feedback=false. May be repeated")
      ->allow_extra_args(false);  // one value for each --set: the next word may be the scenario
  add_logic_options(app, options->logic);
  add_word_option(app, "--cpu", options->cpu, without_markdown(kCpuHelp));
  app.add_option("--serial", options->serial,
                 "Far end of the serial line: pty[:LINK], tcp:PORT (0: any free one), or replay:FILE with the "
                 "serial.csv of a run with another --out");
  app.add_option(
         "--pace", options->pace,
         "Largest simulated time per real time, such as 1 or 0.1 (default: as fast as possible). The results are "
         "the same")
      ->check(CLI::Range(1e-4, 1e4));
  add_quiet_option(app, options->output);
  add_json_option(app, options->output);
  app.callback([options] { check_wave_options(options->wave, options->report); });
  return [options](const CommonOptions& common) { return run(*options, common.search_path()); };
}

}  // namespace

Subcommand run_command() {
  return {.name = "run", .order = 10, .summary = "Run one scenario", .details = kRunDetails, .declare = declare_run};
}

}  // namespace armature::cosim
