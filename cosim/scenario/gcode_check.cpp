#include "cosim/scenario/gcode_check.hpp"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "controller/language/gcode/canon_interpreter.hpp"
#include "controller/language/gcode/motion_commands.hpp"
#include "controller/language/gcode/program_runner.hpp"
#include "controller/language/gcode/source_line.hpp"
#include "cosim/scenario/keys/toml_text.hpp"
#include "cosim/scenario/to_controller.hpp"

namespace armature::cosim {
namespace {

using gcode::CanonInterpreter;

constexpr int kMostErrors = 20;  // of a file, for each of which the program is executed again

// What the arm cannot do, by lines.
class MotionCheck final : public gcode::CanonSink {
 public:
  MotionCheck(const gcode::MotionSetup& setup, ProblemList& problems) : commands_{setup}, problems_{problems} {}

  void begin() { commands_.begin({}); }
  void on_call(const gcode::CanonCall& call, std::uint32_t line) noexcept override {
    const auto problem = commands_.convert(call);
    if (!problem || !lines_.insert(line).second) return;
    // The motions that follow have the same A, B and C.
    if (*problem == gcode::MotionProblem::kTurnNotAllowed && std::exchange(turns_, true)) return;
    problems_.add({.line = static_cast<int>(line), .column = 0, .override_text = {}}, "",
                  std::string{gcode::text_of(*problem)});
  }

 private:
  gcode::MotionCommands commands_;
  ProblemList& problems_;
  std::set<std::uint32_t> lines_;  // with a problem
  bool turns_ = false;             // reported
};

// Executes the program up to its end, its first error, or a place behind which it cannot be checked.
CanonInterpreter::State execute(CanonInterpreter& interpreter, std::string_view program) {
  using State = CanonInterpreter::State;
  State state = interpreter.begin(program, {});
  for (std::int64_t lines = 0; lines < gcode::ProgramRunner::kMostChecked; ++lines) {
    if (state == State::kStopped) interpreter.resume();
    if (state != State::kRunning && state != State::kStopped) break;
    state = interpreter.step();
  }
  return state;
}

// What to change in the scenario, if that is where the program is right.
std::string advice(const gcode::Error& error, const Scenario& scenario) {
  if (error.code != gcode::ErrorCode::kToolUnknown) return {};
  std::vector<std::int64_t> tools = scenario.gcode.tools;
  tools.push_back(error.tenths / 10);
  return "; set tools = " + toml_text(tools) + " in [gcode]";
}

// Puts blanks in place of a line, from 1.
void blank_line(std::string& program, std::uint32_t line) {
  std::size_t begin = 0;
  for (std::uint32_t before = 1; before < line; ++before) begin = gcode::line_at(program, begin).next;
  const gcode::LineSpan span = gcode::line_at(program, begin);
  std::fill(program.begin() + static_cast<std::ptrdiff_t>(span.begin),
            program.begin() + static_cast<std::ptrdiff_t>(span.end), ' ');
}

}  // namespace

void check_gcode(const Scenario& scenario, std::vector<Problem>& all) {
  const ProgramFile& file = scenario.program_files.front();
  ProblemList problems{file.file};
  const RobotModel robot = to_robot_model(scenario.robot);
  const Arm arm{robot};
  const gcode::MotionSetup setup = to_gcode_setup(scenario, robot, arm);
  MotionCheck motion{setup, problems};
  std::string program = file.text;
  std::set<std::uint32_t> lines;  // with an error
  for (int errors = 0; errors < kMostErrors; ++errors) {
    const auto interpreter = std::make_unique<CanonInterpreter>(motion);
    interpreter->executor().add_tools(setup.settings.tools);
    motion.begin();
    if (execute(*interpreter, program) != CanonInterpreter::State::kFailed) break;
    const gcode::Error& error = interpreter->error();
    if (!lines.insert(error.line).second) break;
    problems.add({.line = static_cast<int>(error.line), .column = error.column, .override_text = {}}, "",
                 std::string{gcode::message_of(error).view()} + advice(error, scenario));
    blank_line(program, error.line);
  }
  problems.move_to(all);
}

}  // namespace armature::cosim
