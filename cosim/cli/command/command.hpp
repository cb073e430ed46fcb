// A subcommand of the program `armature`, as its file declares it.
//
// Each file cli/NAME_command.cpp defines one function, `Subcommand NAME_command()`. The build finds these files and
// generates commands(), so no list has to name a new command.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cosim/cli/command/data_path.hpp"

namespace CLI {
class App;
}

namespace armature::cosim {

// The exit codes of the program.
inline constexpr int kExitOk = 0;
inline constexpr int kExitCheckFailed = 1;  // golden, expectation, invariant
inline constexpr int kExitBadInput = 2;
inline constexpr int kExitInternal = 3;
inline constexpr int kExitInterrupted = 130;

// The values of the options that every command has.
struct CommonOptions {
  std::vector<std::string> path;  // --path

  // Where bare names of scenarios and robots are looked up. Throws InputError when a folder that was named is missing.
  [[nodiscard]] SearchPath search_path() const { return data_path(path); }
};

// Runs a command after its options were parsed. Returns the exit code. Reports bad input by throwing InputError.
using CommandAction = std::function<int(const CommonOptions& common)>;

struct Subcommand {
  std::string name;     // as the user types it
  int order = 0;        // in the list of `armature --help`: ascending; commands of equal order by name
  std::string summary;  // its line in that list
  std::string details;  // below the options in `armature NAME --help`: examples, what it does, exit codes
  std::string stray{};  // advice for words that are neither options nor arguments: how such values are given
  // Adds the options to `app`, once, before parsing. The action that it returns must own the variables into which the
  // parser stores values. A check of several options belongs in the callback of `app` and throws
  // CLI::ValidationError.
  std::function<CommandAction(CLI::App& app)> declare;
};

// All commands, in the order of `armature --help`.
[[nodiscard]] std::vector<Subcommand> commands();

}  // namespace armature::cosim
