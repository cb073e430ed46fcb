// axi_timer: two timers with periods, capture, cascade and PWM. From rtl/REGISTERS.md and rtl/axi_timer/README.md.
//
// A write takes effect at the edge of its access, so the counters, flags and pins react from the next edge on. A read
// returns what the edge finds.
//
//   edge           n                   n + 1              n + 2 ...
//   end            TINT, trigger() 1   irq() 1, trigger() 0, reload
//   rise of pin    sampled                                captured at n + 3: TLR, TINT
//   freeze pin     sampled                                counters stand at n + 2
//
// Must be computed: ends, the edge after each, and a few edges after a write or a change of a pin. One timer that runs
// with a period costs two edges per period.
#pragma once

#include <cstdint>

#include "cosim/model/block.hpp"
#include "cosim/model/pin_samples.hpp"
#include "cosim/model/timer/pwm_pin.hpp"
#include "cosim/model/timer/timer_counters.hpp"
#include "cosim/model/timer/timer_registers.hpp"

namespace armature::cosim::model {

struct TimerInputs {
  bool capture_trig = false;  // of both timers
  bool freeze = false;

  bool operator==(const TimerInputs&) const = default;
};

class AxiTimer {
 public:
  Answer edge(Cycles at, const Strobes& access, const TimerInputs& inputs);
  [[nodiscard]] Cycles wakes_at() const { return wakes_at_; }

  // From now on there are no edges of clk_gated_i (rtl/README.md): registers and pins stay as they are, a trigger stays
  // high. The counters run on, but nothing shows them, so that they are left out here.
  void stop_gated_clock();

  // GenerateOut of timer 0 and of timer 1: high for one clock.
  [[nodiscard]] bool trigger() const { return (pulses_ & 1u) != 0; }
  [[nodiscard]] bool second_trigger() const { return (pulses_ & 2u) != 0; }
  [[nodiscard]] bool pwm() const { return pwm_.level(); }
  [[nodiscard]] bool irq() const { return irq_; }

  // Registers after the edge `at`: the latest computed one, or a later one before wakes_at().
  [[nodiscard]] std::uint32_t tcsr(unsigned timer) const;
  [[nodiscard]] std::uint32_t tlr(unsigned timer) const { return registers_[timer].start; }
  [[nodiscard]] std::uint32_t tcr(unsigned timer, Cycles at) const { return counters_.count(timer, at); }

 private:
  [[nodiscard]] Answer answer(Cycles at, const Strobes& access) const;
  [[nodiscard]] std::uint32_t word(std::uint32_t offset, Cycles at) const;
  void compute(Cycles at, const Strobes& access, const TimerInputs& inputs);
  [[nodiscard]] unsigned captures() const;
  void write(const Strobes& access);
  void write_control(unsigned timer, const Strobes& access);
  Cycles plan(Cycles at);
  [[nodiscard]] bool clears_flags(const Strobes& access) const;
  void clear_flags(Cycles at, const Strobes& access);
  [[nodiscard]] static bool writes_run_all(const Strobes& access);

  [[nodiscard]] bool interrupts() const;
  [[nodiscard]] bool asks_for_pwm() const;

  TimerRegisterPair registers_;
  bool run_all_ = false, cascade_ = false;  // ENALL, CASC
  TimerCounters counters_;
  PinSamples<bool, 4> capture_;
  PinSamples<bool, 2> freeze_;
  bool pwm_mode_ = false;  // follows its bits one clock later
  PwmPin pwm_;
  unsigned pulses_ = 0;
  bool irq_ = false;
  bool stopped_ = false;
  bool is_steady_ = false;          // nothing but counters, flags and irq() changes
  Cycles counting_until_ = kNever;  // the next edge that must be computed for the counters
  Cycles wakes_at_ = kNever;
};

}  // namespace armature::cosim::model
