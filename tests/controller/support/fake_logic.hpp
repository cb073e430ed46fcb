// The programmable logic with its drives and encoders as the controller's registers show them, one sub-step per
// microsecond: a register-level stand-in written from the register descriptions, to run the controller without RTL.
//
// It is core 0's RegisterBus. Time passes with every access and charge; wait_for_interrupt() runs to the next trigger.
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "controller/core/axes.hpp"
#include "controller/core/units.hpp"
#include "controller/hal/register_bus.hpp"

namespace armature::test {

class FakeLogic final : public RegisterBus {
 public:
  struct Drive {
    double natural_rad_s = 250.0;
    double damping = 1.0;
    double counts_per_pulse = 1.0;
    std::int64_t lose = 0;  // the next so many pulses are not seen
    bool stuck = false;     // does not move at all
    // state
    double reference = 0.0;    // counts
    double position = 0.0;     // counts
    double speed = 0.0;        // counts/s
    std::int64_t dropped = 0;  // net pulses lost so far
  };

  // Cost of what the core does.
  static constexpr std::int64_t kAccessCycles = 18;
  std::int64_t tick_cycles = 250;

  // World.
  PerAxis<Drive> drives;
  std::uint32_t alarm = 0, limit_pos = 0, limit_neg = 0;  // axis masks
  bool estop_pin = false;
  std::uint32_t encoder_fault = 0;  // events: set the flags once
  std::uint32_t encoder_known = 0x3F;
  PerAxis<std::int64_t> shorten{};  // pulses that will not fit in the tick that starts next
  std::uint32_t pulse_train_id = 0x5054'0106;
  std::uint32_t encoder_id = 0x454E'0106;

  // Called at each trigger, after the logic has acted, with the number of the trigger (from 0).
  std::function<void(std::int64_t)> on_trigger;
  // Called when core 0 begins to wait for the interrupt.
  std::function<void()> on_wait = [] {};
  // Called when core 0 sends an event.
  std::function<void()> on_event;
  std::int64_t triggers_to_run = 0;  // then the core is switched off

  // What came out, for checks.
  [[nodiscard]] std::int64_t emitted(std::size_t axis) const { return emitted_[axis]; }
  [[nodiscard]] std::int64_t count(std::size_t axis) const;  // encoder now
  [[nodiscard]] std::int64_t triggers() const { return triggers_; }
  [[nodiscard]] std::uint32_t underruns() const { return underruns_; }
  [[nodiscard]] std::uint32_t recommits() const { return recommits_; }
  [[nodiscard]] std::uint32_t servo_on() const { return stopped() ? 0 : servo_request_; }
  [[nodiscard]] std::int64_t largest_count() const { return largest_count_; }
  [[nodiscard]] std::uint32_t dir_setup() const { return dir_setup_; }
  [[nodiscard]] std::uint32_t dir_hold() const { return dir_hold_; }
  [[nodiscard]] bool watchdog_latched() const { return watchdog_; }

  // RegisterBus
  std::uint32_t read32(RegAddr addr) noexcept override;
  void write32(RegAddr addr, std::uint32_t value) noexcept override;
  Interrupts wait_for_interrupt(Interrupts mask) noexcept override;
  void send_event() noexcept override { on_event(); }
  Cycles now() noexcept override { return Cycles{now_}; }
  void charge(Work work, std::int64_t times) noexcept override;

 private:
  struct Set {
    std::array<std::int16_t, kAxes> counts{};
    std::uint16_t sequence = 0;
  };

  [[nodiscard]] bool stopped() const { return estop_ || watchdog_; }
  void pass(std::int64_t cycles);
  void sub_step(std::int64_t index);
  void trigger();
  std::uint32_t read_pulse_train(std::uint32_t offset) const;
  void write_pulse_train(std::uint32_t offset, std::uint32_t value);

  std::int64_t now_ = 0;
  // axi_timer
  std::uint32_t tlr_ = 0, tcsr_ = 0;
  std::int64_t tick_start_ = -1;  // -1: the timer stands
  bool interrupt_ = false;
  std::int64_t triggers_ = 0;
  // pulse_train
  Set staged_, pending_set_, active_;
  bool pending_ = false, run_ = false, estop_ = false, watchdog_ = false;
  std::uint32_t servo_request_ = 0, servo_was_ = 0, flags_ = 0, watchdog_limit_ = 4, in_a_row_ = 0, underruns_ = 0,
                recommits_ = 0, dir_setup_ = 25, dir_hold_ = 25;
  PerAxis<std::int64_t> emitted_{}, emitted_snapshot_{}, in_tick_{}, cut_{}, residual_{};
  std::int64_t largest_count_ = 0;
  // encoder
  PerAxis<std::int64_t> position_snapshot_{};
  std::uint32_t encoder_flags_ = 0;
};

}  // namespace armature::test
