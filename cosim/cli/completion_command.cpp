#include <CLI/CLI.hpp>
#include <iostream>
#include <string>

#include "cosim/cli/command.hpp"
#include "cosim/cli/shell_completion.hpp"

namespace armature::cosim {
namespace {

constexpr const char* kCompletionDetails = R"(Example:
  armature completion bash > armature.bash   # then, or in ~/.bashrc: . ./armature.bash

Prints a script with which the shell completes commands, options, and the names of scenarios, robots and files.
'cmake --install' installs it where bash-completion finds it.
Exit code: 0 ok, 2 bad input.)";

CommandAction declare_completion(CLI::App& app) {
  // There is one shell, so its name decides nothing.
  app.add_option_function<std::string>(
         "shell", [](const std::string&) {}, "The shell")
      ->required()
      ->check(CLI::IsMember({"bash"}));
  return [&app](const CommonOptions&) {
    const CLI::App& program = *app.get_parent();
    std::cout << bash_completion(program_row(program), command_rows(program));
    return kExitOk;
  };
}

}  // namespace

Command completion_command() {
  return {.name = "completion",
          .order = 94,
          .summary = "Print a script that lets a shell complete commands",
          .details = kCompletionDetails,
          .declare = declare_completion};
}

}  // namespace armature::cosim
