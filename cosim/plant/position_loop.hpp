// A motor under the position loop of its drive: a second-order system with torque and speed limits.
//
//   x'' = -wn^2 x - 2 zeta wn x',   |x''| <= torque / inertia,   |x'| <= speed limit
//
// x is the position minus the reference, in encoder counts. The reference is constant during a step (kPlantStep).
// Inside the limits a step is the exact solution of the equation; at a limit it is a motion of constant acceleration.
#pragma once

#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

class PositionLoop {
 public:
  // Throws std::invalid_argument when a value is not positive or the loop is too fast for the step (wn h > 0.5).
  PositionLoop(const DriveSpec& spec, double counts_per_rev);

  // The reference has moved by this many counts.
  void shift_reference(double counts) { error_ -= counts; }

  // The reference is placed so that position minus reference is `error`; the motion goes on.
  void set_error(double error) { error_ = error; }

  // One step under control.
  void step();

  // One step with the windings shorted: decelerates to standstill with the full torque and stays there.
  void brake();

  // Position minus reference [counts].
  [[nodiscard]] double error() const { return error_; }
  // Speed [counts per step].
  [[nodiscard]] double speed() const { return speed_; }
  [[nodiscard]] bool stands() const { return speed_ == 0.0; }
  // Exactly on the reference and standing: further steps change nothing.
  [[nodiscard]] bool at_rest() const { return error_ == 0.0 && speed_ == 0.0; }

 private:
  void move_with(double accel);
  void settle();

  // Everything in counts and steps.
  double stiffness_;  // (wn h)^2
  double drag_;       // 2 zeta wn h
  double max_accel_;
  double max_speed_;
  double rest_speed_;
  // (x, v) after a step = Phi (x, v) before it.
  double phi_xx_, phi_xv_, phi_vx_, phi_vv_;

  double error_ = 0.0;
  double speed_ = 0.0;
};

}  // namespace armature::cosim
