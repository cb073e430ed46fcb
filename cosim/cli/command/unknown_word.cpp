#include "cosim/cli/command/unknown_word.hpp"

#include <algorithm>
#include <vector>

#include "cosim/text/suggest.hpp"

namespace armature::cosim {
namespace {

// `known`: the words that are allowed. The help lists them.
std::string message(const std::string& who, const std::string& what, const std::string& word,
                    const std::vector<std::string>& known) {
  const std::vector<std::string_view> names{known.begin(), known.end()};
  const std::string_view near = nearest_name(word, names);
  const std::string hint =
      near.empty() ? "; '" + who + " --help' lists the " + what + "s" : ", did you mean " + std::string{near} + "?";
  return who + ": unknown " + what + " '" + word + "'" + hint;
}

void add_options(const CLI::App& command, std::vector<std::string>& names) {
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_group().empty()) continue;  // hidden
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
}

}  // namespace

std::optional<std::string> unknown_word(const CLI::App& app, const std::vector<Subcommand>& commands) {
  const std::vector<std::string> left = app.remaining(true);
  if (left.empty()) return std::nullopt;
  const std::string& word = left.front();
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  std::vector<std::string> known;
  if (word.starts_with("--") && word.size() > 2) {
    if (!chosen.empty()) add_options(*chosen.front(), known);
    add_options(app, known);
    const std::string who = chosen.empty() ? app.get_name() : app.get_name() + " " + chosen.front()->get_name();
    return message(who, "option", word.substr(0, word.find('=')), known);
  }
  if (!chosen.empty()) {
    const std::string& name = chosen.front()->get_name();
    const auto command = std::ranges::find(commands, name, &Subcommand::name);
    if (command == commands.end() || command->stray.empty()) return std::nullopt;
    return app.get_name() + " " + name + ": unexpected '" + word + "'; " + command->stray;
  }
  if (word.starts_with("-")) return std::nullopt;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    known.push_back(command->get_name());
  }
  return message(app.get_name(), "command", word, known);
}

}  // namespace armature::cosim
