#include "cosim/recording/recorded_path.hpp"

#include <Eigen/Geometry>
#include <vector>

#include "controller/base/angle_units.hpp"
#include "cosim/text/json.hpp"

namespace armature::cosim {
namespace {

// Zero if it is no vector.
Eigen::Vector3d vector_of(const Json& value) {
  if (!value.is_array() || value.size() != 3) return Eigen::Vector3d::Zero();
  return {value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
}

std::optional<RecordedPath> arc_of(const Json& path) {
  auto arc = arc_about(vector_of(path["start_mm"]), vector_of(path["center_mm"]), vector_of(path["normal"]),
                       path["angle_deg"].get<double>() * kRadPerDeg, path.value("advance_mm", 0.0));
  if (!arc) return std::nullopt;
  return RecordedPath{*arc};
}

std::optional<RecordedPath> spline_of(const Json& path) {
  std::vector<Eigen::Vector3d> points{vector_of(path["start_mm"])};
  for (const Json& point : path["through_mm"]) points.push_back(vector_of(point));
  points.push_back(vector_of(path["end_mm"]));
  const auto spline = Spline::through(points);
  if (!spline) return std::nullopt;
  auto curve = std::make_unique<const Spline>(*spline);
  const PositionPath along_curve = along(*curve);
  return RecordedPath{along_curve, std::move(curve)};
}

}  // namespace

std::optional<RecordedPath> recorded_path(const Json& move) {
  if (!move.contains("path")) return std::nullopt;
  const Json& path = move["path"];
  for (const char* key : {"start_mm", "end_mm"}) {
    if (!path.contains(key)) return std::nullopt;
  }
  if (path.contains("through_mm")) return spline_of(path);
  if (path.contains("angle_deg") && path.contains("center_mm") && path.contains("normal")) return arc_of(path);
  return RecordedPath{line(vector_of(path["start_mm"]), vector_of(path["end_mm"]))};
}

}  // namespace armature::cosim
