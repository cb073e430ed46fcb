#include "controller/trajectory/plan/blend.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "controller/core/timebase.hpp"

namespace armature {
namespace {

// Time from rest to the peak speed of a symmetric law.
double ramp_s(const TimeLaw& law) {
  return law.kind == ProfileKind::kTrapezoid ? law.trapezoid.accel_s : 2.0 * law.scurve.jerk_s + law.scurve.hold_s;
}
// Half of a duration, in whole ticks.
double half_s(Ticks duration) {
  const Ticks half{duration.value() / 2};
  return static_cast<double>(half.value()) * kTickSeconds;
}
double most_at_end_s(const CartesianSegment& first) {
  if (first.law.eased) return first.law.eased_trapezoid.last.time_s;
  return std::min(ramp_s(first.law), half_s(first.duration));
}
double most_at_start_s(const CartesianSegment& second) {
  if (second.law.eased) return second.law.eased_trapezoid.first.time_s;
  return std::min(ramp_s(second.law), half_s(second.duration));
}

bool rounded(const CartesianSegment& first, const CartesianSegment& second, double blend_mm) {
  const bool alike = (first.turning == Turning::kFollowing) == (second.turning == Turning::kFollowing);
  return blend_mm > 0.0 && alike && has_length(first) && has_length(second);
}

// Axis of rotation at the end of the first or the start of the second segment, both in the same space; 0 without a
// rotation.
Eigen::Vector3d direction(const CartesianSegment& segment, const Eigen::Matrix3d& base_R_tool) {
  if (segment.turning != Turning::kFollowing) return base_R_tool * segment.orientation.axis;
  const double angle_rad = turn_angle_rad(segment);
  if (angle_rad == 0.0) return Eigen::Vector3d::Zero();
  const PlaneAngles& change = segment.plane_turn.change;
  return Eigen::Vector3d{change.pitch_rad, change.roll_rad, 0.0} / angle_rad;
}

// Limits with which the acceleration is reached in at least kRampTicks and the jerk lasts at least kJerkTicks, for any
// peak speed, over a distance of 1.
TimeLawLimits seen_at_ticks(TimeLawLimits limits) {
  const double ramp_s = kRampTicks * kTickSeconds, jerk_s = kJerkTicks * kTickSeconds;
  limits.accel = std::min({limits.accel, limits.speed / ramp_s, 1.0 / (ramp_s * ramp_s)});
  limits.jerk = std::min(
      {limits.jerk, limits.accel / jerk_s, limits.speed / (jerk_s * jerk_s), 0.5 / (jerk_s * jerk_s * jerk_s)});
  return limits;
}

}  // namespace

Easing easing(const CartesianSegment& first, const CartesianSegment& second, double blend_mm) noexcept {
  if (!rounded(first, second, blend_mm)) return {};
  const Eigen::Vector3d t1 = tangent(first.path, 1.0), t2 = tangent(second.path, 0.0);
  const Eigen::Vector3d w1 = direction(first, first.orientation.end);
  const Eigen::Vector3d w2 = direction(second, second.orientation.start);
  Easing result;
  const double bend1 = blend_mm / least_curve_radius_mm(first.path);
  const double bend2 = blend_mm / least_curve_radius_mm(second.path);
  // As one speed decreases while the other increases, the sum of their squares is at most the larger square.
  result.accel = std::max(1.0, (t2 - t1).norm() + (bend1 + bend2) + 2.0 * std::max(bend1, bend2));
  result.jerk = std::max({1.0, (t2 - t1).norm(), (t2 + t1).norm()});
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
  if (const double r_mm = least_curve_radius_mm(segment.path); std::isfinite(r_mm)) {
    speed_mm_s = std::min(speed_mm_s, std::sqrt(0.5 * std::sqrt(3.0) * accel_mm_s2 * r_mm));
    const double centripetal = speed_mm_s * speed_mm_s / r_mm;
    accel_mm_s2 = std::sqrt(accel_mm_s2 * accel_mm_s2 - centripetal * centripetal);
  }
  // A segment without length or without angle is not limited by it: x / 0 is infinite, and at least one of both is not
  // 0.
  const double length_mm = segment.path.length_mm;
  const double angle_rad = turn_angle_rad(segment);
  return seen_at_ticks({.speed = std::min(speed_mm_s / length_mm, limits.turn_speed_rad_s / angle_rad),
                        .accel = std::min(accel_mm_s2 / easing.accel / length_mm,
                                          limits.turn_accel_rad_s2 / easing.turn_accel / angle_rad),
                        .jerk = std::min(limits.jerk_mm_s3 / easing.jerk / length_mm,
                                         limits.turn_jerk_rad_s3 / easing.turn_jerk / angle_rad)});
}

Corner rounded_corner(const CornerSide& first, const CornerSide& second, double blend_mm) noexcept {
  if (!rounded(first.segment, second.segment, blend_mm)) return {};
  const double l1 = first.segment.path.length_mm, l2 = second.segment.path.length_mm;
  const double reach_mm = std::min({blend_mm, first.most * l1, second.most * l2});
  Corner corner{.blend_mm = blend_mm, .easing = easing(first.segment, second.segment, reach_mm)};
  const TimeLawLimits a = law_limits(first.segment, first.limits, corner.easing);
  const TimeLawLimits b = law_limits(second.segment, second.limits, corner.easing);
  const double time_s = std::min({std::sqrt(2.0 * reach_mm / l1 / a.accel), std::sqrt(2.0 * reach_mm / l2 / b.accel),
                                  a.speed / a.accel, b.speed / b.accel});
  corner.end_of_first = {.accel = a.accel, .time_s = time_s};
  corner.start_of_second = {.accel = b.accel, .time_s = time_s};
  return corner;
}

TimeLaw fastest_law(ProfileKind profile, const CartesianSegment& segment, const PathLimits& limits,
                    const Corner& before, const Corner& after) noexcept {
  if (is_empty(segment)) return plan_time_law(profile, 0.0, {});
  if (profile == ProfileKind::kSCurve) {
    return plan_time_law(profile, 1.0, law_limits(segment, limits, strongest(before.easing, after.easing)));
  }
  return plan_eased_law(1.0, law_limits(segment, limits, {}), before.start_of_second, after.end_of_first);
}

Ticks overlap(const CartesianSegment& first, const CartesianSegment& second, double blend_mm) noexcept {
  if (!rounded(first, second, blend_mm)) return Ticks{0};
  const double l1 = first.path.length_mm, l2 = second.path.length_mm;
  const double radius_mm = std::min({blend_mm, 0.5 * l1, 0.5 * l2});
  const double longest_s = std::min({time_before_end(first.law, radius_mm / l1), time_at(second.law, radius_mm / l2),
                                     most_at_end_s(first), most_at_start_s(second)});
  auto ticks = static_cast<std::int64_t>(longest_s / kTickSeconds) + 1;
  const double duration_s = first.law.duration_s();
  const auto too_long = [&] {
    const double t_s = static_cast<double>(ticks) * kTickSeconds;
    return t_s > longest_s || l1 * (1.0 - position(first.law, duration_s - t_s)) > radius_mm ||
           l2 * position(second.law, t_s) > radius_mm;
  };
  while (ticks > 0 && too_long()) --ticks;
  return Ticks{ticks};
}

}  // namespace armature
