#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "controller/base/words.hpp"
#include "cosim/cli/command/command.hpp"
#include "cosim/cli/options/logic_options.hpp"
#include "cosim/cli/options/output_files.hpp"
#include "cosim/cli/options/output_options.hpp"
#include "cosim/cli/options/value_kinds.hpp"
#include "cosim/cli/options/wave_options.hpp"
#include "cosim/cli/options/word_option.hpp"
#include "cosim/cli/run/check_progress.hpp"
#include "cosim/cli/run/failure_text.hpp"
#include "cosim/cli/run/folder_run.hpp"
#include "cosim/cli/run/interrupt.hpp"
#include "cosim/cli/run/kept_results.hpp"
#include "cosim/cli/run/report_file.hpp"
#include "cosim/cli/run/scenario_run.hpp"
#include "cosim/cli/run/temporary_folder.hpp"
#include "cosim/cli/waves/moment_wave.hpp"
#include "cosim/cpu/make_processor.hpp"
#include "cosim/page/index_page.hpp"
#include "cosim/plot/thumbnail.hpp"
#include "cosim/recording/run_record.hpp"
#include "cosim/report/format/fact_lines.hpp"
#include "cosim/report/format/json/summary_json.hpp"
#include "cosim/report/format/junit.hpp"
#include "cosim/report/format/moment_wave_text.hpp"
#include "cosim/report/format/progress_bar.hpp"
#include "cosim/report/format/summary_text.hpp"
#include "cosim/run/engine_waves.hpp"
#include "cosim/run/parallel.hpp"
#include "cosim/run/run_folder.hpp"
#include "cosim/scenario/files/scenario_loader.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/text_file.hpp"

