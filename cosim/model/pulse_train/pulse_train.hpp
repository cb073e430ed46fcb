// Model of the block pulse_train: six generators that start together on the trigger, with commit, stops, snapshots and
// faults. Written from rtl/REGISTERS.md and rtl/pulse_train/README.md.
//
// A register that is written at an edge acts from the next edge on. The servo enables follow their register one edge
// later. Edge `at` has the TIME at - 1.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "controller/base/axes.hpp"
#include "controller/regs/pulse_train_regs.hpp"
#include "cosim/model/arm_pins.hpp"
#include "cosim/model/block.hpp"
#include "cosim/model/fault_flags.hpp"
#include "cosim/model/pin_samples.hpp"
#include "cosim/model/pulse_train/pulse_axis.hpp"
#include "cosim/model/stop_control.hpp"

namespace armature::cosim::model {

class PulseTrain {
 public:
  Answer edge(Cycles at, const Strobes& access, const PulseInputs& in);
  Answer access(Cycles at, const Strobes& access, const PulseInputs& in);
  [[nodiscard]] Cycles wakes_at() const { return wakes_at_; }

  // A read without an error at the edge `at`; and a write of a whole count, which acts when it is committed. stage()
  // returns false, and does nothing, for other writes.
  [[nodiscard]] std::optional<std::uint32_t> peek(Cycles at, std::uint32_t offset) const {
    const Answer answer = read(at, offset);
    if (answer.rerr) return std::nullopt;
    return answer.rdata;
  }
  [[nodiscard]] bool stage(std::uint32_t offset, std::uint32_t data, std::uint8_t strobes) {
    const std::optional<std::size_t> axis = element_at(offset, armature::regs::pulse_train::kCountOffset);
    if (!axis || strobes != 0xF) return false;
    staged_[*axis] = static_cast<std::uint16_t>(data);
    return true;
  }

  [[nodiscard]] std::uint8_t step() const { return step_; }
  [[nodiscard]] std::uint8_t dir() const { return dir_; }
  [[nodiscard]] std::uint8_t servo_on() const { return servo_pins_; }
  [[nodiscard]] bool heartbeat() const { return stop_.heartbeat(); }

  // ---- whole ticks: edges at which only levels of step and dir change are left out. Their pins stand still meanwhile.

  // The pulses of the tick that has begun at the edge `at`, the latest one, if nothing disturbs it; none: only its
  // edges say them.
  [[nodiscard]] std::optional<TickPulses> whole_tick(Cycles at) const;
  // From the edge `at` on, the latest one, the edges of the generators are left out, or (then wake_after()) computed.
  void leave_out_generators(Cycles at);
  void run_generators(Cycles at);
  // The tick whose generators were left out is over: to the edge before the one that sees the trigger.
  void finish_tick(const TickPulses& pulses);
  // An edge of the generators that was left out, and the next one after it.
  void generator_edge(Cycles at);
  [[nodiscard]] Cycles generators_wake_at() const { return axes_wake_at_; }
  [[nodiscard]] const PulseAxis& axis(std::size_t i) const { return axes_[i]; }
  [[nodiscard]] const PulseAxis::Times& times() const { return times_; }
  // Whether a write to the register may change the pulses of the running tick, or what comes from the encoder.
  [[nodiscard]] static bool write_disturbs(std::uint32_t offset);

  // The edge after `now` must be computed: edges before it were computed late.
  void wake_after(Cycles now) { wakes_at_ = now + Cycles{1}; }

  // The clock of everything but generators, TIME and synchronisers stands still from now on.
  void stop_gated_clock() { gated_clock_stopped_ = true; }

 private:
  // What a write leaves for the next edge.
  struct Orders {
    bool stop = false, clear_estop = false, clear_watchdog = false, commit = false;

    [[nodiscard]] bool stops_or_clears() const { return stop || clear_estop || clear_watchdog; }
  };
  struct Bank {
    PerAxis<std::int32_t> counts{};
    std::uint16_t sequence = 0;
    bool pending = false;
  };

  [[nodiscard]] StopControl::Inputs stop_inputs(bool trigger) const;
  [[nodiscard]] Answer read(Cycles at, std::uint32_t offset) const;
  [[nodiscard]] bool write(const Strobes& access);  // returns whether it is refused
  [[nodiscard]] bool write_ctrl(const Strobes& access, bool locked);
  [[nodiscard]] bool write_protected(const Strobes& access, bool locked);
  void run_axes(Cycles at, bool trigger, bool stopped);
  void show_axes();
  void find_axes_wake(Cycles at);
  void snapshot();
  void move_bank(bool trigger, bool stopped);
  void quiet_edge(Cycles at, const StopControl::Inputs& control, const PulseInputs& in);
  void find_wake(Cycles at, const PulseInputs& in);

  PerAxis<PulseAxis> axes_{};
  PulseAxis::Times times_;
  Cycles axes_wake_at_ = kNever;
  bool generators_run_ = true;
  StopControl stop_;
  PinSamples<ArmPins, 2> pins_;
  FaultFlags<6> faults_;
  Bank bank_;
  Orders orders_;
  bool clipped_ = false, residual_ = false;  // events of the edge before
  std::uint8_t step_ = 0, dir_ = 0, servo_pins_ = 0;
  std::uint16_t active_sequence_ = 0;
  PerAxis<std::uint32_t> emitted_{}, residuals_{};  // snapshots of the last trigger
  Cycles wakes_at_ = Cycles{1};
  bool is_settled_ = false;  // nothing but the generators, a commit and the watchdog has something to do
  bool gated_clock_stopped_ = false;

  // Registers.
  std::uint8_t servo_on_ = 0;
  bool run_ = false;
  bool unlocked_ = false;
  std::uint32_t limit_ = 4;
  std::uint16_t sequence_ = 0;
  PerAxis<std::uint16_t> staged_{};
  std::uint32_t cleared_faults_ = 0;  // by the write of this edge
};

}  // namespace armature::cosim::model
