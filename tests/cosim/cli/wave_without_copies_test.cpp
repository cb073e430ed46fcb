// `run --wave-on` on a host that refuses the snapshots (cosim/rewind): the run and its results are the same, and a
// second run writes the waveform.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "cosim/cli/run/folder_run.hpp"
#include "cosim/time/clock.hpp"
#include "tests/cosim/run/recorded_run.hpp"
#include "tests/cosim/snapshot/refused_copies.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

RunSummary run_with_wave(const fs::path& out) {
  Scenario scenario = test::lively_scenario();
  scenario.engine = Engine::kRtl;
  const MomentWave wanted{.reason = WaveReason::kFault, .before = to_cycles(0.0005)};
  return run_into_folder(scenario, {.out = out,
                                    .moment_wave = MomentWaveRequest{wanted, {.file = out / "wave.vcd"}},
                                    .show_progress = false,
                                    .why_not_compared = "another scenario"});
}

TEST(WaveOn, HasTheSameWaveformWhereTheHostRefusesSnapshots) {
  const test::TempFolder folder;
  fs::permissions(folder.path(), fs::perms::all);  // for the user for whom copies are refused
  const fs::path plain = folder.path() / "plain", refused = folder.path() / "refused";
  const RunSummary summary = run_with_wave(plain);
  ASSERT_TRUE(summary.moment_wave);
  ASSERT_EQ(summary.moment_wave->why_not, "");
  const auto run = [&] {
    test::refuse_copies();
    const RunSummary other = run_with_wave(refused);
    ::_exit(other.moment_wave && other.moment_wave->at == summary.moment_wave->at ? 0 : 1);
  };
  EXPECT_EXIT(run(), testing::ExitedWithCode(0), "");
  for (const char* name : {"wave.vcd", "trace.csv"}) {
    EXPECT_TRUE(test::read_file(plain / name) == test::read_file(refused / name)) << name;
  }
}

}  // namespace
}  // namespace armature::cosim
