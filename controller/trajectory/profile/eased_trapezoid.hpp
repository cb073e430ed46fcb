// A trapezoidal velocity profile with gentler ends than its ramps, for a segment that ends in rounded corners.
//
// From rest it accelerates with the acceleration of its first end for the time of that end, then with its own up to the
// peak speed. It cruises, and brakes with its own acceleration and then with that of its last end. So at a rounded
// corner the tool has the full acceleration everywhere except in the corner itself. Any unit of length L: L/s, L/s^2.
#pragma once

#include "controller/trajectory/profile/trapezoid.hpp"

namespace armature {

// The begin of a profile or, seen backwards, its end.
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
  double up_s = 0.0;  // from the first end to the peak speed
  double cruise_s = 0.0;
  double down_s = 0.0;
  double duration_s = 0.0;  // the sum of all five
};

// The fastest profile over `distance` > 0 with these ends. Neither end may be faster than the speed limit, and the
// distance between them must be long enough to change from the speed of one to that of the other. This holds where no
// end uses more than a third of the distance, or where only one of them takes time and uses at most half.
[[nodiscard]] EasedTrapezoid plan_eased(double distance, const ProfileLimits& limits, const GentleEnd& first,
                                        const GentleEnd& last) noexcept;

// The same path in `duration_s`: speeds times k, accelerations times k^2, with k the ratio of the durations.
[[nodiscard]] EasedTrapezoid scale_in_time(const EasedTrapezoid& profile, double duration_s) noexcept;

// The profile executed backwards.
[[nodiscard]] EasedTrapezoid reversed(const EasedTrapezoid& profile) noexcept;

// As the functions of TrapezoidProfile.
[[nodiscard]] double position(const EasedTrapezoid& profile, double t_s) noexcept;
[[nodiscard]] double velocity(const EasedTrapezoid& profile, double t_s) noexcept;
[[nodiscard]] double acceleration(const EasedTrapezoid& profile, double t_s) noexcept;
[[nodiscard]] double time_at(const EasedTrapezoid& profile, double covered) noexcept;

}  // namespace armature
