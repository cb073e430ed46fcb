// The motion of an axis from one state of motion to another in a given time.
//
// The axis changes its velocity to a constant one, keeps it, and changes it to that of the end. Both changes are the
// shortest ones within the limits. The way grows with the constant velocity, so a search finds the one that leads to
// the end.
#pragma once

#include <array>

#include "controller/trajectory/profile/time_law.hpp"
#include "controller/trajectory/state/phase_law.hpp"
#include "controller/trajectory/state/reach_rules.hpp"

namespace armature {

class AxisPassage {
 public:
  // As for AxisReach. Both states may be beyond a limit: the axis then returns into it without delay, or leaves it at
  // the latest possible time.
  AxisPassage(ProfileKind kind, const AxisState& start, const AxisState& end, const TimeLawLimits& limits) noexcept;

  // The shortest duration. With an S-curve between two states in motion that are so close that the acceleration need
  // not return to 0 in between, a shorter motion of another form may exist.
  [[nodiscard]] double shortest_s() const noexcept;

  // The motion that takes `duration_s`, and ends exactly at the position and the velocity of the end. Returns false,
  // with `law` unchanged, if there is none. A longer duration can be impossible although a shorter one is possible: an
  // axis in motion that must not move far passes its end at once, or it stops and comes back.
  [[nodiscard]] bool motion(double duration_s, PhaseLaw& law) const noexcept;

 private:
  // Both changes of the velocity, for a constant velocity between them.
  struct Changes {
    double velocity = 0.0;
    double duration_s = 0.0;
    double excess = 0.0;  // of the end of both changes beyond the wanted one
  };
  [[nodiscard]] Changes changes(double velocity) const noexcept;
  // An end of the interval in which solve() searches the velocity.
  struct Bound {
    Changes changes;
    double excess = 0.0;  // of the end of the motion beyond the wanted one
    double weight = 0.0;  // the same, or less to move the next velocity away from here
  };
  [[nodiscard]] static double middle_of(const Bound& a, const Bound& b) noexcept;
  // Where the line through both weights is 0; the middle if that is not between them.
  [[nodiscard]] static double secant_of(const Bound& inside, const Bound& outside) noexcept;
  // Finds the velocity for which the end is the wanted one, between `first` and the limit of the speed. `time_for`
  // returns the time of constant velocity; < 0: there is none. Returns false if the limit is not enough.
  template <class TimeFor>
  [[nodiscard]] bool solve(const Changes& first, TimeFor time_for, Changes& solution) const noexcept;
  [[nodiscard]] PhaseLaw law_of(double velocity, double constant_s) const noexcept;
  [[nodiscard]] double way_size(double duration_s) const noexcept;

  // From a given state to its first state within the limits.
  struct Side {
    AxisState given;
    Phases lead{};
    double lead_s = 0.0;
    AxisState state{};

    Side(const ReachRules& rules, const AxisState& given, const TimeLawLimits& limits) noexcept;
  };

  const ReachRules& rules_;
  TimeLawLimits limits_;
  bool at_rest_;  // rests where it is
  Side start_;
  Side end_;  // in reversed time
  // Constant velocities whose changes take little time.
  std::array<double, 2> first_velocities_;
};

}  // namespace armature
