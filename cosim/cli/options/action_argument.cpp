#include "cosim/cli/options/action_argument.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "cosim/cli/options/value_kinds.hpp"
#include "cosim/text/input_error.hpp"
#include "cosim/text/or_list.hpp"
#include "cosim/text/suggest.hpp"

namespace armature::cosim {

void add_action(CLI::App& command, ActionArguments& arguments, const std::string& files_help) {
  arguments.action = arguments.actions.front();
  command
      .add_option("action", arguments.action,
                  or_list(arguments.actions) + " (without it: " + arguments.actions.front() + ")")
      ->check(CLI::IsMember(arguments.actions));
  command.add_option("files", arguments.files, files_help)->type_name(kFileValue);
  command.validate_positionals();  // a word that is no action is a file
}

void check_action(const ActionArguments& arguments) {
  const bool needs_file = std::ranges::find(arguments.fileless, arguments.action) == arguments.fileless.end();
  if (!needs_file) return;
  if (arguments.files.empty()) throw CLI::RequiredError("A file to " + arguments.action);
  const std::string& first = arguments.files.front();
  const std::vector<std::string_view> names{arguments.actions.begin(), arguments.actions.end()};
  std::error_code ignored;
  if (std::filesystem::exists(first, ignored) || nearest_name(first, names).empty()) return;
  throw InputError{first, "no such file" + suggestion(first, arguments.actions)};
}

}  // namespace armature::cosim
