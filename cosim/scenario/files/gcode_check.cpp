#include "cosim/scenario/files/gcode_check.hpp"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "controller/language/gcode/flow/canon_interpreter.hpp"
#include "controller/language/gcode/reader/source_line.hpp"
#include "controller/language/gcode/run/motion_commands.hpp"
#include "controller/language/gcode/run/program_runner.hpp"
#include "cosim/programs/gcode_files.hpp"
#include "cosim/scenario/keys/toml_text.hpp"
#include "cosim/scenario/to_controller.hpp"

namespace armature::cosim {
namespace {

using gcode::CanonInterpreter;

constexpr int kMaxErrors = 20;  // of a file, for each of which the program is executed again

// The problems of a program, each in its file.
class ProgramProblems {
 public:
  explicit ProgramProblems(const std::vector<ProgramFile>& files) : lines_{files} {
    for (const ProgramFile& file : files) lists_.emplace_back(file.file);
  }
  void add(std::uint32_t line, int column, std::string message) {
    const GcodeLine at = lines_.at(line);
    lists_[at.file].add({.line = static_cast<int>(at.line), .column = column, .override_text = {}}, "",
                        std::move(message));
  }
  void move_to(std::vector<Problem>& all) {
    for (ProblemList& list : lists_) list.move_to(all);
  }

 private:
  GcodeLines lines_;
  std::vector<ProblemList> lists_;
};

// What the arm cannot do, by lines.
class MotionCheck final : public gcode::CanonSink {
 public:
  MotionCheck(const gcode::MotionSetup& setup, ProgramProblems& problems) : commands_{setup}, problems_{problems} {}

  void begin() { commands_.begin({}); }
  void on_call(const gcode::CanonCall& call, std::uint32_t line) noexcept override {
    const auto problem = commands_.convert(call);
    if (!problem || !found_.emplace(line, *problem).second) return;
    // The motions that follow have the same A, B and C.
    if (*problem == gcode::MotionProblem::kTurnNotAllowed && std::exchange(turns_, true)) return;
    problems_.add(line, 0, std::string{gcode::text_of(*problem)});
  }

 private:
  gcode::MotionCommands commands_;
  ProgramProblems& problems_;
  std::set<std::pair<std::uint32_t, gcode::MotionProblem>> found_;  // each is reported once for a line
  bool turns_ = false;                                              // reported
};

// Executes the program up to its end, its first error, or a place behind which it cannot be checked.
CanonInterpreter::State execute(CanonInterpreter& interpreter, const gcode::ProgramText& program) {
  using State = CanonInterpreter::State;
  State state = interpreter.begin(program, {});
  for (std::int64_t lines = 0; lines < gcode::ProgramRunner::kMaxChecked; ++lines) {
    if (state == State::kStopped) interpreter.resume();
    if (state != State::kRunning && state != State::kStopped) break;
    state = interpreter.step();
  }
  return state;
}

// The tool that only the scenario lacks.
std::optional<std::int64_t> missing_tool(const gcode::Error& error) {
  if (error.code != gcode::ErrorCode::kToolUnknown) return std::nullopt;
  return error.tenths / 10;
}

}  // namespace

void check_gcode(const Scenario& scenario, std::vector<Problem>& all) {
  ProgramProblems problems{scenario.program_files};
  const RobotModel robot = to_robot_model(scenario.robot);
  const Arm arm{robot};
  const gcode::MotionSetup setup = to_gcode_setup(scenario, robot, arm);
  MotionCheck motion{setup, problems};
  JoinedGcode program{scenario.program_files};
  std::set<std::uint32_t> lines;  // with an error
  std::vector<std::int64_t> tools = scenario.gcode.tools;
  for (int errors = 0; errors < kMaxErrors; ++errors) {
    const auto interpreter = std::make_unique<CanonInterpreter>(motion);
    gcode::ToolNumbers numbers;
    for (const std::int64_t tool : tools) numbers.set(static_cast<std::size_t>(tool));
    interpreter->executor().tools().add(numbers);
    motion.begin();
    if (execute(*interpreter, program.text()) != CanonInterpreter::State::kFailed) break;
    const gcode::Error& error = interpreter->error();
    if (error.code == gcode::ErrorCode::kAborted) break;  // what the program does, and no error of its text
    std::string message{gcode::message_of(error).view()};
    if (const std::optional<std::int64_t> tool = missing_tool(error)) {
      // With this tool the rest of the line can be checked.
      tools.push_back(*tool);
      problems.add(error.line, error.column, message + "; set tools = " + toml_text(tools) + " in [gcode]");
      continue;
    }
    if (!lines.insert(error.line).second) break;
    problems.add(error.line, error.column, std::move(message));
    program.blank_line(error.line);
  }
  problems.move_to(all);
}

}  // namespace armature::cosim
