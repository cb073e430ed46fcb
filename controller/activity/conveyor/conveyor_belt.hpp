// Position and velocity of a belt from the counts of its encoder or camera, and where the belt is expected a little
// later.
//
// An observer of third order with equal poles estimates position, velocity and acceleration. It follows a constant
// acceleration without error. Its position still jumps with the counts. So the expected position is that of a second
// system, which follows the observer with a continuous velocity: its position is always the integral of its velocity.
// After a jump of the belt's acceleration by a it deviates by up to 2.5 a / kBandwidth^2 for some 30 ms.
//
// A correction is added to the position that the second system follows. Its answer to a position does not overshoot, so
// the expected position never differs by more than the largest correction from that without any.
#pragma once

#include <cstdint>
#include <optional>

#include "controller/base/units.hpp"
#include "controller/cell/conveyor_config.hpp"
#include "controller/trajectory/state/phase_law.hpp"

namespace armature {

class ConveyorBelt {
 public:
  static constexpr double kBandwidth = 200.0;  // 1/s, of each system
  struct Bandwidths {
    double observer = kBandwidth, second = kBandwidth;
  };
  // For samples that come less often than each tick: an observer must see several within its own time, and the second
  // system passes on what is left of the step at each sample.
  [[nodiscard]] static Bandwidths bandwidths_for(const std::optional<BeltCamera>& camera) noexcept;

  // `ahead_s` >= 0: how much later than a sample the belt is expected.
  ConveyorBelt(double mm_per_count, double ahead_s, const Bandwidths& bandwidths) noexcept
      : mm_per_count_{mm_per_count}, ahead_s_{ahead_s}, bandwidths_{bandwidths} {}
  ConveyorBelt(double mm_per_count, double ahead_s) noexcept : ConveyorBelt{mm_per_count, ahead_s, Bandwidths{}} {}

  // A count stands for the middle of its interval.
  [[nodiscard]] static double position_of(std::int64_t counts, double mm_per_count) noexcept {
    return (static_cast<double>(counts) + 0.5) * mm_per_count;
  }

  // The count that the belt had in a tick, later than that of the last call.
  void measure(std::int64_t counts, Ticks tick) noexcept;
  // Once in each tick, after a sample that has come in it: what is expected in the tick, which is not before that of a
  // sample. `correction_mm`: of the position that is expected.
  void expect(Ticks tick, double correction_mm = 0.0) noexcept;
  // Both, for a belt that is measured in each tick.
  void sample(std::int64_t counts, Ticks tick, double correction_mm = 0.0) noexcept {
    measure(counts, tick);
    expect(tick, correction_mm);
  }

  // The tick of the last sample; none before the first.
  [[nodiscard]] std::optional<Ticks> measured() const noexcept { return measured_; }
  // In mm, at the tick of the last expect().
  [[nodiscard]] double now_mm() const noexcept { return now_mm_; }
  // At the tick of the last sample.
  [[nodiscard]] double position_mm() const noexcept { return position_mm_; }
  [[nodiscard]] double velocity_mm_s() const noexcept { return velocity_mm_s_; }
  [[nodiscard]] double accel_mm_s2() const noexcept { return accel_mm_s2_; }
  // The measured position minus the one that was predicted for it, at the last sample.
  [[nodiscard]] double error_mm() const noexcept { return error_mm_; }
  // What the second system follows: `ahead_s` later, without a correction.
  [[nodiscard]] const AxisState& target() const noexcept { return target_; }
  // `ahead_s` later.
  [[nodiscard]] const AxisState& expected() const noexcept { return expected_; }

 private:
  double mm_per_count_, ahead_s_;
  Bandwidths bandwidths_;
  double now_mm_ = 0.0;
  double position_mm_ = 0.0;
  double velocity_mm_s_ = 0.0;
  double accel_mm_s2_ = 0.0;
  double error_mm_ = 0.0;
  AxisState target_{}, expected_{};
  std::optional<Ticks> measured_, expected_at_;  // none before the first call that measures, or expects
};

}  // namespace armature
