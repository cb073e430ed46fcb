// The commands and options of the program as data: what the man page and the completion of shells are made from. It is
// read from the parser of the command line, so it has every option that the program accepts.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace armature::cosim {

struct OptionRow {
  std::vector<std::string> names{};  // `--jobs`, `-j`; of an argument without an option: its name alone
  bool positional = false;           // such an argument
  bool required = false;
  int most_values = 0;               // 0: a flag
  std::string kind;                  // of a value: see value_kinds.hpp, or a type such as `INT`
  std::vector<std::string> choices;  // the words that a value can be; empty: any
  std::string description;
};

struct CommandRow {
  std::string name;
  std::string summary;
  std::string details;               // examples and text below the options
  std::vector<OptionRow> options{};  // arguments first; without --help, which every command has
};

// The program itself: its name, its text, and the options that every command has.
[[nodiscard]] CommandRow program_row(const CLI::App& program);
// The commands, in the order of `armature --help`.
[[nodiscard]] std::vector<CommandRow> command_rows(const CLI::App& program);

}  // namespace armature::cosim
