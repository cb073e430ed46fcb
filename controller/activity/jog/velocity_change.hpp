// The change of a velocity of the tool into another one, from any present acceleration, under limits of acceleration
// and jerk.
//
// Without a present acceleration the velocity goes to its end on a straight line (of velocities), and its acceleration
// is a trapezoid in time. Otherwise the acceleration turns first: on a straight line (of accelerations) into the
// direction of what is left of the change then. It keeps of the part that already has this direction what the rest of
// the change can take up. From there on the velocity goes straight to its end.
//
// Accelerations are within the limits where the present one is, because they lie between it and another one that is. An
// acceleration turns with the jerk that it came with, if that is larger than the new limit. Otherwise a smaller limit
// would let the velocity run away before the acceleration has gone.
#pragma once

#include <Eigen/Core>

#include "controller/base/axes.hpp"
#include "controller/trajectory/state/phase_law.hpp"

namespace armature {

class VelocityChange {
 public:
  using Twist = Eigen::Matrix<double, 6, 1>;  // mm/s and rad/s, or their derivatives

  // A change of velocity per second, and what it means for the joints. Both are linear in it.
  struct Change {
    Twist twist = Twist::Zero();
    PerAxis<double> joints_rad_s{};
  };
  struct Limits {
    double accel_mm_s2 = 0.0;        // > 0
    double turn_accel_rad_s2 = 0.0;  // > 0
    double jerk_mm_s3 = 0.0;         // 0: not limited
    double turn_jerk_rad_s3 = 0.0;
    PerAxis<double> joint_accel_rad_s2{};  // > 0 for axes with a rate
    double tick_s = 0.0;                   // an acceleration that may jump does so within a tick
  };

  // At `velocity` for all time.
  void keep(const Twist& velocity) noexcept;
  // From `velocity` with the acceleration `accel`, by `way`, at the time `t_s` of the present change. False if nothing
  // limits the change, or if a joint cannot follow it.
  [[nodiscard]] bool plan(double t_s, const Twist& velocity, const Change& accel, const Change& way,
                          const Limits& limits) noexcept;

  // The same in two parts of about the same work. In between only finish() may be called.
  void begin(double t_s, const Twist& velocity, const Change& accel, const Change& way, const Limits& limits) noexcept;
  [[nodiscard]] bool finish() noexcept;

  // At a time from the start on; exactly the end of the way when the change is over.
  [[nodiscard]] Twist at(double t_s) const noexcept;

 private:
  struct Jerk {
    double move = 0.0, turn = 0.0;  // 0: not limited
  };
  // A direction of acceleration, and what of it the limits are compared with.
  struct Direction {
    Change change;
    double move_mm_s = 0.0, turn_rad_s = 0.0;  // the lengths of both parts
  };
  [[nodiscard]] Direction left_after(double turn_s) const noexcept;
  [[nodiscard]] double turned_accel(const Direction& left, double turn_s) const noexcept;
  [[nodiscard]] double turns_beyond(double turn_s) const noexcept;
  [[nodiscard]] Twist per_jerk(const Twist& change) const noexcept;
  [[nodiscard]] double most_accel(const Direction& direction) const noexcept;
  [[nodiscard]] double most_jerk(const Direction& direction) const noexcept;

  Limits limits_{};
  Jerk turning_{};  // while the acceleration turns
  Change accel_{}, way_{};
  Twist accel_per_jerk_ = Twist::Zero();
  Twist from_ = Twist::Zero(), end_ = Twist::Zero();
  double turn_s_ = 0.0;                 // the acceleration turns
  Twist accel_change_ = Twist::Zero();  // by this
  Twist turned_ = Twist::Zero();        // velocity when it has turned
  Twist direction_ = Twist::Zero();     // from there on
  PhaseLaw law_{};                      // in shares of direction_
};

}  // namespace armature
