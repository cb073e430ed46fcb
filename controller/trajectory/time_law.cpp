#include "controller/trajectory/time_law.hpp"

namespace armature {

ProfileShape TimeLaw::shape() const noexcept {
  return kind == ProfileKind::kSCurve ? scurve.shape : trapezoid.shape;
}
double TimeLaw::duration_s() const noexcept {
  return kind == ProfileKind::kSCurve ? scurve.duration_s : trapezoid.duration_s;
}
double TimeLaw::peak_speed() const noexcept {
  return kind == ProfileKind::kSCurve ? scurve.peak_speed : trapezoid.peak_speed;
}
double TimeLaw::peak_accel() const noexcept {
  return kind == ProfileKind::kSCurve ? scurve.peak_accel : trapezoid.accel;
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
  return law.kind == ProfileKind::kSCurve ? position(law.scurve, t_s) : position(law.trapezoid, t_s);
}
double velocity(const TimeLaw& law, double t_s) noexcept {
  return law.kind == ProfileKind::kSCurve ? velocity(law.scurve, t_s) : velocity(law.trapezoid, t_s);
}
double acceleration(const TimeLaw& law, double t_s) noexcept {
  return law.kind == ProfileKind::kSCurve ? acceleration(law.scurve, t_s) : acceleration(law.trapezoid, t_s);
}
double time_at(const TimeLaw& law, double covered) noexcept {
  return law.kind == ProfileKind::kSCurve ? time_at(law.scurve, covered) : time_at(law.trapezoid, covered);
}

}  // namespace armature
