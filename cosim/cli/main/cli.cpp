#include "cosim/cli/main/cli.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "cosim/cli/command/command.hpp"
#include "cosim/cli/command/standard_streams.hpp"
#include "cosim/cli/command/unknown_word.hpp"
#include "cosim/cli/options/value_kinds.hpp"
#include "cosim/soc/soc.hpp"
#include "cosim/text/input_error.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/version.hpp"

namespace armature::cosim {
namespace {

constexpr const char* kProgramDetails = R"(Example:
  armature run scenarios/fig9_joint_move

'armature COMMAND --help' shows more examples.

A scenario or robot can be given by its name alone. The program then searches folders that have NAME/scenario.toml and
robots/NAME.toml, and uses the first one that has the name. It searches in this order:
  1. the folders of --path
  2. the folders of the variable ARMATURE_PATH, separated by colons
  3. 'scenarios' in the current folder, or in the nearest folder above that has it
  4. the current folder, if it has a folder 'robots'
  5. the folders of the program itself)";

int run_command_line(int argc, const char* const* argv, const std::vector<Subcommand>& more) {
  CLI::App app{"Cycle-accurate co-simulation of a System-on-Chip robot-arm controller", "armature"};
  app.require_subcommand(1);
  app.footer(kProgramDetails);
  app.fallthrough();  // common options may follow the command
  app.set_version_flag("--version", fmt::format("armature {}", version()), "Print the version and exit");
  CommonOptions common;
  app.add_option("--path", common.path,
                 "Folder of scenarios to search before all others. May be repeated, and may follow the command")
      ->type_name(kFolderValue)
      ->allow_extra_args(false);  // one value for each --path: the next word may be the command
  std::map<const CLI::App*, CommandAction> actions;
  std::vector<Subcommand> all = commands();
  all.insert(all.end(), more.begin(), more.end());
  std::ranges::stable_sort(all, {}, &Subcommand::order);
  for (const Subcommand& command : all) {
    CLI::App* sub = app.add_subcommand(command.name, command.summary);
    sub->footer(command.details);
    actions[sub] = command.declare(*sub);
  }

  try {
    if (argc <= 1) {
      std::cout << app.help();
      return kExitOk;
    }
    app.parse(argc, argv);
    return actions.at(app.get_subcommands().front())(common);
  } catch (const CLI::ParseError& error) {
    const bool failed = error.get_exit_code() != static_cast<int>(CLI::ExitCodes::Success);
    if (const auto unknown = failed ? unknown_word(app, all) : std::nullopt) {
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

int cli_main(int argc, const char* const* argv, const std::vector<Subcommand>& more) {
  fill_standard_streams();
  const int code = run_command_line(argc, argv, more);
  return flush_standard_output() ? code : kExitInternal;
}

}  // namespace armature::cosim
