// The whole loop on the logic of Vo 2021, where five encoders are not seen.
#include <gtest/gtest.h>

#include <cstdlib>
#include <vector>

#include "cosim/kernel/scenario_soc.hpp"
#include "cosim/kernel/simulation.hpp"
#include "cosim/scenario/files/scenario_loader.hpp"
#include "tests/support/silent_listener.hpp"

namespace armature::cosim {
namespace {

class PaperRows final : public test::SilentListener {
 public:
  void on_row(TraceRow& row) override { rows.push_back(row); }
  void on_event(const Event& event, Cycles) override {
    if (std::holds_alternative<MoveStarted>(event)) ++moves;
    if (std::holds_alternative<MoveRefused>(event)) ++refused;
    if (const auto* fault = std::get_if<Faulted>(&event)) faults.push_back(fault->cause);
  }

  std::vector<TraceRow> rows;
  std::vector<FaultCause> faults;
  int moves = 0;
  int refused = 0;
};

CommandSpec joint_move(double at_s, double degrees, std::uint32_t index) {
  CommandSpec move;
  move.at_s = at_s;
  move.kind = JointSpec{.target_deg = make_per_axis([=](std::size_t) { return degrees; })};
  move.index = index;
  return move;
}

Scenario scenario_of_paper() {
  const std::filesystem::path scenarios = ARMATURE_SOURCE_DIR "/scenarios";
  Scenario scenario = load_scenario(
      scenarios / "fig9_joint_move",
      {.search_path = scenarios, .overrides = {}, .logic = {.variant = Variant::kPaper, .engine = std::nullopt}});
  scenario.moves.clear();
  return scenario;
}

TEST(PaperSimulation, AfterAStopAxesThatAreNotSeenStandWhereTheirPulsesBroughtThem) {
  Scenario scenario = scenario_of_paper();
  scenario.duration_s = 0.09;
  scenario.moves = {joint_move(0.002, 0.4, 0)};  // 52 ms
  scenario.faults.push_back({.at_s = 0.02, .kind = Estop{.duration_s = 0.001}});
  CommandSpec clear;
  clear.at_s = 0.04;
  clear.kind = ClearFaultSpec{};
  clear.index = 1;
  scenario.moves.push_back(clear);
  scenario.moves.push_back(joint_move(0.045, 0.0, 2));

  PaperRows seen;
  const SimulationEnd end = test::run_to_end(Simulation{scenario, make_soc(scenario), seen});
  EXPECT_EQ(end.reason, EndReason::kFinished) << end.failure;
  EXPECT_EQ(seen.faults, std::vector<FaultCause>{FaultCause::kEstop});
  EXPECT_EQ(seen.refused, 0);
  EXPECT_EQ(seen.moves, 2);
  const TraceRow& stopped = seen.rows.at(700);
  const TraceRow& last = seen.rows.back();
  EXPECT_EQ(last.telemetry.state, MotionState::kIdle);
  for (std::size_t axis = 1; axis < kAxes; ++axis) {
    EXPECT_GT(stopped.pin_pulses[axis], 50) << axis + 1;
    EXPECT_EQ(last.pin_pulses[axis], 0) << axis + 1;
    EXPECT_EQ(last.telemetry.commanded[axis], Pulses{0}) << axis + 1;
    EXPECT_EQ(last.telemetry.encoder[axis], Counts{0}) << axis + 1;
  }
  // The first axis knows from its encoder what the drive made of its pulses.
  EXPECT_LE(std::abs(last.motor_counts[0]), 1);
}

TEST(PaperSimulation, OnlyTheAxisThatIsSeenHasAFollowingError) {
  for (const std::int64_t watched : {2, 3}) {
    Scenario scenario = scenario_of_paper();
    scenario.duration_s = 0.06;
    scenario.paper.encoder_axis = watched;
    scenario.moves = {joint_move(0.002, 0.4, 0)};
    for (AxisSpec& axis : scenario.robot.axes) axis.following_error_deg = 0.2;
    // The drive of axis 3 does not see any pulse.
    scenario.faults.push_back({.at_s = 0.001, .kind = PulseLoss{.axis = 3, .count = 100'000}});
    PaperRows seen;
    const SimulationEnd end = test::run_to_end(Simulation{scenario, make_soc(scenario), seen});
    EXPECT_EQ(end.reason, EndReason::kFinished) << end.failure;
    if (watched == 3) {
      EXPECT_EQ(seen.faults, std::vector<FaultCause>{FaultCause::kFollowingError});
      EXPECT_EQ(seen.rows.back().telemetry.fault_axis, 3);
    } else {
      EXPECT_TRUE(seen.faults.empty());
    }
  }
}

}  // namespace
}  // namespace armature::cosim
