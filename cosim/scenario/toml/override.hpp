// `--set key=value`: changes one value of a parsed file before it is checked.
#pragma once

#include <string>

#include "cosim/scenario/toml/config_value.hpp"

namespace armature::cosim {

// `assignment` is `dotted.key=value`, with `[n]` (from 0) for an element of an array: `move[0].at_s=0.2`,
// `move[1].target_deg[2]=50`. The value is TOML; text that is no TOML value is read as a string, so that
// `controller.sync=const_acc` needs no quotes. Missing tables are created, array elements are not. Problems (no `=`, no
// such element, a key inside a value that is no table) are added to `problems`. The reader of the table reports unknown
// keys.
void apply_override(ConfigValue& root, const std::string& assignment, ProblemList& problems);

}  // namespace armature::cosim