namespace armature::cosim {
namespace {

constexpr const char* kCheckDetails = R"(Examples:
  armature check
  armature check fig9_joint_move max_rate_4mpps --jobs 2
  armature check scenarios   # a folder of scenarios: all of them
  armature check --junit results.xml
  armature check fig9_joint_move --report-dir reports
  armature check fig9_joint_move --engine both
  armature check fig9_joint_move --wave-on fail --before 2

Without names it checks the scenarios of all your folders that 'armature list' shows. If they have none, it checks those
of the program. It prints one line with the verdict for each scenario. For a failed scenario it prints the reason and a
command that shows it, and keeps trace.csv, log.txt and summary.json in --out/<scenario>. It removes
the results of an earlier check. --report-dir writes index.html, with a row for each scenario and a link to the report
of each failure. The JUnit file names these reports in the property 'report'.
--wave-on keeps a waveform of each failed scenario beside its results, of the moment that 'armature run --help' explains:
failure.fst, or failure.vcd without the program vcd2fst. The scenario is run again up to this moment, on the RTL if the
engine was the model. What passes takes no more time.
Exit code: 0 all passed, 1 one failed, 2 bad input, 3 internal error, 130 interrupted.)";

struct CheckOptions {
  std::vector<std::string> scenarios;  // or folders of scenarios; empty: all of the user, or else all of the program
  int jobs = 1;
  std::filesystem::path out = "out/check";  // results of failed scenarios, each in a folder named after it
  std::optional<std::filesystem::path> junit;
  std::optional<std::filesystem::path> report_dir;
  std::vector<Engine> engines;  // with each of them; empty: with that of the scenario
  std::optional<CpuKind> cpu;   // replaces that of each scenario
  WaveOptions wave;             // of failed scenarios: --wave-on and --before only
  OutputOptions output;
};

constexpr const char* kIndexFile = "index.html";

bool has_passed(const JunitCase& result) {
  return result.failure.empty() && result.error.empty();
}

// What stays of a failure, and where.
struct FailureFiles {
  std::filesystem::path kept;                   // folder
  std::optional<std::filesystem::path> report;  // page
  std::optional<MomentWave> wave;               // in the folder
};

std::string wave_of_failure(const Scenario& scenario, const RunSummary& summary, const FailureFiles& files) {
  if (!files.wave || summary.passed()) return {};
  const WaveFormat format = preferred_format();
  const MomentWaveText wave = moment_wave_text(write_moment_wave(
      {*files.wave, {.file = failure_wave(files.kept, format), .format = format}}, {scenario, summary, interrupted}));
  return fmt::format("{}: {}\n", wave.label, wave.text);
}

// For the index. `folder`: of the results.
std::string picture_of(const std::filesystem::path& folder, const RunSummary& summary) {
  return thumbnail(read_run_record(folder, kTraceFile, summary_json(summary), folder / kSummaryFile));
}

// Runs and judges one scenario. Returns nothing if the run was interrupted. `options`: what the user adds to repeat it.
std::optional<JunitCase> run_and_judge(const Scenario& scenario, const FailureFiles& files,
                                       const std::vector<std::string>& options = {}) {
  const auto& [kept, report, wave] = files;
  JunitCase result;
  result.name = scenario.name;
  result.description = scenario.description;
  try {
    remove_failure_waves(kept);  // of an earlier check, and its other results
    remove_results(kept);
    const TemporaryFolder folder;
    ScenarioRunOptions run;
    run.traces = {{folder.path() / kTraceFile, scenario.trace.every_ticks}};
    run.load = {folder.path() / kLoadFile, scenario.trace.every_ticks};
    run.log = folder.path() / kLogFile;
    run.serial_log = folder.path() / kSerialFile;
    run.compare_golden = {kept / kTraceFile, scenario.trace.every_ticks};
    RunSummary summary = run_scenario(scenario, run);
    if (summary.interrupted) return std::nullopt;
    result.wall_s = summary.host.wall_s;
    result.simulated_s = summary.facts.simulated_s();
    if (report && can_be_shown(summary)) result.picture = picture_of(folder.path(), summary);
    result.output = summary_text(summary);
    result.properties = fact_properties(summary);
    result.failure = failure_reasons(scenario, summary);
    if (!result.failure.empty()) {
      keep_results(folder.path(), summary, kept);
      if (summary.engines_differ_at) {
        write_engine_waves(scenario, *summary.engines_differ_at, kept, {.stop_requested = interrupted});
        summary.engine_waves_written = true;
      }
      const NextCommand next = summary.engine_waves_written
                                   ? compare_engines_command(kept)
                                   : next_command(scenario, summary, default_folder(scenario).string(), options);
      result.failure +=
          fmt::format("results: {}\n{}: {}\n", printable(kept.string(), kShowAll), next.what, next.command);
      result.failure += wave_of_failure(scenario, summary, files);
      if (report && can_be_shown(summary)) {
        write_report(kept, *report);
        result.report = report->string();
        result.failure += "report: " + printable(result.report, kShowAll) + '\n';
      }
    }
  } catch (const std::exception& error) {
    result.error = error.what();
  }
  return result;
}

// The same with each engine, up to the first failure; without engines with that of the scenario.
std::optional<JunitCase> check_scenario(const Scenario& scenario, const CheckOptions& given,
                                        const FailureFiles& files) {
  std::vector<std::string> options;
  if (given.cpu) options = {"--cpu", std::string{word_of(*given.cpu)}};
  if (given.engines.empty()) return run_and_judge(scenario, files, options);
  options.insert(options.end(), {"--engine", std::string{}});
  Scenario chosen = scenario;
  std::optional<JunitCase> result;
  double wall_s = 0;
  for (const Engine engine : given.engines) {
    chosen.engine = engine;
    options.back() = word_of(engine);
    result = run_and_judge(chosen, files, options);
    if (!result) return std::nullopt;
    wall_s += std::exchange(result->wall_s, 0);
    result->wall_s = wall_s;
    if (!result->failure.empty()) result->failure = fmt::format("engine {}: {}", word_of(engine), result->failure);
    if (!has_passed(*result)) return result;
  }
  return result;
}

// The named scenarios. Without names: those of all folders of the user, or those of the program if the user has none.
std::vector<std::filesystem::path> scenarios_to_check(const std::vector<std::string>& named, const SearchPath& path) {
  std::vector<std::filesystem::path> files;
  for (const std::string& name : named) std::ranges::move(find_scenario_files(name, path), std::back_inserter(files));
  for (const bool own : {true, false}) {
    if (files.empty()) files = path.scenarios(own);
  }
  if (files.empty()) throw InputError{"check", "no scenarios (searched: " + path.searched() + ")"};
  return files;
}

void write_index(const std::filesystem::path& folder, const std::vector<JunitCase>& cases) {
  std::vector<IndexRow> rows;
  rows.reserve(cases.size());
  for (const JunitCase& one : cases) {
    rows.push_back({.scenario = one.name,
                    .passed = has_passed(one),
                    .reason = one.failure + one.error,
                    .report = std::filesystem::path{one.report}.filename().string(),
                    .description = one.description,
                    .simulated_s = one.simulated_s,
                    .wall_s = one.wall_s,
                    .picture = one.picture});
  }
  replace_text_file(folder / kIndexFile, index_page(std::move(rows)));
}

void print_verdict(const JunitCase& result) {
  std::cout << with_color(
      fmt::format("{}  {}  ({:.1f} s)\n", has_passed(result) ? "PASS" : "FAIL", printable(result.name), result.wall_s));
  for (const std::string& text : {result.failure, result.error}) {
    std::size_t begin = 0;
    while (begin < text.size()) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      std::cout << "      " << printable(text.substr(begin, end - begin), kShowAll) << '\n';
      begin = end + 1;
    }
  }
  std::cout.flush();
}

