// A trapezoidal velocity profile whose ends are gentler than its ramps: for a segment whose ends are rounded corners.
//
// From rest it speeds up with the acceleration of its first end for as long as that end lasts, with its own up to the
// peak speed, cruises, and brakes with its own and then with that of its last end. Where a corner is rounded the tool
// then has the full acceleration everywhere but in the corner itself. Any unit of length L: L/s, L/s^2.
#pragma once

#include "controller/trajectory/profile/trapezoid.hpp"

namespace armature {

// How a profile begins or, seen backwards, how it ends.
struct GentleEnd {
  double accel = 0.0;  // >= 0
  double time_s = 0.0;

  [[nodiscard]] double speed() const noexcept { return accel * time_s; }
  [[nodiscard]] double distance() const noexcept { return 0.5 * accel * time_s * time_s; }
};

struct EasedTrapezoid {
  GentleEnd first{}, last{};
  double distance = 0.0;  // > 0
  double peak_speed = 0.0;
  double accel = 0.0;
  double up_s = 0.0;  // between the first end and the peak speed
  double cruise_s = 0.0;
  double down_s = 0.0;
  double duration_s = 0.0;  // the sum of all five
};

// The fastest profile over `distance` > 0 with these ends. Neither end is faster than the speed limit, and the way
// between them is long enough to change from the speed of one to that of the other: always so where no end takes more
// than a third of the distance, or only one of them takes time and not more than half.
[[nodiscard]] EasedTrapezoid plan_eased(double distance, const ProfileLimits& limits, const GentleEnd& first,
                                        const GentleEnd& last) noexcept;

// The same path in `duration_s`: speeds times k, accelerations times k^2, with k the ratio of the durations.
[[nodiscard]] EasedTrapezoid scale_in_time(const EasedTrapezoid& profile, double duration_s) noexcept;

// As it is driven backwards.
[[nodiscard]] EasedTrapezoid reversed(const EasedTrapezoid& profile) noexcept;

// As those of TrapezoidProfile.
[[nodiscard]] double position(const EasedTrapezoid& profile, double t_s) noexcept;
[[nodiscard]] double velocity(const EasedTrapezoid& profile, double t_s) noexcept;
[[nodiscard]] double acceleration(const EasedTrapezoid& profile, double t_s) noexcept;
[[nodiscard]] double time_at(const EasedTrapezoid& profile, double covered) noexcept;

}  // namespace armature
