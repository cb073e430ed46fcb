// summary.json: all facts and verdicts of a run. Only the values under "host" depend on the machine. Ends with '\n'.
#pragma once

#include <string>

#include "cosim/report/judge/run_summary.hpp"

namespace armature::cosim {

[[nodiscard]] std::string summary_json(const RunSummary& summary);

}  // namespace armature::cosim
