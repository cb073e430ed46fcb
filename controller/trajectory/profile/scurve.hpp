// Jerk-limited profiles of one axis: up to seven phases of constant jerk (the acceleration is a trapezoid in each
// ramp).
//
// The papers have trapezoids only, whose jumps of acceleration excite vibrations of an arm. Any unit of length L: L/s,
// L/s^2, L/s^3. The distance may have either sign. With a distance of 0 the profile is empty and takes no time.
#pragma once

#include "controller/trajectory/profile/trapezoid.hpp"

namespace armature {

struct SCurveLimits {
  double speed = 0.0;  // > 0
  double accel = 0.0;  // > 0, for speeding up and for braking
  double jerk = 0.0;   // > 0
};

// jerk_s of +jerk, hold_s of constant acceleration, jerk_s of -jerk; cruise_s; then mirrored. Symmetric in time.
struct SCurveProfile {
  ProfileShape shape = ProfileShape::kNone;  // or kSCurve
  double sign = 1.0;                         // of the motion, +1 or -1
  double distance = 0.0;                     // >= 0
  double jerk = 0.0;
  double peak_accel = 0.0;
  double peak_speed = 0.0;
  double jerk_s = 0.0;
  double hold_s = 0.0;
  double cruise_s = 0.0;
  double duration_s = 0.0;  // 4 jerk_s + 2 hold_s + cruise_s
};

// The fastest profile over `distance` within the limits.
[[nodiscard]] SCurveProfile plan_scurve(double distance, const SCurveLimits& limits) noexcept;

// The same path in `duration_s`: speeds times k, accelerations times k^2, jerks times k^3.
[[nodiscard]] SCurveProfile scale_in_time(const SCurveProfile& profile, double duration_s) noexcept;

// Signed position from the start, speed, acceleration and jerk at `t_s`. For t_s < 0 the values at 0; from duration_s
// on exactly the distance, at rest. At a jump of the jerk the value after the jump.
[[nodiscard]] double position(const SCurveProfile& profile, double t_s) noexcept;
[[nodiscard]] double velocity(const SCurveProfile& profile, double t_s) noexcept;
[[nodiscard]] double acceleration(const SCurveProfile& profile, double t_s) noexcept;
[[nodiscard]] double jerk(const SCurveProfile& profile, double t_s) noexcept;

// The inverse of position(): the time at which `covered`, the distance from the start in the direction of motion, is
// reached. 0 before the start, the whole duration beyond the end.
[[nodiscard]] double time_at(const SCurveProfile& profile, double covered) noexcept;

}  // namespace armature
