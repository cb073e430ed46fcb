// The paths that moves of a run were given, as points.
#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <vector>

namespace armature::cosim {

using SpacePoints = std::vector<Eigen::Vector3d>;

// A move of `result.moves` in the summary: ends of a line, points along an arc or a circle. Empty for other moves.
[[nodiscard]] SpacePoints planned_path(const nlohmann::ordered_json& move);

}  // namespace armature::cosim
