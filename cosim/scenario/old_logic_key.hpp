// The key `fabric`, which `variant` and `engine` have replaced.
#pragma once

#include "cosim/scenario/config_value.hpp"

namespace armature::cosim {

// Reports the key in the document of a scenario, with the key to write instead. The document then has what was meant,
// so that its other keys are checked with it.
void refuse_old_logic_key(ConfigValue& root, ProblemList& problems);

}  // namespace armature::cosim
