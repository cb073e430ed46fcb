// How far an axis can move from a state of motion and still come to rest: one set of rules for each profile.
//
// All rules are exact: closed forms, and for one duration a Newton iteration that converges from one side. They are
// internal to axis_reach.hpp and axis_passage.hpp. Limits and durations are finite, limits > 0.
#pragma once

#include "controller/trajectory/profile/time_law.hpp"
#include "controller/trajectory/state/phase_law.hpp"

namespace armature {

// The three last rules start at a state from which the speed need not exceed its limit; that after lead() is one.
struct ReachRules {
  // The phases that return a start beyond a limit into it, without delay; none for other starts. They end where an
  // acceleration that returns to 0 at once does so exactly at the speed limit. Every time-optimal motion, a stop
  // included, begins with them.
  Phases (*lead)(const AxisState& start, const TimeLawLimits& limits) noexcept;
  // The shortest phases to constant `velocity`.
  Phases (*ramp)(const AxisState& start, double velocity, const TimeLawLimits& limits) noexcept;
  // The least time to come to rest at `distance` from the start. It must not be less than the distance of a stop.
  double (*shortest_s)(const AxisState& start, double distance, const TimeLawLimits& limits) noexcept;
  // The phases that end at rest after `duration_s`, not less than the time of a stop, as far in the positive direction
  // as possible.
  Phases (*farthest)(const AxisState& start, double duration_s, const TimeLawLimits& limits) noexcept;
};

extern const ReachRules kTrapezoidReach;  // accelerations may jump; that of the start has no effect
extern const ReachRules kSCurveReach;

[[nodiscard]] inline const ReachRules& rules_of(ProfileKind kind) noexcept {
  return kind == ProfileKind::kSCurve ? kSCurveReach : kTrapezoidReach;
}

}  // namespace armature
