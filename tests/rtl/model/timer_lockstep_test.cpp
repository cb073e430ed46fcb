// The model of axi_timer against the verilated block.
#include <cstdint>
#include <sstream>
#include <string>

#include "Vaxi_timer.h"
#include "cosim/model/timer/axi_timer.hpp"
#include "tests/rtl/axi_timer_bits.hpp"
#include "tests/rtl/axi_timer_events.hpp"
#include "tests/rtl/axi_timer_traffic.hpp"
#include "tests/rtl/model/block_lockstep.hpp"

namespace armature::test::axi_timer {
namespace {

using cosim::kNever;
using cosim::model::AxiTimer;
using cosim::model::TimerInputs;

// How the master, the pins and the timers behave for a while.
struct Style {
  std::uint32_t gap, lazy;            // see BlockLockstep::run
  std::uint32_t span;                 // see TimerTraffic
  std::uint32_t pin_gap, freeze_gap;  // mean clocks between changes
};

class TimerLockstep : public BlockLockstep<Vaxi_timer, AxiTimer, TimerInputs> {
 protected:
  BusTraffic random_write() override {
    if (random_.below(32) == 0) {
      const auto addr = static_cast<std::uint16_t>(random_.below(random_.below(2) != 0 ? 0x30 : 0x10000));
      return {.addr = addr, .data = static_cast<std::uint32_t>(random_.next())};
    }
    const TimerWrite write = traffic_.write();
    return {.addr = write.addr, .data = write.data, .wstrb = write.strobe};
  }
  std::uint16_t random_read() override {
    if (random_.below(32) == 0) return static_cast<std::uint16_t>(random_.below(0x10000));
    return static_cast<std::uint16_t>(random_.below(0x24));
  }
  void change_inputs() override {
    if (random_.below(style_.pin_gap) == 0) inputs_.capture_trig = !inputs_.capture_trig;
    if (random_.below(inputs_.freeze ? 8 : style_.freeze_gap) == 0) inputs_.freeze = !inputs_.freeze;
    access_ = every_.port.strobes();
  }
  void drive_inputs(Vaxi_timer& dut, const TimerInputs& in) override {
    dut.capture_trig_i = in.capture_trig ? 0b11 : 0b00;
    dut.freeze_i = in.freeze;
  }
  std::string difference(const Vaxi_timer& dut, const AxiTimer& block) override {
    if (&block == &every_.block) events_.edge(TimerView{block, Cycles{cycle_}}, access_, inputs_);
    const unsigned pulses = (block.trigger() ? 1u : 0u) | (block.second_trigger() ? 2u : 0u);
    if (dut.generate_o == pulses && dut.pwm_o == block.pwm() && dut.irq_o == block.irq()) return {};
    std::ostringstream text;
    text << "RTL/model: GenerateOut " << int{dut.generate_o} << '/' << pulses << ", pwm " << int{dut.pwm_o} << '/'
         << block.pwm() << ", irq " << int{dut.irq_o} << '/' << block.irq();
    return text.str();
  }

  void run(const Style& style, int stretches, std::int64_t clocks) {
    style_ = style;
    for (int i = 0; i < stretches && !HasFatalFailure(); ++i) {
      traffic_.begin_stretch(style.span);
      BlockLockstep::run(clocks, style.gap, style.lazy);
    }
  }
  // Clocks without an access.
  void stay_idle(std::int64_t clocks) {
    for (std::int64_t i = 0; i < clocks; ++i) {
      step();
      ASSERT_EQ(compare(), "") << "edge " << cycle_;
    }
  }
  void write(std::uint16_t addr, std::uint32_t data) {
    master_.write({.addr = addr, .data = data});
    while (master_.writes()) {
      master_.drive(1);
      step();
      ASSERT_EQ(compare(), "") << "edge " << cycle_;
    }
  }