// `skipped`: scenarios that were not run, because of an interrupt.
nlohmann::ordered_json verdicts_json(const std::vector<JunitCase>& finished, std::ptrdiff_t passed,
                                     std::size_t skipped) {
  nlohmann::ordered_json document;
  document["passed"] = passed;
  document["failed"] = std::ssize(finished) - passed;
  document["not_run"] = skipped;
  document["scenarios"] = nlohmann::ordered_json::array();
  for (const JunitCase& one : finished) {
    document["scenarios"].push_back({{"scenario", one.name},
                                     {"passed", has_passed(one)},
                                     {"failure", one.failure},
                                     {"error", one.error},
                                     {"report", one.report},
                                     {"wall_s", one.wall_s}});
  }
  return document;
}

std::vector<Scenario> load_scenarios(const CheckOptions& given, const SearchPath& path) {
  std::vector<Scenario> scenarios;
  for (const auto& file : scenarios_to_check(given.scenarios, path)) {
    scenarios.push_back(load_scenario(file, {.search_path = path, .processor = given.cpu}));
    require_processor(scenarios.back().cpu);
  }
  return scenarios;
}

// The report of each scenario, if it fails; nothing without --report-dir. `kept`: the folders of their results.
std::vector<std::optional<std::filesystem::path>> report_files(const CheckOptions& given,
                                                               const std::vector<std::filesystem::path>& kept) {
  std::vector<std::optional<std::filesystem::path>> reports(kept.size());
  if (!given.report_dir) return reports;
  create_folder(*given.report_dir);
  for (std::size_t i = 0; i < reports.size(); ++i) {
    reports[i] = *given.report_dir / (kept[i].filename().string() + ".html");
  }
  return reports;
}

