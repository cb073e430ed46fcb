// A million clocks of random register writes and pin changes, without the bus and so with a write in every clock at
// most: every register and pin of the timer pair is that of its model in every clock.
#include <sstream>
#include <string>

#include "cosim/model/timer/axi_timer.hpp"
#include "tests/rtl/axi_timer_core_fixture.hpp"
#include "tests/rtl/axi_timer_events.hpp"
#include "tests/rtl/axi_timer_traffic.hpp"

namespace armature::test::axi_timer {
namespace {

constexpr std::uint64_t kSeed = 42;
constexpr int kClocks = 1'000'000;

class AxiTimerLockstep : public CoreFixture<Vtimer_core> {
 protected:
  cosim::model::Strobes random_write() {
    const TimerWrite write = traffic_.write();
    return {.write = true, .waddr = write.addr, .wdata = write.data, .wstrb = write.strobe};
  }

  // One edge of the timers and of the model.
  void clock(const cosim::model::Strobes& access) {
    dut_.tcsr0_we_i = access.write && access.waddr == 0x00;
    dut_.tlr0_we_i = access.write && access.waddr == 0x04;
    dut_.tcsr1_we_i = access.write && access.waddr == 0x10;
    dut_.tlr1_we_i = access.write && access.waddr == 0x14;
    dut_.wdata_i = access.wdata;
    dut_.wstrb_i = access.wstrb;
    dut_.capture_trig_i = inputs_.capture_trig ? 0b11 : 0b00;
    dut_.freeze_i = inputs_.freeze;
    tick();
    model_.edge(Cycles{cycle_}, access, inputs_);
    view_ = TimerView{model_, Cycles{cycle_}};
    events_.edge(view_, access, inputs_);
  }

  bool equal() {
    bool all = dut_.pwm_o == model_.pwm() && dut_.irq_o == model_.irq() && pulse(0) == model_.trigger() &&
               pulse(1) == model_.second_trigger();
    for (unsigned t = 0; t < 2; ++t) {
      all = all && tcsr(t) == view_.tcsr[t] && tlr(t) == view_.tlr[t] && tcr(t) == view_.tcr[t];
    }
    return all;
  }

  std::string difference() {
    std::ostringstream text;
    text << std::hex;
    for (unsigned t = 0; t < 2; ++t) {
      text << "\ntimer " << t << " RTL/model: TCSR " << tcsr(t) << '/' << view_.tcsr[t] << ", TLR " << tlr(t) << '/'
           << view_.tlr[t] << ", TCR " << tcr(t) << '/' << view_.tcr[t] << ", pulse " << pulse(t) << '/'
           << (t == 0 ? model_.trigger() : model_.second_trigger());
    }
    text << "\npwm " << int{dut_.pwm_o} << '/' << model_.pwm() << ", irq " << int{dut_.irq_o} << '/' << model_.irq();
    return text.str();
  }

  SplitMix random_{kSeed};
  TimerTraffic traffic_{random_};
  cosim::model::TimerInputs inputs_;
  cosim::model::AxiTimer model_;
  TimerView view_;
  TimerEvents events_;
};

TEST_F(AxiTimerLockstep, RandomTrafficIsThatOfTheModelInEveryClock) {
  std::uint32_t gap = 1;  // mean clocks between writes
  for (int i = 0; i < kClocks; ++i) {
    if (i % 512 == 0) {
      gap = 1 + random_.below(4) * random_.below(16);
      traffic_.begin_stretch(14);
    }
    if (random_.below(6) == 0) inputs_.capture_trig = random_.below(2) != 0;
    if (random_.below(inputs_.freeze ? 8 : 200) == 0) inputs_.freeze = !inputs_.freeze;
    clock(random_.below(gap) == 0 ? random_write() : cosim::model::Strobes{});
    ASSERT_TRUE(equal()) << "seed " << kSeed << ", clock " << i << difference();
  }
  events_.expect_each(100);
}

}  // namespace
}  // namespace armature::test::axi_timer
