// GoogleTest fixture around one verilated block with the ports clk_i and rst_ni.
//
// A failing RTL assertion ($error, `ASSERT) becomes a GoogleTest failure at the file and line of the assertion; the
// run goes on. $fatal and a model that does not converge throw, which ends the test as a failure.
#pragma once

#include <gtest/gtest.h>
#include <verilated.h>

#include <cstdint>

#include "cosim/fabric/gated_clocks.hpp"
#include "tests/support/split_mix.hpp"

namespace armature::test {

// Registers without a reset, and input ports, start with random bits from this seed: a missing reset or a forgotten
// input shows.
inline constexpr int kPowerUpSeed = 20210417;

class PowerUpContext : public VerilatedContext {
 public:
  PowerUpContext() {
    randReset(2);
    randSeed(kPowerUpSeed);
  }
};

// Called before a model goes, while it can still be looked at; null: nobody looks (tests/coverage does).
extern void (*at_end_of_model)(VerilatedContext& context);

// Long enough to flush every synchroniser.
inline constexpr int kResetCycles = 4;

template <class Dut>
class VerilatedTest : public ::testing::Test {
 protected:
  ~VerilatedTest() override {
    dut_.final();
    if (at_end_of_model != nullptr) at_end_of_model(context_);
  }

  // One clock cycle: the inputs set before the call are sampled, the outputs are those after the edge.
  void tick() {
    dut_.clk_i = 1;
    raise_gated_clock();
    dut_.eval();
    dut_.clk_i = 0;
    if constexpr (requires { dut_.clk_gated_i; }) dut_.clk_gated_i = 0;
    if constexpr (requires { dut_.clk_io_i; }) cosim::set_clocks(dut_, {});
    dut_.eval();
    ++cycle_;
  }

  void tick(std::int64_t cycles) {
    for (std::int64_t i = 0; i < cycles; ++i) tick();
  }

  // Leaves the inputs alone: set their idle levels first.
  void reset() {
    dut_.rst_ni = 0;
    tick(kResetCycles);
    dut_.rst_ni = 1;
    cycle_ = 0;
  }

  // The edges that a gated clock need not have it gets, or not, at random: no test may tell the difference.
  void raise_gated_clock() {
    if constexpr (requires { dut_.clk_gated_i; }) {
      dut_.clk_i = dut_.clk_gated_i = 0;
      dut_.eval();  // active_o looks at inputs
      dut_.clk_i = 1;
      dut_.clk_gated_i = dut_.active_o || !dut_.rst_ni || gate_random_.below(2) == 0;
    }
    if constexpr (requires { dut_.clk_io_i; }) {
      cosim::set_clocks(
          dut_, cosim::needed_clocks(dut_, static_cast<unsigned>(gate_random_.below(cosim::kAllGatedClocks + 1))));
    }
  }

  PowerUpContext context_;
  SplitMix gate_random_{kPowerUpSeed};
  Dut dut_{&context_};
  std::int64_t cycle_ = 0;  // edges since the end of the last reset
};

}  // namespace armature::test
