// Time law of a motion over a distance: one interface to trapezoids and S-curves.
//
// Any unit of length; rest-to-rest; symmetric in time.
#pragma once

#include <cstdint>

#include "controller/trajectory/profile/scurve.hpp"
#include "controller/trajectory/profile/trapezoid.hpp"

namespace armature {

enum class ProfileKind : std::uint8_t { kTrapezoid, kSCurve };

struct TimeLawLimits {
  double speed = 0.0;  // > 0
  double accel = 0.0;  // > 0
  double jerk = 0.0;   // > 0 for kSCurve, ignored for kTrapezoid
};

struct TimeLaw {
  ProfileKind kind = ProfileKind::kTrapezoid;
  TrapezoidProfile trapezoid{};  // valid according to `kind`, like the one below
  SCurveProfile scurve{};

  [[nodiscard]] ProfileShape shape() const noexcept;
  [[nodiscard]] double duration_s() const noexcept;
  [[nodiscard]] double peak_speed() const noexcept;
  [[nodiscard]] double peak_accel() const noexcept;
};

// The fastest law over `distance` (either sign, 0 takes no time) within the limits.
[[nodiscard]] TimeLaw plan_time_law(ProfileKind kind, double distance, const TimeLawLimits& limits) noexcept;

// The same path in `duration_s`: speeds times k, accelerations times k^2, jerks times k^3.
[[nodiscard]] TimeLaw scale_in_time(const TimeLaw& law, double duration_s) noexcept;

// Signed position, speed and acceleration. For t_s < 0 the values at 0; from the duration on exactly the distance, at
// rest.
[[nodiscard]] double position(const TimeLaw& law, double t_s) noexcept;
[[nodiscard]] double velocity(const TimeLaw& law, double t_s) noexcept;
[[nodiscard]] double acceleration(const TimeLaw& law, double t_s) noexcept;

// The time at which `covered`, the distance from the start in the direction of motion, is reached; see trapezoid.hpp.
[[nodiscard]] double time_at(const TimeLaw& law, double covered) noexcept;

}  // namespace armature
