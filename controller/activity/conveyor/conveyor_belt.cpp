#include "controller/activity/conveyor/conveyor_belt.hpp"

#include <utility>

#include "controller/base/timebase.hpp"

namespace armature {
namespace {

// Tuned for targets of a hand with a camera at 50 Hz, 40 ms late, and noise of 0.2 mm (armature train --camera).
constexpr double kObserverPerSample = 0.75, kSecondPerSample = 1.0;

}  // namespace

ConveyorBelt::Bandwidths ConveyorBelt::bandwidths_for(const std::optional<BeltCamera>& camera) noexcept {
  if (!camera) return {};
  return {.observer = kObserverPerSample / seconds(camera->period),
          .second = kSecondPerSample / seconds(camera->period)};
}

void ConveyorBelt::measure(std::int64_t counts, Ticks tick) noexcept {
  const double measured_mm = position_of(counts, mm_per_count_);
  const std::optional<Ticks> before = std::exchange(measured_, tick);
  if (!before) {
    position_mm_ = measured_mm;
    return;
  }
  const double time_s = seconds(tick - *before);
  const double pole = 1.0 / (1.0 + bandwidths_.observer * time_s), gain = 1.0 - pole;
  const AxisState predicted =
      after({.position = position_mm_, .velocity = velocity_mm_s_, .accel = accel_mm_s2_}, 0.0, time_s);
  error_mm_ = measured_mm - predicted.position;
  position_mm_ = predicted.position + (1.0 - pole * pole * pole) * error_mm_;
  velocity_mm_s_ = predicted.velocity + 1.5 * gain * gain * (1.0 + pole) / time_s * error_mm_;
  accel_mm_s2_ += gain * gain * gain / (time_s * time_s) * error_mm_;
}

void ConveyorBelt::expect(Ticks tick, double correction_mm) noexcept {
  if (!measured_) return;
  const AxisState estimate{.position = position_mm_, .velocity = velocity_mm_s_, .accel = accel_mm_s2_};
  const double age_s = seconds(tick - *measured_);
  now_mm_ = after(estimate, 0.0, age_s).position;
  const std::optional<Ticks> before = std::exchange(expected_at_, tick);
  if (!before) {
    expected_ = {.position = position_mm_};
    return;
  }
  const double time_s = seconds(tick - *before);
  target_ = after(estimate, 0.0, ahead_s_ - time_s + age_s);
  const double second = bandwidths_.second, error = target_.position + correction_mm - expected_.position;
  const double accel = accel_mm_s2_ + second * (second * error + 2.0 * (target_.velocity - expected_.velocity));
  expected_ = after({.position = expected_.position, .velocity = expected_.velocity, .accel = accel}, 0.0, time_s);
}

}  // namespace armature
