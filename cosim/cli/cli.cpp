#include "cosim/cli/cli.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <exception>
#include <functional>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "cosim/cli/commands.hpp"
#include "cosim/cli/data_path.hpp"
#include "cosim/cli/standard_streams.hpp"
#include "cosim/cli/unknown_word.hpp"
#include "cosim/fabric/fabric.hpp"
#include "cosim/scenario/scenario.hpp"
#include "cosim/text/input_error.hpp"
#include "cosim/text/printable.hpp"

namespace armature::cosim {
namespace {

// Where the parser stores what it reads; must outlive the parsing.
struct CommandLine {
  RunArguments run;
  CheckArguments check;
  CompareArguments compare;
  BlessArguments bless;
  FkArguments fk;
  IkArguments ik;
  ServeArguments serve;
  std::vector<std::string> path;  // --path
  std::function<int()> chosen;
};

CLI::IsMember fabric_name() {
  return CLI::IsMember(std::vector{std::string{kRtlFabricName}, std::string{kPaperFabricName}});
}

void add_run(CLI::App& app, CommandLine& line) {
  RunArguments& args = line.run;
  CLI::App* run = app.add_subcommand("run", "Run one scenario");
  run->footer(
      "Examples:\n"
      "  armature run scenarios/fig9_joint_move\n"
      "  armature run fig9_joint_move --vcd fig9.vcd --from 0.1 --to 0.1002\n"
      "  armature run late_core --fst late.fst --wave-on fault\n"
      "  armature run fig9_joint_move --serial pty:/tmp/arm\n"
      "  armature run pulse_loss_recovered --set controller.feedback=false --out out/open_loop   # exits with 1\n"
      "  armature run fig9_joint_move --fabric paper --out out/paper   # exits with 1: its decoder sees one axis\n\n"
      "Writes trace.csv, summary.json and log.txt to --out; serial.csv if the serial line is connected:\n"
      "scenarios/RESULTS.md. One run at a time writes into a folder; while it does, and after it was killed, the\n"
      "folder holds a file 'unfinished'. A device, a pipe or a link that stands in place of a result or of --vcd is\n"
      "written to; in place of --fst it is refused, and so is every file that the run reads.\n"
      "The run is compared with golden.csv unless an option makes it another run: --fabric, --serial, --set of\n"
      "anything but expect. and trace.every_ticks.\n"
      "Exit code: 0 ok, 1 the golden, an expectation or an invariant failed, 2 bad input, 3 internal error,\n"
      "130 interrupted.");
  run->add_option("scenario", args.scenario, "Scenario folder, scenario.toml, or a name from 'armature list'")
      ->required();
  run->add_option("--out", args.out, "Folder for the results (default out/<scenario>)");
  CLI::Option* vcd = run->add_option("--vcd", args.vcd, "Write a VCD waveform of every signal to this file");
  CLI::Option* fst = run->add_option("--fst", args.fst, "Write an FST waveform (fifty times smaller)")->excludes(vcd);
  run->add_option("--from", args.from_s, "Waveform begins at this simulated time [s]");
  run->add_option("--to", args.to_s, "Waveform ends at this simulated time [s]");
  run->add_option_function<std::string>(
         "--wave-on", [&args](const std::string&) { args.wave_on_fault = true; },
         "'fault': the waveform begins at the first fault and lasts 1 ms or until --to")
      ->check(CLI::IsMember({"fault"}));
  run->add_option("--set", args.set, "Override a key of the scenario: --set controller.feedback=false; may be repeated")
      ->allow_extra_args(false);  // one value each: the next word may be the scenario
  run->add_option("--fabric", args.fabric,
                  "Instead of the scenario's: 'rtl', or 'paper', the logic as Vo 2021 describes it (half periods, one "
                  "decoder)")
      ->check(fabric_name());
  run->add_option("--serial", args.serial,
                  "Other end of the serial line: pty[:LINK], tcp:PORT (0: any), or replay:FILE, the serial.csv of a "
                  "run with another "
                  "--out");
  run->callback([&line, run, vcd, fst] {
    const bool wave = vcd->count() + fst->count() > 0;
    for (const char* option : {"--from", "--to", "--wave-on"}) {
      if (run->count(option) > 0 && !wave) throw CLI::ValidationError(option, "needs --vcd or --fst");
    }
    const RunArguments& given = line.run;
    for (const auto& [option, time_s] : {std::pair{"--from", given.from_s}, std::pair{"--to", given.to_s}}) {
      if (time_s && !(std::isfinite(*time_s) && *time_s >= 0)) {
        throw CLI::ValidationError(option, "must be a time from 0 on, in seconds");
      }
    }
    if (given.from_s && given.to_s && *given.to_s <= *given.from_s) {
      throw CLI::ValidationError("--to", "must be later than --from");
    }
    line.chosen = [&line] { return run_command(line.run, data_path(line.path)); };
  });
}

void add_check(CLI::App& app, CommandLine& line) {
  CheckArguments& args = line.check;
  CLI::App* check = app.add_subcommand("check", "Run scenarios and compare them with their goldens and expectations");
  check->footer(
      "Examples:\n"
      "  armature check\n"
      "  armature check fig9_joint_move max_rate_4mpps --jobs 2\n"
      "  armature check scenarios   # a folder of scenarios: all of them\n"
      "  armature check --junit results.xml\n\n"
      "Without names: all of your own folders that 'armature list' shows, or of the program when yours have none.\n"
      "One verdict line a scenario; of one that fails, why, and a command that shows it. Its trace.csv (every 20th\n"
      "tick), log.txt and summary.json are kept in --out/<scenario>; what an earlier check kept there is removed.\n"
      "Exit code: 0 all passed, 1 one failed, 2 bad input, 3 internal error, 130 interrupted.");
  check->add_option("scenario", args.scenarios, "Scenario folders, folders of them, or names (default: all of yours)");
  check->add_option("--jobs,-j", args.jobs, "Scenarios at a time")->check(CLI::Range(1, 256))->capture_default_str();
  check->add_option("--out", args.out, "Folder for the results of scenarios that fail, each in one of its name")
      ->capture_default_str();
  check->add_option("--junit", args.junit, "Write the verdicts as JUnit XML to this file");
  check->callback([&line] { line.chosen = [&line] { return check_command(line.check, data_path(line.path)); }; });
}

void add_compare(CLI::App& app, CommandLine& line) {
  CompareArguments& args = line.compare;
  CLI::App* compare = app.add_subcommand("compare", "Compare two trace files");
  compare->footer(
      "Example:\n"
      "  armature compare scenarios/fig9_joint_move/golden.csv out/fig9_joint_move/trace.csv\n\n"
      "Integer columns must be equal, others within the tolerance of their unit. Exit code: 0 equal, 1 different,\n"
      "2 bad input, 3 internal error.");
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
      "Writes golden.csv and the hash in scenario.toml, and prints what changed. Refused while an expectation fails.\n"
      "Exit code: 0 blessed, 1 refused, 2 bad input, 3 internal error, 130 interrupted.");
  bless->add_option("scenario", args.scenario, "Scenario folder or name")->required();
  bless->callback([&line] { line.chosen = [&line] { return bless_command(line.bless, data_path(line.path)); }; });
}

// What fk and ik share. One pose on the command line, or a file of them.
void add_kinematics(CLI::App* command, std::string& robot, std::optional<std::string>& in, std::string& out,
                    const char* in_help, const char* out_help) {
  command->add_option("--robot", robot, "Name from 'armature list', or a path ending in .toml")->required();
  CLI::Option* in_option = command->add_option("--in", in, in_help);
  command->add_option("--out", out, out_help)->needs(in_option);
}

void add_fk(CLI::App& app, CommandLine& line) {
  FkArguments& args = line.fk;
  CLI::App* fk = app.add_subcommand("fk", "Forward kinematics: poses of the flange from joint angles");
  fk->footer(
      "Examples:\n"
      "  armature fk --robot abb_irb120 10 20 -30 0 45 90\n"
      "  armature fk --robot abb_irb120 --in scenarios/robots/examples/joints.csv --out poses.csv\n"
      "  printf 'j1_deg,j2_deg,j3_deg,j4_deg,j5_deg\\n0,-90,0,-90,0\\n' | armature fk --robot hu2012_5r --in -\n\n"
      "joints.csv has the header j1_deg,...,j6_deg (as many as the arm has joints), poses.csv gets\n"
      "t11,t12,t13,t14,t21,...,t34: the rows of the 3x4 matrix [R | p], p in mm. Limits are not applied.\n"
      "Exit code: 0 ok, 2 bad input (then nothing is written).");
  add_kinematics(fk, args.robot, args.in, args.out, "File of joint angles, '-' for standard input",
                 "File for the poses (default '-', standard output)");
  fk->add_option("joints", args.joints, "Joint angles of one pose [deg]")->excludes("--in");
  // Not of this command; CLI11 would take its numbers for the joint angles of a pose.
  fk->add_option("--previous")->expected(0, 6)->group("");
  fk->callback([&line, fk] {
    if (fk->count("--previous") > 0) {
      throw CLI::ValidationError("--previous", "belongs to 'armature ik': poses do not depend on the joints before");
    }
    if (fk->count("--in") + fk->count("joints") == 0) throw CLI::RequiredError("Joint angles or --in");
    line.chosen = [&line] { return fk_command(line.fk, data_path(line.path)); };
  });
}

void add_ik(CLI::App& app, CommandLine& line) {
  IkArguments& args = line.ik;
  CLI::App* ik = app.add_subcommand("ik", "Inverse kinematics: all joint angles that bring the flange to a pose");
  ik->footer(
      "Examples:\n"
      "  armature ik --robot abb_irb120 --xyz 350 -120 500 --rpy 30 120 -10\n"
      "  armature ik --robot abb_irb120 --xyz 350 -120 500 --rpy 30 120 -10 --previous 0 0 0 90 0 -90\n"
      "  armature ik --robot abb_irb120 --in poses.csv --out solutions.csv\n\n"
      "poses.csv is as 'armature fk' writes it; columns prev1_deg,... may follow with the joint angles before, "
      "without\n"
      "which all are 0. solutions.csv gets one row a branch, in the order shoulder (1, -1), elbow (1, -1), flip (1, "
      "-1):\n"
      "pose,branch,shoulder,elbow,flip,singular,within_limits,selected,j1_deg,...; flip is 0 for five axes, singular\n"
      "adds 1 for the shoulder, 2 for the wrist, 4 for the elbow, 8 for folded. A pose without a branch is a row "
      "pose,none,REASON.\n"
      "Selected is the branch inside the limits that a joint move from the angles before reaches soonest.\n"
      "--rpy: rotations about the fixed axes x, then y, then z.\n"
      "A file's poses that were solved for the nearest orientation (five joints) or clamped at the reach limit are\n"
      "counted in one line on standard error.\n"
      "Exit code: 0 ok, 1 one pose that the arm cannot take, 2 bad input (then nothing is written).");
  add_kinematics(ik, args.robot, args.in, args.out, "File of poses, '-' for standard input",
                 "File for the solutions (default '-', standard output)");
  CLI::Option* xyz = ik->add_option("--xyz", args.xyz, "Position of one pose [mm]")->expected(3)->excludes("--in");
  CLI::Option* rpy = ik->add_option("--rpy", args.rpy, "Its roll, pitch and yaw [deg]")->expected(3)->needs(xyz);
  xyz->needs(rpy);
  ik->add_option("--previous", args.previous, "Joint angles before [deg] (default: all 0)")->expected(1, 6);
  ik->callback([&line, ik] {
    if (ik->count("--previous") > 0 && ik->count("--in") > 0) {
      throw CLI::ValidationError("--previous",
                                 "belongs to --xyz; a file has the joints before in columns prev1_deg,...");
    }
    if (ik->count("--in") + ik->count("--xyz") == 0) throw CLI::RequiredError("--xyz and --rpy, or --in,");
    line.chosen = [&line] { return ik_command(line.ik, data_path(line.path)); };
  });
}

void add_serve(CLI::App& app, CommandLine& line) {
  ServeArguments& args = line.serve;
  CLI::App* serve = app.add_subcommand("serve", "Let other programs drive the bus and the pins of the logic");
  serve->footer(
      "Examples:\n"
      "  armature serve --listen /tmp/arm_soc.sock --out waves\n"
      "  python3 cosim/serve/client/timer_self_test.py /tmp/arm_soc.sock\n"
      "  printf 'w 0x42800004 2498\\nw 0x42800000 0x20\\nw 0x42800000 0xD2\\nrun-until-irq 5000\\npin irq_o\\n' |\n"
      "    nc -N -U /tmp/arm_soc.sock        # nc of netcat-openbsd\n"
      "Over TCP the first line of a client is 'token TOKEN', with the token that the server prints when it starts:\n"
      "  (umask 077; exec armature serve --listen tcp:5025 --fabric paper > serve.txt) &\n"
      "  sleep 1; export ARMATURE_TOKEN=$(sed -n 's/^token //p' serve.txt)\n"
      "  python3 cosim/serve/client/timer_self_test.py tcp:5025\n"
      "  printf \"token $ARMATURE_TOKEN\\ntime\\n\" | nc -N 127.0.0.1 5025\n\n"
      "One line a command, one answer line each, in order: ok, ok 0xVALUE, ok CYCLE or error WHAT. Commands:\n"
      "  r ADDR               w ADDR DATA [STRB]    run CYCLES    run-until-irq MAX\n"
      "  pin NAME [VALUE]     time                  vcd [FILE]    help [COMMAND]\n"
      "Numbers are decimal or 0x...; many commands may be sent before the first answer is read. Simulated time passes "
      "in\n"
      "r, w, run and run-until-irq only: the same commands give the same cycles and values. No controller, no drives.\n"
      "TCP is reachable from this machine only, a socket file by its user only; it is removed at the end. One client "
      "at\n"
      "a time: another gets 'error busy: ...' and is closed. The next finds the logic as it was left. vcd FILE writes "
      "below\n"
      "the folder of --out only. cosim/serve/README.md describes the protocol, cosim/serve/client has clients in C "
      "and\n"
      "Python, which take the token from ARMATURE_TOKEN.\n"
      "Ctrl-C ends the server and closes the waveform. Exit code: 130 interrupted, 1 a check inside the logic failed,\n"
      "2 bad input, 3 internal error.");
  serve->add_option("--listen", args.listen, "Path of a Unix socket, or tcp:PORT (0: any free one, printed)")
      ->required();
  serve->add_option("--out", args.out, "Folder for the waveforms of vcd FILE (default: none, they are refused)");
  serve
      ->add_option_function<std::string>(
          "--fabric", [&args](const std::string& name) { args.paper_fabric = name == kPaperFabricName; },
          "Variant of the logic: 'rtl' (default) or 'paper', as Vo 2021 describes it")
      ->check(fabric_name());
  serve->callback([&line] { line.chosen = [&line] { return serve_command(line.serve); }; });
}

int run_command_line(int argc, char** argv) {
  CLI::App app{"Cycle-accurate co-simulation of a System-on-Chip robot-arm controller", "armature"};
  app.require_subcommand(1);
  app.footer(
      "Example:\n"
      "  armature run scenarios/fig9_joint_move\n\n"
      "'armature COMMAND --help' has more of them.\n\n"
      "Bare names of scenarios and robots are looked up in folders that have NAME/scenario.toml and robots/NAME.toml.\n"
      "The first that has the name wins: the folders of --path, of ARMATURE_PATH (separated by colons), 'scenarios' "
      "in\n"
      "the current folder or the nearest above, the current folder if it has 'robots', those of the program itself.");
  app.fallthrough();  // options of every command may stand behind the command word, too
  app.set_version_flag("--version", std::string{"armature "} + ARMATURE_VERSION, "Print the version and exit");
  CommandLine line;
  app.add_option("--path", line.path,
                 "Folder of scenarios to search before all others; may be repeated, also behind the command")
      ->type_name("DIR")
      ->allow_extra_args(false);  // one value each: the next word may be the command
  add_run(app, line);
  add_check(app, line);
  add_compare(app, line);
  add_bless(app, line);
  add_fk(app, line);
  add_ik(app, line);
  add_serve(app, line);
  CLI::App* list = app.add_subcommand("list", "List the scenarios and robots");
  list->footer(
      "Examples:\n"
      "  armature list\n"
      "  armature list --path scenarios\n\n"
      "Folder by folder in the order that 'armature --help' tells. What an earlier folder shadows is found by its "
      "path\n"
      "only. Exit code: 0 ok, 2 a file cannot be read, or nothing is found.");
  list->callback([&line] { line.chosen = [&line] { return list_command(data_path(line.path)); }; });
  CLI::App* info = app.add_subcommand("info", "Version, clock, address map, where scenarios are searched");
  info->footer("Example:\n  armature info");
  info->callback([&line] { line.chosen = [&line] { return info_command(data_path(line.path)); }; });

  try {
    app.parse(argc, argv);
    return line.chosen();
  } catch (const CLI::ParseError& error) {
    const bool failed = error.get_exit_code() != static_cast<int>(CLI::ExitCodes::Success);
    if (const auto unknown = failed ? unknown_word(app) : std::nullopt) {
      std::cerr << printable_lines(*unknown + '\n');
      return kExitBadInput;
    }
    std::ostringstream message;
    const int code = app.exit(error, std::cout, message);
    std::cerr << printable_lines(message.str());
    return code == 0 ? kExitOk : kExitBadInput;
  } catch (const InputError& error) {
    std::cerr << error.what() << '\n';
    return kExitBadInput;
  } catch (const WaveError& error) {
    std::cerr << printable_lines(error.what()) << '\n';
    return kExitBadInput;
  } catch (const std::exception& error) {
    std::cerr << "armature: internal error: " << printable_lines(error.what()) << '\n';
    return kExitInternal;
  }
}

}  // namespace

int cli_main(int argc, char** argv) {
  fill_standard_streams();
  const int code = run_command_line(argc, argv);
  return flush_standard_output() ? code : kExitInternal;
}

}  // namespace armature::cosim
