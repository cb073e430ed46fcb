#include "cosim/scenario/keys/key_context.hpp"

#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

std::string KeyContext::lack_of(Needs needs) const {
  switch (needs) {
    case Needs::kKinematics:
      return robot.lacks_kinematics() ? "needs [kinematics] in " + robot.file : "";
    case Needs::kPaper:
      return paper_keys ? "" : "needs variant = \"paper\"";
    case Needs::kSerial:
      return scenario != nullptr && scenario->serial ? "" : "needs a table [serial]";
    case Needs::kNothing:
      break;
  }
  return {};
}

}  // namespace armature::cosim
