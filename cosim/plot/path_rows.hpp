// The rows of a trace in which moves on paths are under way.
#pragma once

#include <cstddef>
#include <vector>

#include "cosim/recording/run_record.hpp"

namespace armature::cosim {

// From a row to another one, which is drawn too.
struct PathRows {
  std::size_t first = 0, last = 0;
  bool rapid = false;  // only ways to the next cut
};

// In the order of time. A piece begins at the row with which a connected one before it ends. A run without a move on a
// path has one piece: all rows.
[[nodiscard]] std::vector<PathRows> path_rows(const RunRecord& run);

}  // namespace armature::cosim
