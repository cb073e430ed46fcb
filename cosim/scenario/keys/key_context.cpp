#include "cosim/scenario/keys/key_context.hpp"

#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

bool KeyContext::has(Needs needs) const {
  const bool program = scenario != nullptr && scenario->program;
  switch (needs) {
    case Needs::kKinematics:
      return !robot.lacks_kinematics();
    case Needs::kPaper:
      return paper_keys;
    case Needs::kSerial:
      return scenario != nullptr && scenario->serial;
    case Needs::kProgram:
      return program || (scenario != nullptr && scenario->pendant && !sent_program(*scenario->pendant).empty());
    case Needs::kGcode:
      return program && program_language(*scenario->program) == ProgramLanguage::kGcode;
    case Needs::kJob:
      return program && program_language(*scenario->program) == ProgramLanguage::kJob;
    case Needs::kNothing:
      break;
  }
  return true;
}

std::string KeyContext::lack_of(Needs needs) const {
  return has(needs) ? std::string{} : "needs " + needs_text(needs, robot.file, "");
}

}  // namespace armature::cosim
