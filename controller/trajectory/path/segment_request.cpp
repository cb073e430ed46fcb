#include "controller/trajectory/path/segment_request.hpp"

#include <algorithm>
#include <array>

namespace armature {

PathLimits larger(const PathLimits& a, const PathLimits& b) noexcept {
  return {.speed_mm_s = std::max(a.speed_mm_s, b.speed_mm_s),
          .accel_mm_s2 = std::max(a.accel_mm_s2, b.accel_mm_s2),
          .jerk_mm_s3 = std::max(a.jerk_mm_s3, b.jerk_mm_s3),
          .turn_speed_rad_s = std::max(a.turn_speed_rad_s, b.turn_speed_rad_s),
          .turn_accel_rad_s2 = std::max(a.turn_accel_rad_s2, b.turn_accel_rad_s2),
          .turn_jerk_rad_s3 = std::max(a.turn_jerk_rad_s3, b.turn_jerk_rad_s3),
          .joint_accel = std::max(a.joint_accel, b.joint_accel)};
}

std::optional<PositionPath> path_of(const SegmentRequest& request, const Eigen::Vector3d& from_mm,
                                    Spline& curve) noexcept {
  const Eigen::Vector3d &via_mm = request.via_mm, &to_mm = request.target.position_mm;
  switch (request.kind) {
    case SegmentRequest::Kind::kLine:
      break;
    case SegmentRequest::Kind::kArc:
      return arc(from_mm, via_mm, to_mm);
    case SegmentRequest::Kind::kCircle:
      return circle(from_mm, via_mm, to_mm);
    case SegmentRequest::Kind::kArcAbout:
      return arc_about(from_mm, via_mm, request.about.axis, request.about.angle_rad, request.about.advance_mm);
    case SegmentRequest::Kind::kSpline: {
      std::array<Eigen::Vector3d, Spline::kMaxPoints> points;
      const std::size_t through = request.through_mm.size();
      if (through > ThroughPoints::kMax) return std::nullopt;
      points[0] = from_mm;
      std::copy(request.through_mm.begin(), request.through_mm.end(), points.begin() + 1);
      points[through + 1] = to_mm;
      const std::optional<Spline> found = Spline::through(std::span{points}.first(through + 2));
      if (!found) return std::nullopt;
      curve = *found;
      return along(curve);
    }
  }
  return line(from_mm, to_mm);
}

}  // namespace armature
