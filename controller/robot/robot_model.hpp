// A robot as constant data: the properties of each axis that the controller needs. The host loads it from
// scenarios/robots/*.toml and gives it to the controller in the host memory.
#pragma once

#include <cstdint>
#include <optional>

#include "controller/base/axes.hpp"
#include "controller/base/members.hpp"
#include "controller/base/misfit.hpp"
#include "controller/robot/arm_geometry.hpp"

namespace armature {

// How an axis finds its joint angle, see activity/homing/axis_homing.hpp.
struct HomingModel {
  std::uint8_t order = 1;     // axes with the lowest number first, those with the same number together
  double direction = -1.0;    // of the search for the home switch: 1 or -1, joint side
  double search_rad_s = 0.0;  // > 0
  double latch_rad_s = 0.0;   // > 0; away from the edge of the switch to the index
  double index_rad = 0.0;     // joint angle at the first index behind the edge
  double home_rad = 0.0;      // where the axis stands at the end

  [[nodiscard]] constexpr const void* misfit() const noexcept {
    return first_misfit({{&order, order >= 1 && order <= kAxes},
                         {&direction, direction == 1.0 || direction == -1.0},
                         {&search_rad_s, is_positive(search_rad_s)},
                         {&latch_rad_s, is_positive(latch_rad_s)},
                         {&index_rad, is_finite(index_rad)},
                         {&home_rad, is_finite(home_rad)}});
  }
  ARMATURE_MEMBERS(HomingModel, order, direction, search_rad_s, latch_rad_s, index_rad, home_rad)
};

struct AxisModel {
  // Motor turns per joint turn; negative when motor and joint turn in opposite directions.
  double gear_ratio = 1.0;
  // Electronic gear of the drive: pulses per motor revolution.
  std::int32_t pulses_per_rev = 1;
  // Encoder counts (four per line) per motor revolution.
  std::int32_t counts_per_rev = 1;
  // An index of the encoder is at joint angle 0. An arm that starts there has its first index where it expects it.
  bool index_at_zero = false;

  // Joint limits and rates, joint side.
  double min_rad = 0.0;
  double max_rad = 0.0;
  double max_speed_rad_s = 0.0;
  double max_accel_rad_s2 = 0.0;
  double max_jerk_rad_s3 = 0.0;  // 0: not known; S-curve moves are then refused

  // The motion loop enters Fault when reference minus encoder position exceeds this. It must include the drive's normal
  // lag.
  double following_error_limit_rad = 0.0;

  // The same when the encoder is farther from where the nominal drive would be, with its lag, than this and a share of
  // the lag (feedback.hpp). 0: not checked.
  double following_error_at_rest_rad = 0.0;

  // The motion loop enters Fault when the encoder moves faster, or changes its speed faster (encoder_monitor.hpp). 0:
  // not checked.
  double encoder_speed_rad_s = 0.0;
  double encoder_accel_rad_s2 = 0.0;

  // The drive's nominal position loop, from which the feedback computes the lag: natural frequency and damping ratio.
  double drive_natural_rad_s = 0.0;
  double drive_damping = 1.0;

  // Direction set-up and hold times from the drive's data sheet, in cycles of the logic (20 ns), 0..1023: direction
  // stable before the first rising step edge after a change, and after the last falling edge before it. The logic has
  // one setting for all axes; the largest value is used.
  static constexpr std::int32_t kMaxDirCycles = 1023;
  std::int32_t dir_setup_cycles = 25;
  std::int32_t dir_hold_cycles = 25;

  // Shortest high and low time of a step pulse, likewise. Only generators of half periods need them; generators of
  // counts always keep longer times.
  std::int32_t min_step_high_cycles = 5;
  std::int32_t min_step_low_cycles = 5;

  std::optional<HomingModel> homing{};  // none: the axis cannot be homed

  [[nodiscard]] constexpr double nearer_limit_rad(double angle_rad) const noexcept {
    return angle_rad - min_rad < max_rad - angle_rad ? min_rad : max_rad;
  }

  [[nodiscard]] constexpr const void* misfit() const noexcept {
    return first_misfit({{&gear_ratio, is_finite(gear_ratio) && gear_ratio != 0.0},
                         {&pulses_per_rev, pulses_per_rev > 0},
                         {&counts_per_rev, counts_per_rev > 0},
                         {&min_rad, is_finite(min_rad)},
                         {&max_rad, is_finite(max_rad) && max_rad >= min_rad},
                         {&max_speed_rad_s, is_at_least_0(max_speed_rad_s)},
                         {&max_accel_rad_s2, is_at_least_0(max_accel_rad_s2)},
                         {&max_jerk_rad_s3, is_at_least_0(max_jerk_rad_s3)},
                         {&following_error_limit_rad, is_at_least_0(following_error_limit_rad)},
                         {&following_error_at_rest_rad, is_at_least_0(following_error_at_rest_rad)},
                         {&encoder_speed_rad_s, is_at_least_0(encoder_speed_rad_s)},
                         {&encoder_accel_rad_s2, is_at_least_0(encoder_accel_rad_s2)},
                         {&drive_natural_rad_s, is_at_least_0(drive_natural_rad_s)},
                         {&drive_damping, is_at_least_0(drive_damping)},
                         {&dir_setup_cycles, dir_setup_cycles >= 0 && dir_setup_cycles <= kMaxDirCycles},
                         {&dir_hold_cycles, dir_hold_cycles >= 0 && dir_hold_cycles <= kMaxDirCycles},
                         {&min_step_high_cycles, min_step_high_cycles >= 0},
                         {&min_step_low_cycles, min_step_low_cycles >= 0}});
  }
  ARMATURE_MEMBERS(AxisModel, gear_ratio, pulses_per_rev, counts_per_rev, index_at_zero, min_rad, max_rad,
                   max_speed_rad_s, max_accel_rad_s2, max_jerk_rad_s3, following_error_limit_rad,
                   following_error_at_rest_rad, encoder_speed_rad_s, encoder_accel_rad_s2, drive_natural_rad_s,
                   drive_damping, dir_setup_cycles, dir_hold_cycles, min_step_high_cycles, min_step_low_cycles, homing)
};

struct RobotModel {
  PerAxis<AxisModel> axes{};
  // Joints of the arm, 1..kAxes. The axes beyond have no drive; their set-points stay 0.
  std::uint32_t axis_count = kAxes;
  ArmGeometry arm{};

  [[nodiscard]] constexpr const void* misfit() const noexcept {
    return first_misfit({{&axis_count, axis_count >= 1 && axis_count <= kAxes}});
  }
  ARMATURE_MEMBERS(RobotModel, axes, axis_count, arm)
};

}  // namespace armature
