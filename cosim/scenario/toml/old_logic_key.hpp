// The key `fabric`, which `variant` and `engine` have replaced.
#pragma once

#include "cosim/scenario/toml/config_value.hpp"

namespace armature::cosim {

// Reports the key in the document of a scenario, with the key to write instead. The function then writes the
// intended variant into the document, so that the other keys are checked with it.
void refuse_old_logic_key(ConfigValue& root, ProblemList& problems);

}  // namespace armature::cosim
