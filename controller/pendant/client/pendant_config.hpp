// What a scenario states about the teach pendant.
#pragma once

#include "controller/base/members.hpp"
#include "controller/pendant/protocol/admission.hpp"

namespace armature::pendant {

struct PendantConfig {
  Profile profile = Profile::kStrict;
  bool paper_logic = false;
  ARMATURE_MEMBERS(PendantConfig, profile, paper_logic)
};

}  // namespace armature::pendant
