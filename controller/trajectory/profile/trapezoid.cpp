#include "controller/trajectory/profile/trapezoid.hpp"

#include <cmath>

namespace armature {
namespace {

TrapezoidProfile empty_trapezoid(double duration_s) {
  TrapezoidProfile profile;
  profile.duration_s = duration_s;
  profile.cruise_s = duration_s;
  return profile;
}

// Distance covered at t_s, for the first half.
double first_half(const TrapezoidProfile& p, double t_s) {
  if (t_s <= p.accel_s) return 0.5 * p.accel * t_s * t_s;
  return 0.5 * p.accel * p.accel_s * p.accel_s + p.peak_speed * (t_s - p.accel_s);
}

}  // namespace

TrapezoidProfile plan_profile(double distance, const ProfileLimits& limits) noexcept {
  const double q = std::fabs(distance);
  if (q == 0.0) return empty_trapezoid(0.0);
  TrapezoidProfile p;
  p.sign = distance < 0.0 ? -1.0 : 1.0;
  p.distance = q;
  p.accel = limits.accel;
  if (q * limits.accel > limits.speed * limits.speed) {
    p.shape = ProfileShape::kTrapezoid;
    p.peak_speed = limits.speed;
    p.accel_s = limits.speed / limits.accel;
    p.duration_s = p.accel_s + q / limits.speed;
    p.cruise_s = p.duration_s - 2.0 * p.accel_s;
  } else {
    p.shape = ProfileShape::kTriangle;
    p.peak_speed = std::sqrt(q * limits.accel);
    p.accel_s = std::sqrt(q / limits.accel);
    p.duration_s = 2.0 * p.accel_s;
  }
  return p;
}

TrapezoidProfile plan_with_accel(double distance, double accel, double duration_s) noexcept {
  const double q = std::fabs(distance);
  if (q == 0.0) return empty_trapezoid(duration_s);
  // The discriminant of eq. (13) over a^2; the text below it prints 4 q instead of 4 q a.
  const double discriminant = duration_s * duration_s - 4.0 * q / accel;
  if (discriminant < 0.0) return plan_triangle(distance, duration_s);
  TrapezoidProfile p;
  p.shape = ProfileShape::kTrapezoid;
  p.sign = distance < 0.0 ? -1.0 : 1.0;
  p.distance = q;
  p.accel = accel;
  // Avoids the cancellation of the printed form, which loses 2e-5 of the speed for a nanodegree.
  p.peak_speed = 2.0 * q / (duration_s + std::sqrt(discriminant));
  p.accel_s = p.peak_speed / accel;
  p.cruise_s = duration_s - 2.0 * p.accel_s;
  p.duration_s = duration_s;
  return p;
}

TrapezoidProfile plan_triangle(double distance, double duration_s) noexcept {
  const double q = std::fabs(distance);
  if (q == 0.0) return empty_trapezoid(duration_s);
  TrapezoidProfile p;
  p.shape = ProfileShape::kTriangle;
  p.sign = distance < 0.0 ? -1.0 : 1.0;
  p.distance = q;
  p.peak_speed = 2.0 * q / duration_s;
  p.accel = 4.0 * q / (duration_s * duration_s);
  p.accel_s = 0.5 * duration_s;
  p.duration_s = duration_s;
  return p;
}

TrapezoidProfile scale_in_time(const TrapezoidProfile& profile, double duration_s) noexcept {
  if (profile.shape == ProfileShape::kNone) return empty_trapezoid(duration_s);
  const double k = profile.duration_s / duration_s;
  TrapezoidProfile p = profile;
  p.peak_speed = profile.peak_speed * k;
  p.accel = profile.accel * (k * k);
  p.accel_s = profile.accel_s / k;
  p.cruise_s = profile.cruise_s / k;
  p.duration_s = duration_s;
  return p;
}

double position(const TrapezoidProfile& p, double t_s) noexcept {
  if (t_s <= 0.0) return 0.0;
  if (t_s >= p.duration_s) return p.sign * p.distance;
  // Each half is computed from its own end: exact at both.
  const bool first = t_s <= 0.5 * p.duration_s;
  return p.sign * (first ? first_half(p, t_s) : p.distance - first_half(p, p.duration_s - t_s));
}

double velocity(const TrapezoidProfile& p, double t_s) noexcept {
  if (t_s <= 0.0 || t_s >= p.duration_s) return 0.0;
  const double from_end = t_s <= 0.5 * p.duration_s ? t_s : p.duration_s - t_s;
  return p.sign * (from_end < p.accel_s ? p.accel * from_end : p.peak_speed);
}

double time_at(const TrapezoidProfile& p, double covered) noexcept {
  if (covered <= 0.0 || p.shape == ProfileShape::kNone) return 0.0;
  if (covered >= p.distance) return p.duration_s;
  const double ramp = 0.5 * p.accel * p.accel_s * p.accel_s;
  const bool first = covered <= 0.5 * p.distance;
  const double from_end = first ? covered : p.distance - covered;
  const double t_s =
      from_end <= ramp ? std::sqrt(2.0 * from_end / p.accel) : p.accel_s + (from_end - ramp) / p.peak_speed;
  return first ? t_s : p.duration_s - t_s;
}

double acceleration(const TrapezoidProfile& p, double t_s) noexcept {
  if (p.shape == ProfileShape::kNone || t_s >= p.duration_s) return 0.0;
  if (t_s < p.accel_s) return p.sign * p.accel;
  return t_s < p.duration_s - p.accel_s ? 0.0 : -p.sign * p.accel;
}

}  // namespace armature
