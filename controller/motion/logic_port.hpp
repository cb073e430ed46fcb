// The programmable logic as the motion loop sees it: one look and one commit per tick over the three drivers.
#pragma once

#include <cstdint>

#include "controller/core/axes.hpp"
#include "controller/core/units.hpp"
#include "controller/drivers/axi_timer.hpp"
#include "controller/drivers/encoder.hpp"
#include "controller/drivers/pulse_train.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature {

// What the logic shows after a trigger.
struct LogicInput {
  PulseTrain::Status status;
  PulseTrain::Switches switches;
  PulseTrain::Drives drives;
  Encoder::Faults encoder_faults;
  PerAxis<Counts> encoder{};        // at the trigger, unwrapped to 64 bits
  std::uint32_t underruns = 0;      // in all, as counted by the logic
  std::uint32_t new_underruns = 0;  // since the look before
  PerAxis<Pulses> not_emitted{};    // pulses that did not fit in their tick, since the look before
};

class LogicPort {
 public:
  explicit LogicPort(RegisterBus& bus) noexcept : timer_{bus}, pulse_train_{bus}, encoder_{bus} {}

  // False, and nothing has been written, when a block is not the one that this software was built for.
  [[nodiscard]] bool identified() noexcept;

  // Configures the blocks, clears old flags, takes over the counters, commits an empty set, enables the drives and
  // starts the trigger. With a blind axis nothing is committed and the drives stay off.
  void start(const RobotModel& robot) noexcept;

  // Axes whose encoder did not count when last looked at, by start() or clear_faults(); mask with bit 0 for axis 1.
  [[nodiscard]] std::uint8_t blind() const noexcept { return blind_; }

  // Ends the interrupt that announced the trigger.
  void acknowledge() noexcept { timer_.acknowledge(); }

  // Reads what the logic shows now. Flags that are only counted (underrun, residual) are cleared.
  [[nodiscard]] const LogicInput& look() noexcept;
  [[nodiscard]] const LogicInput& last() const noexcept { return input_; }

  // Commits the counts of the next tick, -200..200 each, under the next sequence number.
  void commit(const PerAxis<Pulses>& counts) noexcept;
  [[nodiscard]] std::uint16_t sequence() const noexcept { return sequence_; }

  // Servo-enable of all axes.
  void set_servo(bool on) noexcept { pulse_train_.control(on ? PulseTrain::kAllAxes : std::uint8_t{0}, true); }

  // Clears all latches and flags whose cause is gone, and looks again at axes that were blind.
  void clear_faults() noexcept;

  // All pulses emitted up to the last trigger, unwrapped to 64 bits. To be called at least every 2^31 pulses.
  [[nodiscard]] const PerAxis<Pulses>& emitted() noexcept;

 private:
  void read_residual() noexcept;
  void find_blind() noexcept;

  AxiTimer timer_;
  PulseTrain pulse_train_;
  Encoder encoder_;
  LogicInput input_{};
  PerAxis<Pulses> emitted_{};
  PerAxis<Pulses> residual_{};
  std::uint16_t sequence_ = 0;
  std::uint8_t blind_ = 0;
};

}  // namespace armature
