// The rows of a run as arrays for NumPy.
#pragma once

#include <optional>
#include <ostream>

#include "cosim/recording/run_record.hpp"
#include "cosim/recording/trace_table.hpp"

namespace armature::cosim {

// An array for each column of trace.csv, with its name: int64 for columns of integers, float64 (nan: no value) for
// others, texts for `state`. The columns of `load` (load.csv) that the trace does not have follow.
void export_npz(std::ostream& out, const RunRecord& run, const std::optional<TraceTable>& load);

}  // namespace armature::cosim
