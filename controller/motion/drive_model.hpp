// The position of an undisturbed servo drive for the pulses that it receives: x'' = wn^2 (r - x) - 2 zeta wn x'.
//
// Exact for pulses that are spread evenly over their tick (a ramp of r): no integration error for any bandwidth.
#pragma once

#include "controller/base/units.hpp"

namespace armature {

class DriveModel {
 public:
  // Natural frequency > 0 and damping ratio > 0 of the position loop.
  DriveModel(double natural_rad_s, double damping) noexcept;

  // At rest at the position that follows from the pulses sent so far.
  void restart(Pulses sent) noexcept;

  // Advances by one tick in which `count` pulses are sent.
  void step(Pulses count) noexcept {
    // Relative to the steady motion behind the ramp the system is unforced.
    const double ramp = static_cast<double>(count.value());
    const double x = ramp_lag_ticks_ * ramp - lag_;
    const double v = speed_ - ramp;
    sent_ += count;
    lag_ = ramp_lag_ticks_ * ramp - (phi_xx_ * x + phi_xv_ * v);
    speed_ = ramp + phi_vx_ * x + phi_vv_ * v;
  }

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
