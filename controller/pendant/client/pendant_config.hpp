// What a scenario states about the teach pendant.
#pragma once

#include "controller/language/gcode/run/motion_setup.hpp"
#include "controller/language/job/state/machine_setup.hpp"
#include "controller/pendant/protocol/admission.hpp"

namespace armature::pendant {

struct PendantConfig {
  Profile profile = Profile::kStrict;
  bool paper_logic = false;
  // Of the programs that the pendant sends.
  job::MachineSettings job{};
  gcode::MotionSettings gcode{};
};

}  // namespace armature::pendant
