#include "cosim/plot/planned_path.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "controller/base/angle_units.hpp"
#include "cosim/recording/recorded_path.hpp"

namespace armature::cosim {
namespace {

// Points that no eye tells from the curve.
double steps_along(const PositionPath& path) {
  constexpr double kStepRad = 2 * kRadPerDeg;
  constexpr double kStepsBetweenPoints = 24;  // of a spline
  switch (path.shape) {
    case PositionPath::Shape::kLine:
      break;
    case PositionPath::Shape::kArc:
      return std::max(1.0, std::ceil(path.angle_rad / kStepRad));
    case PositionPath::Shape::kSpline:
      return kStepsBetweenPoints * static_cast<double>(path.spline->points_mm().size() - 1);
  }
  return 1.0;
}

}  // namespace

SpacePoints planned_path(const nlohmann::ordered_json& move) {
  const std::optional<RecordedPath> recorded = recorded_path(move);
  if (!recorded) return {};
  const PositionPath& path = recorded->path;
  const double steps = steps_along(path);
  SpacePoints points;
  for (double i = 0; i <= steps; ++i) points.push_back(point(path, i / steps));
  return points;
}

}  // namespace armature::cosim
