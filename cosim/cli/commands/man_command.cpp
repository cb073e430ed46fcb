#include <CLI/CLI.hpp>
#include <iostream>

#include "cosim/cli/command/command.hpp"
#include "cosim/cli/options/man_page.hpp"

namespace armature::cosim {
namespace {

constexpr const char* kManDetails = R"(Example:
  armature man > armature.1   # then: man -l armature.1

Prints the manual page: all that --help prints, of all commands. 'cmake --install' installs it.
Exit code: 0 ok.)";

CommandAction declare_man(CLI::App& app) {
  return [&app](const CommonOptions&) {
    const CLI::App& program = *app.get_parent();
    std::cout << man_page(program_row(program), command_rows(program));
    return kExitOk;
  };
}

}  // namespace

Subcommand man_command() {
  return {.name = "man",
          .order = 96,
          .summary = "Print the manual page of the program",
          .details = kManDetails,
          .declare = declare_man};
}

}  // namespace armature::cosim
