#include "cosim/scenario/keys/key_context.hpp"

#include <algorithm>

#include "cosim/programs/program_name.hpp"
#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

namespace {

bool sends(const Scenario& scenario, ProgramLanguage language) {
  return scenario.pendant && std::ranges::any_of(scenario.pendant->steps, [language](const PendantStepSpec& step) {
           return sends_program(step) && program_language(step.file) == language;
         });
}

// The key `program`, or the pendant, has a program in this language. A live pendant may send any: it comes in place of
// steps, and those that send no program do not say which.
bool has_program(const Scenario& scenario, ProgramLanguage language) {
  if (scenario.program && program_language(*scenario.program) == language) return true;
  return scenario.pendant && (sends(scenario, language) || !sends_program(*scenario.pendant));
}

}  // namespace

bool KeyContext::has(Needs needs) const {
  switch (needs) {
    case Needs::kKinematics:
      return !robot.lacks_kinematics();
    case Needs::kPaper:
      return paper_keys;
    case Needs::kSerial:
      return scenario != nullptr && scenario->serial;
    case Needs::kProgram:
      return scenario != nullptr && (scenario->program || (scenario->pendant && sends_program(*scenario->pendant)));
    case Needs::kGcode:
      return scenario != nullptr && has_program(*scenario, ProgramLanguage::kGcode);
    case Needs::kJob:
      return scenario != nullptr && has_program(*scenario, ProgramLanguage::kJob);
    case Needs::kFlops:
      return scenario != nullptr && scenario->engine == Engine::kRtl;
    case Needs::kMemory:
      return scenario != nullptr && processor.value_or(scenario->cpu.processor) == CpuKind::kA9 && scenario->cpu.cpi;
    case Needs::kNothing:
      break;
  }
  return true;
}

std::string KeyContext::lack_of(Needs needs) const {
  return has(needs) ? std::string{} : "needs " + needs_text(needs, robot.file, "");
}

}  // namespace armature::cosim
