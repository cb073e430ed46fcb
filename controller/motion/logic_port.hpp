// The programmable logic as the motion loop sees it: one sample and one commit per tick.
//
// CountLogicPort is the logic of this controller (counts, a decoder per axis), PaperLogicPort that of Vo 2021 (half
// periods, one decoder behind a switch).
#pragma once

#include <algorithm>
#include <cstdint>

#include "controller/core/axes.hpp"
#include "controller/core/units.hpp"
#include "controller/drivers/encoder.hpp"
#include "controller/drivers/pulse_train.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature {

// What the logic shows after a trigger.
struct LogicInput {
  PulseTrain::Status status;
  PulseTrain::Switches switches;
  PulseTrain::Drives drives;
  Encoder::Faults encoder_faults;
  PerAxis<Counts> encoder{};                 // at the trigger, unwrapped to 64 bits
  std::uint8_t seen = PulseTrain::kAllAxes;  // axes whose encoder is watched all the time, mask; of the others
                                             // `encoder` lacks what they moved unseen
  std::uint32_t underruns = 0;               // in all, as counted by the logic
  std::uint32_t new_underruns = 0;           // since the sample before
  PerAxis<Pulses> not_emitted{};  // pulses that were committed and did not come out, since the sample before; negative:
                                  // pulses that came out and were not committed
};

class LogicPort {
 public:
  // False, and nothing has been written, when a block is not the one that this software was built for.
  [[nodiscard]] virtual bool identified() noexcept = 0;

  // Configures the blocks, clears old flags, takes over the counters, commits an empty set, enables the drives and
  // starts the trigger. With a blind axis nothing is committed and the drives stay off.
  virtual void start(const RobotModel& robot) noexcept = 0;

  // Axes whose encoder did not count when last sampled, by start() or clear_faults(); mask with bit 0 for axis 1.
  [[nodiscard]] std::uint8_t blind() const noexcept { return blind_; }

  // Ends the interrupt that announced the trigger.
  virtual void acknowledge() noexcept = 0;

  // Reads what the logic shows now. Flags that are only counted (underrun, residual) are cleared.
  [[nodiscard]] virtual const LogicInput& sample() noexcept = 0;
  [[nodiscard]] const LogicInput& last() const noexcept { return input_; }

  // Commits the counts of the next tick, -200..200 each, under the next sequence number.
  virtual void commit(const PerAxis<Pulses>& counts) noexcept = 0;
  [[nodiscard]] std::uint16_t sequence() const noexcept { return sequence_; }

  // Servo-enable of all axes.
  virtual void set_servo(bool on) noexcept = 0;

  // Clears all latches and flags whose cause is gone, and looks again at axes that were blind.
  virtual void clear_faults() noexcept = 0;

  // All pulses emitted up to the last trigger, unwrapped to 64 bits. To be called at least every 2^31 pulses, and when
  // they are taken for what has been committed.
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

  // One setting serves all axes: what the slowest drive needs.
  [[nodiscard]] static Cycles largest_of(const RobotModel& robot, std::int32_t AxisModel::*cycles) noexcept {
    std::int32_t result = 0;
    for (const AxisModel& axis : robot.axes) result = std::max(result, axis.*cycles);
    return Cycles{result};
  }

  LogicInput input_{};
  std::uint16_t sequence_ = 0;
  std::uint8_t blind_ = 0;
};

}  // namespace armature
