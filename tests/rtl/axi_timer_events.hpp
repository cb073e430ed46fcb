// Counts what the timer pair does, as its registers and pins show it, so that a random test can check that it has met
// every case.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <utility>

#include "cosim/model/block.hpp"
#include "cosim/model/timer/axi_timer.hpp"
#include "tests/rtl/axi_timer_bits.hpp"

namespace armature::test::axi_timer {

// Registers and pins after an edge.
struct TimerView {
  std::array<std::uint32_t, 2> tcsr{}, tlr{}, tcr{};
  bool pwm = false;

  TimerView() = default;
  TimerView(const cosim::model::AxiTimer& timer, Cycles at)
      : tcsr{timer.tcsr(0), timer.tcsr(1)},
        tlr{timer.tlr(0), timer.tlr(1)},
        tcr{timer.tcr(0, at), timer.tcr(1, at)},
        pwm{timer.pwm()} {}

  [[nodiscard]] bool has(unsigned timer, std::uint32_t bits) const { return (tcsr[timer] & bits) == bits; }
  [[nodiscard]] std::uint64_t wide_tcr() const { return std::uint64_t{tcr[1]} << 32 | tcr[0]; }
  [[nodiscard]] std::uint64_t wide_tlr() const { return std::uint64_t{tlr[1]} << 32 | tlr[0]; }
};

class TimerEvents {
 public:
  // One edge, with the write and the pins at it.
  void edge(const TimerView& after, const cosim::model::Strobes& access, const cosim::model::TimerInputs& inputs) {
    const TimerView before = std::exchange(view_, after);
    const bool rises = (samples_ & 0b1100u) == 0b0100u;
    samples_ = samples_ << 1 | (inputs.capture_trig ? 1u : 0u);
    if (inputs.freeze) ++frozen_;
    const bool cascade = before.has(0, kCascade);
    const std::array<bool, 2> ends{cascade ? ends_wide(before, after) : ends_alone(0, before, after),
                                   !cascade && ends_alone(1, before, after)};
    if (cascade) count_cascade(before, after, ends[0]);
    for (unsigned t = 0; t < (cascade ? 1u : 2u); ++t) {
      const bool captured = rises && count_capture(t, before, after, access);
      if (ends[t]) ++ends_[t];
      if (ends[t] && !before.has(t, kReload)) ++one_shots_;
      const bool clears = access.write && access.waddr == 0x10 * t && (access.wstrb & 2u) && (access.wdata & kFlag);
      if (clears && (ends[t] || captured) && after.has(t, kFlag)) ++events_over_clears_;
    }
    if (access.write && (access.waddr & ~0x10u) == 0 && (access.wstrb & 2u) && (access.wdata & kRunAll)) ++run_alls_;
    if (!cascade && drives_pwm(before, 0) && drives_pwm(before, 1)) count_pwm(before, after, ends);
  }

  void expect_each(int least) const {
    const std::pair<const char*, int> counts[]{
        {"ends of timer 0", ends_[0]},
        {"ends of timer 1", ends_[1]},
        {"one-shot ends", one_shots_},
        {"64-bit ends", wide_ends_},
        {"64-bit reloads", wide_reloads_},
        {"carries", carries_},
        {"captures of timer 0", captures_[0]},
        {"captures of timer 1", captures_[1]},
        {"64-bit captures", wide_captures_},
        {"dropped captures", dropped_captures_},
        {"captures over writes", captures_over_writes_},
        {"events over clears", events_over_clears_},
        {"starts of both", run_alls_},
        {"frozen clocks", frozen_},
        {"PWM rises", pwm_rises_},
        {"PWM falls", pwm_falls_},
        {"pulses that PWM withheld", pwm_withheld_},
        {"pulses that PWM cut off", pwm_cut_off_},
        {"PWM ties", pwm_ties_},
    };
    for (const auto& [what, count] : counts) {
      ::testing::Test::RecordProperty(what, count);
      EXPECT_GE(count, least) << "too few " << what;
    }
  }

 private:
  static bool counts(const TimerView& v, unsigned t) { return v.has(t, kRun) && !v.has(t, kLoad); }
  static bool ends_alone(unsigned t, const TimerView& before, const TimerView& after) {
    const bool down = before.has(t, kDown);
    return counts(before, t) && !before.has(t, kCapture) && before.tcr[t] == before_end(down, 0) &&
           after.tcr[t] == before_end(!down, 0);
  }
  static bool ends_wide(const TimerView& before, const TimerView& after) {
    const std::uint64_t last = before.has(0, kDown) ? 0 : ~std::uint64_t{0};
    return counts(before, 0) && !before.has(0, kCapture) && before.wide_tcr() == last && after.wide_tcr() == ~last;
  }
  static bool drives_pwm(const TimerView& v, unsigned t) { return v.has(t, kPwm | kGenerate) && !v.has(t, kCapture); }

  void count_cascade(const TimerView& before, const TimerView& after, bool ends) {
    const std::uint64_t wrapped = before.has(0, kDown) ? ~std::uint64_t{0} : 0;
    if (ends) ++wide_ends_;
    if (counts(before, 0) && before.has(0, kReload) && before.wide_tcr() == wrapped && before.wide_tlr() != wrapped &&
        after.wide_tcr() == before.wide_tlr()) {
      ++wide_reloads_;
    }
    if (!before.has(1, kLoad) && after.tcr[1] != before.tcr[1] && after.tcr[0] - before.tcr[0] + 1 <= 2) ++carries_;
  }

  bool count_capture(unsigned t, const TimerView& before, const TimerView& after, const cosim::model::Strobes& access) {
    if (!before.has(t, kCapture | kCapturePin | kRun)) return false;
    if (before.has(t, kFlag) && !before.has(t, kReload)) {
      ++dropped_captures_;
      return false;
    }
    if (after.tlr[t] != before.tcr[t]) return false;
    ++captures_[t];
    if (before.has(0, kCascade) && after.tlr[1] == before.tcr[1]) ++wide_captures_;
    if (access.write && access.waddr == 0x10 * t + 4 && access.wstrb != 0) ++captures_over_writes_;
    return true;
  }

  void count_pwm(const TimerView& before, const TimerView& after, const std::array<bool, 2>& ends) {
    if (!before.pwm && after.pwm) ++pwm_rises_;
    if (before.pwm && !after.pwm) ++pwm_falls_;
    if (!ends[0]) return;
    if (ends[1]) {
      ++pwm_ties_;
    } else if (!after.pwm) {
      ++(before.pwm ? pwm_cut_off_ : pwm_withheld_);
    }
  }

  TimerView view_;
  unsigned samples_ = 0;  // of the capture pin, the latest in bit 0
  std::array<int, 2> ends_{}, captures_{};
  int one_shots_ = 0, wide_ends_ = 0, wide_reloads_ = 0, carries_ = 0;
  int wide_captures_ = 0, dropped_captures_ = 0, captures_over_writes_ = 0;
  int events_over_clears_ = 0, run_alls_ = 0, frozen_ = 0;
  int pwm_rises_ = 0, pwm_withheld_ = 0, pwm_cut_off_ = 0, pwm_falls_ = 0, pwm_ties_ = 0;
};

}  // namespace armature::test::axi_timer
