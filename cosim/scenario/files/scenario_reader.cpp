#include "cosim/scenario/files/scenario_reader.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "cosim/scenario/tables/tables.hpp"

namespace armature::cosim {
namespace {

// Reports each [[input]] that does not change its pin. `inputs` were read without a problem, in the order of the file.
void require_changes(TableReader& root, const std::vector<InputSpec>& inputs) {
  std::size_t index = 0;
  root.tables("input", [&](TableReader& table) {
    table.ignore_rest();
    const InputSpec& input = inputs[index++];
    const InputSpec* before = nullptr;
    for (const InputSpec& other : inputs) {
      const bool earlier = other.at_s < input.at_s || (other.at_s == input.at_s && &other < &input);
      if (other.pin == input.pin && earlier && (before == nullptr || other.at_s >= before->at_s)) before = &other;
    }
    const std::string pin = "pin " + std::to_string(input.pin);
    if (before != nullptr && before->at_s == input.at_s) {
      table.problem("at_s", "line " + std::to_string(before->line) + " changes " + pin + " at the same time");
    } else if (input.level == (before != nullptr && before->level)) {
      table.problem("level", "has no effect, " + pin + " is " + (input.level ? "high" : "low") + " already");
    }
  });
}

// What a pendant decides cannot be left to the program.
void require_no_pendant(TableReader& root, const Scenario& scenario) {
  if (!scenario.pendant) return;
  if (scenario.ends_with_program) root.problem("duration_s", "missing, needed with [pendant]");
  if (scenario.program_resumes_after_s) {
    root.problem("program_resumes_after_s", "not allowed with [pendant]: the operator resumes the program");
  }
}

template <class Spec>
void sort_by_time(std::vector<Spec>& specs) {
  std::stable_sort(specs.begin(), specs.end(), [](const Spec& a, const Spec& b) { return a.at_s < b.at_s; });
}

}  // namespace

std::vector<std::string_view> read_scenario_keys(TableReader& root, Scenario& scenario) {
  scenario.ends_with_program = root.has("program") && !root.has("duration_s");
  if (scenario.ends_with_program) scenario.duration_s = kLongestProgramRunS;
  return scenario_keys().read_keys(root, {.scenario = &scenario}, scenario);
}

void read_scenario_tables(TableReader& root, const std::vector<std::string_view>& bad, const ScenarioRobot& robot,
                          const LogicChoice& chosen, std::optional<CpuKind> processor, Scenario& scenario) {
  KeyContext context{.robot = robot, .scenario = &scenario, .processor = processor};
  const Variant written = scenario.variant;
  scenario.variant = chosen.variant.value_or(written);
  scenario.engine = chosen.engine.value_or(scenario.engine);
  context.paper_keys = scenario.variant == Variant::kPaper || written == Variant::kPaper;

  scenario_keys().count_elements(bad, root, context, scenario);
  scenario_keys().read_tables(root, context, scenario);
  scenario.cpu.processor = processor.value_or(scenario.cpu.processor);
  if (scenario.pendant && !scenario.serial) scenario.serial.emplace();
  require_no_pendant(root, scenario);
  if (scenario.variant == Variant::kPaper) scenario.controller.feedback = false;
  scenario.expect.file = scenario.file;
  for (std::size_t i = 0; i < scenario.moves.size(); ++i) scenario.moves[i].index = static_cast<std::uint32_t>(i);
  for (std::size_t i = 0; i < scenario.streams.size(); ++i) scenario.streams[i].index = i;
  if (root.problem_count() == 0) require_changes(root, scenario.inputs);
  root.finish();
  sort_by_time(scenario.moves);
  sort_by_time(scenario.streams);
  sort_by_time(scenario.faults);
  sort_by_time(scenario.serial_sends);
  sort_by_time(scenario.inputs);
}

}  // namespace armature::cosim
