// What a run says about the waveforms of two engines that differ. No run of the shipped program has any.
#include <gtest/gtest.h>

#include "cosim/cli/run/failure_text.hpp"

namespace armature::cosim {
namespace {

TEST(FailureText, NamesTheWaveformsOfBothEnginesAndTheCommandThatComparesThem) {
  RunSummary summary;
  summary.engines_differ_at = Cycles{617'280};
  EXPECT_EQ(engine_waves_text(summary, "out/x"), "") << "the far end of the serial line was another program";
  summary.engine_waves_written = true;
  EXPECT_EQ(engine_waves_text(summary, "out/x"),
            "waveforms      out/x/lockstep_rtl.vcd, out/x/lockstep_model.vcd: both engines around cycle 617280\n");
  const NextCommand next = compare_engines_command("my out");
  EXPECT_EQ(next.what, "to see it");
  EXPECT_EQ(next.command, "armature compare 'my out/lockstep_rtl.vcd' 'my out/lockstep_model.vcd' --views 'my out'");
}

}  // namespace
}  // namespace armature::cosim
