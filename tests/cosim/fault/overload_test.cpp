// The overload alarm of a drive, in runs of the whole system.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include "cosim/run/run.hpp"
#include "tests/cosim/support/whole_run.hpp"

namespace armature::cosim {
namespace {

// Axis 2 is blocked during its move. Its drive has some milliseconds for three times the rated torque.
Scenario blocked_move(double overload_300_s) {
  Scenario scenario = test::scenario_with(R"(
[[move]]
at_s = 0.002
type = "joint"
target_deg = [0, 40, 0, 0, 0, 0]
[[fault]]
at_s = 0.05
kind = "axis_blocked"
axis = 2
duration_s = 1
)",
                                          "vo2021_6r_dynamic");
  scenario.duration_s = 0.35;
  scenario.engine = Engine::kModel;
  for (AxisSpec& axis : scenario.robot.axes) {
    axis.dynamics->overload_300_s = overload_300_s;
    axis.dynamics->overload_200_s = 3 * overload_300_s;
  }
  return scenario;
}

class OverloadRows final : public RunListener {
 public:
  void on_row(const TraceRow& row, const IntegerDigest&) override {
    rows.push_back({row.cycle, row.telemetry.encoder, row.motor_to});
  }
  std::vector<std::tuple<std::int64_t, PerAxis<Counts>, PerAxis<std::int64_t>>> rows;
};

// An axis that is blocked falls behind at once, and its drive is hot only later.
TEST(Overload, StopsTheArmWhenNothingElseHasFoundTheBlockedAxis) {
  OverloadRows rows;
  const RunSummary slow = test::summary_of(blocked_move(2.8), {&rows});
  EXPECT_EQ(slow.outcome(), "fault:following_error");
  const RunSummary quick = test::summary_of(blocked_move(0.01), {&rows});
  ASSERT_FALSE(quick.facts.faults.empty());
  EXPECT_EQ(quick.facts.faults[0].cause, FaultCause::kDriveAlarm);
  EXPECT_LT(quick.facts.faults[0].where.at, slow.facts.faults[0].where.at);
}

TEST(Overload, IsTheSameOnAllEngines) {
  Scenario scenario = blocked_move(0.01);
  scenario.duration_s = 0.1;
  OverloadRows of_model, of_both;
  scenario.engine = Engine::kModel;
  EXPECT_EQ(test::summary_of(scenario, {&of_model}).failure, std::nullopt);
  scenario.engine = Engine::kLockstep;
  EXPECT_EQ(test::summary_of(scenario, {&of_both}).failure, std::nullopt);
  EXPECT_EQ(of_model.rows, of_both.rows);
}

}  // namespace
}  // namespace armature::cosim
