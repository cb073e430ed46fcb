#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "cosim/cli/command/command.hpp"
#include "cosim/cli/options/value_kinds.hpp"
#include "cosim/cli/run/interrupt.hpp"
#include "cosim/pendant/device_line.hpp"
#include "cosim/pendant/operator_desk.hpp"
#include "cosim/pendant/operator_link.hpp"
#include "cosim/pendant/screen.hpp"
#include "cosim/pendant/terminal.hpp"
#include "cosim/programs/program_name.hpp"
#include "cosim/scenario/files/pendant_file.hpp"
#include "cosim/scenario/files/robot_loader.hpp"
#include "cosim/text/input_error.hpp"
#include "cosim/text/text_file.hpp"

namespace armature::cosim {
namespace {

constexpr const char* kPendantDetails = R"(Example:
  armature pendant /tmp/arm --robot vo2021_6r 2>&1   # exits with 2: no run has this line

The other end of the line is a run in another terminal: armature run SCENARIO --serial pty:/tmp/arm --pace 1
The scenario must have [pendant]; its steps are not executed then. The screen shows what each key does.
A jog lasts while its key is held down: a terminal repeats the key, and the controller stops the arm 100 ms
after the last command. The first press lasts longer, because terminals begin to repeat late. The space bar
stops at once.
The line is no safety device. It is a serial device, a pseudo-terminal, or tcp:PORT. For a run with --serial tcp:PORT,
set the environment variable ARMATURE_TOKEN to the token that the run prints.
Exit code: 0 ended with Q, 2 bad input or a closed line, 3 internal error, 130 interrupted.)";

constexpr int kPollMs = 5;

struct PendantOptions {
  std::string line;
  std::string robot;
  std::vector<std::filesystem::path> programs;
};

OperatorProgram read_program(const std::filesystem::path& file) {
  const ProgramLanguage language = program_language(file.string());
  if (language == ProgramLanguage::kNone) {
    throw InputError{file.string(), fmt::format("expected a file that {}", kEndsLikeProgram)};
  }
  const bool gcode = language == ProgramLanguage::kGcode;
  OperatorProgram program{.name = file.filename().string(),
                          .kind = gcode ? pendant::Content::kGcode : pendant::Content::kJob,
                          .text = read_ascii_file(file, kMaxSentBytes),
                          .lines = {}};
  std::istringstream text{program.text};
  for (std::string line; std::getline(text, line);) {
    if (line.ends_with('\r')) line.pop_back();
    program.lines.push_back(line);
  }
  return program;
}

int pendant(const PendantOptions& given, const SearchPath& path) {
  std::optional<RobotSpec> robot;
  if (!given.robot.empty()) robot = find_robot(given.robot, path);
  std::vector<OperatorProgram> programs;
  for (const auto& file : given.programs) programs.push_back(read_program(file));
  std::signal(SIGPIPE, SIG_IGN);  // the next read() reports a closed line
  const char* const token = std::getenv("ARMATURE_TOKEN");
  DeviceLine line{given.line, token == nullptr ? "" : token};
  using Clock = std::chrono::steady_clock;
  const auto now = [] { return std::chrono::duration_cast<OperatorLink::Time>(Clock::now().time_since_epoch()); };
  OperatorLink link{static_cast<std::int32_t>(now().count() / 1000 % pendant::kLargestPayload)};
  OperatorDesk desk{link, robot ? &*robot : nullptr, std::move(programs)};
  Terminal terminal;
  catch_interrupts();
  constexpr OperatorLink::Time kDrawEvery{50'000};
  OperatorLink::Time drawn{-kDrawEvery};
  std::vector<std::uint8_t> out;
  while (!interrupted()) {
    link.receive(line.read(STDIN_FILENO, kPollMs));
    while (const std::optional<int> key = terminal.key()) {
      if (*key == kQuitKey) return kExitOk;
      desk.press(*key, now());
    }
    out.clear();
    link.poll(now(), out);
    line.write(out);
    if (now() - drawn < kDrawEvery) continue;
    drawn = now();
    terminal.show(screen_lines(desk, given.line, terminal.rows(), terminal.columns()));
  }
  return kExitInterrupted;
}

CommandAction declare_pendant(CLI::App& app) {
  const auto options = std::make_shared<PendantOptions>();
  app.add_option("line", options->line, "Serial device, pseudo-terminal or tcp:PORT")
      ->required()
      ->type_name(kFileValue);
  app.add_option("--robot", options->robot, "Robot, for positions in degrees: a name or a .toml file")
      ->type_name(kRobotValue);
  app.add_option("--program", options->programs, "Program to load and run, .jbi, .ngc, .nc or .gcode. May be repeated")
      ->type_name(kFileValue)
      ->allow_extra_args(false);
  return [options](const CommonOptions& common) { return pendant(*options, common.search_path()); };
}

}  // namespace

Subcommand pendant_command() {
  return {.name = "pendant",
          .order = 45,
          .summary = "Teach pendant in this terminal, at a serial line",
          .details = kPendantDetails,
          .declare = declare_pendant};
}

}  // namespace armature::cosim
