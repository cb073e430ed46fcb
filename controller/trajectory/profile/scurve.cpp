#include "controller/trajectory/profile/scurve.hpp"

#include <algorithm>
#include <cmath>

#include "controller/base/math.hpp"

namespace armature {
namespace {

SCurveProfile empty_scurve(double duration_s) {
  SCurveProfile profile;
  profile.duration_s = duration_s;
  profile.cruise_s = duration_s;
  return profile;
}

double ramp_s(const SCurveProfile& p) {
  return 2.0 * p.jerk_s + p.hold_s;
}

// Functions of the first half, `t_s` from the near end. The part of falling acceleration is computed from its own end,
// the peak, so that rounding never exceeds the peak.

double speed_after(const SCurveProfile& p, double t_s) {
  if (t_s <= p.jerk_s) return 0.5 * p.jerk * t_s * t_s;
  const double to_peak_s = ramp_s(p) - t_s;
  if (to_peak_s <= 0.0) return p.peak_speed;
  if (to_peak_s <= p.jerk_s) return p.peak_speed - 0.5 * p.jerk * to_peak_s * to_peak_s;
  const double gained = 0.5 * p.peak_accel * p.jerk_s + p.peak_accel * (t_s - p.jerk_s);
  return std::min(gained, p.peak_speed);
}

double covered_after(const SCurveProfile& p, double t_s) {
  if (t_s <= p.jerk_s) return p.jerk * t_s * t_s * t_s / 6.0;
  const double ramp = ramp_s(p);
  const double to_peak_s = ramp - t_s;
  if (to_peak_s <= p.jerk_s) {
    const double at_peak_speed = p.peak_speed * (t_s - 0.5 * ramp);
    return to_peak_s <= 0.0 ? at_peak_speed : at_peak_speed + p.jerk * to_peak_s * to_peak_s * to_peak_s / 6.0;
  }
  const double held_s = t_s - p.jerk_s;
  const double speed = 0.5 * p.peak_accel * p.jerk_s;
  return p.peak_accel * p.jerk_s * p.jerk_s / 6.0 + (speed + 0.5 * p.peak_accel * held_s) * held_s;
}

double accel_after(const SCurveProfile& p, double t_s) {
  return std::min({p.jerk * t_s, p.peak_accel, p.jerk * std::max(ramp_s(p) - t_s, 0.0)});
}

// u in [0, jerk_s] with peak_speed u - jerk u^3 / 6 = missing: the time before the peak. The left side rises with at
// least half of the peak speed and is concave, so Newton's method converges from below without overshoot. Five steps
// reach the last digit even at u = jerk_s.
double time_before_peak(const SCurveProfile& p, double missing) {
  double u = missing / p.peak_speed;
  for (int step = 0; step < 6; ++step) {
    const double rest = missing - (p.peak_speed * u - p.jerk * u * u * u / 6.0);
    u += rest / (p.peak_speed - 0.5 * p.jerk * u * u);
  }
  return u;
}

// The time at which `covered`, at most half of the distance, is reached.
double time_after(const SCurveProfile& p, double covered) {
  const double ramp = ramp_s(p);
  const double first_part = p.peak_accel * p.jerk_s * p.jerk_s / 6.0;
  if (covered <= first_part) return std::min(math::cbrt(6.0 * covered / p.jerk), p.jerk_s);
  const double missing = 0.5 * p.peak_speed * ramp - covered;
  if (missing <= 0.0) return covered / p.peak_speed + 0.5 * ramp;
  const double last_part = (p.peak_speed - p.peak_accel * p.jerk_s / 6.0) * p.jerk_s;
  if (missing <= last_part) return ramp - time_before_peak(p, missing);
  // p (t - jerk_s)^2 / 2 + speed (t - jerk_s) = held, without cancellation.
  const double held = covered - first_part;
  const double speed = 0.5 * p.peak_accel * p.jerk_s;
  return p.jerk_s + 2.0 * held / (speed + std::sqrt(speed * speed + 2.0 * p.peak_accel * held));
}

}  // namespace

SCurveProfile plan_scurve(double distance, const SCurveLimits& limits) noexcept {
  const double q = std::fabs(distance);
  if (q == 0.0) return empty_scurve(0.0);
  SCurveProfile p;
  p.shape = ProfileShape::kSCurve;
  p.sign = distance < 0.0 ? -1.0 : 1.0;
  p.distance = q;
  p.jerk = limits.jerk;

  // The ramp to the full speed, with or without a phase of full acceleration.
  const double to_full_accel_s = limits.accel / limits.jerk;
  const double speed_by_accel_s = limits.speed / limits.accel;
  const bool may_hold = speed_by_accel_s > to_full_accel_s;
  p.peak_speed = limits.speed;
  p.jerk_s = may_hold ? to_full_accel_s : std::sqrt(limits.speed / limits.jerk);
  p.hold_s = may_hold ? speed_by_accel_s - to_full_accel_s : 0.0;
  const double at_full_speed_s = q / limits.speed;
  if (at_full_speed_s > ramp_s(p)) {
    p.cruise_s = at_full_speed_s - ramp_s(p);
    p.duration_s = at_full_speed_s + ramp_s(p);
  } else if (may_hold && q > 2.0 * limits.accel * to_full_accel_s * to_full_accel_s) {
    // v^2 / a + v a / j = q, without cancellation.
    p.peak_speed = 2.0 * q / (to_full_accel_s + std::sqrt(to_full_accel_s * to_full_accel_s + 4.0 * q / limits.accel));
    p.peak_speed = std::min(p.peak_speed, limits.speed);
    p.hold_s = std::max(p.peak_speed / limits.accel - to_full_accel_s, 0.0);
    p.duration_s = 2.0 * ramp_s(p);
  } else {
    // Root by root, since q / jerk can underflow.
    p.jerk_s = math::cbrt(q) / math::cbrt(2.0 * limits.jerk);
    p.hold_s = 0.0;
    p.peak_speed = std::min(0.5 * (q / p.jerk_s), limits.speed);
    p.duration_s = 4.0 * p.jerk_s;
  }
  p.peak_accel = p.hold_s > 0.0 ? limits.accel : std::min(p.peak_speed / p.jerk_s, limits.accel);
  return p;
}

SCurveProfile scale_in_time(const SCurveProfile& profile, double duration_s) noexcept {
  if (profile.shape == ProfileShape::kNone) return empty_scurve(duration_s);
  const double k = profile.duration_s / duration_s;
  SCurveProfile p = profile;
  p.jerk = profile.jerk * (k * k * k);
  p.peak_accel = profile.peak_accel * (k * k);
  p.peak_speed = profile.peak_speed * k;
  p.jerk_s = profile.jerk_s / k;
  p.hold_s = profile.hold_s / k;
  p.cruise_s = profile.cruise_s / k;
  p.duration_s = duration_s;
  return p;
}

double position(const SCurveProfile& p, double t_s) noexcept {
  if (t_s <= 0.0) return 0.0;
  if (t_s >= p.duration_s) return p.sign * p.distance;
  // Each half is computed from its own end: exact at both.
  const bool first = t_s <= 0.5 * p.duration_s;
  return p.sign * (first ? covered_after(p, t_s) : p.distance - covered_after(p, p.duration_s - t_s));
}

double velocity(const SCurveProfile& p, double t_s) noexcept {
  if (t_s <= 0.0 || t_s >= p.duration_s) return 0.0;
  return p.sign * speed_after(p, t_s <= 0.5 * p.duration_s ? t_s : p.duration_s - t_s);
}

double acceleration(const SCurveProfile& p, double t_s) noexcept {
  if (t_s <= 0.0 || t_s >= p.duration_s) return 0.0;
  const bool first = t_s <= 0.5 * p.duration_s;
  return first ? p.sign * accel_after(p, t_s) : -p.sign * accel_after(p, p.duration_s - t_s);
}

double jerk(const SCurveProfile& p, double t_s) noexcept {
  if (p.shape == ProfileShape::kNone || t_s >= p.duration_s) return 0.0;
  const double ramp = ramp_s(p);
  if (t_s < ramp) return t_s < p.jerk_s ? p.sign * p.jerk : t_s < ramp - p.jerk_s ? 0.0 : -p.sign * p.jerk;
  const double left_s = p.duration_s - t_s;
  if (left_s > ramp) return 0.0;
  return left_s > ramp - p.jerk_s ? -p.sign * p.jerk : left_s > p.jerk_s ? 0.0 : p.sign * p.jerk;
}

double time_at(const SCurveProfile& p, double covered) noexcept {
  if (covered <= 0.0 || p.shape == ProfileShape::kNone) return 0.0;
  if (covered >= p.distance) return p.duration_s;
  const bool first = covered <= 0.5 * p.distance;
  return first ? time_after(p, covered) : p.duration_s - time_after(p, p.distance - covered);
}

}  // namespace armature
