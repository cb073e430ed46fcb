#include "cosim/iss/debug/debug_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "cosim/cli/options/logic_options.hpp"
#include "cosim/cli/options/output_files.hpp"
#include "cosim/cli/options/output_options.hpp"
#include "cosim/cli/options/value_kinds.hpp"
#include "cosim/cli/run/interrupt.hpp"
#include "cosim/iss/debug/debug_server.hpp"
#include "cosim/net/stream_socket.hpp"
#include "cosim/scenario/files/scenario_loader.hpp"
#include "cosim/text/input_error.hpp"

namespace armature::cosim::iss {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDetails = R"(Example, in two terminals:
  armature-iss debug fig9_joint_move --port 3333                                    # waits for gdb
  gdb-multiarch build/iss/board/controller.elf -ex 'target remote :3333'            # in the other one

The run executes the firmware (--cpu a9) and stands before its first instruction until gdb continues it. Threads 1 and 2
are the cores 0 and 1. Simulated time stands still while the run does, so results do not depend on the debugger. gdb may
read the memory of the firmware and, word by word, the registers of the logic; reading them has no effect on the run,
not even where a core's read would have one. It may write registers of a core that executes or waits for an interrupt,
and memory except the code. 'detach' lets the run continue to its end, 'kill' ends it. A gdb that goes away without
either leaves the run where it is, for the next one. 'monitor help' lists what else there is.
The run goes back with 'reverse-stepi', 'reverse-continue' and the like: processor, logic and plant together.
The port can be reached from this machine only. Every user of the machine can connect to it.
Ctrl-C ends the run. At its end the summary is printed, as 'armature-iss run' does; no results are written.
Exit code: that of 'run'; 130 when gdb or Ctrl-C has ended it.)";

struct DebugOptions {
  std::string scenario;
  std::uint16_t port = 0;
  std::optional<fs::path> vcd;
  std::vector<std::string> set;
  LogicChoice logic;
};

LoopbackPort listen_on(std::uint16_t port) try {
  constexpr int kBacklog = 4;
  return listen_on_loopback(port, kBacklog);
} catch (const std::system_error& error) {
  throw InputError{fmt::format("--port {}", port), error.what()};
}

int debug(const DebugOptions& given, const SearchPath& path) {
  const Scenario scenario = load_scenario(
      given.scenario, {.search_path = path, .overrides = given.set, .logic = given.logic, .processor = CpuKind::kA9});
  OutputFiles files;
  files.reads(scenario);
  if (given.vcd) files.writes(*given.vcd, "--vcd", Writing::kInPlace);
  const LoopbackPort port = listen_on(given.port);
  catch_interrupts();
  RemoteRun run{scenario, {.wave = given.vcd, .compare_golden = given.set.empty() && !given.logic.variant}};
  std::cout << fmt::format("listening on tcp:{}\n", port.port) << std::flush;
  const DebugResult result = serve_debugger(port, run, interrupted);
  if (result.end == DebugEnd::kKilled) std::cout << "gdb has ended the run\n";
  if (result.end != DebugEnd::kRunEnded) return kExitInterrupted;
  if (result.stop.why == Stop::Why::kFailed) {
    std::cerr << "armature-iss: " << run.end_text();
    return kExitInternal;
  }
  std::cout << with_color(run.end_text());
  return result.stop.exit_code;
}

CommandAction declare(CLI::App& app) {
  const auto options = std::make_shared<DebugOptions>();
  app.add_option("scenario", options->scenario, "Scenario folder, scenario.toml, or a name from 'armature list'")
      ->required()
      ->type_name(kScenarioValue);
  app.add_option("--port", options->port, "TCP port for gdb (default: any free one, which is printed)");
  app.add_option("--vcd", options->vcd, "File of the waveform that 'monitor wave on' writes (default: none)")
      ->type_name(kFileValue);
  app.add_option("--set", options->set, "Replace a value of the scenario, as KEY=VALUE; may be repeated")
      ->allow_extra_args(false);
  add_logic_options(app, options->logic);
  return [options](const CommonOptions& common) { return debug(*options, common.search_path()); };
}

}  // namespace

Subcommand debug_command() {
  return {.name = "debug",
          .order = 75,
          .summary = "Run the firmware of a scenario under gdb",
          .details = kDetails,
          .declare = declare};
}

}  // namespace armature::cosim::iss
