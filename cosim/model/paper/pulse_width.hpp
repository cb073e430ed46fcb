// Model of the block pulse_width: six generators of the paper's variant with stop and snapshot (rtl/REGISTERS.md,
// rtl/pulse_width/README.md). Pins, stops and times as in pulse_train. There is no commit: each trigger samples WIDTH.
#pragma once

#include <cstdint>

#include "controller/base/axes.hpp"
#include "cosim/model/arm_pins.hpp"
#include "cosim/model/block.hpp"
#include "cosim/model/fault_flags.hpp"
#include "cosim/model/paper/width_axis.hpp"
#include "cosim/model/pin_samples.hpp"
#include "cosim/model/stop_control.hpp"

namespace armature::cosim::model {

class PulseWidth {
 public:
  Answer edge(Cycles at, const Strobes& access, const PulseInputs& in);
  [[nodiscard]] Cycles wakes_at() const { return wakes_at_; }

  [[nodiscard]] std::uint8_t step() const { return step_; }
  [[nodiscard]] std::uint8_t dir() const { return dir_; }
  [[nodiscard]] std::uint8_t servo_on() const { return servo_pins_; }
  [[nodiscard]] bool heartbeat() const { return stop_.heartbeat(); }

  // The clock of everything but generators, TIME and synchronisers stands still from now on.
  void stop_gated_clock() { gated_clock_stopped_ = true; }

 private:
  [[nodiscard]] StopControl::Inputs stop_inputs(bool trigger) const;
  [[nodiscard]] Answer read(Cycles at, std::uint32_t offset) const;
  [[nodiscard]] bool write(const Strobes& access);  // returns whether it is refused
  void run_axes(Cycles at, bool trigger, bool stopped);
  void find_wake(Cycles at, const PulseInputs& in);

  PerAxis<WidthAxis> axes_{};
  Cycles axes_wake_at_ = kNever;
  StopControl stop_;
  PinSamples<ArmPins, 2> pins_;
  FaultFlags<1> faults_;
  std::uint8_t step_ = 0, dir_ = 0, servo_pins_ = 0;
  std::uint8_t armed_ = 0;
  PerAxis<std::uint32_t> emitted_{};  // snapshot of the last trigger
  Cycles wakes_at_ = Cycles{1};
  bool gated_clock_stopped_ = false;

  // Registers, and what a write leaves for the next edge.
  std::uint8_t servo_on_ = 0;
  PerAxis<std::uint32_t> widths_{};
  std::uint32_t cleared_faults_ = 0;  // by the write of this edge
  std::uint8_t written_ = 0;          // axes whose WIDTH was written
  bool stop_order_ = false, clear_order_ = false;
};

}  // namespace armature::cosim::model
