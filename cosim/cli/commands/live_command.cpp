#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cosim/cli/command/command.hpp"
#include "cosim/cli/live/live_run.hpp"
#include "cosim/cli/options/logic_options.hpp"
#include "cosim/cli/options/output_files.hpp"
#include "cosim/cli/options/serial_option.hpp"
#include "cosim/cli/options/value_kinds.hpp"
#include "cosim/cli/run/folder_run.hpp"
#include "cosim/cli/run/interrupt.hpp"
#include "cosim/cli/texts/new_scenario.hpp"
#include "cosim/net/web_admission.hpp"
#include "cosim/run/run_folder.hpp"
#include "cosim/scenario/files/robot_loader.hpp"
#include "cosim/scenario/files/scenario_loader.hpp"
#include "cosim/text/number_text.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/shell_text.hpp"
#include "cosim/text/text_file.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLiveDetails = R"(Examples:
  armature live pendant_jog --pace 2000 --for 1   # prints an address; without --for it ends with Ctrl-C
  armature live arm_5r_pick_place --out five_axes --for 1
  armature live job_pick_and_place --engine rtl --for 0.01
  armature live --robot hu2012_5r --for 0.01

Open the printed address in a browser. The page shows the arm as simulated time passes, and is a teach pendant: it
switches the drives, jogs joints and the tool while a button is held down, moves to taught points, loads and runs
programs, and has an emergency stop. A click changes an input of the tool, holds a switch or the line of the emergency
stop, or causes a fault of any kind that a scenario can have. Its sliders move a shadow of the arm, by joint angles or by the place of the hand.
Everything that the page commands is a frame of the pendant's protocol on the simulated serial line.
A scenario with [pendant] runs as it is; the page takes the place of the steps. Any other scenario gets the pendant
with the profile 'extended' and loses its moves: the drives are off until the page switches them on.
With --robot no scenario is needed. One in which this robot only waits is written to the folder of --out.
The simulation keeps the pace of real time if the machine is fast enough; the page shows the factor. The engine is the
model, whatever the scenario says; --engine chooses another one.
The time bar of the page goes back to any moment of the session. From there it can go on: what came after the moment is
gone then, also in serial.csv and log.txt.
When the page is closed or frozen, the arm stops. Only this machine can connect; the address has a random token, without
which nothing is served. One page at a time has the arm.
--out gets serial.csv and log.txt. The last lines that the command prints repeat the session without the page, from
serial.csv, with the same bytes.
Exit code: 0 the time of --for is over, 1 the run failed, 2 bad input, 3 internal error, 130 interrupted.)";

struct LiveOptions {
  std::string scenario;
  std::string robot;  // instead of a scenario
  std::optional<fs::path> out;
  std::uint16_t port = 0;
  double pace = 1;
  double for_s = 86'400;
  std::vector<std::string> set;
  LogicChoice logic;
};

struct LiveScenario {
  Scenario scenario;
  std::vector<std::string> overrides;  // --set of a run that repeats the session, without the duration
};

// Writes the scenario of --robot, and has the session use it.
void make_scenario(LiveOptions& given, const SearchPath& path) {
  static_cast<void>(find_robot(given.robot, path));
  const std::string name = fs::path{given.robot}.stem().string();
  if (!given.out) given.out = fs::path{"out"} / (name + "_live");
  const fs::path folder = *given.out / name;
  create_folder(folder);
  const fs::path file = folder / kScenarioFile;
  replace_text_file(file, bare_scenario(robot_key(given.robot, folder)));
  given.scenario = file.string();
}

LiveScenario load(const LiveOptions& given, const SearchPath& path) {
  LogicChoice logic = given.logic;
  if (!logic.engine) logic.engine = Engine::kModel;
  std::vector<std::string> overrides = given.set;
  const auto loaded = [&] {
    return load_scenario(given.scenario, {.search_path = path, .overrides = overrides, .logic = logic});
  };
  LiveScenario live{loaded(), {}};
  if (!live.scenario.pendant) {
    for (const char* const change : {"pendant.profile=\"extended\"", "move=[]", "stream=[]", "expect={}"}) {
      overrides.emplace_back(change);
    }
    live.scenario = loaded();
  }
  live.overrides = std::move(overrides);
  live.scenario.duration_s = given.for_s;
  live.scenario.ends_with_program = false;
  return live;
}

