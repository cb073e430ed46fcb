#include "controller/trajectory/profile/time_law.hpp"

namespace armature {

namespace {

// Calls `f` with the profile that is valid.
template <typename F>
auto with_profile(const TimeLaw& law, const F& f) {
  if (law.kind == ProfileKind::kSCurve) return f(law.scurve);
  return f(law.trapezoid);
}

}  // namespace

ProfileShape TimeLaw::shape() const noexcept {
  if (kind == ProfileKind::kSCurve) return scurve.shape;
  return trapezoid.shape;
}
double TimeLaw::duration_s() const noexcept {
  return with_profile(*this, [](const auto& profile) { return profile.duration_s; });
}
double TimeLaw::peak_speed() const noexcept {
  return with_profile(*this, [](const auto& profile) { return profile.peak_speed; });
}
double TimeLaw::peak_accel() const noexcept {
  if (kind == ProfileKind::kSCurve) return scurve.peak_accel;
  return trapezoid.accel;
}

TimeLaw plan_time_law(ProfileKind kind, double distance, const TimeLawLimits& limits) noexcept {
  if (kind == ProfileKind::kSCurve) {
    return {.kind = kind,
            .scurve = plan_scurve(distance, {.speed = limits.speed, .accel = limits.accel, .jerk = limits.jerk})};
  }
  return {.kind = kind, .trapezoid = plan_profile(distance, {.speed = limits.speed, .accel = limits.accel})};
}

TimeLaw scale_in_time(const TimeLaw& law, double duration_s) noexcept {
  if (law.kind == ProfileKind::kSCurve) {
    return {.kind = law.kind, .scurve = scale_in_time(law.scurve, duration_s)};
  }
  return {.kind = law.kind, .trapezoid = scale_in_time(law.trapezoid, duration_s)};
}

double position(const TimeLaw& law, double t_s) noexcept {
  return with_profile(law, [t_s](const auto& profile) { return position(profile, t_s); });
}
double velocity(const TimeLaw& law, double t_s) noexcept {
  return with_profile(law, [t_s](const auto& profile) { return velocity(profile, t_s); });
}
double acceleration(const TimeLaw& law, double t_s) noexcept {
  return with_profile(law, [t_s](const auto& profile) { return acceleration(profile, t_s); });
}
double time_at(const TimeLaw& law, double covered) noexcept {
  return with_profile(law, [covered](const auto& profile) { return time_at(profile, covered); });
}

}  // namespace armature
