// A million clocks of random register writes and pin changes: every output of the timer pair is that of the model in
// every clock.
#include <sstream>
#include <string>
#include <utility>

#include "tests/rtl/axi_timer_core_fixture.hpp"
#include "tests/rtl/axi_timer_model.hpp"
#include "tests/support/split_mix.hpp"

namespace armature::test::axi_timer {
namespace {

constexpr std::uint64_t kSeed = 42;
constexpr int kClocks = 1'000'000;

class AxiTimerLockstep : public CoreFixture<Vtimer_core> {
 protected:
  // A count near an end of the range: mostly of the short periods in which things meet.
  std::uint32_t near_an_end() {
    const bool down = random_.below(2) != 0;
    switch (random_.below(8)) {
      case 0:
        return static_cast<std::uint32_t>(random_.next());
      case 1:
      case 2:
      case 3:
        return before_end(down, 0);
      default:
        return before_end(down, random_.below(14));
    }
  }

  // Mode bits that let the timers run most of the time, in the modes that need several bits at once too.
  std::uint32_t mode(unsigned timer) {
    auto bits = static_cast<std::uint32_t>(random_.next());
    if (random_.below(4) != 0) bits &= ~kLoad;
    if (random_.below(4) != 0) bits |= kRun;
    if (random_.below(4) != 0) bits &= ~kRunAll;
    switch (favourite_ < 4 ? favourite_ : random_.below(4)) {
      case 0:  // capture
        return bits | kCapture | kCapturePin;
      case 1:  // PWM
        return (bits | kPwm | kGenerate | kReload) & ~(kCapture | kCascade);
      case 2:  // cascade
        return (bits | (timer == 0 ? kCascade : 0u)) & ~kCapture;
      default:
        return bits;
    }
  }

  TimerModel::Write random_write() {
    TimerModel::Write write;
    write.timer = random_.below(2);
    write.tlr = random_.below(3) == 0;
    write.strobe = random_.below(8) == 0 ? random_.below(16) : 0xF;
    write.data = write.tlr ? near_an_end() : mode(write.timer);
    return write;
  }

  void apply(const TimerModel::Write& write) {
    dut_.tcsr0_we_i = write.strobe && !write.tlr && write.timer == 0;
    dut_.tcsr1_we_i = write.strobe && !write.tlr && write.timer == 1;
    dut_.tlr0_we_i = write.strobe && write.tlr && write.timer == 0;
    dut_.tlr1_we_i = write.strobe && write.tlr && write.timer == 1;
    dut_.wdata_i = write.data;
    dut_.wstrb_i = static_cast<CData>(write.strobe);
  }

  bool equal() {
    bool all = dut_.pwm_o == model_.pwm() && dut_.irq_o == model_.irq();
    for (unsigned t = 0; t < 2; ++t) {
      all = all && tcsr(t) == model_.tcsr(t) && tlr(t) == model_.tlr(t) && tcr(t) == model_.tcr(t) &&
            pulse(t) == model_.pulse(t);
    }
    return all;
  }

  std::string difference() {
    std::ostringstream text;
    text << std::hex;
    for (unsigned t = 0; t < 2; ++t) {
      text << "\ntimer " << t << " RTL/model: TCSR " << tcsr(t) << '/' << model_.tcsr(t) << ", TLR " << tlr(t) << '/'
           << model_.tlr(t) << ", TCR " << tcr(t) << '/' << model_.tcr(t) << ", pulse " << pulse(t) << '/'
           << model_.pulse(t);
    }
    text << "\npwm " << int{dut_.pwm_o} << '/' << model_.pwm() << ", irq " << int{dut_.irq_o} << '/' << model_.irq();
    return text.str();
  }

  SplitMix random_{kSeed};
  std::uint32_t favourite_ = 0;  // kind of mode() that a stretch of clocks stays with; from 4 on any
  TimerModel model_;
};

TEST_F(AxiTimerLockstep, RandomTrafficIsThatOfTheModelInEveryClock) {
  std::uint32_t gap = 1;  // mean clocks between writes
  for (int clock = 0; clock < kClocks; ++clock) {
    if (clock % 512 == 0) {
      gap = 1 + random_.below(4) * random_.below(16);
      favourite_ = random_.below(8);
    }
    TimerModel::Write write;
    if (random_.below(gap) == 0) write = random_write();
    if (random_.below(6) == 0) dut_.capture_trig_i = static_cast<CData>(random_.below(4));
    if (random_.below(dut_.freeze_i ? 8 : 200) == 0) dut_.freeze_i = !dut_.freeze_i;
    apply(write);
    model_.step(dut_.capture_trig_i, dut_.freeze_i, write);
    tick();
    ASSERT_TRUE(equal()) << "seed " << kSeed << ", clock " << clock << difference();
  }

  const TimerModel::Seen& seen = model_.seen();
  const std::pair<const char*, int> counts[]{
      {"ends of timer 0", seen.ends[0]},
      {"ends of timer 1", seen.ends[1]},
      {"one-shot ends", seen.one_shot_ends},
      {"64-bit ends", seen.wide_ends},
      {"64-bit reloads", seen.wide_reloads},
      {"carries", seen.carries},
      {"captures of timer 0", seen.captures[0]},
      {"captures of timer 1", seen.captures[1]},
      {"64-bit captures", seen.wide_captures},
      {"dropped captures", seen.dropped_captures},
      {"captures over writes", seen.captures_over_writes},
      {"events over clears", seen.ends_over_clears},
      {"starts of both", seen.run_alls},
      {"frozen clocks", seen.frozen_clocks},
      {"PWM rises", seen.pwm_rises},
      {"PWM falls", seen.pwm_falls},
      {"pulses that PWM withheld", seen.pwm_suppressed},
      {"pulses that PWM cut off", seen.pwm_cut_off},
      {"PWM ties", seen.pwm_ties},
  };
  for (const auto& [what, count] : counts) {
    RecordProperty(what, count);
    EXPECT_GE(count, 100) << "too few " << what << ", seed " << kSeed;
  }
}

}  // namespace
}  // namespace armature::test::axi_timer
