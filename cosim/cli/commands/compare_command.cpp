#include "cosim/trace/compare.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include "cosim/cli/command/command.hpp"
#include "cosim/cli/options/output_files.hpp"
#include "cosim/cli/options/output_options.hpp"
#include "cosim/cli/options/value_kinds.hpp"
#include "cosim/cli/run/report_file.hpp"
#include "cosim/cli/waves/wave_pairs.hpp"
#include "cosim/report/format/json/comparison_json.hpp"
#include "cosim/report/format/json/wave_json.hpp"
#include "cosim/run/run_folder.hpp"
#include "cosim/scenario/files/search_path.hpp"
#include "cosim/text/input_error.hpp"
#include "cosim/text/json.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/shell_text.hpp"
#include "cosim/waves/wave_input.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCompareDetails = R"(Examples:
  armature compare scenarios/fig9_joint_move/golden.csv out/fig9_joint_move/trace.csv
  armature compare scenarios/fig9_joint_move/golden.csv out/fig9_joint_move/trace.csv --report both.html
  armature run fig9_joint_move --out out/rtl --vcd out/rtl/w.vcd --from 0.1 --to 0.1002
  armature run fig9_joint_move --engine model --out out/model --vcd out/model/w.vcd --from 0.1 --to 0.1002
  armature compare out/rtl out/model --views out/views

A folder of results stands for its trace.csv. If both are folders, their waveforms (.vcd, .fst) of one name are compared,
too, or the only one of each. Two waveforms may also be named themselves. The first cycle in which a signal differs is
named, with its tick, the signals and both values. Signals are paired by name, and only the time that both files have is
compared. --views writes a GTKWave view of that moment for each file; --open starts GTKWave with both.
With --report it writes a page that shows both: the second run, and its deviation from the first one. The second trace
must then be in a folder of results.
Integer columns must be equal. Other columns may differ by the tolerance of their unit.
Exit code: 0 equal, 1 different, 2 bad input, 3 internal error.)";

struct CompareOptions {
  fs::path a;
  fs::path b;
  std::optional<fs::path> report;
  std::optional<fs::path> views;
  bool open = false;
  OutputOptions output;
};

// What is compared. Two waveforms have no traces.
struct Compared {
  std::optional<fs::path> trace_a{}, trace_b{};
  WavePairs waves{};
};

fs::path trace_of(const fs::path& given) {
  return fs::is_directory(given) ? given / kTraceFile : given;
}

Compared compared_by(const CompareOptions& given) {
  if (is_wave_name(given.a) != is_wave_name(given.b)) {
    const auto& [wave, other] = is_wave_name(given.a) ? std::pair{given.a, given.b} : std::pair{given.b, given.a};
    throw InputError{other.string(), "expected a waveform (.vcd or .fst), as " + wave.string() + " is one"};
  }
  if (is_wave_name(given.a)) {
    if (given.report) throw InputError{"--report", "needs traces or folders of results, not waveforms"};
    return {.waves = {.pairs = {{given.a, given.b}}}};
  }
  Compared compared{.trace_a = trace_of(given.a), .trace_b = trace_of(given.b)};
  if (fs::is_directory(given.a) && fs::is_directory(given.b)) compared.waves = wave_pairs(given.a, given.b);
  return compared;
}

fs::path folder_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path{"."};
}

void claim_files(const CompareOptions& given, const Compared& compared) {
  OutputFiles files;
  if (compared.trace_a) {
    for (const fs::path& file : {*compared.trace_a, *compared.trace_b, folder_of(*compared.trace_b) / kSummaryFile})
      files.reads(file);
  }
  for (const WavePair& pair : compared.waves.pairs) {
    for (const fs::path& file : {pair.a, pair.b}) files.reads(file);
  }
  if (given.report) files.writes(*given.report, "--report", Writing::kInPlace);
  if (!given.views) return;
  create_folder(*given.views);
  const WavePair views = view_files(*given.views);
  for (const fs::path& file : {views.a, views.b}) files.writes(file, "--views", Writing::kInPlace);
}

Comparison compare_the_traces(const fs::path& a, const fs::path& b) {
  for (const fs::path& file : {a, b}) {
    if (const auto why = why_unfinished(folder_of(file)))
      std::cerr << fmt::format("{}: unfinished: {}\n", printable(file.string(), kShowAll), *why);
  }
  Comparison comparison = compare_traces(a, b);
  // The folder of a golden is that of its scenario.
  const fs::path folder = a.parent_path();
  if (std::error_code ignored; fs::exists(folder / kScenarioFile, ignored)) {
    comparison.scenario = folder.empty() ? "." : folder.string();
  }
  return comparison;
}

// Below the first difference of waveforms: the commands that show it, or the one that writes the views for them.
std::string next_text(const CompareOptions& given, const WaveComparison& waves) {
  if (given.views) return "  to see it:\n" + write_wave_views(waves, *given.views);
  return fmt::format("  to see it: armature compare {} {} --views out/views\n", shell_word(waves.a),
                     shell_word(waves.b));
}

int compare(const CompareOptions& given) {
  const Compared compared = compared_by(given);
  claim_files(given, compared);
  bool equal = true;
  std::string text = compared.waves.why_none;
  Json json, waves_json = Json::array();
  if (compared.trace_a) {
    const Comparison traces = compare_the_traces(*compared.trace_a, *compared.trace_b);
    equal = traces.equal();
    text = traces.report() + text;
    json = comparison_json(traces);
  }
  std::optional<WaveComparison> different;  // the first pair of waveforms that is
  for (const WavePair& pair : compared.waves.pairs) {
    const WaveComparison waves = compare_waves(pair.a, pair.b);
    equal = equal && waves.equal();
    text += waves.report();
    waves_json.push_back(wave_comparison_json(waves));
    if (!waves.first || different) continue;
    different = waves;
    text += next_text(given, waves);
  }
  if (given.output.json) {
    if (compared.trace_a) json["waveforms"] = waves_json;
    print_json(compared.trace_a ? json : waves_json.front());
  } else if (!given.output.quiet || !equal) {
    std::cout << with_color(printable_lines(text));
  }
  if (given.report) write_report(folder_of(*compared.trace_b), *given.report, {.other = *compared.trace_a});
  if (given.open && different) open_wave_views(*different, *given.views);
  return equal ? kExitOk : kExitCheckFailed;
}

CommandAction declare_compare(CLI::App& app) {
  const auto options = std::make_shared<CompareOptions>();
  app.add_option("a", options->a, "Reference: a trace, a waveform, or a folder of results")
      ->required()
      ->type_name(kFileValue);
  app.add_option("b", options->b, "What is compared with it")->required()->type_name(kFileValue);
  app.add_option("--report", options->report, "Write a page that shows both runs to this file")->type_name(kFileValue);
  CLI::Option* views =
      app.add_option("--views", options->views, "Write a GTKWave view of the first difference of each waveform there")
          ->type_name(kFolderValue);
  app.add_flag("--open", options->open, "Start GTKWave with both views")->needs(views);
  add_quiet_option(app, options->output);
  add_json_option(app, options->output);
  return [options](const CommonOptions&) { return compare(*options); };
}

}  // namespace

Subcommand compare_command() {
  return {.name = "compare",
          .order = 30,
          .summary = "Compare two runs: traces and waveforms",
          .details = kCompareDetails,
          .declare = declare_compare};
}

}  // namespace armature::cosim
