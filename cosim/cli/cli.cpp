#include "cosim/cli/cli.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>
#include <iostream>

#include "cosim/cli/commands.hpp"
#include "cosim/cli/interrupt.hpp"
#include "cosim/text/input_error.hpp"

namespace armature::cosim {
namespace {

// Where the parser stores what it reads; must outlive the parsing.
struct CommandLine {
  RunArguments run;
  CheckArguments check;
  CompareArguments compare;
  BlessArguments bless;
  std::function<int()> chosen;
};

void add_run(CLI::App& app, CommandLine& line) {
  RunArguments& args = line.run;
  CLI::App* run = app.add_subcommand("run", "Run one scenario");
  run->footer(
      "Examples:\n"
      "  armature run scenarios/fig9_joint_move\n"
      "  armature run fig9_joint_move --vcd fig9.vcd --from 0.1 --to 0.1002\n"
      "  armature run late_core --fst late.fst --wave-on fault\n"
      "  armature run pulse_loss_recovered --set controller.feedback=false --out out/open_loop\n\n"
      "Writes trace.csv, summary.json and log.txt to --out. Exit code: 0 ok, 1 an expectation or an invariant failed,\n"
      "2 bad input, 3 internal error, 130 interrupted.");
  run->add_option("scenario", args.scenario, "Scenario folder, scenario.toml, or a name from 'armature list'")
      ->required();
  run->add_option("--out", args.out, "Folder for the results (default out/<scenario>)");
  CLI::Option* vcd = run->add_option("--vcd", args.vcd, "Write a VCD waveform of every signal to this file");
  CLI::Option* fst = run->add_option("--fst", args.fst, "Write an FST waveform (fifty times smaller)")->excludes(vcd);
  run->add_option("--from", args.from_s, "Waveform begins at this simulated time [s]")->check(CLI::NonNegativeNumber);
  run->add_option("--to", args.to_s, "Waveform ends at this simulated time [s]")->check(CLI::NonNegativeNumber);
  run->add_option_function<std::string>(
         "--wave-on", [&args](const std::string&) { args.wave_on_fault = true; },
         "'fault': the waveform begins at the first fault and lasts 1 ms or until --to")
      ->check(CLI::IsMember({"fault"}));
  run->add_option("--set", args.set, "Override a key of the scenario: --set controller.feedback=false; may be repeated")
      ->allow_extra_args(false);  // one value each: the next word may be the scenario
  run->callback([&line, run, vcd, fst] {
    const bool wave = vcd->count() + fst->count() > 0;
    for (const char* option : {"--from", "--to", "--wave-on"}) {
      if (run->count(option) > 0 && !wave) throw CLI::ValidationError(option, "needs --vcd or --fst");
    }
    const RunArguments& given = line.run;
    for (const auto& [option, time_s] : {std::pair{"--from", given.from_s}, std::pair{"--to", given.to_s}}) {
      if (time_s && !std::isfinite(*time_s)) throw CLI::ValidationError(option, "must be a finite time");
    }
    if (given.from_s && given.to_s && *given.to_s <= *given.from_s) {
      throw CLI::ValidationError("--to", "must be later than --from");
    }
    line.chosen = [&line] { return run_command(line.run); };
  });
}

void add_check(CLI::App& app, CommandLine& line) {
  CheckArguments& args = line.check;
  CLI::App* check = app.add_subcommand("check", "Run scenarios and compare them with their goldens and expectations");
  check->footer(
      "Examples:\n"
      "  armature check\n"
      "  armature check fig9_joint_move max_rate_4mpps --jobs 2\n"
      "  armature check --junit results.xml\n\n"
      "Without names every scenario is checked. One verdict line a scenario. Exit code: 0 all passed, 1 one failed.");
  check->add_option("scenario", args.scenarios, "Scenario folders or names (default: all)");
  check->add_option("--jobs,-j", args.jobs, "Scenarios at a time")->check(CLI::Range(1, 256))->capture_default_str();
  check->add_option("--junit", args.junit, "Write the verdicts as JUnit XML to this file");
  check->callback([&line] { line.chosen = [&line] { return check_command(line.check); }; });
}

void add_compare(CLI::App& app, CommandLine& line) {
  CompareArguments& args = line.compare;
  CLI::App* compare = app.add_subcommand("compare", "Compare two trace files");
  compare->footer(
      "Example:\n"
      "  armature compare scenarios/fig9_joint_move/golden.csv out/fig9_joint_move/trace.csv\n\n"
      "Integer columns must be equal, others within the tolerance of their unit. Exit code: 0 equal, 1 different.");
  compare->add_option("a", args.a, "Reference trace")->required();
  compare->add_option("b", args.b, "Trace to compare with it")->required();
  compare->callback([&line] { line.chosen = [&line] { return compare_command(line.compare); }; });
}

void add_bless(CLI::App& app, CommandLine& line) {
  BlessArguments& args = line.bless;
  CLI::App* bless = app.add_subcommand("bless", "Make the present result of a scenario its golden");
  bless->footer(
      "Example:\n"
      "  armature bless fig9_joint_move\n\n"
      "Writes golden.csv and the hash in scenario.toml, and prints what changed. Refused while an expectation fails.");
  bless->add_option("scenario", args.scenario, "Scenario folder or name")->required();
  bless->callback([&line] { line.chosen = [&line] { return bless_command(line.bless); }; });
}

}  // namespace

int cli_main(int argc, char** argv) {
  CLI::App app{"Cycle-accurate co-simulation of a System-on-Chip robot-arm controller", "armature"};
  app.require_subcommand(1);
  app.footer("Example:\n  armature run scenarios/fig9_joint_move\n\n'armature COMMAND --help' has more of them.");
  CommandLine line;
  add_run(app, line);
  add_check(app, line);
  add_compare(app, line);
  add_bless(app, line);
  CLI::App* list = app.add_subcommand("list", "List the scenarios and robots");
  list->footer("Example:\n  armature list");
  list->callback([&line] { line.chosen = list_command; });
  CLI::App* info = app.add_subcommand("info", "Version, clock, address map");
  info->footer("Example:\n  armature info");
  info->callback([&line] { line.chosen = info_command; });

  // CLI11 would only say that a command is missing.
  const auto commands = app.get_subcommands([](const CLI::App*) { return true; });
  if (argc > 1 && argv[1][0] != '-' && std::ranges::find(commands, argv[1], &CLI::App::get_name) == commands.end()) {
    std::cerr << "armature: unknown command '" << argv[1] << "'; 'armature --help' lists the commands\n";
    return kExitBadInput;
  }
  try {
    app.parse(argc, argv);
    catch_interrupts();
    return line.chosen();
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kExitOk : kExitBadInput;
  } catch (const InputError& error) {
    std::cerr << error.what() << '\n';
    return kExitBadInput;
  } catch (const std::exception& error) {
    std::cerr << "armature: internal error: " << error.what() << '\n';
    return kExitInternal;
  }
}

}  // namespace armature::cosim
