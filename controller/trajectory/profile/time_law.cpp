#include "controller/trajectory/profile/time_law.hpp"

#include <initializer_list>

namespace armature {

namespace {

// Calls `f` with the profile that is valid.
template <typename F>
auto with_profile(const TimeLaw& law, const F& f) {
  if (law.kind == ProfileKind::kSCurve) return f(law.scurve);
  return law.eased ? f(law.eased_trapezoid) : f(law.trapezoid);
}

}  // namespace

ProfileShape TimeLaw::shape() const noexcept {
  if (kind == ProfileKind::kSCurve) return scurve.shape;
  if (!eased) return trapezoid.shape;
  return eased_trapezoid.cruise_s > 0.0 ? ProfileShape::kTrapezoid : ProfileShape::kTriangle;
}
double TimeLaw::duration_s() const noexcept {
  return with_profile(*this, [](const auto& profile) { return profile.duration_s; });
}
double TimeLaw::peak_speed() const noexcept {
  return with_profile(*this, [](const auto& profile) { return profile.peak_speed; });
}
double TimeLaw::peak_accel() const noexcept {
  if (kind == ProfileKind::kSCurve) return scurve.peak_accel;
  return eased ? eased_trapezoid.accel : trapezoid.accel;
}

Kinks kinks(const TimeLaw& law) noexcept {
  const auto at_ends_of = [](std::initializer_list<double> phases_s) {
    Kinks result{.count = 1};
    for (const double phase_s : phases_s) {
      result.time_s[result.count] = result.time_s[result.count - 1] + phase_s;
      ++result.count;
    }
    return result;
  };
  if (law.kind == ProfileKind::kSCurve) {
    const SCurveProfile& p = law.scurve;
    return at_ends_of({p.jerk_s, p.hold_s, p.jerk_s, p.cruise_s, p.jerk_s, p.hold_s, p.jerk_s});
  }
  if (law.eased) {
    const EasedTrapezoid& p = law.eased_trapezoid;
    return at_ends_of({p.first.time_s, p.up_s, p.cruise_s, p.down_s, p.last.time_s});
  }
  const TrapezoidProfile& p = law.trapezoid;
  return at_ends_of({p.accel_s, p.cruise_s, p.accel_s});
}

TimeLaw plan_time_law(ProfileKind kind, double distance, const TimeLawLimits& limits) noexcept {
  if (kind == ProfileKind::kSCurve) {
    return {.kind = kind,
            .scurve = plan_scurve(distance, {.speed = limits.speed, .accel = limits.accel, .jerk = limits.jerk})};
  }
  return {.kind = kind, .trapezoid = plan_profile(distance, {.speed = limits.speed, .accel = limits.accel})};
}

TimeLaw plan_eased_law(double distance, const TimeLawLimits& limits, const GentleEnd& first,
                       const GentleEnd& last) noexcept {
  if (first.time_s == 0.0 && last.time_s == 0.0) return plan_time_law(ProfileKind::kTrapezoid, distance, limits);
  return {.kind = ProfileKind::kTrapezoid,
          .eased = true,
          .eased_trapezoid = plan_eased(distance, {.speed = limits.speed, .accel = limits.accel}, first, last)};
}

TimeLaw scale_in_time(const TimeLaw& law, double duration_s) noexcept {
  if (law.kind == ProfileKind::kSCurve) {
    return {.kind = law.kind, .scurve = scale_in_time(law.scurve, duration_s)};
  }
  if (law.eased) {
    return {.kind = law.kind, .eased = true, .eased_trapezoid = scale_in_time(law.eased_trapezoid, duration_s)};
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
double time_before_end(const TimeLaw& law, double left) noexcept {
  return law.eased ? time_at(reversed(law.eased_trapezoid), left) : time_at(law, left);
}

}  // namespace armature
