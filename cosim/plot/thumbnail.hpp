// A run at a glance: a small picture without numbers, for lists of runs.
#pragma once

#include <string>

#include "cosim/recording/run_record.hpp"

namespace armature::cosim {

// As SVG: the path of the tool if moves along paths were made, and otherwise the angles of all joints over time.
[[nodiscard]] std::string thumbnail(const RunRecord& run);

}  // namespace armature::cosim
