// What a command prints on the standard output: text for people, nothing, or JSON for programs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace CLI {
class App;
}

namespace armature::cosim {

struct OutputOptions {
  bool quiet = false;
  bool json = false;  // not with quiet
};

// Adds --quiet; `options` must outlive the parsing, here and below.
void add_quiet_option(CLI::App& command, OutputOptions& options);
// Adds --json. Call it after add_quiet_option(), if the command has both.
void add_json_option(CLI::App& command, OutputOptions& options);

// Prints a document on the standard output. Bytes of names that are no UTF-8 are replaced.
void print_json(const nlohmann::ordered_json& document);

// The text with its first word in green or red if that is a verdict, such as PASSED or FAIL, and if the standard output
// is a terminal. Without colours if the variable NO_COLOR is not empty, or TERM is `dumb`.
[[nodiscard]] std::string with_color(const std::string& text);

}  // namespace armature::cosim
