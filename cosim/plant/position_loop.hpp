// A motor under the position loop of its drive: a second-order system with torque and speed limits.
//
//   x'' = -wn^2 x - 2 zeta wn x',   |x''| <= torque / inertia,   |x'| <= speed limit
//
// x is the position minus the reference, in encoder counts: Shaft::error. The reference is constant during a step
// (kPlantStep). Inside the limits a step is the exact solution of the equation; at a limit it is a motion of constant
// acceleration.
#pragma once

#include "cosim/plant/mechanics.hpp"
#include "cosim/robot/robot_spec.hpp"

namespace armature::cosim {

class PositionLoop {
 public:
  // Throws std::invalid_argument when a value is not positive or the loop is too fast for the step (wn h > 0.5).
  PositionLoop(const DriveSpec& spec, double counts_per_rev);

  // One step under control. A shaft at rest stays as it is.
  void step(Shaft& shaft) const;

  // One step with the windings shorted: decelerates to standstill with the full torque and stays there.
  void brake(Shaft& shaft) const;

  // Of a step under control, in counts and steps.
  struct Numbers {
    // (error, speed) after a step within the limits = this matrix times (error, speed) before it.
    double error_by_error, error_by_speed, speed_by_error, speed_by_speed;
    double max_accel, max_speed;  // the limits
    double rest_speed;            // below it, and below kRestCounts, the shaft is set to rest
  };
  [[nodiscard]] const Numbers& numbers() const { return numbers_; }

  // A settling motion below this is set to rest, so that a finished motion needs no computation: a millionth of a
  // count.
  static constexpr double kRestCounts = 0x1.0p-20;

 private:
  void move_with(double accel, Shaft& shaft) const;
  void settle(Shaft& shaft) const;

  double stiffness_;  // (wn h)^2
  double drag_;       // 2 zeta wn h
  Numbers numbers_;
};

}  // namespace armature::cosim
