#include "cosim/kernel/simulation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "cosim/kernel/clock.hpp"
#include "cosim/scenario/scenario_loader.hpp"

namespace armature::cosim {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;

class Rows final : public SimulationListener {
 public:
  void on_row(const TraceRow& row) override { rows.push_back(row); }
  void on_move_started(const MoveReport& report) override { moves.push_back(report); }
  void on_move_refused(const MoveRefusal&, Cycles) override { ++refused; }
  void on_fault(const Telemetry& telemetry, Cycles) override { faults.push_back(telemetry.fault); }
  bool stop_requested() override { return stop_after > 0 && std::ssize(rows) >= stop_after; }

  std::vector<TraceRow> rows;
  std::vector<MoveReport> moves;
  std::vector<FaultCause> faults;
  int refused = 0;
  std::int64_t stop_after = 0;
};

// 20 ms with one small move of every axis at 2 ms.
Scenario short_move() {
  const std::filesystem::path scenarios = ARMATURE_SOURCE_DIR "/scenarios";
  Scenario scenario = load_scenario(scenarios / "fig9_joint_move", {.scenarios_dir = scenarios, .overrides = {}});
  scenario.duration_s = 0.02;
  scenario.moves.front().at_s = 0.002;
  scenario.moves.front().target_deg = {0.02, -0.02, 0.01, 0.01, -0.01, 0.02};
  return scenario;
}

SimulationEnd run(const Scenario& scenario, Rows& rows) {
  return Simulation{scenario, rows}.run();
}

TEST(Simulation, GivesOneRowPerTriggerAndTriggersExactlyOneTickApart) {
  Rows rows;
  const SimulationEnd end = run(short_move(), rows);
  EXPECT_EQ(end.reason, EndReason::kFinished) << end.failure;
  EXPECT_EQ(end.cycles, Cycles{1'000'000});
  ASSERT_GE(rows.rows.size(), 398u);
  for (std::size_t i = 1; i < rows.rows.size(); ++i) {
    ASSERT_EQ(rows.rows[i].tick, static_cast<std::int64_t>(i));
    ASSERT_EQ(rows.rows[i].cycle - rows.rows[i - 1].cycle, kTickCycles);
  }
}

TEST(Simulation, EmitsACountOneTickAfterItWasComputed) {
  Rows rows;
  run(short_move(), rows);
  const auto differs = [&](auto value) {
    for (const TraceRow& row : rows.rows) {
      if (value(row) != 0) return row.tick;
    }
    return std::int64_t{-1};
  };
  const auto commanded = differs([](const TraceRow& row) { return row.telemetry.commanded[0].value(); });
  const auto emitted = differs([](const TraceRow& row) { return row.pin_pulses[0]; });
  EXPECT_GT(commanded, 0);
  EXPECT_EQ(emitted, commanded + 1);
}

TEST(Simulation, StopsWhenAsked) {
  Rows rows;
  rows.stop_after = 10;
  EXPECT_EQ(run(short_move(), rows).reason, EndReason::kInterrupted);
  EXPECT_EQ(rows.rows.size(), 10u);
}

TEST(Simulation, StallsOfTheBusDoNotChangeTheMotion) {
  Scenario scenario = short_move();
  Rows calm, stalled;
  run(scenario, calm);
  scenario.bus.stall_probability = 0.4;
  const SimulationEnd end = run(scenario, stalled);
  ASSERT_EQ(end.reason, EndReason::kFinished) << end.failure;
  ASSERT_EQ(calm.rows.size(), stalled.rows.size());
  for (std::size_t i = 0; i < calm.rows.size(); ++i) {
    ASSERT_EQ(calm.rows[i].pin_pulses, stalled.rows[i].pin_pulses) << "tick " << i;
  }
}

TEST(Simulation, AnAccessThatTakesTooLongEndsTheRunWithAddressCoreAndCycle) {
  Scenario scenario = short_move();
  scenario.bus.timeout_cycles = 3;
  Rows rows;
  const SimulationEnd end = run(scenario, rows);
  EXPECT_EQ(end.reason, EndReason::kFailed);
  EXPECT_THAT(end.failure, MatchesRegex("bus: (read|write) at 0x4[0-9A-F]+ by core 0: .*time-out .cycle [0-9]+."));
}

TEST(Simulation, APulseThatIsTooShortForTheDriveEndsTheRun) {
  Scenario scenario = short_move();
  for (AxisSpec& axis : scenario.robot.axes) axis.drive.min_step_high_ns = 1e6;
  Rows rows;
  const SimulationEnd end = run(scenario, rows);
  EXPECT_EQ(end.reason, EndReason::kFailed);
  EXPECT_THAT(end.failure, HasSubstr("axis"));
  EXPECT_THAT(end.failure, HasSubstr("the drive needs 50000 cycles"));
}

TEST(Simulation, TheSameScenarioGivesTheSameRowsTwice) {
  Rows first, second;
  run(short_move(), first);
  run(short_move(), second);
  ASSERT_EQ(first.rows.size(), second.rows.size());
  for (std::size_t i = 0; i < first.rows.size(); ++i) {
    ASSERT_EQ(first.rows[i].cycle, second.rows[i].cycle);
    ASSERT_EQ(first.rows[i].motor_deg, second.rows[i].motor_deg);
    ASSERT_EQ(first.rows[i].telemetry.encoder, second.rows[i].telemetry.encoder);
  }
}

TEST(Simulation, AnEmergencyStopAtTheStartKeepsTheArmStill) {
  Scenario scenario = short_move();
  FaultSpec estop;
  estop.kind = FaultKind::kEstop;
  estop.duration_s = 1.0;
  scenario.faults = {estop};
  Rows rows;
  const SimulationEnd end = run(scenario, rows);
  EXPECT_EQ(end.reason, EndReason::kFinished) << end.failure;
  EXPECT_EQ(rows.faults, (std::vector{FaultCause::kEmergencyStop}));
  EXPECT_EQ(rows.refused, 1);
  EXPECT_EQ(rows.rows.back().pin_pulses, (PerAxis<std::int64_t>{}));
}

}  // namespace
}  // namespace armature::cosim
