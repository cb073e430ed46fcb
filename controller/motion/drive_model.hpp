// The position of an undisturbed servo drive for the pulses that it receives: x'' = wn^2 (r - x) - 2 zeta wn x'.
//
// Exact for pulses that are spread evenly over their tick (a ramp of r): no integration error for any bandwidth.
#pragma once

#include "controller/core/units.hpp"

namespace armature {

class DriveModel {
 public:
  // Natural frequency > 0 and damping ratio > 0 of the position loop.
  DriveModel(double natural_rad_s, double damping) noexcept;

  // At rest at the position that follows from the pulses sent so far.
  void restart(Pulses sent) noexcept;

  // Advances by one tick in which `count` pulses are sent.
  void step(Pulses count) noexcept;

  // Corrects step(): `count` of its pulses were not sent.
  void subtract(Pulses count) noexcept;

  // The motor's expected position: the pulses sent so far, and its lag behind them.
  [[nodiscard]] Pulses sent() const noexcept { return sent_; }
  [[nodiscard]] double lag() const noexcept { return lag_; }

 private:
  double ramp_lag_ticks_;  // steady lag behind a ramp per pulse/tick: 2 zeta / (wn Ts)
  // (x, x') after a tick = exp(A) (x, x'), time in ticks
  double phi_xx_, phi_xv_, phi_vx_, phi_vv_;

  // Only the small lag is a floating-point state, so nothing drifts over long distances.
  Pulses sent_{};
  double lag_ = 0.0;    // pulses
  double speed_ = 0.0;  // pulses/tick
};

}  // namespace armature
