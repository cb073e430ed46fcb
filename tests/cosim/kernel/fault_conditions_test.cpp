// Faults that wait for a condition: when they begin, and that both engines agree on it.
#include "cosim/kernel/script/fault_conditions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>

#include "controller/base/angle_units.hpp"
#include "controller/base/timebase.hpp"
#include "cosim/kernel/scenario_soc.hpp"
#include "cosim/kernel/simulation.hpp"
#include "tests/cosim/support/scenario_files.hpp"
#include "tests/support/silent_listener.hpp"

namespace armature::cosim {
namespace {

Scenario with_fault(const std::string& keys) {
  const test::TempFolder folder;
  const std::string text = R"(description = "a fault of a condition"
robot = "vo2021_6r"
duration_s = 0.6
engine = "model"
[[move]]
at_s = 0.01
type = "joint"
target_deg = [5, -10, 0, 0, 0, 0]
[[move]]
at_s = 0.011
type = "joint"
target_deg = [0, 0, 0, 0, 0, 0]
[[fault]]
kind = "estop"
duration_s = 0.001
)" + keys;
  return load_scenario(folder.write("s/scenario.toml", text), test::shipped());
}

class Seen final : public test::SilentListener {
 public:
  void on_row(TraceRow& row) override {
    if (!begun_at) {
      before = after;
      after = row;
    }
    digest.emplace_back(row.cycle, row.motor_counts, row.telemetry.reference_pulses);
  }
  void on_action(const ScriptAction& action, Cycles now) override {
    if (std::holds_alternative<FaultSpec>(action)) begun_at = now;
  }
  void on_event(const Event& event, Cycles) override {
    if (const auto* move = std::get_if<MoveStarted>(&event)) begins.push_back(move->start_tick);
  }
  TraceRow before, after;  // the triggers before the fault
  std::optional<Cycles> begun_at;
  std::vector<Ticks> begins;
  std::vector<std::tuple<std::int64_t, PerAxis<std::int64_t>, PerAxis<Pulses>>> digest;
};

Seen run(const Scenario& scenario) {
  Seen seen;
  const SimulationEnd end = test::run_to_end(Simulation{scenario, make_soc(scenario), seen});
  EXPECT_EQ(end.reason, EndReason::kFinished) << end.failure;
  return seen;
}

constexpr double kCountsPerDeg = 500'000 / 360.0;

TEST(FaultConditions, APlaceIsPassedBetweenTheTriggersBeforeTheFault) {
  const Seen seen = run(with_fault("at_s = 0\nwhen = \"passes\"\nwhen_axis = 2\nwhen_deg = -3\n"));
  ASSERT_TRUE(seen.begun_at);
  EXPECT_EQ(*seen.begun_at, Cycles{seen.after.cycle + 1});
  EXPECT_GE(static_cast<double>(seen.before.motor_counts[1]), -3 * kCountsPerDeg);
  EXPECT_LT(static_cast<double>(seen.after.motor_counts[1]), -3 * kCountsPerDeg);
}

TEST(FaultConditions, ASpeedIsReachedInEitherDirection) {
  const Seen seen = run(with_fault("at_s = 0\nwhen = \"speed\"\nwhen_axis = 2\nwhen_deg_s = 40\n"));
  ASSERT_TRUE(seen.begun_at);
  const double step_deg = (seen.after.telemetry.reference[1] - seen.before.telemetry.reference[1]).value() * kDegPerRad;
  EXPECT_NEAR(std::fabs(step_deg) / kTickSeconds, 40, 0.1);
}

TEST(FaultConditions, AMoveBeginsAtTheTriggerBeforeTheFault) {
  const Seen seen = run(with_fault("at_s = 0\nwhen = \"move_begins\"\nwhen_move = 1\n"));
  ASSERT_TRUE(seen.begun_at);
  ASSERT_EQ(seen.begins.size(), 2u);
  EXPECT_NEAR(static_cast<double>(seen.after.tick - seen.begins[1].value()), 1, 1);
}

TEST(FaultConditions, NothingBeginsBeforeItsTimeAndItBeginsOnce) {
  EXPECT_FALSE(run(with_fault("at_s = 0.59\nwhen = \"passes\"\nwhen_axis = 1\nwhen_deg = 2\n")).begun_at);
  EXPECT_FALSE(run(with_fault("at_s = 0\nwhen = \"passes\"\nwhen_axis = 1\nwhen_deg = 50\n")).begun_at);
  EXPECT_EQ(run(with_fault("at_s = 0.05\n")).begun_at, Cycles{2'500'000});
  // In the second move, on the way back.
  const Seen seen = run(with_fault("at_s = 0.25\nwhen = \"passes\"\nwhen_axis = 1\nwhen_deg = 2\n"));
  ASSERT_TRUE(seen.begun_at);
  EXPECT_GE(*seen.begun_at, Cycles{12'500'000});
  EXPECT_LT(seen.after.motor_counts[0], seen.before.motor_counts[0]);
}

TEST(FaultConditions, AreTheSameOnBothEngines) {
  Scenario scenario = with_fault("at_s = 0\nwhen = \"speed\"\nwhen_axis = 1\nwhen_deg_s = 1\n");
  scenario.duration_s = 0.025;
  const Seen model = run(scenario);
  scenario.engine = Engine::kLockstep;
  const Seen both = run(scenario);
  ASSERT_TRUE(model.begun_at);
  EXPECT_EQ(model.begun_at, both.begun_at);
  EXPECT_EQ(model.digest, both.digest);
}

}  // namespace
}  // namespace armature::cosim
