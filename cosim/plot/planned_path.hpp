// The paths that moves of a run were given, as points.
#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <vector>

namespace armature::cosim {

using SpacePoints = std::vector<Eigen::Vector3d>;

// Of a move of `result.moves` in the summary: the ends of a line, points along a curve. Empty for a move without a
// path.
[[nodiscard]] SpacePoints planned_path(const nlohmann::ordered_json& move);

}  // namespace armature::cosim
