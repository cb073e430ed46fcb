// Cycle-accurate model of the timer pair, from the description of the AXI Timer v2.0 and the decisions in
// rtl/axi_timer/README.md. It is independent of the RTL: a cascade is one 64-bit number, and the resulting value marks
// the end of a period. It counts all events, so that tests can check that they are not vacuous.
#pragma once

#include <array>
#include <cstdint>

#include "tests/rtl/axi_timer_bits.hpp"

namespace armature::test::axi_timer {

class TimerModel {
 public:
  struct Write {
    bool tlr = false;  // else TCSR
    unsigned timer = 0;
    std::uint32_t data = 0;
    unsigned strobe = 0;  // 0: no write
  };

  // Number of events of each kind.
  struct Seen {
    int ends[2] = {}, one_shot_ends = 0, wide_ends = 0, wide_reloads = 0, carries = 0;
    int captures[2] = {}, wide_captures = 0, dropped_captures = 0, captures_over_writes = 0;
    int ends_over_clears = 0, run_alls = 0, frozen_clocks = 0;
    int pwm_rises = 0, pwm_suppressed = 0, pwm_cut_off = 0, pwm_falls = 0, pwm_ties = 0;
  };

  std::uint32_t tcsr(unsigned timer) const {
    return timers_[timer].mode | (run_all_ ? kRunAll : 0u) | (cascade_ && timer == 0 ? kCascade : 0u);
  }
  std::uint32_t tlr(unsigned timer) const { return timers_[timer].start; }
  std::uint32_t tcr(unsigned timer) const { return timers_[timer].count; }
  bool pulse(unsigned timer) const { return timers_[timer].pulse; }
  bool pwm() const { return pwm_; }
  bool irq() const { return irq_; }
  const Seen& seen() const { return seen_; }

  // One clock, with the pins before its edge and the write at the edge.
  void step(unsigned trigger_pins, bool freeze_pin, const Write& write) {
    const bool frozen = pins_[2].freeze;
    const unsigned edges = pins_[1].triggers & ~pins_[0].triggers;
    pins_ = {pins_[1], pins_[2], pins_[3], Pins{trigger_pins, freeze_pin}};
    if (frozen) ++seen_.frozen_clocks;

    const std::array<Timer, 2> before = timers_;
    const bool cascade = cascade_, pwm_mode = pwm_mode_;
    pwm_mode_ = !cascade && drives_pwm(before[0]) && drives_pwm(before[1]);
    const bool clears = write.strobe & 2u && !write.tlr && write.data & kFlag;
    irq_ = interrupts(before[0]) || (!cascade && interrupts(before[1]));

    bool ended[2] = {}, captured[2] = {};
    for (unsigned t = 0; t < 2; ++t) {
      const std::uint32_t needed = kCapture | kCapturePin | kRun;
      if ((t == 1 && cascade) || !(edges & 1u << t) || (before[t].mode & needed) != needed) continue;
      captured[t] = before[t].mode & kReload || !(before[t].mode & kFlag);
      ++(captured[t] ? seen_.captures[t] : seen_.dropped_captures);
    }
    if (cascade) {
      ended[0] = count_wide(before, frozen);
    } else {
      ended[0] = count_one(0, before, frozen, true);
      const bool restarts = pwm_mode && timer0_reloaded_ && before[1].mode & kRun;
      if (!restarts) ended[1] = count_one(1, before, frozen, !pwm_mode || !(before[0].mode & kRun));
      if (restarts) timers_[1].count = before[1].start, timers_[1].held = false;
    }
    drive_pwm(pwm_mode, ended[0], ended[1], before[1].mode & kRun);

    apply(write);
    for (unsigned t = 0; t < 2; ++t) {
      timers_[t].pulse = ended[t] && before[t].mode & kGenerate;
      if (ended[t]) ++seen_.ends[t];
      if (ended[t] || captured[t]) {
        timers_[t].mode |= kFlag;
        if (clears && write.timer == t) ++seen_.ends_over_clears;
      }
      if (captured[t] || (t == 1 && cascade && captured[0])) {
        timers_[t].start = before[t].count;
        if (write.strobe && write.tlr && write.timer == t) ++seen_.captures_over_writes;
      }
    }
    if (cascade && captured[0]) ++seen_.wide_captures;
  }

 private:
  struct Timer {
    std::uint32_t mode = 0;   // TCSR without ENALL and CASC
    std::uint32_t start = 0;  // TLR
    std::uint32_t count = 0;  // TCR
    bool held = false;        // the count is the wrapped value
    int more = 0;             // clocks for which the wrapped value is still visible after this one
    bool pulse = false;
  };
  struct Pins {
    unsigned triggers = 0;
    bool freeze = false;
  };

  static bool interrupts(const Timer& t) { return t.mode & kFlag && t.mode & kIrq; }
  static bool drives_pwm(const Timer& t) { return (t.mode & (kPwm | kGenerate | kCapture)) == (kPwm | kGenerate); }

