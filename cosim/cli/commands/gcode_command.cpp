#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "controller/language/gcode/flow/canon_interpreter.hpp"
#include "controller/language/gcode/reader/code_table.hpp"
#include "cosim/cli/command/command.hpp"
#include "cosim/cli/options/action_argument.hpp"
#include "cosim/cli/options/kinematics_io.hpp"
#include "cosim/cli/texts/canon_text.hpp"
#include "cosim/programs/gcode_files.hpp"
#include "cosim/text/input_error.hpp"
#include "cosim/text/number_text.hpp"
#include "cosim/text/printable.hpp"

namespace armature::cosim {
namespace {

constexpr const char* kGcodeDetails = R"(Examples:
  armature gcode codes
  printf 'G21 G90 F600\nG1 X10 Y5\nG2 X20 I5\nM2\n' | armature gcode canon -
  printf 'G1 X10 F#<_rate>\nM2\n' | armature gcode --define _rate=250 canon -
  printf 'G1 X10 F600\nM2\n' | armature gcode -
  printf 'G41 D1\n' | armature gcode check - 2>&1   # exits with 2: G41 is not supported

check   executes programs and reports the first error of each, as file:line:column
canon   executes programs and prints their canonical calls, as `rs274 -g` of LinuxCNC does
codes   prints the table of all codes
Programs are in the language RS274/NGC, as LinuxCNC has it. M0, M1 and M60 do not stop, and M66 reads 0. A subroutine
that is not in the program comes from the file NAME.ngc beside it: 100.ngc for M98 P100, probe.ngc for O<probe> CALL.
Exit code: 0 ok, 2 bad input.)";

constexpr const char* kCheck = "check";
constexpr const char* kCanon = "canon";
constexpr const char* kCodes = "codes";

struct GcodeOptions {
  ActionArguments what{.actions = {kCheck, kCanon, kCodes}, .fileless = {kCodes}};
  bool block_delete = false;
  std::vector<std::string> define;
  std::vector<int> tool;
  std::int64_t most_lines = 10'000'000;
};

// A number of the command line; the whole text.
double parse_define(const std::string& define, std::string_view text) {
  const std::optional<double> value = parsed_number<double>(text);
  if (!value || !std::isfinite(*value)) throw InputError("--define " + define, "expected NAME=NUMBER");
  return *value;
}

// A program with the files of its subroutines, which stand beside it.
class ProgramInput {
 public:
  explicit ProgramInput(const std::string& file) {
    TextInput input = read_input(file);
    files_.push_back({.name = input.name, .file = input.name, .text = std::move(input.text)});
    if (file == "-") return;
    const std::filesystem::path folder = std::filesystem::path{file}.parent_path();
    read_subroutines(files_, folder, [this](const std::filesystem::path& found) {
      files_.push_back({.name = found.string(), .file = found.string(), .text = read_input(found.string()).text});
    });
  }

  [[nodiscard]] const std::string& name() const { return files_.front().name; }
  [[nodiscard]] JoinedGcode joined() const { return JoinedGcode{files_}; }
  // `file:12:3:`, or `file:12:` for a line as a whole.
  [[nodiscard]] std::string place(std::uint32_t line, int column) const {
    const GcodeLine at = GcodeLines{files_}.at(line);
    std::string text = fmt::format("{}:{}:", printable(files_[at.file].name, kShowAll), at.line);
    if (column > 0) fmt::format_to(std::back_inserter(text), "{}:", column);
    return text;
  }
  // `file:12:3: G41: the code is not supported`
  [[nodiscard]] std::string error_text(const gcode::Error& error) const {
    std::string text = place(error.line, error.column).append(" ").append(gcode::message_of(error).view());
    if (error.code == gcode::ErrorCode::kToolUnknown) {
      text += fmt::format("; name it with --tool {}", error.tenths / 10);
    }
    return text;
  }

