#include "cosim/cli/options/output_options.hpp"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cstdlib>
#include <iostream>
#include <string_view>
#include <utility>

namespace armature::cosim {
namespace {

constexpr const char* kGreen = "\x1b[32m";
constexpr const char* kRed = "\x1b[31m";
constexpr const char* kNoColor = "\x1b[0m";
constexpr std::array<std::pair<std::string_view, const char*>, 4> kVerdicts{
    {{"PASSED", kGreen}, {"PASS", kGreen}, {"FAILED", kRed}, {"FAIL", kRed}}};

bool has_value(const char* variable) {
  const char* const value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

bool has_colors() {
  const char* const terminal = std::getenv("TERM");
  const bool dumb = terminal == nullptr || std::string_view{terminal} == "dumb";
  return !dumb && !has_value("NO_COLOR") && isatty(STDOUT_FILENO) == 1;
}

}  // namespace

void add_quiet_option(CLI::App& command, OutputOptions& options) {
  command.add_flag("-q,--quiet", options.quiet, "Print only what failed");
}

void add_json_option(CLI::App& command, OutputOptions& options) {
  CLI::Option* const json = command.add_flag("--json", options.json, "Print the result as JSON, for programs");
  if (CLI::Option* const quiet = command.get_option_no_throw("--quiet")) json->excludes(quiet);
}

void print_json(const nlohmann::ordered_json& document) {
  constexpr int kIndent = 2;
  std::cout << document.dump(kIndent, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
}

std::string with_color(const std::string& text) {
  if (!has_colors()) return text;
  for (const auto& [word, color] : kVerdicts) {
    if (text.starts_with(std::string{word} + ' ')) {
      return color + std::string{word} + kNoColor + text.substr(word.size());
    }
  }
  return text;
}

}  // namespace armature::cosim
