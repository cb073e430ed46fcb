// The error counters of the encoder block: each event counts once, and a full counter stays full.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "Verror_counters.h"
#include "tests/support/split_mix.hpp"
#include "tests/support/verilated_test.hpp"

namespace armature::test {
namespace {

constexpr std::uint32_t kAxes = 6;
constexpr std::uint32_t kFull = 0xFFFF;

class ErrorCounters : public VerilatedTest<Verror_counters> {
 protected:
  void SetUp() override {
    drive({});
    reset();
  }

  struct Events {
    std::uint32_t illegal = 0, a = 0, b = 0, z = 0;  // one bit per axis
  };

  void drive(const Events& events) {
    dut_.illegal_i = static_cast<CData>(events.illegal);
    dut_.glitch_a_i = static_cast<CData>(events.a);
    dut_.glitch_b_i = static_cast<CData>(events.b);
    dut_.glitch_z_i = static_cast<CData>(events.z);
  }

  void clock(const Events& events) {
    drive(events);
    tick();
    for (std::uint32_t axis = 0; axis < kAxes; ++axis) {
      const auto bit = [axis](std::uint32_t word) { return word >> axis & 1u; };
      illegal_[axis] = std::min(kFull, illegal_[axis] + bit(events.illegal));
      glitches_[axis] = std::min(kFull, glitches_[axis] + bit(events.a) + bit(events.b) + bit(events.z));
    }
  }

  void expect_counts() const {
    for (std::uint32_t axis = 0; axis < kAxes; ++axis) {
      EXPECT_EQ(dut_.illegal_count_o[axis / 2] >> 16 * (axis % 2) & kFull, illegal_[axis]) << "axis " << axis;
      EXPECT_EQ(dut_.glitch_count_o[axis / 2] >> 16 * (axis % 2) & kFull, glitches_[axis]) << "axis " << axis;
    }
  }

  std::array<std::uint32_t, kAxes> illegal_{}, glitches_{};
};

TEST_F(ErrorCounters, CountEveryEventOfEveryAxis) {
  SplitMix random{16};
  for (int i = 0; i < 2000; ++i) {
    clock({random.below(64), random.below(64), random.below(64), random.below(64)});
    expect_counts();
  }
}

// Axis 1 comes to the end one by one, axis 2 by two, axis 3 by three; the last step of two or three does not fit.
TEST_F(ErrorCounters, AFullCounterStaysFull) {
  for (std::uint32_t i = 0; i < kFull - 5; ++i) clock({0b001, 0b111, 0b110, 0b100});
  for (int i = 0; i < 10; ++i) {
    clock({0b001, 0b111, 0b110, 0b100});
    expect_counts();
  }
  EXPECT_EQ(illegal_[0], kFull);
  EXPECT_EQ(illegal_[1], 0u);
}

}  // namespace
}  // namespace armature::test
