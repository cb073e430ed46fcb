// The commands of `monitor` that show the run.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cosim/kernel/simulation_state.hpp"
#include "cosim/report/measure/run_events.hpp"

namespace armature::cosim::iss {

[[nodiscard]] std::string monitor_help();
// The answer to `tick`, `cycle`, `pins` or `fault`; to any other command that it does not know it.
[[nodiscard]] std::string monitor_text(std::string_view command, const SimulationState& seen,
                                       const std::vector<FaultEvent>& faults);

}  // namespace armature::cosim::iss
