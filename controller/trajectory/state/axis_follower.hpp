// One axis that follows a moving reference, tick by tick, within its limits.
//
// Where the axis can be on the reference at the end of a tick, with its velocity (and acceleration, with a jerk limit),
// it is there: two phases of constant acceleration (three of constant jerk) within the tick, inside all limits.
// Elsewhere it makes one tick of the fastest motion to rest in the frame that moves with the reference, with what the
// speed and the acceleration of the frame leave of the limits. A step after which the axis could not stop before an end
// of its range is replaced by one tick of the fastest stop. So the range is never left.
#pragma once

#include "controller/trajectory/profile/time_law.hpp"
#include "controller/trajectory/state/phase_law.hpp"

namespace armature {

class AxisFollower {
 public:
  struct Range {
    double least = 0.0;
    double largest = 0.0;
  };
  AxisFollower() noexcept = default;
  // Limits > 0; jerk only for kSCurve. The axis stands at `position`, inside its range.
  AxisFollower(ProfileKind kind, const TimeLawLimits& limits, const Range& range, double position) noexcept;

  // Continues from here: a state within the limits, from which the axis can stop inside its range.
  void set_state(const AxisState& state) noexcept { state_ = state; }

  // Makes one tick. `reference`: where the axis should be after it.
  void advance(const AxisState& reference) noexcept;
  [[nodiscard]] const AxisState& state() const noexcept { return state_; }

  // The fastest stop within the limits.
  [[nodiscard]] PhaseLaw stop() const noexcept;

 private:
  [[nodiscard]] bool meets(const AxisState& reference) const noexcept;
  [[nodiscard]] AxisState towards(const AxisState& reference) const noexcept;
  [[nodiscard]] bool keeps_speed(const AxisState& next) const noexcept;
  [[nodiscard]] bool can_stop_after(const AxisState& next) const noexcept;

  ProfileKind kind_ = ProfileKind::kTrapezoid;
  TimeLawLimits limits_{};
  Range range_{};
  AxisState state_{};
};

}  // namespace armature
