// Speed and acceleration of the axes as their encoders show them, against limits of the robot.
//
// Both are means over fixed windows, so that single counts do not matter: the speed over 1 ms, the acceleration from
// the motions in two successive windows of 5 ms. A speed above the limit is found after 2 ms at the latest, an
// acceleration after 10 ms. They need an encoder that is always counted.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "controller/base/axes.hpp"
#include "controller/base/timebase.hpp"
#include "controller/base/units.hpp"
#include "controller/robot/axis_units.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature {

class EncoderMonitor {
 public:
  static constexpr std::int32_t kSpeedTicks = 20;
  static constexpr std::int32_t kAccelWindows = 5;  // windows of the speed in one of the acceleration

  explicit EncoderMonitor(const RobotModel& robot) noexcept
      : max_moved_{make_per_axis([&](std::size_t i) { return limit(robot.axes[i], &AxisModel::encoder_speed_rad_s); })},
        max_change_{
            make_per_axis([&](std::size_t i) { return limit(robot.axes[i], &AxisModel::encoder_accel_rad_s2); })} {}

  // The axes continue from here, whatever was before.
  void restart(const PerAxis<Counts>& encoder) noexcept {
    encoder_ = window_began_ = encoder;
    ticks_ = windows_ = 0;
    compares_ = false;
    too_fast_ = too_hard_ = 0;
  }

  // Once per tick. Afterwards too_fast() and too_hard() are those of the windows that end in this tick.
  void observe(const PerAxis<Counts>& encoder) noexcept {
    too_fast_ = too_hard_ = 0;
    if (++ticks_ < kSpeedTicks) return;
    ticks_ = 0;
    too_fast_ = mask_of([&](std::size_t axis) { return distance(encoder[axis] - encoder_[axis]) > max_moved_[axis]; });
    encoder_ = encoder;
    if (++windows_ < kAccelWindows) return;
    windows_ = 0;
    end_window(encoder);
  }

  // Masks of axes, bit 0 for axis 1.
  [[nodiscard]] std::uint8_t too_fast() const noexcept { return too_fast_; }
  [[nodiscard]] std::uint8_t too_hard() const noexcept { return too_hard_; }

 private:
  template <class Test>
  [[nodiscard]] static std::uint8_t mask_of(Test test) noexcept {
    std::uint8_t mask = 0;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (test(axis)) mask = static_cast<std::uint8_t>(mask | (1u << axis));
    }
    return mask;
  }
  [[nodiscard]] static double distance(Counts moved) noexcept { return std::fabs(static_cast<double>(moved.value())); }

  // In counts of a window. Each of its ends is up to a count away from where the axis is.
  [[nodiscard]] static double limit(const AxisModel& axis, double AxisModel::*rate) noexcept {
    if (axis.*rate == 0.0) return std::numeric_limits<double>::infinity();
    const double speed_s = kSpeedTicks * kTickSeconds, accel_s = kAccelWindows * speed_s;
    const bool is_speed = rate == &AxisModel::encoder_speed_rad_s;
    const double moved_rad = axis.*rate * (is_speed ? speed_s : accel_s * accel_s);
    const double counts_per_rad = std::fabs(axis.gear_ratio) * axis.counts_per_rev / (2.0 * std::numbers::pi);
    return moved_rad * counts_per_rad + (is_speed ? 1.0 : 2.0);
  }

  void end_window(const PerAxis<Counts>& encoder) noexcept {
    PerAxis<Counts> moved;
    for (std::size_t axis = 0; axis < kAxes; ++axis) moved[axis] = encoder[axis] - window_began_[axis];
    if (compares_) {
      too_hard_ = mask_of([&](std::size_t axis) { return distance(moved[axis] - moved_[axis]) > max_change_[axis]; });
    }
    compares_ = true;
    moved_ = moved;
    window_began_ = encoder;
  }

  PerAxis<double> max_moved_, max_change_;  // [counts]
  PerAxis<Counts> encoder_{};               // at the begin of the window of the speed
  PerAxis<Counts> window_began_{};          // of that of the acceleration
  PerAxis<Counts> moved_{};                 // in the one before
  std::int32_t ticks_ = 0, windows_ = 0;
  bool compares_ = false;  // moved_ is known
  std::uint8_t too_fast_ = 0, too_hard_ = 0;
};

}  // namespace armature
