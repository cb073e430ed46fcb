// Fixture of debounce with 18 lines, as in the encoder block.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>

#include "Vdebounce.h"
#include "tests/support/verilated_test.hpp"

namespace armature::test {

inline constexpr int kLines = 18;
inline constexpr std::uint32_t kAllLines = (1U << kLines) - 1;
inline constexpr std::uint8_t kRestart = 0, kUpDown = 1;  // mode_i

class DebounceFixture : public VerilatedTest<Vdebounce> {
 protected:
  explicit DebounceFixture(std::uint8_t mode) {
    dut_.level_i = 0;
    dut_.valid_i = 1;
    dut_.mode_i = mode;
    dut_.time_i = 5;
    reset();
  }

  void settle(std::uint32_t level) {
    dut_.level_i = level;
    tick(600);
    ASSERT_EQ(dut_.level_o, level);
    ASSERT_EQ(dut_.known_o, kAllLines);
  }

  // Holds `level` for `cycles` and counts the glitches of line 0.
  int hold(std::uint32_t level, int cycles) {
    dut_.level_i = level;
    int glitches = 0;
    for (int i = 0; i < cycles; ++i) {
      tick();
      glitches += dut_.glitch_o & 1U ? 1 : 0;
    }
    return glitches;
  }
};

}  // namespace armature::test
