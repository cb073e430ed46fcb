// A response that a fault turns into an error: the logic has executed the access, and the core does not know.
#include <gtest/gtest.h>

#include <cstdint>

#include "controller/regs/pulse_train_regs.hpp"
#include "controller/regs/soc_map.hpp"
#include "cosim/run/run.hpp"
#include "tests/cosim/support/whole_run.hpp"

namespace armature::cosim {
namespace {

constexpr std::uint32_t kCommit = regs::soc::kPulseTrainBase + regs::pulse_train::kCommitOffset;

RunSummary with_error_of_commit(Engine engine) {
  Scenario scenario = test::moving_scenario(0.03, engine);
  scenario.faults = {{.at_s = 0.02, .kind = SlaveError{.address = kCommit, .count = 1}}};
  return test::summary_of(scenario);
}

// The pulses of the last set that core 0 has committed come out, although its write was answered with SLVERR.
TEST(SlaveError, OfACommitLosesNoPulse) {
  const RunSummary run = with_error_of_commit(Engine::kModel);
  EXPECT_EQ(run.failure, std::nullopt);
  ASSERT_FALSE(run.facts.bus_aborts.empty());
  EXPECT_EQ(run.facts.bus_aborts[0].address, kCommit);
}

TEST(SlaveError, OfACommitIsTheSameOnBothEngines) {
  EXPECT_EQ(with_error_of_commit(Engine::kLockstep).failure, std::nullopt);
}

}  // namespace
}  // namespace armature::cosim