  TimerTraffic traffic_{random_};
  TimerEvents events_;
  Style style_{};
  cosim::model::Strobes access_;
};

TEST_F(TimerLockstep, RandomTrafficIsThatOfTheBlockInEveryClock) {
  run({.gap = 1, .lazy = 1, .span = 14, .pin_gap = 6, .freeze_gap = 200}, 1'000, 512);
  run({.gap = 20, .lazy = 4, .span = 14, .pin_gap = 1, .freeze_gap = 200}, 300, 512);
  run({.gap = 60, .lazy = 2, .span = 60, .pin_gap = 20, .freeze_gap = 100}, 300, 1024);
  run({.gap = 600, .lazy = 1, .span = 500, .pin_gap = 400, .freeze_gap = 2000}, 60, 8192);
  events_.expect_each(50);
}

TEST_F(TimerLockstep, WithoutTheGatedClockPinsAndBusStandStill) {
  int high = 0;  // stopped while a pin was high
  for (int i = 0; i < 300 && !HasFatalFailure(); ++i) {
    restart();
    run({.gap = 1 + random_.below(20), .lazy = 1, .span = 6, .pin_gap = 6, .freeze_gap = 200}, 1,
        100 + random_.below(300));
    if (dut_.generate_o || dut_.pwm_o || dut_.irq_o) ++high;
    stop_gated_clock();
    run(style_, 1, 200);
  }
  EXPECT_GE(high, 50);
}

// The trigger of the tick.
TEST_F(TimerLockstep, APeriodIsTwoEdges) {
  constexpr std::int64_t kPeriod = 2500, kPeriods = 100;
  constexpr std::uint32_t kTick = kDown | kGenerate | kReload | kIrq;
  write(0x04, kPeriod - 2);
  write(0x00, kTick | kLoad);
  write(0x00, kTick | kRun);
  stay_idle(kPeriod);
  const std::int64_t before = needed_.computed;
  stay_idle(kPeriods * kPeriod);
  EXPECT_EQ(needed_.computed - before, 2 * kPeriods);
}

// Too long for the verilated block: the model alone.
class LongPeriod : public ::testing::Test {
 protected:
  void write(std::uint16_t addr, std::uint32_t data) {
    at_ += Cycles{1};
    timer_.edge(at_, {.write = true, .waddr = addr, .wdata = data, .wstrb = 0xF}, {});
  }
  // Clocks until the next pulse of timer 0.
  std::int64_t clocks_to_trigger() {
    const Cycles from = at_;
    for (int edges = 0; edges < 5; ++edges) {
      at_ = timer_.wakes_at();
      timer_.edge(at_, {}, {});
      if (timer_.trigger()) return (at_ - from).value();
    }
    return 0;
  }

  AxiTimer timer_;
  Cycles at_{0};
};

TEST_F(LongPeriod, ThirtyTwoBits) {
  constexpr std::uint32_t kMode = kDown | kGenerate | kReload;
  write(0x04, kMax);
  write(0x00, kMode | kLoad);
  write(0x00, kMode | kRun);
  EXPECT_EQ(clocks_to_trigger(), std::int64_t{1} << 32);
  EXPECT_EQ(clocks_to_trigger(), (std::int64_t{1} << 32) + 1);
  timer_.edge(at_ + Cycles{1}, {}, {});
  EXPECT_EQ(timer_.tcr(0, at_ + Cycles{1'000'001}), kMax - 1'000'000);
}

TEST_F(LongPeriod, SixtyFourBits) {
  constexpr std::uint32_t kMode = kDown | kGenerate | kReload | kCascade;
  write(0x04, 5);
  write(0x14, 3);
  write(0x10, kLoad);
  write(0x00, kMode | kLoad);
  write(0x10, 0);
  write(0x00, kMode | kRun);
  EXPECT_EQ(clocks_to_trigger(), (std::int64_t{3} << 32) + 6);
  EXPECT_EQ(clocks_to_trigger(), (std::int64_t{3} << 32) + 9);
  write(0x14, kMax);
  write(0x00, kMode | kLoad);
  write(0x10, kLoad);
  write(0x10, 0);
  write(0x00, kMode | kRun);
  EXPECT_EQ(timer_.wakes_at(), kNever) << "longer than the time that counts";
}

TEST_F(TimerLockstep, ATimerThatStandsIsNotComputed) {
  stay_idle(10);
  const std::int64_t before = needed_.computed;
  for (const std::uint32_t mode : {0u, kLoad, kRun | kCapture, kRun | kDown, kRun | kCascade | kCapture}) {
    write(0x04, 3);
    write(0x00, mode);
    write(0x10, mode);
    stay_idle(10'000);
  }
  EXPECT_LT(needed_.computed - before, 100);
}

}  // namespace
}  // namespace armature::test::axi_timer
