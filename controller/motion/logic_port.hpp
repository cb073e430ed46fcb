// The interface between the motion loop and the programmable logic: one sample and one commit per tick.
//
// CountLogicPort is for the logic of this controller (counts, a decoder per axis), PaperLogicPort for that of Vo 2021
// (half periods, one decoder behind a switch).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/drivers/encoder.hpp"
#include "controller/drivers/pulse_train.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature {

// One sample of the logic after a trigger.
struct LogicInput {
  PulseTrain::Status status;
  PulseTrain::Switches switches;
  PulseTrain::Drives drives;
  Encoder::Faults encoder_faults;
  PerAxis<Counts> encoder{};                           // at the trigger, unwrapped to 64 bits
  std::uint8_t always_counted = PulseTrain::kAllAxes;  // mask of axes whose encoder is always counted; for other axes
                                                       // `encoder` lacks the motion while they were not selected
  std::uint32_t underruns = 0;                         // in all, as counted by the logic
  std::uint32_t new_underruns = 0;                     // since the sample before
  PerAxis<Pulses> not_emitted{};  // pulses that were committed and not emitted, since the previous sample; negative:
                                  // emitted and not committed
};

class LogicPort {
 public:
  // False when a block is not the one that this software supports; then nothing has been written.
  [[nodiscard]] virtual bool identified() noexcept = 0;

  // Configures the blocks, clears old flags, reads the counters, commits an empty set, enables the drives and starts
  // the trigger. If uncounted_axes() is not 0, nothing is committed and the drives stay off.
  virtual void start(const RobotModel& robot) noexcept = 0;

  // start() leaves the drives off. Call it before start().
  void keep_drives_off() noexcept { drives_at_start_ = false; }
  [[nodiscard]] bool drives_at_start() const noexcept { return drives_at_start_; }

  // The arm does not start at joint angles 0, so start() expects the first index of no axis there. Call it before
  // start().
  void start_anywhere() noexcept { starts_at_zero_ = false; }

  // Mask of axes (bit 0 for axis 1) whose encoder did not count when last sampled by start() or clear_faults().
  [[nodiscard]] std::uint8_t uncounted_axes() const noexcept { return uncounted_axes_; }

  // Acknowledges the interrupt of the trigger.
  virtual void acknowledge() noexcept = 0;

  // Reads the present state of the logic. Clears the flags that are only counted (underrun, residual).
  [[nodiscard]] virtual const LogicInput& sample() noexcept = 0;
  [[nodiscard]] const LogicInput& last() const noexcept { return input_; }

  // Encoder position of an axis at its last index pulse, as in LogicInput; none: not latched.
  [[nodiscard]] virtual std::optional<Counts> index(std::size_t axis) noexcept = 0;
  // From now on the encoder positions of an axis, the last one included, are larger by `shift`.
  void shift_position(std::size_t axis, Counts shift) noexcept {
    origin_[axis] += shift;
    input_.encoder[axis] += shift;
  }

  // Commits the counts of the next tick, -200..200 each, under the next sequence number.
  virtual void commit(const PerAxis<Pulses>& counts) noexcept = 0;
  [[nodiscard]] std::uint16_t sequence() const noexcept { return sequence_; }

  // Sets the servo enables of all axes.
  virtual void set_servo(bool on) noexcept = 0;

  // Clears all latches and flags whose cause is gone, and updates uncounted_axes().
  virtual void clear_faults() noexcept = 0;

  // All pulses emitted up to the last trigger, unwrapped to 64 bits. Call it at least every 2^31 pulses, and when the
  // committed pulses are set to its result.
  [[nodiscard]] virtual const PerAxis<Pulses>& emitted() noexcept = 0;

 protected:
  LogicPort() = default;
  LogicPort(const LogicPort&) = default;
  LogicPort& operator=(const LogicPort&) = default;
  ~LogicPort() = default;  // never owned through this interface

  // The 64-bit value nearest to `last` whose low 32 bits are `low`.
  [[nodiscard]] static constexpr std::int64_t unwrapped(std::int64_t last, std::int32_t low) noexcept {
    return last + static_cast<std::int32_t>(static_cast<std::uint32_t>(low) - static_cast<std::uint32_t>(last));
  }

  // One setting serves all axes: that of the slowest drive.
  [[nodiscard]] static Cycles largest_of(const RobotModel& robot, std::int32_t AxisModel::*cycles) noexcept {
    std::int32_t result = 0;
    for (const AxisModel& axis : robot.axes) result = std::max(result, axis.*cycles);
    return Cycles{result};
  }

  LogicInput input_{};
  PerAxis<Counts> origin_{};  // position minus the counts of the logic
  std::uint16_t sequence_ = 0;
  bool starts_at_zero_ = true;
  std::uint8_t uncounted_axes_ = 0;
  bool drives_at_start_ = true;
};

}  // namespace armature
