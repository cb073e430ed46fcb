// Angles and speeds of all joints over time, as Figure 9 of Vo 2021 shows them.
#pragma once

#include <string>

#include "cosim/recording/run_record.hpp"

namespace armature::cosim {

// An SVG document.
[[nodiscard]] std::string joints_figure(const RunRecord& run);

}  // namespace armature::cosim
