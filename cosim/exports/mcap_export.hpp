// A run as an MCAP file, for Foxglove and programs that read MCAP.
#pragma once

#include <optional>
#include <ostream>
#include <vector>

#include "cosim/recording/recorded_program.hpp"
#include "cosim/recording/run_record.hpp"
#include "cosim/recording/trace_table.hpp"

namespace armature::cosim {

// Times are simulated time since the start of the run. Angles are in rad and rad/s, lengths in m. `load`: load.csv.
void export_mcap(std::ostream& out, const RunRecord& run, const std::vector<RecordedProgram>& programs,
                 const std::optional<TraceTable>& load);

}  // namespace armature::cosim
