// The distance of the tool from the paths of the moves, in each row of a trace. It is measured as in a run
// (cosim/report/measure/path_error.hpp), with the joint angles of the trace.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "cosim/recording/run_record.hpp"

namespace armature::cosim {

struct PathErrors {
  static constexpr int kDigits = 6;  // of mm, in integers; the angles of a trace say no more
  static constexpr std::int64_t kNone = -1;

  // In each row; kNone: not measured.
  std::vector<std::int64_t> encoders{}, set_points{};
};

// Nothing if no move has a path, or if the robot has no kinematics.
[[nodiscard]] std::optional<PathErrors> path_errors(const RunRecord& run);

}  // namespace armature::cosim
