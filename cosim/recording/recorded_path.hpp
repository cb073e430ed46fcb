// The path that a move of a run was given, read from the summary.
#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "controller/trajectory/path/position_path.hpp"

namespace armature::cosim {

struct RecordedPath {
  PositionPath path;
  std::unique_ptr<const Spline> curve{};  // of a spline, to which the path refers
};

// `move`: one of `result.moves`. Nothing if it has no path, as a joint move, or if its numbers are no path.
[[nodiscard]] std::optional<RecordedPath> recorded_path(const nlohmann::ordered_json& move);

}  // namespace armature::cosim
