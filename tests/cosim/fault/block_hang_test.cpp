// The clock of a block stops at any clock of the accesses of core 0 to it, also while the block shows a response. No
// later access gets this response: the crossbar answers SLVERR, and the core that reads it stops.
#include <gtest/gtest.h>

#include <cstdint>

#include "cosim/run/run.hpp"
#include "tests/cosim/support/whole_run.hpp"

namespace armature::cosim {
namespace {

// A move that the hang interrupts.
RunSummary hung_at(std::int64_t cycle, ClockGroup clock, Engine engine) {
  Scenario scenario = test::moving_scenario(0.0205, engine);
  scenario.drop_out_us = 200;
  scenario.faults = {{.at_s = static_cast<double>(cycle) * 20e-9, .kind = BlockHang{.clock = clock}}};
  return test::summary_of(scenario);
}

// Core 0 reads three positions, one after the other.
constexpr std::int64_t kReads = 1'000'750, kClocksOfReads = 3 * 18;

TEST(BlockHang, AtAnyClockOfAnAccessGivesNoStaleResponse) {
  for (std::int64_t cycle = kReads; cycle < kReads + kClocksOfReads; ++cycle) {
    const RunSummary hung = hung_at(cycle, ClockGroup::kEncoder, Engine::kModel);
    EXPECT_EQ(hung.failure, std::nullopt) << "cycle " << cycle;
    ASSERT_FALSE(hung.facts.bus_aborts.empty()) << "cycle " << cycle;
    EXPECT_EQ(hung.facts.bus_aborts[0].error, BusError::kSlaveError) << "cycle " << cycle;
  }
}

TEST(BlockHang, DuringAResponseIsTheSameOnBothEngines) {
  for (const std::int64_t cycle : {kReads + 10, kReads + 28, kReads + 29}) {
    EXPECT_EQ(hung_at(cycle, ClockGroup::kEncoder, Engine::kLockstep).failure, std::nullopt) << "cycle " << cycle;
  }
}

}  // namespace
}  // namespace armature::cosim
