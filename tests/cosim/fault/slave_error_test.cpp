// A response that a fault turns into an error: the logic has executed the access, and the core does not know.
#include <gtest/gtest.h>

#include <cstdint>

#include "controller/regs/pulse_train_regs.hpp"
#include "controller/regs/soc_map.hpp"
#include "cosim/run/run.hpp"
#include "tests/cosim/support/scenario_files.hpp"

namespace armature::cosim {
namespace {

constexpr std::uint32_t kCommit = regs::soc::kPulseTrainBase + regs::pulse_train::kCommitOffset;

RunSummary with_error_of_commit(Engine engine) {
  Scenario scenario = test::scenario_with(R"(
[[move]]
at_s = 0.002
type = "joint"
target_deg = [40, 40, 40, 40, 40, 40]
)");
  scenario.duration_s = 0.03;
  scenario.engine = engine;
  scenario.faults = {{.at_s = 0.02, .kind = SlaveError{.address = kCommit, .count = 1}}};
  Run run{scenario};
  while (run.advance(run.now() + Cycles{1'000'000})) {
  }
  return run.finish();
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
