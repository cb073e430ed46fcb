// The path of the tool in its plane, as Figure 10 of Vo 2021 shows drawn shapes.
#pragma once

#include <string>

#include "cosim/recording/run_record.hpp"

namespace armature::cosim {

// An SVG document. Throws InputError if the trace has no columns of the tool centre point.
[[nodiscard]] std::string path_figure(const RunRecord& run);

}  // namespace armature::cosim
