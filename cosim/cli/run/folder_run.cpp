#include "cosim/cli/run/folder_run.hpp"

#include <memory>
#include <system_error>

#include "cosim/cli/options/serial_option.hpp"
#include "cosim/cli/run/interrupt.hpp"
#include "cosim/cli/run/scenario_run.hpp"
#include "cosim/report/format/json/summary_json.hpp"
#include "cosim/run/engine_waves.hpp"
#include "cosim/run/run_folder.hpp"
#include "cosim/serial/silent_peer.hpp"
#include "cosim/text/text_file.hpp"

namespace armature::cosim {

namespace fs = std::filesystem;

fs::path default_folder(const Scenario& scenario) {
  return fs::path{"out"} / scenario.name;
}

void claim_results(OutputFiles& files, const fs::path& out) {
  create_folder(out);
  for (const char* name : kResultFiles) files.writes(out / name, "a result in --out", Writing::kInPlace);
  for (const char* name : kEngineWaveFiles) files.writes(out / name, "a result in --out", Writing::kInPlace);
}

RunSummary run_into_folder(Scenario& scenario, const FolderRunOptions& given) {
  const fs::path& out = given.out;
  RunFolder folder{out};
  // The folder must not have what an earlier run wrote and this one may not write.
  for (const char* name : {kSummaryFile, kRtlWaveFile, kModelWaveFile}) {
    std::error_code ignored;
    if (fs::is_regular_file(fs::symlink_status(out / name, ignored))) fs::remove(out / name);
  }
  folder.describe(summary_json(summary_before_run(scenario)));
  ScenarioRunOptions options;
  options.traces = {{out / kTraceFile, scenario.trace.every_ticks}};
  options.load = {out / kLoadFile, scenario.trace.every_ticks};
  options.wave = given.wave;
  options.moment_wave = given.moment_wave;
  options.log = out / kLogFile;
  options.show_progress = given.show_progress;
  options.stop_requested = given.stop_requested;
  options.pace = given.pace;
  std::unique_ptr<HostPort> serial_port;
  if (given.serial) serial_port = connect_serial(*given.serial, scenario);
  prepare_serial_log(out / kSerialFile);
  options.serial_log = out / kSerialFile;
  options.serial_peer = serial_port.get();
  SilentPeer nobody;  // a replay sends what the pendant has sent, so the pendant does not
  if (given.serial && !serial_port && scenario.pendant) options.serial_peer = &nobody;
  const bool compared = given.why_not_compared.empty();
  if (compared) options.compare_golden = {out / kTraceFile, scenario.trace.every_ticks};
  RunSummary summary = run_scenario(scenario, options);
  if (!compared) summary.golden = {GoldenVerdict::kNotCompared, given.why_not_compared, {}};
  if (serial_port) finish_serial(*serial_port, !summary.interrupted);
  if (summary.engines_differ_at && !serial_port) {
    const auto stop = [&given] { return interrupted() || (given.stop_requested && given.stop_requested()); };
    write_engine_waves(scenario, *summary.engines_differ_at, out, {.stop_requested = stop});
    summary.engine_waves_written = true;
  }
  replace_text_file(out / kSummaryFile, summary_json(summary));
  folder.finish();
  return summary;
}

}  // namespace armature::cosim