  // Timer `t` alone. Returns whether a period ends.
  bool count_one(unsigned t, const std::array<Timer, 2>& before, bool frozen, bool reloads_itself) {
    const Timer& old = before[t];
    Timer& timer = timers_[t];
    if (t == 0) timer0_reloaded_ = false;
    if (old.mode & kLoad) {
      timer.count = old.start;
      timer.held = false;
      return false;
    }
    if (!(old.mode & kRun) || frozen) return false;
    if (old.held && !(old.mode & kCapture)) {
      if (old.more > 0) {
        --timer.more;
      } else if (old.mode & kReload && reloads_itself) {
        timer.count = old.start;
        timer.held = false;
        if (t == 0) timer0_reloaded_ = true;
      }
      return false;
    }
    const bool down = old.mode & kDown;
    timer.count = down ? old.count - 1 : old.count + 1;
    timer.held = timer.count == (down ? kMax : 0u) && !(old.mode & kCapture);
    timer.more = 0;
    if (timer.held && !(old.mode & kReload)) ++seen_.one_shot_ends;
    return timer.held;
  }

  // Both timers as one counter with the mode of timer 0. Returns whether its period ends.
  bool count_wide(const std::array<Timer, 2>& before, bool frozen) {
    const Timer& low = before[0];
    const std::uint64_t old = std::uint64_t{before[1].count} << 32 | low.count;
    const bool down = low.mode & kDown, capture = low.mode & kCapture, loads = low.mode & kLoad;
    std::uint64_t now = old;
    bool ended = false;
    if (!loads && low.mode & kRun && !frozen) {
      if (low.held && !capture && low.more > 0) {
        --timers_[0].more;
      } else if (low.held && !capture && low.mode & kReload) {
        now = std::uint64_t{before[1].start} << 32 | low.start;
        timers_[0].held = timers_[1].held = false;
        ++seen_.wide_reloads;
      } else if (!low.held || capture) {
        now = down ? old - 1 : old + 1;
        if (now >> 32 != old >> 32) {
          timers_[1].held = false;
          ++seen_.carries;
        }
        ended = !capture && now == (down ? ~std::uint64_t{0} : 0u);
        timers_[0].held = ended;
        if (ended) {
          timers_[0].more = 2;
          ++seen_.wide_ends;
        }
      }
    }
    timers_[0].count = static_cast<std::uint32_t>(now);
    timers_[1].count = static_cast<std::uint32_t>(now >> 32);
    for (unsigned t = 0; t < 2; ++t) {
      if (!(before[t].mode & kLoad)) continue;
      timers_[t].count = before[t].start;
      timers_[t].held = false;
    }
    return ended;
  }

  void drive_pwm(bool enabled, bool period_ends, bool high_ends, bool timer1_runs) {
    const bool was = pwm_;
    if (!enabled) {
      pwm_ = timer1_ended_ = false;
      return;
    }
    if (period_ends) {
      pwm_ = timer1_ended_ || !timer1_runs;
      if (high_ends) {
        ++seen_.pwm_ties;
      } else if (!pwm_) {
        ++(was ? seen_.pwm_cut_off : seen_.pwm_suppressed);
      }
      timer1_ended_ = !timer1_runs;  // a stopped timer 1 does not suppress the next pulse
    } else if (high_ends) {
      pwm_ = false;
      timer1_ended_ = true;
    }
    if (!was && pwm_) ++seen_.pwm_rises;
    if (was && !pwm_) ++seen_.pwm_falls;
  }

  void apply(const Write& write) {
    std::uint32_t bytes = 0;
    for (unsigned byte = 0; byte < 4; ++byte) bytes |= write.strobe >> byte & 1u ? 0xFFu << (8 * byte) : 0u;
    Timer& timer = timers_[write.timer];
    if (write.tlr) {
      timer.start = (timer.start & ~bytes) | (write.data & bytes);
      return;
    }
    const std::uint32_t plain = (0x7Fu | kRun | kPwm) & bytes;
    timer.mode = (timer.mode & ~plain) | (write.data & plain);
    if (write.data & bytes & kFlag) timer.mode &= ~kFlag;
    if (bytes & kCascade && write.timer == 0) cascade_ = write.data & kCascade;
    if (!(bytes & kRunAll)) return;
    run_all_ = write.data & kRunAll;
    if (!run_all_) return;
    for (Timer& each : timers_) each.mode |= kRun;
    ++seen_.run_alls;
  }

  std::array<Timer, 2> timers_;
  std::array<Pins, 4> pins_{};  // pins of the last clocks, oldest first
  bool run_all_ = false, cascade_ = false;
  bool pwm_mode_ = false, pwm_ = false, timer1_ended_ = false, timer0_reloaded_ = false, irq_ = false;
  Seen seen_;
};

}  // namespace armature::test::axi_timer