// Checks scenarios, several of them at a time, and prints each verdict. Returns the results of those that were not
// interrupted. Runs share nothing, so the results do not depend on how many run at a time.
std::vector<JunitCase> check_all(const CheckOptions& given, const std::vector<Scenario>& scenarios) {
  const std::vector<std::filesystem::path> kept = result_folders(scenarios, given.out);
  const std::vector<std::optional<std::filesystem::path>> reports = report_files(given, kept);
  const std::optional<MomentWave> wave = moment_wave(given.wave);
  catch_interrupts();
  std::vector<std::optional<JunitCase>> results(scenarios.size());
  std::mutex printing;
  CheckProgress progress{std::cerr, scenarios.size(), !given.output.quiet && stderr_is_terminal()};
  for_each_in_parallel(scenarios.size(), given.jobs, [&](std::size_t i, int) {
    if (interrupted()) return false;
    {
      const std::scoped_lock lock{printing};
      progress.begin(scenarios[i].name);
    }
    results[i] = check_scenario(scenarios[i], given, {.kept = kept[i], .report = reports[i], .wave = wave});
    if (!results[i]) return false;
    const std::scoped_lock lock{printing};
    progress.clear();
    if (!given.output.json && !(given.output.quiet && has_passed(*results[i]))) print_verdict(*results[i]);
    progress.end(scenarios[i].name);
    return true;
  });
  std::vector<JunitCase> finished;
  for (std::optional<JunitCase>& result : results) {
    if (result) finished.push_back(*std::move(result));
  }
  return finished;
}

// `skipped`: as in verdicts_json().
void print_summary(const OutputOptions& output, const std::vector<JunitCase>& finished, std::size_t skipped) {
  const auto passed = std::ranges::count_if(finished, has_passed);
  const auto failed = std::ssize(finished) - passed;
  if (output.json) {
    print_json(verdicts_json(finished, passed, skipped));
  } else if (!output.quiet || failed > 0 || skipped > 0) {
    std::cout << fmt::format("{} passed, {} failed", passed, failed)
              << (skipped > 0 ? fmt::format(", {} not run: interrupted\n", skipped) : "\n");
  }
}

int check_scenarios(const CheckOptions& given, const SearchPath& path) {
  const std::vector<Scenario> scenarios = load_scenarios(given, path);
  if (given.junit) {
    OutputFiles files;
    for (const Scenario& scenario : scenarios) files.reads(scenario);
    files.writes(*given.junit, "--junit", Writing::kInPlace);
  }
  const std::vector<JunitCase> finished = check_all(given, scenarios);
  const std::size_t skipped = scenarios.size() - finished.size();
  if (given.junit) replace_text_file(*given.junit, junit_xml(finished));
  if (given.report_dir) write_index(*given.report_dir, finished);
  print_summary(given.output, finished, skipped);
  if (skipped > 0) return kExitInterrupted;
  return std::ranges::all_of(finished, has_passed) ? kExitOk : kExitCheckFailed;
}

CommandAction declare_check(CLI::App& app) {
  const auto options = std::make_shared<CheckOptions>();
  app.add_option("scenario", options->scenarios,
                 "Scenario folders, folders of scenarios, or names (default: all of yours)")
      ->type_name(kScenarioValue);
  app.add_option("--jobs,-j", options->jobs, "Number of scenarios that run at the same time")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  app.add_option("--out", options->out, "Folder for the results of failed scenarios, each in a subfolder of its name")
      ->type_name(kFolderValue)
      ->capture_default_str();
  app.add_option("--junit", options->junit, "Write the verdicts as JUnit XML to this file")->type_name(kFileValue);
  app.add_option("--report-dir", options->report_dir,
                 "Write index.html to this folder, and the report of each failed scenario")
      ->type_name(kFolderValue);
  add_engines_option(app, options->engines);
  add_word_option(app, "--cpu", options->cpu, without_markdown(kCpuHelp));
  add_moment_options(app, options->wave);
  add_quiet_option(app, options->output);
  add_json_option(app, options->output);
  app.callback([options] { check_wave_options(options->wave, false); });
  return [options](const CommonOptions& common) { return check_scenarios(*options, common.search_path()); };
}

}  // namespace

Subcommand check_command() {
  return {.name = "check",
          .order = 20,
          .summary = "Run scenarios and compare them with their goldens and expectations",
          .details = kCheckDetails,
          .declare = declare_check};
}

}  // namespace armature::cosim
