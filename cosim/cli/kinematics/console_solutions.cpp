#include "cosim/cli/kinematics/console_solutions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

#include "controller/base/angle_units.hpp"
#include "cosim/console/inverse_run.hpp"
#include "cosim/cpu/make_processor.hpp"
#include "cosim/text/input_error.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

constexpr double kCpi = 1.5;

// Reads words in their order.
class Words {
 public:
  explicit Words(std::string_view text) : stream_{std::string{text}} {}
  template <class Value>
  void take(Value& value) {
    if (!(stream_ >> value)) fail();
  }
  // A number behind a word that says what it is.
  template <class Value>
  void take(std::string_view name, Value& value) {
    std::string word;
    take(word);
    if (word != name) fail();
    int number = 0;
    take(number);
    value = static_cast<Value>(number);
  }
  // `angle1=-1.5`
  void take_angle(std::size_t axis, Radians& angle) {
    std::string word;
    take(word);
    const std::string name = fmt::format("angle{}=", axis + 1);
    if (!word.starts_with(name)) fail();
    char* end = nullptr;
    angle = Radians{std::strtod(word.c_str() + name.size(), &end) * kRadPerDeg};
    if (*end != '\0') fail();
  }
  void end() {
    if (std::string word; stream_ >> word) fail();
  }
  [[noreturn]] static void fail() { throw std::runtime_error{"the text of the console is not that of a solved pose"}; }

 private:
  std::istringstream stream_;
};

InverseRun run_on(CpuKind kind, const ArmOfFile& robot, const InverseTask& task) {
  CpuSpec cpu;
  cpu.processor = kind;
  if (kind == CpuKind::kA9) cpu.cpi = kCpi;
  return run_inverse(robot.model, task, cpu);
}

}  // namespace

IkSolutions parse_console(std::string_view text, const IkSolutions& host, std::size_t axes) {
  Words words{text};
  IkSolutions solutions = host;
  words.take("solutions", solutions.count);
  if (solutions.count > IkSolutions::kMax) Words::fail();
  words.take("status", solutions.status);
  words.take("selected", solutions.selected);
  if (solutions.selected >= static_cast<int>(solutions.count)) Words::fail();
  for (std::size_t i = 0; i < solutions.count; ++i) {
    IkBranch& branch = solutions.branches[i];
    std::size_t index = 0;
    words.take("branch", index);
    if (index != i) Words::fail();
    words.take("shoulder", branch.shoulder);
    words.take("elbow", branch.elbow);
    words.take("flip", branch.flip);
    words.take("singular", branch.singular);
    words.take("clamped", branch.clamped);
    for (std::size_t axis = 0; axis < axes; ++axis) words.take_angle(axis, branch.joints[axis]);
  }
  words.end();
  return solutions;
}

ConsoleSolutions solve_on_a9(const ArmOfFile& robot, const Transform& base_T_flange, const JointAngles& previous) {
  if (!is_provided(CpuKind::kA9)) {
    throw InputError{"--on a9",
                     "this program executes no ARM instructions; expected host or cordic, or the program "
                     "armature-iss (tools/iss)"};
  }
  const InverseTask task{.base_T_flange = base_T_flange, .previous = previous};
  const InverseRun run = run_on(CpuKind::kA9, robot, task);
  if (const std::string text = run_on(CpuKind::kHost, robot, task).text; run.text != text) {
    throw std::runtime_error{
        fmt::format("the firmware shows\n{}and the same controller on the host\n{}", run.text, text)};
  }
  const IkSolutions host = robot.arm.inverse(base_T_flange, previous);
  ConsoleSolutions found;
  found.console = run.text;
  found.instructions = run.instructions;
  found.clocks = run.clocks;
  std::erase(found.console, '\r');
  found.solutions = parse_console(found.console, host, robot.spec.axis_count);
  found.difference = difference(found.solutions, host, robot.model);
  return found;
}

void ConsoleSolutions::add_to(nlohmann::ordered_json& json) const {
  json["console"] = console;
  json["instructions"] = instructions;
  json["clocks"] = clocks.value();
  json["cpi"] = kCpi;
  json["difference_pulses"] = difference.pulses;
  json["other_branches"] = difference.other_branches;
}

std::string ConsoleSolutions::text() const {
  std::string text = fmt::format("console of the firmware, from the pin of its serial line:\n{}", console);
  text +=
      fmt::format("by core 1 of the Cortex-A9: {} instructions, {} clocks ({:.2f} us) at {} clocks of 667 MHz each\n",
                  instructions, clocks.value(), to_seconds(clocks) * 1e6, kCpi);
  if (solutions.count > 0) {
    text += fmt::format("largest difference from the host: {:.4f} pulses\n", difference.pulses);
  }
  text += "the controller that is compiled for the host shows the same text, byte for byte\n";
  return text;
}

}  // namespace armature::cosim