// `happened`: overrides for what happened in the cell.
std::string replay_command(const LiveOptions& given, const LiveScenario& live, const std::vector<std::string>& happened,
                           const fs::path& out, Cycles end) {
  std::string words;
  std::vector<std::string> changes = live.overrides;
  changes.insert(changes.end(), happened.begin(), happened.end());
  for (const std::string& change : changes) words += " --set " + shell_word(change);
  return fmt::format("armature run {}{} --set duration_s={} --engine {} --serial replay:{} --out {}",
                     shell_word(given.scenario), words, seconds_text(end), word_of(live.scenario.engine),
                     shell_word((out / kSerialFile).string()), shell_word((out / "replay").string()));
}

int live(LiveOptions given, const SearchPath& path) {
  if (!given.robot.empty()) make_scenario(given, path);
  if (given.scenario.empty()) throw InputError{"live", "expected a scenario, or --robot and a robot"};
  LiveScenario live = load(given, path);
  Scenario& scenario = live.scenario;
  if (!scenario.serial) scenario.serial.emplace();
  const fs::path out = given.out.value_or(fs::path{"out"} / (scenario.name + "_live"));
  OutputFiles files;
  files.reads(scenario);
  claim_results(files, out);
  RunFolder folder{out};
  prepare_serial_log(out / kSerialFile);
  catch_interrupts();
  const Listener listener{ListenAddress{.tcp_port = given.port, .path = {}}};
  ReversibleSession session{scenario, {.serial = out / kSerialFile, .log = out / kLogFile}};
  WebServer server{listener, session};
  std::cout << page_address(listener.tcp_port().value(), listener.token().value())
            << std::endl;  // a script waits for it
  run_live(session, server, given.pace);
  const SessionResult result = session.finish();
  folder.finish();
  std::cout << fmt::format("simulated      {} s, {} ticks\nsha256         {}\n", seconds_text(result.cycles),
                           result.ticks, result.sha256)
            << fmt::format("results        {}\nto repeat it   {}\n", printable(out.string(), kShowAll),
                           replay_command(given, live, result.overrides, out, result.cycles));
  if (!result.failure.empty()) std::cerr << result.failure << "\n";
  if (!result.failure.empty()) return kExitCheckFailed;
  return result.interrupted ? kExitInterrupted : kExitOk;
}

CommandAction declare_live(CLI::App& app) {
  const auto options = std::make_shared<LiveOptions>();
  CLI::Option* const scenario =
      app.add_option("scenario", options->scenario, "Scenario folder, scenario.toml, or a name from 'armature list'")
          ->type_name(kScenarioValue);
  app.add_option("--robot", options->robot,
                 "Instead of a scenario: a robot alone. Name from 'armature list', or a path ending in .toml")
      ->type_name(kRobotValue)
      ->excludes(scenario);
  app.add_option("--port", options->port, "Port on 127.0.0.1 (default 0: any free one, printed)");
  app.add_option("--out", options->out,
                 "Folder for serial.csv and log.txt (default out/<scenario>_live or out/<robot>_live)")
      ->type_name(kFolderValue);
  app.add_option("--pace", options->pace, "Largest simulated time per real time (default 1)")
      ->check(CLI::Range(1e-4, 1e4));
  constexpr double kDay = 86'400;
  app.add_option("--for", options->for_s, "Simulated time after which the session ends [s] (default: a day)")
      ->check(CLI::Range(1e-4, kDay));
  app.add_option("--set", options->set, "Override a key of the scenario. May be repeated")->allow_extra_args(false);
  add_logic_options(app, options->logic);
  return [options](const CommonOptions& common) { return live(*options, common.search_path()); };
}

}  // namespace

Subcommand live_command() {
  return {.name = "live",
          .order = 44,
          .summary = "See and drive the arm in a browser while the simulation runs",
          .details = kLiveDetails,
          .declare = declare_live};
}

}  // namespace armature::cosim
