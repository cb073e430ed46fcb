#include "controller/trajectory/profile/eased_trapezoid.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace armature {
namespace {

// The time at which braking from the peak speed begins.
double brakes_at_s(const EasedTrapezoid& p) {
  return p.duration_s - (p.down_s + p.last.time_s);
}

// Functions of the part before braking.

double covered_after(const EasedTrapezoid& p, double t_s) {
  if (t_s <= p.first.time_s) return 0.5 * p.first.accel * t_s * t_s;
  const double on_ramp_s = std::min(t_s - p.first.time_s, p.up_s);
  const double ramp = p.first.distance() + (p.first.speed() + 0.5 * p.accel * on_ramp_s) * on_ramp_s;
  return ramp + p.peak_speed * std::max(t_s - p.first.time_s - p.up_s, 0.0);
}

double speed_after(const EasedTrapezoid& p, double t_s) {
  if (t_s <= p.first.time_s) return p.first.accel * t_s;
  const double on_ramp_s = t_s - p.first.time_s;
  return on_ramp_s < p.up_s ? std::min(p.first.speed() + p.accel * on_ramp_s, p.peak_speed) : p.peak_speed;
}

double accel_after(const EasedTrapezoid& p, double t_s) {
  return t_s < p.first.time_s ? p.first.accel : t_s < p.first.time_s + p.up_s ? p.accel : 0.0;
}

double time_after(const EasedTrapezoid& p, double covered) {
  const double end = p.first.distance();
  if (covered <= end) return p.first.time_s > 0.0 ? std::sqrt(2.0 * covered / p.first.accel) : 0.0;
  const double u = p.first.speed();
  const double ramp = (u + 0.5 * p.accel * p.up_s) * p.up_s;
  const double beyond = covered - end;
  if (beyond > ramp) return p.first.time_s + p.up_s + (beyond - ramp) / p.peak_speed;
  // accel t^2 / 2 + u t = beyond, without cancellation.
  return p.first.time_s + 2.0 * beyond / (u + std::sqrt(u * u + 2.0 * p.accel * beyond));
}

}  // namespace

EasedTrapezoid plan_eased(double distance, const ProfileLimits& limits, const GentleEnd& first,
                          const GentleEnd& last) noexcept {
  EasedTrapezoid p;
  p.first = first;
  p.last = last;
  p.distance = distance;
  p.accel = limits.accel;
  const double between = std::max(distance - first.distance() - last.distance(), 0.0);
  const double u = first.speed(), w = last.speed();
  const double squares = 0.5 * (u * u + w * w);
  // At least the speed of either end, in spite of rounding.
  p.peak_speed = std::max({std::min(std::sqrt(limits.accel * between + squares), limits.speed), u, w});
  p.up_s = (p.peak_speed - u) / limits.accel;
  p.down_s = (p.peak_speed - w) / limits.accel;
  const double on_ramps = 0.5 * (p.peak_speed + u) * p.up_s + 0.5 * (p.peak_speed + w) * p.down_s;
  p.cruise_s = p.peak_speed < limits.speed ? 0.0 : std::max(between - on_ramps, 0.0) / p.peak_speed;
  p.duration_s = first.time_s + p.up_s + p.cruise_s + p.down_s + last.time_s;
  return p;
}

EasedTrapezoid scale_in_time(const EasedTrapezoid& profile, double duration_s) noexcept {
  const double k = profile.duration_s / duration_s;
  EasedTrapezoid p = profile;
  for (GentleEnd* end : {&p.first, &p.last}) {
    end->accel *= k * k;
    end->time_s /= k;
  }
  p.peak_speed *= k;
  p.accel *= k * k;
  p.up_s /= k;
  p.cruise_s /= k;
  p.down_s /= k;
  p.duration_s = duration_s;
  return p;
}

EasedTrapezoid reversed(const EasedTrapezoid& profile) noexcept {
  EasedTrapezoid p = profile;
  std::swap(p.first, p.last);
  std::swap(p.up_s, p.down_s);
  return p;
}

double position(const EasedTrapezoid& p, double t_s) noexcept {
  if (t_s <= 0.0) return 0.0;
  if (t_s >= p.duration_s) return p.distance;
  // Each part is computed from its own end: exact at both.
  if (t_s <= brakes_at_s(p)) return covered_after(p, t_s);
  return p.distance - covered_after(reversed(p), p.duration_s - t_s);
}

double velocity(const EasedTrapezoid& p, double t_s) noexcept {
  if (t_s <= 0.0 || t_s >= p.duration_s) return 0.0;
  return t_s <= brakes_at_s(p) ? speed_after(p, t_s) : speed_after(reversed(p), p.duration_s - t_s);
}

double acceleration(const EasedTrapezoid& p, double t_s) noexcept {
  if (t_s >= p.duration_s) return 0.0;
  if (t_s < brakes_at_s(p)) return accel_after(p, std::max(t_s, 0.0));
  return p.duration_s - t_s <= p.last.time_s ? -p.last.accel : -p.accel;
}

double time_at(const EasedTrapezoid& p, double covered) noexcept {
  if (covered <= 0.0) return 0.0;
  if (covered >= p.distance) return p.duration_s;
  const double while_braking = p.last.distance() + 0.5 * (p.peak_speed + p.last.speed()) * p.down_s;
  if (p.distance - covered >= while_braking) return time_after(p, covered);
  return p.duration_s - time_after(reversed(p), p.distance - covered);
}

}  // namespace armature
