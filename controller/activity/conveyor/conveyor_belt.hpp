// Position and velocity of a belt from the counts of its encoder, and where the belt is expected a little later.
//
// An observer of third order with equal poles estimates position, velocity and acceleration. It follows a constant
// acceleration without error. Its position still jumps with the counts. So the expected position is that of a second
// system, which follows the observer with a continuous velocity: its position is always the integral of its velocity.
// After a jump of the belt's acceleration by a it deviates by up to 2.5 a / kBandwidth^2 for some 30 ms.
#pragma once

#include <cstdint>

#include "controller/base/units.hpp"
#include "controller/trajectory/state/phase_law.hpp"

namespace armature {

class ConveyorBelt {
 public:
  static constexpr double kBandwidth = 200.0;  // 1/s, of each system

  // `ahead_s` >= 0: how much later than a sample the belt is expected.
  ConveyorBelt(double mm_per_count, double ahead_s) noexcept : mm_per_count_{mm_per_count}, ahead_s_{ahead_s} {}

  // A count stands for the middle of its interval.
  [[nodiscard]] static double position_of(std::int64_t counts, double mm_per_count) noexcept {
    return (static_cast<double>(counts) + 0.5) * mm_per_count;
  }

  // The count of a tick, later than that of the last call.
  void sample(std::int64_t counts, Ticks tick) noexcept;

  // In mm, at the tick of the last sample.
  [[nodiscard]] double position_mm() const noexcept { return position_mm_; }
  [[nodiscard]] double velocity_mm_s() const noexcept { return velocity_mm_s_; }
  // `ahead_s` later.
  [[nodiscard]] const AxisState& expected() const noexcept { return expected_; }

 private:
  double mm_per_count_, ahead_s_;
  double position_mm_ = 0.0;
  double velocity_mm_s_ = 0.0;
  double accel_mm_s2_ = 0.0;
  AxisState expected_{};
  Ticks tick_{};
  bool sampled_ = false;
};

}  // namespace armature
