// Time law of a motion over a distance: one interface to trapezoids and S-curves.
//
// Any unit of length; rest-to-rest; symmetric in time except for a trapezoid with gentle ends.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "controller/trajectory/profile/eased_trapezoid.hpp"
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
  bool eased = false;            // kTrapezoid with gentle ends
  TrapezoidProfile trapezoid{};  // valid according to `kind` and `eased`, like the two below
  EasedTrapezoid eased_trapezoid{};
  SCurveProfile scurve{};

  [[nodiscard]] ProfileShape shape() const noexcept;
  [[nodiscard]] double duration_s() const noexcept;
  [[nodiscard]] double peak_speed() const noexcept;
  [[nodiscard]] double peak_accel() const noexcept;
};

// The times at which the acceleration of a trapezoid or the jerk of an S-curve jumps, in order, including begin and
// end.
struct Kinks {
  static constexpr std::size_t kMax = 8;
  std::array<double, kMax> time_s{};
  std::size_t count = 0;
};
[[nodiscard]] Kinks kinks(const TimeLaw& law) noexcept;

// The fastest law over `distance` (either sign, 0 takes no time) within the limits.
[[nodiscard]] TimeLaw plan_time_law(ProfileKind kind, double distance, const TimeLawLimits& limits) noexcept;

// A trapezoid over `distance` > 0 with gentle ends; see plan_eased(). If neither end takes time it is a plain
// trapezoid.
[[nodiscard]] TimeLaw plan_eased_law(double distance, const TimeLawLimits& limits, const GentleEnd& first,
                                     const GentleEnd& last) noexcept;

// The same path in `duration_s`: speeds times k, accelerations times k^2, jerks times k^3.
[[nodiscard]] TimeLaw scale_in_time(const TimeLaw& law, double duration_s) noexcept;

// Signed position, speed and acceleration. For t_s < 0 the values at 0; from the duration on exactly the distance, at
// rest.
[[nodiscard]] double position(const TimeLaw& law, double t_s) noexcept;
[[nodiscard]] double velocity(const TimeLaw& law, double t_s) noexcept;
[[nodiscard]] double acceleration(const TimeLaw& law, double t_s) noexcept;

// The time at which `covered`, the distance from the start in the direction of motion, is reached; see trapezoid.hpp.
[[nodiscard]] double time_at(const TimeLaw& law, double covered) noexcept;

// The time before the end at which the distance to the end is `left`: time_at() of the law executed backwards.
[[nodiscard]] double time_before_end(const TimeLaw& law, double left) noexcept;

}  // namespace armature
