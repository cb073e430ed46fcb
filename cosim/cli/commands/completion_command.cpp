#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "cosim/cli/command/command.hpp"
#include "cosim/cli/options/shell_completion.hpp"
#include "cosim/cli/options/value_kinds.hpp"
#include "cosim/text/input_error.hpp"

namespace armature::cosim {
namespace {

constexpr const char* kCompletionDetails = R"(Examples:
  armature completion bash > armature.bash   # then, or in ~/.bashrc: . ./armature.bash
  armature completion zsh > _armature        # in a folder of $fpath
  armature completion fish > armature.fish   # in ~/.config/fish/completions
  armature completion bash -- run fig

Prints a script with which the shell completes commands, options, and the names of scenarios, robots and files.
'cmake --install' installs the scripts where the shells find them. A script asks with the words of the command line
after --. The answer says whether the shell adds files or folders, and has a line for each word that it offers.
Exit code: 0 ok, 2 bad input.)";

struct CompletionOptions {
  std::string shell;
  std::vector<std::string> words;
};

// The names that a search finds; none if a folder of --path is missing.
std::vector<std::string> names_of(std::string_view kind, const std::vector<std::string>& folders) {
  try {
    const SearchPath path = data_path(folders);
    return kind == kRobotValue ? path.robot_names() : path.scenario_names();
  } catch (const InputError&) {
    return {};
  }
}

CommandAction declare_completion(CLI::App& app) {
  const auto options = std::make_shared<CompletionOptions>();
  std::vector<std::string> names;
  for (const ShellKind& shell : shell_kinds()) names.emplace_back(shell.name);
  app.add_option("shell", options->shell, "The shell")->required()->check(CLI::IsMember(names));
  app.add_option("words", options->words, "Words of a command line: print what the shell offers for the last one");
  return [options, &app](const CommonOptions&) {
    const ShellKind& shell = *std::ranges::find(shell_kinds(), options->shell, &ShellKind::name);
    if (options->words.empty()) {
      std::cout << shell.script;
    } else {
      const CLI::App& program = *app.get_parent();
      std::cout << answer_text(shell,
                               complete_word(program_row(program), command_rows(program), options->words, names_of));
    }
    return kExitOk;
  };
}

}  // namespace

Subcommand completion_command() {
  return {.name = "completion",
          .order = 94,
          .summary = "Print a script that lets a shell complete commands",
          .details = kCompletionDetails,
          .declare = declare_completion};
}

}  // namespace armature::cosim
