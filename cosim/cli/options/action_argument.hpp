// The arguments of a command that does one of several things with files: `armature job check FILE`. Without the action
// it does the first of them: `armature job FILE`.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace armature::cosim {

struct ActionArguments {
  std::vector<std::string> actions;   // the first one is the default
  std::vector<std::string> fileless;  // of these actions, those that take no file
  std::string action{};               // the one that is given
  std::vector<std::string> files{};
};

// Adds both arguments. `arguments` must outlive the parsing.
void add_action(CLI::App& command, ActionArguments& arguments, const std::string& files_help);

// For the callback of the command. Throws CLI::RequiredError if the action needs a file and there is none, and
// InputError if the first file is missing and resembles an action.
void check_action(const ActionArguments& arguments);

}  // namespace armature::cosim
