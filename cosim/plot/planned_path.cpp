#include "cosim/plot/planned_path.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

#include "controller/core/math.hpp"
#include "cosim/text/angle_units.hpp"

namespace armature::cosim {
namespace {

// Zero if the summary does not have it.
Eigen::Vector3d vector_of(const nlohmann::ordered_json& path, const char* key) {
  if (!path.contains(key) || !path[key].is_array() || path[key].size() != 3) return Eigen::Vector3d::Zero();
  return {path[key][0].get<double>(), path[key][1].get<double>(), path[key][2].get<double>()};
}

SpacePoints arc_points(const nlohmann::ordered_json& path) {
  constexpr double kStepDeg = 2;
  const Eigen::Vector3d center = vector_of(path, "center_mm");
  const Eigen::Vector3d x = vector_of(path, "start_mm") - center;
  const Eigen::Vector3d y = vector_of(path, "normal").cross(x);
  const double angle_deg = path["angle_deg"].get<double>();
  const double steps = std::max(1.0, std::ceil(std::fabs(angle_deg) / kStepDeg));
  SpacePoints points;
  for (double i = 0; i <= steps; ++i) {
    const double angle = angle_deg * i / steps / kDegPerRad;
    points.emplace_back(center + math::cos(angle) * x + math::sin(angle) * y);
  }
  return points;
}

}  // namespace

SpacePoints planned_path(const nlohmann::ordered_json& move) {
  if (!move.contains("path") || !move["path"].contains("start_mm")) return {};
  const nlohmann::ordered_json& path = move["path"];
  if (path.contains("angle_deg")) return arc_points(path);
  if (path.contains("through_mm")) return {};
  return {vector_of(path, "start_mm"), vector_of(path, "end_mm")};
}

}  // namespace armature::cosim
