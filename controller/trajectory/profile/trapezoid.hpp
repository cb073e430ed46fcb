// Trapezoidal and triangular velocity profiles of one axis, Vo 2021 eq. (1)-(11).
//
// Any unit of length L, with speeds in L/s and accelerations in L/s^2. The distance may have either sign. With a
// distance of 0, where the printed equations divide by zero, the profile is empty and takes no time.
#pragma once

#include <cstdint>

namespace armature {

// kSCurve is a shape of scurve.hpp.
enum class ProfileShape : std::uint8_t { kNone, kTriangle, kTrapezoid, kSCurve };

struct ProfileLimits {
  double speed = 0.0;  // > 0
  double accel = 0.0;  // > 0, for accelerating and for braking
};

// Accelerates for accel_s, cruises for cruise_s, brakes for accel_s. Symmetric in time.
struct TrapezoidProfile {
  ProfileShape shape = ProfileShape::kNone;
  double sign = 1.0;      // of the motion, +1 or -1
  double distance = 0.0;  // >= 0
  double peak_speed = 0.0;
  double accel = 0.0;
  double accel_s = 0.0;   // t_c
  double cruise_s = 0.0;  // T - 2 t_c, 0 for a triangle
  double duration_s = 0.0;
};

// The fastest profile over `distance` within the limits. If the distance just suffices to reach the speed limit, the
// shape is a triangle.
[[nodiscard]] TrapezoidProfile plan_profile(double distance, const ProfileLimits& limits) noexcept;

// The profile over `distance` that takes `duration_s` with this acceleration, Vo 2021 eq. (13). If the acceleration is
// too small, the result is the triangle of eq. (14), which needs more; see its `accel`.
[[nodiscard]] TrapezoidProfile plan_with_accel(double distance, double accel, double duration_s) noexcept;

// The triangle over `distance` that takes `duration_s`, Vo 2021 eq. (14).
[[nodiscard]] TrapezoidProfile plan_triangle(double distance, double duration_s) noexcept;

// The same path in `duration_s`: speeds times k, accelerations times k^2, with k the ratio of the durations.
[[nodiscard]] TrapezoidProfile scale_in_time(const TrapezoidProfile& profile, double duration_s) noexcept;

// Signed position from the start, speed and acceleration at `t_s`. For t_s < 0 the values at 0; from duration_s on
// exactly the distance, at rest. At a jump of the acceleration the value after the jump.
[[nodiscard]] double position(const TrapezoidProfile& profile, double t_s) noexcept;
[[nodiscard]] double velocity(const TrapezoidProfile& profile, double t_s) noexcept;
[[nodiscard]] double acceleration(const TrapezoidProfile& profile, double t_s) noexcept;

// The inverse of position(): the time at which `covered`, the distance from the start in the direction of motion, is
// reached. 0 before the start, the whole duration beyond the end.
[[nodiscard]] double time_at(const TrapezoidProfile& profile, double covered) noexcept;

}  // namespace armature
