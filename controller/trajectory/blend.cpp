#include "controller/trajectory/blend.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "controller/core/timebase.hpp"

namespace armature {
namespace {

// Time from rest to the greatest speed.
double ramp_s(const TimeLaw& law) {
  return law.kind == ProfileKind::kTrapezoid ? law.trapezoid.accel_s : 2.0 * law.scurve.jerk_s + law.scurve.hold_s;
}

bool rounded(const CartesianSegment& first, const CartesianSegment& second, double blend_mm) {
  const bool alike = (first.turning == Turning::kFollowing) == (second.turning == Turning::kFollowing);
  return blend_mm > 0.0 && alike && has_length(first) && has_length(second);
}

// Direction of turning at the end of the first or the start of the second, both in the same space; 0 without a turn.
Eigen::Vector3d direction(const CartesianSegment& segment, const Eigen::Matrix3d& base_R_tool) {
  if (segment.turning != Turning::kFollowing) return base_R_tool * segment.orientation.axis;
  const double angle_rad = turn_angle_rad(segment);
  if (angle_rad == 0.0) return Eigen::Vector3d::Zero();
  const PlaneAngles& way = segment.plane_turn.way;
  return Eigen::Vector3d{way.pitch_rad, way.roll_rad, 0.0} / angle_rad;
}

}  // namespace

Easing easing(const CartesianSegment& first, const CartesianSegment& second, double blend_mm) noexcept {
  if (!rounded(first, second, blend_mm)) return {};
  const Eigen::Vector3d t1 = tangent(first.path, 1.0), t2 = tangent(second.path, 0.0);
  const Eigen::Vector3d w1 = direction(first, first.orientation.end);
  const Eigen::Vector3d w2 = direction(second, second.orientation.start);
  Easing result;
  result.accel = std::max(1.0, (t2 - t1).norm());
  result.jerk = std::max(result.accel, (t2 + t1).norm());
  result.turn_accel = std::max(1.0, (w2 - w1).norm());
  result.turn_jerk = std::max(result.turn_accel, (w2 + w1).norm());
  return result;
}

Easing strongest(const Easing& a, const Easing& b) noexcept {
  return {.accel = std::max(a.accel, b.accel),
          .jerk = std::max(a.jerk, b.jerk),
          .turn_accel = std::max(a.turn_accel, b.turn_accel),
          .turn_jerk = std::max(a.turn_jerk, b.turn_jerk)};
}

TimeLawLimits law_limits(const CartesianSegment& segment, const PathLimits& limits, const Easing& easing) noexcept {
  double speed_mm_s = limits.speed_mm_s;
  double accel_mm_s2 = limits.accel_mm_s2;
  if (segment.path.shape == PositionPath::Shape::kArc) {
    const double r_mm = segment.path.radius_mm;
    speed_mm_s = std::min(speed_mm_s, std::sqrt(0.5 * std::sqrt(3.0) * accel_mm_s2 * r_mm));
    const double centripetal = speed_mm_s * speed_mm_s / r_mm;
    accel_mm_s2 = std::sqrt(accel_mm_s2 * accel_mm_s2 - centripetal * centripetal);
  }
  // A segment without length or without angle is not limited by that: x / 0 is infinite, and one of both is not 0.
  const double length_mm = segment.path.length_mm;
  const double angle_rad = turn_angle_rad(segment);
  return {.speed = std::min(speed_mm_s / length_mm, limits.turn_speed_rad_s / angle_rad),
          .accel = std::min(accel_mm_s2 / easing.accel / length_mm,
                            limits.turn_accel_rad_s2 / easing.turn_accel / angle_rad),
          .jerk = std::min(limits.jerk_mm_s3 / easing.jerk / length_mm,
                           limits.turn_jerk_rad_s3 / easing.turn_jerk / angle_rad)};
}

Ticks overlap(const CartesianSegment& first, const CartesianSegment& second, double blend_mm) noexcept {
  if (!rounded(first, second, blend_mm)) return Ticks{0};
  const double l1 = first.path.length_mm, l2 = second.path.length_mm;
  const double radius_mm = std::min({blend_mm, 0.5 * l1, 0.5 * l2});
  // Laws are symmetric in time: what is left at T - t is what is covered at t.
  const double longest_s = std::min(
      {time_at(first.law, radius_mm / l1), time_at(second.law, radius_mm / l2), ramp_s(first.law), ramp_s(second.law)});
  std::int64_t ticks = std::min({static_cast<std::int64_t>(longest_s / kTickSeconds) + 1, first.duration.value() / 2,
                                 second.duration.value() / 2});
  const auto too_long = [&] {
    const double t_s = static_cast<double>(ticks) * kTickSeconds;
    return t_s > longest_s || l1 * position(first.law, t_s) > radius_mm || l2 * position(second.law, t_s) > radius_mm;
  };
  while (ticks > 0 && too_long()) --ticks;
  return Ticks{ticks};
}

}  // namespace armature
