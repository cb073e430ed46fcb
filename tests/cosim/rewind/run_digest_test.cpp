#include "cosim/rewind/run_digest.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "cosim/trace/integer_digest.hpp"

namespace armature::cosim {
namespace {

std::string digest_of(const SimulationState& seen) {
  return std::string{RunDigest{}.state(seen).digest_text()};
}

TEST(RunDigest, DependsOnAllThatIsSeen) {
  std::vector<SimulationState> states(14);
  states[1].now = Cycles{1};
  states[2].over = true;
  states[3].triggers = 1;
  states[4].bus_reads = 1;
  states[5].bus_writes = 1;
  states[6].inputs.enc_b = 1;
  states[7].outputs.step = 1;
  states[8].telemetry.actual[5] = Radians{1e-300};
  states[9].drive_pulses[0] = Pulses{1};
  states[10].motor_counts[0] = Counts{1};
  states[11].motor_deg[0] = 1e-300;
  states[12].following_error_counts[0] = 1e-300;
  states[13].motor_counts[1] = Counts{1};
  std::set<std::string> digests;
  for (const SimulationState& state : states) digests.insert(digest_of(state));
  EXPECT_EQ(digests.size(), states.size());
}

TEST(RunDigest, DependsOnAllThatIsHeard) {
  std::set<std::string> digests;
  const auto hear = [&](auto tell) {
    RunDigest digest;
    tell(digest);
    EXPECT_EQ(digest.state({}).heard, 1);
    digests.insert(std::string{digest.state({}).digest_text()});
  };
  const IntegerDigest integers;
  TraceRow row;
  hear([&](RunDigest& digest) { digest.on_row(row, integers); });
  row.motor_to[3] = 1;
  hear([&](RunDigest& digest) { digest.on_row(row, integers); });
  row.load[1].bus_cycles = 1;
  hear([&](RunDigest& digest) { digest.on_row(row, integers); });
  hear([&](RunDigest& digest) { digest.on_event(Faulted{.cause = FaultCause::kEstop}, {}); });
  hear([&](RunDigest& digest) { digest.on_event(Faulted{.cause = FaultCause::kEncoder}, {}); });
  hear([&](RunDigest& digest) { digest.on_event(Faulted{.cause = FaultCause::kEncoder}, {.at = Cycles{1}}); });
  hear([&](RunDigest& digest) { digest.on_action(InputSpec{}, {}); });
  hear([&](RunDigest& digest) { digest.on_signal(OutputLevel{.pin = 2}, {}); });
  hear([&](RunDigest& digest) { digest.on_signal(SerialEvent{.byte = 7}, {}); });
  hear([&](RunDigest& digest) { digest.on_signal(PendantStepDone{"a"}, {}); });
  EXPECT_EQ(digests.size(), 10u);
}

}  // namespace
}  // namespace armature::cosim
