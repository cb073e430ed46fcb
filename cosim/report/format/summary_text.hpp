// The summary of a run for a terminal: one screen, each line ends with '\n'.
#pragma once

#include <string>

#include "cosim/report/judge/run_summary.hpp"

namespace armature::cosim {

// `PASSED nod: a joint move`, its first line.
[[nodiscard]] std::string verdict_line(const RunSummary& summary);

[[nodiscard]] std::string summary_text(const RunSummary& summary);

}  // namespace armature::cosim
