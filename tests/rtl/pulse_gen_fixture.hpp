// Fixture of one pulse generator with a trigger source and a drive.
#pragma once

#include <cstdint>

#include "tests/support/step_dir_monitor.hpp"
#include "tests/support/verilated_test.hpp"

namespace armature::test {

inline constexpr int kTickCycles = 2500;
inline constexpr int kMaxCount = 200;
inline constexpr int kMinWidth = 6;
inline constexpr int kDirSetup = 25;
inline constexpr int kDirHold = 25;

template <class Dut>
class PulseGenBase : public VerilatedTest<Dut> {
 protected:
  PulseGenBase() {
    this->dut_.trigger_i = 0;
    this->dut_.stop_i = 0;
    this->dut_.count_i = 0;
    this->dut_.tick_cycles_i = kTickCycles;
    this->dut_.dir_setup_i = kDirSetup;
    this->dut_.dir_hold_i = kDirHold;
    this->reset();
  }

  void step_clock() {
    this->tick();
    monitor_.sample(this->cycle_, this->dut_.step_o, this->dut_.dir_o);
  }

  // Runs the trigger cycle and `cycles` - 1 more, so that the next cycle is the next trigger cycle.
  // An edge that coincides with the next trigger edge is therefore recorded in the next tick, at cycle 0.
  void run_tick(int count, int cycles = kTickCycles) {
    begin_tick(count);
    for (int i = 1; i < cycles; ++i) step_clock();
  }

  void begin_tick(int count) {
    this->dut_.trigger_i = 1;
    this->dut_.count_i = static_cast<std::uint16_t>(count) & 0x1FF;
    step_clock();
    this->dut_.trigger_i = 0;
    this->dut_.count_i = 0x155;  // must have no effect outside the trigger cycle
    trigger_ = this->cycle_;
    monitor_.edges.clear();
  }

  [[nodiscard]] int emitted() const { return static_cast<std::int32_t>(this->dut_.emitted_o); }
  [[nodiscard]] int unfinished() const {
    return static_cast<std::int16_t>(static_cast<std::uint16_t>(this->dut_.unfinished_o << 7)) >> 7;
  }

  void expect_legal_timing(int dir_setup = kDirSetup, int dir_hold = kDirHold) const {
    EXPECT_EQ(monitor_.dir_changes_while_high, 0);
    EXPECT_GE(monitor_.min_high, kMinWidth);
    EXPECT_GE(monitor_.min_low, kMinWidth);
    EXPECT_GE(monitor_.min_setup, dir_setup);
    EXPECT_GE(monitor_.min_hold, dir_hold);
  }

  StepDirMonitor monitor_;
  std::int64_t trigger_ = 0;  // the trigger edge of the running tick
};

}  // namespace armature::test
