#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "cosim/cli/commands.hpp"
#include "cosim/cli/golden_run.hpp"
#include "cosim/cli/interrupt.hpp"
#include "cosim/cli/output_files.hpp"
#include "cosim/cli/run_folder.hpp"
#include "cosim/cli/scenario_run.hpp"
#include "cosim/cli/serial_option.hpp"
#include "cosim/fabric/fst_converter.hpp"
#include "cosim/report/format/summary_json.hpp"
#include "cosim/report/format/summary_text.hpp"
#include "cosim/scenario/scenario_loader.hpp"
#include "cosim/text/number_text.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/text_file.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

// `files` knows the others of this run.
std::optional<WaveRequest> wave_request(const RunArguments& arguments, double duration_s, OutputFiles& files) {
  const auto& file = arguments.vcd ? arguments.vcd : arguments.fst;
  if (!file) return std::nullopt;
  if (arguments.vcd) {
    files.writes(*file, "--vcd", Writing::kInPlace);
  } else {
    files.writes(*file, "--fst", Writing::kReplaced);
    files.writes(file->string() + ".hier", "--fst", Writing::kReplaced);  // the converter's scratch file
  }
  if (arguments.fst && !fst_converter_available()) {
    throw InputError("--fst", "needs the program vcd2fst (Debian package gtkwave), which is not installed");
  }
  if (arguments.from_s && *arguments.from_s >= duration_s) {
    throw InputError("--from", "must be earlier than the end of the run, duration_s = " + number_text(duration_s));
  }
  WaveRequest request;
  request.file = *file;
  request.format = arguments.vcd ? WaveFormat::kVcd : WaveFormat::kFst;
  if (arguments.from_s) request.from = to_cycles(*arguments.from_s);
  if (arguments.to_s) request.to = to_cycles(std::min(*arguments.to_s, duration_s));
  request.on_fault = arguments.wave_on_fault;
  return request;
}

// Why the file that was asked for is not there.
std::string no_wave_text(const WaveRequest& wave) {
  const std::string from = wave.from ? " at or after --from" : "";
  return fmt::format("no waveform    {} is not written: {}\n", printable(wave.file.string(), kShowAll),
                     wave.on_fault ? "there was no fault" + from : "the run ended before --from");
}

}  // namespace

int run_command(const RunArguments& arguments, const SearchPath& path) {
  Scenario scenario =
      load_scenario(arguments.scenario, {.search_path = path, .overrides = arguments.set, .fabric = arguments.fabric});
  const fs::path out = arguments.out.value_or(fs::path{"out"} / scenario.name);
  create_folder(out);
  OutputFiles files;
  files.reads(scenario);
  if (arguments.serial) {
    if (const auto file = file_of_serial(*arguments.serial)) files.reads(*file);
  }
  for (const char* name : kResultFiles) {
    files.writes(out / name, "a result in --out", Writing::kInPlace);
  }
  ScenarioRunOptions options;
  options.wave = wave_request(arguments, scenario.duration_s, files);
  catch_interrupts();  // from here on there is something to put in order
  RunFolder folder{out};
  // Results of an earlier run must not be taken for those of this one if it ends early.
  std::error_code ignored;
  if (fs::is_regular_file(fs::symlink_status(out / kSummaryFile, ignored))) fs::remove(out / kSummaryFile);
  options.traces = {{out / kTraceFile, scenario.trace.every_ticks}};
  options.log = out / kLogFile;
  options.show_progress = true;
  std::unique_ptr<HostPort> serial_port;
  if (arguments.serial) serial_port = connect_serial(*arguments.serial, scenario);
  prepare_serial_log(out / kSerialFile);
  options.serial_log = out / kSerialFile;
  options.serial_peer = serial_port.get();
  const std::string not_compared = why_not_comparable(arguments);
  if (not_compared.empty()) options.compare_golden = {out / kTraceFile, scenario.trace.every_ticks};
  RunSummary summary = run_scenario(scenario, options);
  if (!not_compared.empty()) summary.golden = {GoldenVerdict::kNotCompared, not_compared, {}, {}};
  if (serial_port) finish_serial(*serial_port, !summary.interrupted);

  replace_text_file(out / kSummaryFile, summary_json(summary));
  folder.finish();
  std::cout << summary_text(summary) << fmt::format("results        {}\n", printable(out.string(), kShowAll));
  if (options.wave && !summary.wave_written) std::cout << no_wave_text(*options.wave);
  if (summary.interrupted) return kExitInterrupted;
  return summary.passed() ? kExitOk : kExitCheckFailed;
}

}  // namespace armature::cosim
