#include "cosim/report/judge/run_summary.hpp"

#include "cosim/scenario/command_names.hpp"
#include "cosim/scenario/program_frame.hpp"
#include "cosim/text/version.hpp"

namespace armature::cosim {

bool RunSummary::has(FactGroup group) const {
  switch (group) {
    case FactGroup::kPaper:
      return variant == Variant::kPaper;
    case FactGroup::kSerial:
      return !facts.serial_sent.empty() || facts.serial_errors > 0;
    case FactGroup::kOutputs:
      return !facts.outputs.empty();
    case FactGroup::kInstructions:
      return facts.counts_instructions();
    case FactGroup::kProgram:
      return facts.names.has_program();
    case FactGroup::kResult:
    case FactGroup::kEvents:
      break;
  }
  return true;
}
double RunSummary::cycles_per_s() const {
  return host.wall_s > 0 ? static_cast<double>(facts.cycles.value()) / host.wall_s : 0;
}
double RunSummary::real_time_factor() const {
  return host.wall_s > 0 ? facts.simulated_s() / host.wall_s : 0;
}

RunSummary summary_before_run(const Scenario& scenario) {
  RunSummary summary;
  summary.scenario = scenario.name;
  summary.description = scenario.description;
  summary.robot = scenario.robot_name;
  summary.tool_version = version();
  summary.arm = scenario.robot;
  summary.tool = scenario.tool;
  summary.frames = scenario.frames;
  summary.program_frame = program_frame(scenario);
  summary.sources = scenario.sources;
  summary.overrides = scenario.overrides;
  summary.seed = scenario.seed;
  summary.variant = scenario.variant;
  summary.engine = scenario.engine;
  const CommandNames names{scenario};
  summary.facts = RunFactsCollector{scenario.robot, scenario.expect.settled_counts, scenario.conveyor, names}.facts();
  summary.interrupted = true;
  return summary;
}

}  // namespace armature::cosim