 private:
  std::vector<ProgramFile> files_;
};

void print_codes() {
  std::cout << fmt::format("{:<6} {:<19} {:<6} {}\n", "code", "group", "words", "meaning");
  for (const gcode::CodeInfo& info : gcode::code_table()) {
    std::string code = fmt::format("{}{}", gcode::to_upper(info.letter), info.tenths / 10);
    if (info.tenths % 10 != 0) code += fmt::format(".{}", info.tenths % 10);
    std::string words;
    for (const char letter : info.words) words += gcode::to_upper(letter);
    std::cout << fmt::format("{:<6} {:<19} {:<6} {}\n", code, gcode::name_of(info.group), words, info.meaning);
  }
}

// Makes calls and forgets them.
class SilentCanon final : public gcode::CanonSink {
 public:
  void on_call(const gcode::CanonCall&, std::uint32_t) noexcept override {}
};

void prepare(gcode::CanonInterpreter& interpreter, const GcodeOptions& given) {
  for (const int tool : given.tool) interpreter.executor().tools().add(tool, {});
  for (const std::string& define : given.define) {
    const std::size_t equal = define.rfind('=');
    const std::string_view name = std::string_view{define}.substr(0, std::min(equal, define.size()));
    if (equal == std::string::npos || name.empty() || name.front() != '_') {
      throw InputError("--define " + define, "expected NAME=NUMBER with a name that begins with '_'");
    }
    const double value = parse_define(define, std::string_view{define}.substr(equal + 1));
    if (const auto problem = interpreter.executor().parameters().set(name, value)) {
      throw InputError("--define " + define, std::string{gcode::text_of(*problem)});
    }
  }
}

// Returns true if the program is right. Calls `flush` after each step.
template <class Flush>
bool execute(gcode::CanonInterpreter& interpreter, const ProgramInput& input, const GcodeOptions& given, Flush flush) {
  using State = gcode::CanonInterpreter::State;
  const JoinedGcode program = input.joined();
  State state = interpreter.begin(program.text(), {.block_delete = given.block_delete});
  prepare(interpreter, given);
  flush();
  for (std::int64_t steps = 0; state != State::kEnded && state != State::kFailed; ++steps) {
    if (steps == given.most_lines) {
      throw InputError(input.name(), fmt::format("the program has not ended after {} lines", given.most_lines));
    }
    interpreter.resume();
    interpreter.give_input(0.0);
    state = interpreter.step();
    flush();
  }
  if (state == State::kFailed) std::cerr << input.error_text(interpreter.error()) << '\n';
  if (state == State::kEnded && interpreter.ended_without_code()) {
    std::cerr << input.place(interpreter.line(), 0) << " note: " << gcode::CanonInterpreter::kNoEndCode << '\n';
  }
  return state == State::kEnded;
}

// Executes a program and prints its calls.
bool print_calls(const ProgramInput& input, const GcodeOptions& given) {
  CanonText calls;
  const auto interpreter = std::make_unique<gcode::CanonInterpreter>(calls);
  return execute(*interpreter, input, given, [&calls] {
    std::cout << calls.text();
    calls.clear();
  });
}

bool check_program(const ProgramInput& input, const GcodeOptions& given) {
  SilentCanon silent;
  const auto interpreter = std::make_unique<gcode::CanonInterpreter>(silent);
  return execute(*interpreter, input, given, [] {});
}

int run_gcode(const GcodeOptions& given) {
  if (given.what.action == kCodes) {
    print_codes();
    return kExitOk;
  }
  bool good = true;
  for (const std::string& file : given.what.files) {
    const ProgramInput input{file};
    good = (given.what.action == kCanon ? print_calls(input, given) : check_program(input, given)) && good;
  }
  return good ? kExitOk : kExitBadInput;
}

// What the actions were before: `--check FILE`. The help does not show them.
void add_old_options(CLI::App& app, ActionArguments& what) {
  for (const char* action : {kCheck, kCanon}) {
    app.add_option_function<std::vector<std::string>>(std::string{"--"} + action,
                                                      [&what, action](const std::vector<std::string>& files) {
                                                        what.action = action;
                                                        what.files = files;
                                                      })
        ->group("");
  }
  app.add_flag_callback(std::string{"--"} + kCodes, [&what] { what.action = kCodes; })->group("");
}

CommandAction declare_gcode(CLI::App& app) {
  const auto options = std::make_shared<GcodeOptions>();
  add_action(app, options->what, "Programs, '-' for standard input");
  add_old_options(app, options->what);
  app.add_flag("--block-delete", options->block_delete, "Skip lines that begin with '/'");
  app.add_option("--define", options->define, "NAME=NUMBER: a global parameter of the programs, such as _rate=250")
      ->allow_extra_args(false);  // one value for each --define: the next word may be a program
  app.add_option("--tool", options->tool, "Numbers of tools in the tool table")
      ->check(CLI::Range(1, gcode::kMaxTools - 1))
      ->allow_extra_args(false);
  app.add_option("--most-lines", options->most_lines, "Lines after which a program is stopped (default 10000000)")
      ->check(CLI::PositiveNumber);
  app.callback([options] { check_action(options->what); });
  return [options](const CommonOptions&) { return run_gcode(*options); };
}

}  // namespace

Subcommand gcode_command() {
  return {.name = "gcode",
          .order = 56,
          .summary = "Check G-code programs (RS274/NGC) and print their canonical calls",
          .details = kGcodeDetails,
          .declare = declare_gcode};
}

}  // namespace armature::cosim
