#include "cosim/iss/instruction_time.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace armature::cosim::iss {
namespace {

TEST(InstructionTime, LosesNoPartOfACycle) {
  InstructionTime time{1.5};
  std::int64_t cycles = 0;
  for (int i = 1; i <= 20'000; ++i) {
    time.count(1);
    if (i % 7 == 0) cycles += time.take().value();
  }
  cycles += time.take().value();
  EXPECT_EQ(cycles, 2250) << "20000 instructions of 1.5 clocks at 666.667 MHz are 45 us";
  EXPECT_EQ(time.instructions(), 20'000);
  EXPECT_EQ(time.take(), Cycles{0});
}

TEST(InstructionTime, BeginsAgain) {
  InstructionTime time{100};
  for (int i = 0; i < 9; ++i) time.count(1);
  EXPECT_EQ(time.take(), Cycles{67});
  time.reset();
  EXPECT_EQ(time.take(), Cycles{0});
  time.count(1);
  EXPECT_EQ(time.take(), Cycles{7});
  EXPECT_EQ(time.instructions(), 1);
}

}  // namespace
}  // namespace armature::cosim::iss
