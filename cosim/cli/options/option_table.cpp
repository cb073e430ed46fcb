#include "cosim/cli/options/option_table.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>

namespace armature::cosim {
namespace {

// The words of `TEXT:{counts,paper}`: the type of a value that must be one of them.
std::vector<std::string> choices_of(std::string_view type) {
  std::vector<std::string> choices;
  const std::size_t begin = type.find('{');
  const std::size_t end = type.find('}');
  if (begin == std::string_view::npos || end == std::string_view::npos) return choices;
  std::string_view rest = type.substr(begin + 1, end - begin - 1);
  while (true) {
    const std::size_t comma = rest.find(',');
    choices.emplace_back(rest.substr(0, comma));
    if (comma == std::string_view::npos) return choices;
    rest.remove_prefix(comma + 1);
  }
}

// How many values follow the option where it is written. An option that is repeated for each of its values takes one.
int most_values(const CLI::Option& option) {
  const int most = option.get_items_expected_max();
  const bool one_each = !option.get_positional() && !option.get_allow_extra_args();
  return one_each && most >= CLI::detail::expected_max_vector_size ? 1 : most;
}

OptionRow option_row(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  OptionRow row{.positional = option.get_positional(),
                .required = option.get_required(),
                .most_values = most_values(option),
                .kind = type.substr(0, type.find(':')),
                .choices = choices_of(type),
                .description = option.get_description()};
  if (row.positional) row.names.push_back(option.get_name(true, false));
  for (const std::string& name : option.get_lnames()) row.names.push_back("--" + name);
  for (const std::string& name : option.get_snames()) row.names.push_back("-" + name);
  return row;
}

CommandRow command_row(const CLI::App& app) {
  CommandRow command{.name = app.get_name(), .summary = app.get_description(), .details = app.get_footer()};
  for (const CLI::Option* option : app.get_options()) {
    const bool hidden = option->get_group().empty();
    if (!hidden && option != app.get_help_ptr()) command.options.push_back(option_row(*option));
  }
  std::stable_partition(command.options.begin(), command.options.end(),
                        [](const OptionRow& row) { return row.positional; });
  return command;
}

}  // namespace

CommandRow program_row(const CLI::App& program) {
  return command_row(program);
}

std::vector<CommandRow> command_rows(const CLI::App& program) {
  std::vector<CommandRow> rows;
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
    rows.push_back(command_row(*command));
  }
  return rows;
}

}  // namespace armature::cosim
