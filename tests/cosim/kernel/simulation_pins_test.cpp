// The tool's pins inside a whole simulation: the real logic, its interrupt, both cores.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "cosim/kernel/scenario_soc.hpp"
#include "cosim/kernel/simulation.hpp"
#include "cosim/scenario/files/scenario_loader.hpp"
#include "cosim/time/clock.hpp"
#include "tests/cosim/support/scenario_files.hpp"
#include "tests/cosim/support/temp_folder.hpp"
#include "tests/support/silent_listener.hpp"

namespace armature::cosim {
namespace {

struct Change {
  int pin = 0;
  bool level = false;
  double at_s = 0;
};

class PinRecorder final : public test::SilentListener {
 public:
  void on_row(TraceRow& row) override { rows.push_back(row); }
  void on_event(const Event& event, Cycles now) override {
    if (const auto* move = std::get_if<MoveStarted>(&event)) moves.push_back(*move);
    if (const auto* io = std::get_if<IoDone>(&event)) done.push_back(io->tag.number());
    if (const auto* refusal = std::get_if<MoveRefused>(&event)) {
      refusals.push_back(*refusal);
      refused_at_s.push_back(to_seconds(now));
    }
  }
  void on_signal(const Signal& signal, Cycles now) override {
    const auto* output = std::get_if<OutputLevel>(&signal);
    if (output != nullptr) outputs.push_back({output->pin, output->level, to_seconds(now)});
  }

  std::vector<TraceRow> rows;
  std::vector<MoveStarted> moves;
  std::vector<MoveRefused> refusals;
  std::vector<double> refused_at_s;
  std::vector<std::uint32_t> done;
  std::vector<Change> outputs;
};

struct Outcome {
  PinRecorder seen;
  SimulationEnd end;
};

Outcome run(const std::string& tables) {
  const test::TempFolder folder;
  const std::string head = "description = \"pins\"\nrobot = \"vo2021_6r\"\nduration_s = 0.02\n";
  const Scenario scenario = load_scenario(folder.write("s/scenario.toml", head + tables), test::shipped());
  Outcome outcome;
  outcome.end = test::run_to_end(Simulation{scenario, make_soc(scenario), outcome.seen});
  EXPECT_EQ(outcome.end.reason, EndReason::kFinished) << outcome.end.failure;
  return outcome;
}

TEST(SimulationPins, AnOutputFollowsItsCommandWithinSomeMicroseconds) {
  const Outcome r = run(R"(
[[move]]
at_s = 0.005
type = "dout"
pin = 16
level = 1
[[move]]
at_s = 0.010
type = "dout"
pin = 16
level = 0
)");
  ASSERT_EQ(r.seen.outputs.size(), 2u);
  EXPECT_EQ(r.seen.outputs[0].pin, 16);
  EXPECT_TRUE(r.seen.outputs[0].level);
  EXPECT_GT(r.seen.outputs[0].at_s, 0.005);
  EXPECT_LT(r.seen.outputs[0].at_s, 0.005 + 10e-6);
  EXPECT_FALSE(r.seen.outputs[1].level);
  EXPECT_EQ(r.seen.done, (std::vector<std::uint32_t>{0, 1}));
}

// The input is seen by its interrupt, not by looking again and again: the output follows within microseconds, and an
// input that nobody waits for costs no access.
TEST(SimulationPins, AnInputWakesTheCoreThatWaitsForIt) {
  const Outcome r = run(R"(
[[move]]
at_s = 0.005
type = "wait_din"
pin = 9
level = 1
[[move]]
at_s = 0.005
type = "dout"
pin = 1
level = 1
[[input]]
at_s = 0.007
pin = 8
level = 1
[[input]]
at_s = 0.0123
pin = 9
level = 1
)");
  ASSERT_EQ(r.seen.outputs.size(), 1u);
  EXPECT_GT(r.seen.outputs[0].at_s, 0.0123);
  EXPECT_LT(r.seen.outputs[0].at_s, 0.0123 + 10e-6);

  const Outcome without = run("");
  const Outcome unheard = run("[[input]]\nat_s = 0.007\npin = 8\nlevel = 1\n");
  EXPECT_EQ(unheard.end.bus_reads, without.end.bus_reads);
  EXPECT_EQ(unheard.end.bus_writes, without.end.bus_writes);
  // Two at the beginning and at each change (status, inputs), one for the output.
  EXPECT_EQ(r.end.bus_reads, without.end.bus_reads + 7);
  // Two to enable, one to acknowledge each change, the output.
  EXPECT_EQ(r.end.bus_writes, without.end.bus_writes + 5);
}

TEST(SimulationPins, ATimeOutComesWithinTwoTicks) {
  const Outcome r = run(R"(
[[move]]
at_s = 0.005
type = "wait_din"
pin = 9
level = 1
timeout_s = 0.004
[[move]]
at_s = 0.005
type = "joint"
target_deg = [1, 0, 0, 0, 0, 0]
)");
  ASSERT_EQ(r.seen.refusals.size(), 2u);
  for (const MoveRefused& refusal : r.seen.refusals) EXPECT_EQ(refusal.reason, Refusal::kInputTimeout);
  EXPECT_EQ(r.seen.refusals[0].tag, 0u);
  EXPECT_EQ(r.seen.refusals[1].tag, 1u);
  for (const double at_s : r.seen.refused_at_s) {
    EXPECT_GE(at_s, 0.009);
    EXPECT_LE(at_s, 0.009 + 100e-6);
  }
  EXPECT_TRUE(r.seen.moves.empty());
}

TEST(SimulationPins, AnOutputWaitsForTheLastPulseOfTheMoveBeforeIt) {
  const Outcome r = run(R"(
[[move]]
at_s = 0.001
type = "joint"
target_deg = [0.01, 0, 0, 0, 0, 0]
[[move]]
at_s = 0.001
type = "dout"
pin = 2
level = 1
)");
  ASSERT_EQ(r.seen.outputs.size(), 1u);
  const std::int64_t at = to_cycles(r.seen.outputs[0].at_s).value();
  std::int64_t last_pulse = 0;      // cycle of the trigger after it
  std::int64_t last_set_point = 0;  // cycle of the trigger that starts its set
  for (std::size_t k = 1; k < r.seen.rows.size(); ++k) {
    const TraceRow& row = r.seen.rows[k];
    const TraceRow& before = r.seen.rows[k - 1];
    if (row.pin_pulses != before.pin_pulses) last_pulse = row.cycle;
    if (row.telemetry.reference != before.telemetry.reference) last_set_point = row.cycle;
  }
  ASSERT_GT(last_pulse, 0);
  EXPECT_GT(at, last_pulse);
  EXPECT_GT(at, last_set_point + kTickCycles);
  EXPECT_LT(at, last_set_point + 2 * kTickCycles);
}

}  // namespace
}  // namespace armature::cosim
