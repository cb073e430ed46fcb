#include <fmt/format.h>

#include <fstream>
#include <iostream>

#include "cosim/cli/commands.hpp"
#include "cosim/cli/scenario_folder.hpp"
#include "cosim/cli/scenario_run.hpp"
#include "cosim/kernel/clock.hpp"
#include "cosim/scenario/scenario_loader.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

// Finds out before the run, not after it, that results cannot be written.
void require_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError(folder.string(), "cannot create this folder: " + error.message());
}

void require_writable(const fs::path& file) {
  if (!std::ofstream{file}) throw InputError(file.string(), "cannot write this file");
}

std::optional<WaveRequest> wave_request(const RunArguments& arguments) {
  const auto& file = arguments.vcd ? arguments.vcd : arguments.fst;
  if (!file) return std::nullopt;
  require_writable(*file);
  WaveRequest request;
  request.file = *file;
  request.format = arguments.vcd ? WaveFormat::kVcd : WaveFormat::kFst;
  if (arguments.from_s) request.from = to_cycles(*arguments.from_s);
  if (arguments.to_s) request.to = to_cycles(*arguments.to_s);
  request.on_fault = arguments.wave_on_fault;
  return request;
}

}  // namespace

int run_command(const RunArguments& arguments) {
  const Scenario scenario =
      load_scenario(arguments.scenario, {.scenarios_dir = scenario_folder(), .overrides = arguments.set});
  const fs::path out = arguments.out.value_or(fs::path{"out"} / scenario.name);
  require_folder(out);
  for (const char* name : {"trace.csv", "summary.json", "log.txt"}) require_writable(out / name);

  ScenarioRunOptions options;
  options.traces = {{out / "trace.csv", scenario.trace.every_ticks}};
  options.wave = wave_request(arguments);
  options.log = out / "log.txt";
  options.show_progress = true;
  const RunSummary summary = run_scenario(scenario, options);

  std::ofstream{out / "summary.json"} << summary_json(summary);
  std::cout << summary_text(summary) << fmt::format("results        {}\n", out.string());
  if (summary.interrupted) return kExitInterrupted;
  return summary.passed() ? kExitOk : kExitCheckFailed;
}

}  // namespace armature::cosim
