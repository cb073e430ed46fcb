// Fixture of arm_soc with its bus and all inputs idle. It records the cycles of triggers and pulses.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "Varm_soc.h"
#include "controller/regs/pulse_train_regs.hpp"
#include "cosim/fabric/model_pins.hpp"
#include "tests/support/axi_stall_test.hpp"

namespace armature::test {

class ArmSocTest : public AxiStallTest<Varm_soc> {
 protected:
  // Literal numbers on purpose, because software and documents depend on them.
  static constexpr std::uint32_t kGpio = 0x4120'0000u, kUart = 0x43C0'1000u;
  static constexpr std::uint32_t kTimer = 0x4280'0000u, kPulse = 0x43C1'0000u, kEncoder = 0x43C2'0000u,
                                 kIk = 0x43C4'0000u, kPolicy = 0x43C5'0000u;
  static constexpr std::uint32_t kTcsr0 = kTimer + 0x00, kTlr0 = kTimer + 0x04;
  static constexpr std::uint32_t kLoad = 0x020, kTimerAck = 0x1D6, kTimerRun = 0x0D6;  // down, GENT, ARHT, ENIT, ENT
  static constexpr std::uint32_t kAxes = 6, kAllAxes = 0x3F;
  static constexpr std::int64_t kTick = 2500;

  void SetUp() override {
    cosim::drive_pins(dut_, cosim::SocInputs{});
    AxiStallTest::SetUp();
  }

  void clock() override {
    const unsigned step = dut_.step_o;
    if (environment_) environment_();
    tick();
    if (dut_.trigger_o) triggers_.push_back(cycle_);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (dut_.step_o & ~step & (1u << axis)) rises_[axis].push_back(cycle_);
    }
  }

  void start_timer() {
    write(kTlr0, kTick - 2);
    write(kTcsr0, kLoad);
    write(kTcsr0, kTimerRun);
  }
  void run_to_trigger() {
    const std::size_t seen = triggers_.size();
    for (int i = 0; i < 2 * kTick && triggers_.size() == seen; ++i) axi_.step();
    ASSERT_GT(triggers_.size(), seen) << "no trigger";
    axi_.step();  // the edge on which the blocks sample the trigger
  }
  // Cycle of the last trigger, or -1.
  std::int64_t last_trigger() const { return triggers_.empty() ? -1 : triggers_.back(); }
  void commit(const std::array<int, kAxes>& counts) {
    for (std::uint32_t i = 0; i < kAxes; ++i) {
      write(kPulse + regs::pulse_train::kCountOffset + 4 * i, static_cast<std::uint32_t>(counts[i]) & 0xFFFFu);
    }
    write(kPulse + regs::pulse_train::kCommitOffset, 1);
  }

  std::vector<std::int64_t> triggers_;                  // cycles in which trigger_o was high
  std::array<std::vector<std::int64_t>, kAxes> rises_;  // first cycle of each pulse
  std::function<void()> environment_;                   // drives input pins before each edge
};

}  // namespace armature::test
