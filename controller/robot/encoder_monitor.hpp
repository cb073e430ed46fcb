// Speed and acceleration of the axes as their encoders show them, against limits of the robot.
//
// Both are means over fixed windows, so that single counts do not matter: the speed over 1 ms, the acceleration from
// the motions in two successive windows of 5 ms. A speed above the limit is found after 2 ms at the latest, an
// acceleration after 10 ms. They need an encoder that is always counted. The windows of each axis end in a tick of
// their own, every second one, so that no tick has the work of all axes.
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
  static constexpr std::uint32_t kSpeedTicks = 20;
  static constexpr std::uint32_t kAccelWindows = 5;  // windows of the speed in one of the acceleration

  explicit EncoderMonitor(const RobotModel& robot) noexcept
      : max_moved_{make_per_axis([&](std::size_t i) { return limit(robot.axes[i], &AxisModel::encoder_speed_rad_s); })},
        max_change_{
            make_per_axis([&](std::size_t i) { return limit(robot.axes[i], &AxisModel::encoder_accel_rad_s2); })} {}

  // The axes continue from where they are in the next ticks, whatever was before.
  void restart() noexcept {
    axes_ = {};
    too_fast_ = too_hard_ = 0;
  }

  // Once per tick. Afterwards too_fast() and too_hard() are those of the windows that end in this tick.
  void observe(const PerAxis<Counts>& encoder) noexcept {
    too_fast_ = too_hard_ = 0;
    const std::uint32_t slot = ticks_;
    ticks_ = slot + 1 < kSpeedTicks ? slot + 1 : 0;
    const std::size_t axis = slot / 2;
    if (slot % 2 != 0 || axis >= kAxes) return;
    const auto bit = static_cast<std::uint8_t>(1u << axis);
    const Counts here = encoder[axis];
    Axis& one = axes_[axis];
    if (one.begun) {
      if (distance(here - one.encoder) > max_moved_[axis]) too_fast_ = bit;
      if (++one.windows == kAccelWindows && end_window(one, here) > max_change_[axis]) too_hard_ = bit;
    } else {
      one.begun = true;
      one.window_began = here;
    }
    one.encoder = here;
  }

  // No window ends in the tick of the last observe(): there is time for other checks. True in every second tick.
  [[nodiscard]] bool rests() const noexcept { return ticks_ % 2 == 0; }

  // Masks of axes, bit 0 for axis 1.
  [[nodiscard]] std::uint8_t too_fast() const noexcept { return too_fast_; }
  [[nodiscard]] std::uint8_t too_hard() const noexcept { return too_hard_; }

 private:
  struct Axis {
    bool begun = false;     // the members below are known
    bool compares = false;  // `moved` is known
    std::uint32_t windows = 0;
    Counts encoder{};       // at the begin of the window of the speed
    Counts window_began{};  // of that of the acceleration
    Counts moved{};         // in the one before
  };

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

  // The change of the motion from the window before to the one that ends here; 0: there was none before. [counts]
  [[nodiscard]] static double end_window(Axis& one, Counts here) noexcept {
    const Counts moved = here - one.window_began;
    const double change = one.compares ? distance(moved - one.moved) : 0.0;
    one.compares = true;
    one.moved = moved;
    one.window_began = here;
    one.windows = 0;
    return change;
  }

  PerAxis<double> max_moved_, max_change_;  // [counts]
  PerAxis<Axis> axes_{};
  std::uint32_t ticks_ = 0;
  std::uint8_t too_fast_ = 0, too_hard_ = 0;
};

}  // namespace armature
