// Flips of the memory of the cores, in whole runs of the firmware with the logic.
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "cosim/cpu/make_processor.hpp"
#include "cosim/flips/drawn_flips.hpp"
#include "cosim/flips/flip_sweep.hpp"
#include "cosim/iss/arm_program.hpp"
#include "cosim/iss/firmware.hpp"
#include "tests/cosim/fault/fault_rows.hpp"
#include "tests/cosim/support/scenario_files.hpp"
#include "tests/cosim/support/whole_flip.hpp"
#include "tests/cosim/support/whole_run.hpp"

namespace armature::cosim::iss {
namespace {

using RunUnderTest = Run;  // Test has a function Run

class MemoryFlips : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    provide_a9([](host_memory::HostMemory& memory, const CpuSpec& spec) -> std::unique_ptr<CoreProgram> {
      return std::make_unique<ArmProgram>(firmware(), memory, spec.cpi);
    });
  }
};

// The places do not depend on what the compiler makes of the firmware.
TEST_F(MemoryFlips, TheCommittedRowsAreWhatTheRunsShow) {
  const std::vector<test::FaultCase> rows{
      {.fault = R"(kind = "memory_flip", symbol = "armature_charge", bit = 28)", .firmware = true},
      {.fault = R"(kind = "memory_flip", symbol = "start_core1", bit = 3)",
       .why = "Nothing executes it any more; core 1 compares all code with what it was.",
       .firmware = true},
      {.fault = R"(kind = "memory_flip", symbol = "host_memory", offset = 184, bit = 30)",
       .why = "The controller reads the robot before it starts, and not any more.",
       .firmware = true},
  };
  test::expect_committed("## Memory of the cores\n",
                         "\nThe same runs with the firmware in the simulator of ARM "
                         "instructions. What bits at random places do is in\n"
                         "[cosim/flips](../cosim/flips/README.md).\n\n" +
                             test::table_of(rows));
}

TEST_F(MemoryFlips, ASweepJudgesEachAsAWholeRunDoes) {
  Scenario scenario = test::moving_scenario(0.1, Engine::kRtl, "1, 1, 1, 1, 1, 1");
  scenario.cpu.processor = CpuKind::kA9;
  scenario.cpu.cpi = 1.5;
  const auto never = [] { return false; };
  const UnflippedRun unflipped = run_unflipped(scenario, never).value();
  ASSERT_EQ(unflipped.verdict.outcome, Outcome::kFinished) << unflipped.verdict.reason;
  std::vector<Flip> flips = flips_of(memory_of(scenario), "", 1, 5);
  flips.push_back({.part = "code", .name = "armature_charge", .offset = 0, .bit = 28});
  flips.push_back({.part = "host memory", .name = "host_memory", .offset = 13'888, .bit = 3});  // the telemetry
  const std::vector<FlipResult> results =
      sweep_flips(scenario, unflipped,
                  {.flips = flips, .instants = {Cycles{800'555}, Cycles{1'000'123}}, .jobs = 2, .stop = never});
  ASSERT_EQ(results.size(), 2 * flips.size());
  int stopped = 0;
  for (const FlipResult& result : results) {
    const Verdict verdict = test::whole_run(scenario, unflipped, result);
    EXPECT_EQ(result.verdict.outcome, verdict.outcome) << keys_of(result.flip) << ": " << verdict.reason;
    EXPECT_EQ(result.verdict.latency_ticks, verdict.latency_ticks) << keys_of(result.flip);
    if (verdict.outcome == Outcome::kStopped) ++stopped;
  }
  EXPECT_GT(stopped, 1);
}

TEST_F(MemoryFlips, AnUnknownSymbolAndAPlaceWithoutMemoryAreRefused) {
  const auto error_of = [](const std::string& place) -> std::string {
    const Scenario scenario = test::scenario_with(
        std::string{test::kFirmwareKeys} + "\n[[fault]]\nat_s = 0.1\nkind = \"memory_flip\"\n" + place + "\nbit = 0\n");
    try {
      const RunUnderTest run{scenario};
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(error_of("symbol = \"page_tabel\"").find("did you mean \"page_table\"?"), std::string::npos);
  EXPECT_NE(error_of("symbol = \"vectors\"\noffset = -4").find("offset: expected a place in the memory"),
            std::string::npos);
  EXPECT_EQ(error_of("symbol = \"vectors\"\noffset = 4"), "");
}

}  // namespace
}  // namespace armature::cosim::iss
