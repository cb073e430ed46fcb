// Fixture of the timer pair without the bus: a register write takes one clock, every output is checked in each clock.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "Vtimer_core.h"
#include "tests/rtl/axi_timer_bits.hpp"
#include "tests/support/verilated_test.hpp"

namespace armature::test::axi_timer {

// A change of the freeze pin takes effect in the clock after this number of calls of tick(), an edge of a capture pin
// one clock later.
inline constexpr int kSyncClocks = 2, kEdgeClocks = 3;

template <class Dut>
class CoreFixture : public VerilatedTest<Dut> {
 protected:
  void SetUp() override { start(0, false); }

  void start(unsigned idle_triggers, bool freeze) {
    dut().tcsr0_we_i = dut().tlr0_we_i = dut().tcsr1_we_i = dut().tlr1_we_i = 0;
    dut().capture_trig_i = static_cast<CData>(idle_triggers);
    dut().freeze_i = freeze;
    this->reset();
  }

  // The value takes effect in the clock after the call.
  void write_tcsr(unsigned timer, std::uint32_t value, unsigned strobe = 0xF) {
    write(timer == 0 ? dut().tcsr0_we_i : dut().tcsr1_we_i, value, strobe);
  }
  void write_tlr(unsigned timer, std::uint32_t value, unsigned strobe = 0xF) {
    write(timer == 0 ? dut().tlr0_we_i : dut().tlr1_we_i, value, strobe);
  }
  std::uint32_t tcsr(unsigned timer) { return timer == 0 ? dut().tcsr0_rdata_o : dut().tcsr1_rdata_o; }
  std::uint32_t tlr(unsigned timer) { return timer == 0 ? dut().tlr0_rdata_o : dut().tlr1_rdata_o; }
  std::uint32_t tcr(unsigned timer) { return timer == 0 ? dut().tcr0_rdata_o : dut().tcr1_rdata_o; }
  bool flag(unsigned timer) { return (tcsr(timer) & kFlag) != 0; }
  bool pulse(unsigned timer) { return (dut().generate_o >> timer & 1u) != 0; }

  // Loads the counter and writes `mode`, which must not start the timer, to TCSR.
  void load(unsigned timer, std::uint32_t value, std::uint32_t mode = 0) {
    write_tlr(timer, value);
    write_tcsr(timer, mode | kLoad);
    write_tcsr(timer, mode);
    EXPECT_EQ(tcr(timer), value);
  }

  // Clocks, counted from 1, after which `condition` is true.
  template <class Condition>
  std::vector<std::int64_t> when(std::int64_t clocks, Condition condition) {
    std::vector<std::int64_t> found;
    for (std::int64_t i = 1; i <= clocks; ++i) {
      this->tick();
      if (condition()) found.push_back(i);
    }
    return found;
  }
  std::vector<std::int64_t> pulses(unsigned timer, std::int64_t clocks) {
    return when(clocks, [&] { return pulse(timer); });
  }

  Dut& dut() { return this->dut_; }

 private:
  void write(CData& strobe_port, std::uint32_t value, unsigned strobe) {
    strobe_port = 1;
    dut().wdata_i = value;
    dut().wstrb_i = static_cast<CData>(strobe);
    this->tick();
    strobe_port = 0;
    dut().wdata_i = ~value;
  }
};

}  // namespace armature::test::axi_timer
