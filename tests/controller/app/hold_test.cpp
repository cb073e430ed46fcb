// Hold, resume, override and stop through the whole controller, with joint moves.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "controller/base/timebase.hpp"
#include "tests/controller/support/controller_rig.hpp"
#include "tests/controller/support/path_rig.hpp"
#include "tests/controller/support/random.hpp"

namespace armature {
namespace {

using test::ControllerRig;
using test::kFigure9Deg;

std::int64_t ticks_in(const ControllerRig& rig, MotionState state) {
  return std::count_if(rig.rows.begin(), rig.rows.end(), [&](const Telemetry& row) { return row.state == state; });
}

// Of all set-points of the run, at 100 %.
void expect_joint_limits(const ControllerRig& rig) {
  for (std::size_t k = 2; k < rig.rows.size(); ++k) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const AxisModel& model = rig.robot.axes[axis];
      const double step = (rig.rows[k].reference[axis] - rig.rows[k - 1].reference[axis]).value();
      const double before = (rig.rows[k - 1].reference[axis] - rig.rows[k - 2].reference[axis]).value();
      ASSERT_LE(std::fabs(step) / kTickSeconds, model.max_speed_rad_s * (1.0 + 2e-6)) << "tick " << k;
      ASSERT_LE(std::fabs(step - before) / (kTickSeconds * kTickSeconds), model.max_accel_rad_s2 * (1.0 + 2e-6))
          << "axis " << axis + 1 << ", tick " << k;
    }
  }
}

TEST(Hold, BrakesStandsAndGoesOnToTheTarget) {
  ControllerRig rig;
  rig.move_at(9, kFigure9Deg);
  rig.submit_at(8'000, Hold{});
  rig.submit_at(20'000, Resume{});
  rig.run(40'000);
  EXPECT_EQ(rig.row(7'990).state, MotionState::kMoving);
  EXPECT_EQ(rig.row(7'990).rate, 1.0);
  EXPECT_EQ(rig.row(8'010).state, MotionState::kHolding);
  EXPECT_GT(rig.row(8'010).rate, 0.9);
  EXPECT_EQ(rig.row(19'000).state, MotionState::kHolding);
  EXPECT_EQ(rig.row(19'000).rate, 0.0);
  EXPECT_EQ(rig.row(15'000).reference, rig.row(19'000).reference);
  EXPECT_EQ(rig.row(20'010).state, MotionState::kMoving);
  EXPECT_NEAR(static_cast<double>(ticks_in(rig, MotionState::kHolding)), 12'000.0, 2.0);
  EXPECT_EQ(rig.last().state, MotionState::kIdle);
  EXPECT_EQ(rig.last().rate, 0.0);
  EXPECT_EQ(rig.moves_finished(), 1);
  EXPECT_EQ(rig.moves.size(), 1u);
  EXPECT_TRUE(rig.refusals.empty());
  expect_joint_limits(rig);
  rig.expect_at(kFigure9Deg);
  rig.expect_pulses_conserved();
}

TEST(Hold, KeepsTheMovesThatWaitAndThoseThatArrive) {
  ControllerRig rig;
  rig.move_at(0, {5, 0, 0, 0, 0, 0});
  rig.move_at(0, {10, 0, 0, 0, 0, 0});
  rig.submit_at(100, Hold{});
  rig.submit_at(150, Hold{});  // nothing
  rig.move_at(3'000, {15, 0, 0, 0, 0, 0});
  rig.submit_at(10'000, Resume{});
  rig.run(30'000);
  EXPECT_EQ(rig.moves_finished(9'990), 0);
  ASSERT_EQ(rig.moves.size(), 3u);
  EXPECT_GT(rig.moves[1].start_tick, Ticks{10'000});
  EXPECT_EQ(rig.moves_finished(), 3);
  rig.expect_at({15, 0, 0, 0, 0, 0});
}

TEST(Hold, AMoveThatEndsWithinTheBrakingEndsAndTheNextOneWaits) {
  ControllerRig rig;
  rig.move_at(0, {30, 0, 0, 0, 0, 0});
  rig.move_at(0, {0, 0, 0, 0, 0, 0});
  constexpr std::int64_t kDuration = 9'000;  // 120 / 600 + 30 / 120 s
  rig.submit_at(kDuration - 4, Hold{});      // brakes already with all there is
  rig.submit_at(20'000, Resume{});
  rig.run(40'000);
  ASSERT_EQ(rig.moves.size(), 2u);
  EXPECT_EQ(rig.moves[0].duration, Ticks{kDuration});
  EXPECT_EQ(rig.moves_finished(15'000), 1);
  EXPECT_EQ(rig.row(15'000).state, MotionState::kHolding);
  EXPECT_EQ(rig.row(15'000).reference[0], Radians{30.0 * test::kDeg});
  EXPECT_GT(rig.moves[1].start_tick, Ticks{19'998});
  expect_joint_limits(rig);
  rig.expect_at({});
}

TEST(Hold, WhileIdleTheNextMoveWaitsForTheResume) {
  ControllerRig rig;
  rig.submit_at(10, Hold{});
  rig.move_at(1'000, {5, 0, 0, 0, 0, 0});
  rig.submit_at(2'000, Resume{});
  rig.run(8'000);
  EXPECT_EQ(rig.row(900).state, MotionState::kIdle);
  EXPECT_EQ(rig.row(1'900).state, MotionState::kHolding);
  ASSERT_EQ(rig.moves.size(), 1u);
  EXPECT_GE(rig.moves[0].start_tick, Ticks{1'999});
  rig.expect_at({5, 0, 0, 0, 0, 0});
}

TEST(Hold, AStopDropsEverythingAndEndsTheHold) {
  ControllerRig rig;
  rig.move_at(0, kFigure9Deg);
  rig.move_at(0, {});
  rig.submit_at(6'000, Hold{});
  rig.submit_at(15'000, Stop{});
  rig.move_at(16'000, {1, 1, 1, 1, 1, 1});
  rig.run(30'000);
  ASSERT_EQ(rig.refusals.size(), 1u);
  EXPECT_EQ(rig.refusals[0].reason, Refusal::kNotReady);
  // The set-points do not move between the hold's standstill and the move after the stop.
  EXPECT_EQ(rig.row(14'000).reference, rig.row(15'990).reference);
  EXPECT_EQ(rig.row(15'990).state, MotionState::kIdle);
  EXPECT_EQ(rig.moves.size(), 2u);
  EXPECT_EQ(rig.moves_finished(), 1);
  rig.expect_at({1, 1, 1, 1, 1, 1});
}

TEST(Hold, AStopWhileBrakingForAHoldGoesOnBraking) {
  ControllerRig rig;
  rig.move_at(0, kFigure9Deg);
  rig.submit_at(8'000, Hold{});
  rig.submit_at(9'000, Stop{});
  rig.run(20'000);
  ControllerRig without;
  without.move_at(0, kFigure9Deg);
  without.submit_at(8'000, Stop{});
  without.run(20'000);
  EXPECT_EQ(rig.last().reference, without.last().reference);
  EXPECT_EQ(rig.last().state, MotionState::kIdle);
}

// A soft stop brakes as a hold and ends as a stop.
TEST(Hold, ASoftStopBrakesWithinTheLimitsOfTheMove) {
  const auto run = [](ControllerRig& rig, auto command) {
    JointMove move{.target = test::degrees(kFigure9Deg), .profile = ProfileKind::kSCurve};
    rig.submit_at(0, move);
    rig.submit_at(0, JointMove{});
    rig.submit_at(3'000, command);
    rig.run(20'000);
  };
  ControllerRig soft{test::irb120()}, quick{test::irb120()}, hold{test::irb120()};
  run(soft, Stop{.kind = Stop::Kind::kSoft});
  run(quick, Stop{});
  run(hold, Hold{});
  const auto moving = [](const ControllerRig& rig) { return rig.last().reference != rig.row(3'000).reference; };
  EXPECT_TRUE(moving(soft) && moving(quick) && moving(hold));
  EXPECT_EQ(soft.last().reference, hold.last().reference);
  EXPECT_EQ(soft.last().state, MotionState::kIdle);
  EXPECT_EQ(soft.refusals.size(), 1u);
  EXPECT_GT(ticks_in(soft, MotionState::kStopping), ticks_in(quick, MotionState::kStopping));
}

TEST(Hold, AQuickStopReplacesASoftOneThatBrakes) {
  const auto braking = [](bool both) {
    ControllerRig rig{test::irb120()};
    rig.submit_at(0, JointMove{.target = test::degrees(kFigure9Deg), .profile = ProfileKind::kSCurve});
    rig.submit_at(3'000, Stop{.kind = Stop::Kind::kSoft});
    if (both) rig.submit_at(3'050, Stop{});
    rig.run(20'000);
    EXPECT_EQ(rig.last().state, MotionState::kIdle);
    return ticks_in(rig, MotionState::kStopping);
  };
  EXPECT_LT(braking(true), braking(false));
}

TEST(Hold, AFaultEndsIt) {
  ControllerRig rig;
  rig.move_at(0, kFigure9Deg);
  rig.submit_at(6'000, Hold{});
  rig.at(9'000, [&] { rig.logic.pins.drive_alarm = 1; });
  rig.at(9'100, [&] { rig.logic.pins.drive_alarm = 0; });
  rig.submit_at(12'000, ClearFault{});
  rig.move_at(12'100, {1, 1, 1, 1, 1, 1});
  rig.run(30'000);
  EXPECT_EQ(rig.row(9'500).state, MotionState::kFault);
  EXPECT_EQ(rig.row(9'500).rate, 0.0);
  rig.expect_at({1, 1, 1, 1, 1, 1});
}

TEST(Hold, OneThatIsAskedForInFaultHoldsTheFirstMoveAfterIt) {
  ControllerRig rig;
  rig.at(100, [&] { rig.logic.pins.drive_alarm = 1; });
  rig.at(200, [&] { rig.logic.pins.drive_alarm = 0; });
  rig.submit_at(300, Hold{});
  rig.submit_at(1'000, ClearFault{});
  rig.move_at(1'100, {1, 1, 1, 1, 1, 1});
  rig.submit_at(3'000, Resume{});
  rig.run(8'000);
  EXPECT_EQ(rig.row(2'900).state, MotionState::kHolding);
  EXPECT_EQ(rig.row(2'900).reference, rig.row(1'050).reference);
  rig.expect_at({1, 1, 1, 1, 1, 1});
}

TEST(Override, TakesAsMuchLongerAsItsShare) {
  ControllerRig rig;
  rig.submit_at(0, SetOverride{0.5});
  rig.move_at(1, {10, 0, 0, 0, 0, 0});
  rig.run(20'000);
  ASSERT_EQ(rig.moves.size(), 1u);
  EXPECT_EQ(ticks_in(rig, MotionState::kMoving), 2 * rig.moves[0].duration.value());
  rig.expect_at({10, 0, 0, 0, 0, 0});
}

TEST(Override, AppliesToAllMovesUntilTheNextOneAndSurvivesAStop) {
  ControllerRig rig;
  rig.submit_at(0, SetOverride{0.25});
  rig.move_at(1, {5, 0, 0, 0, 0, 0});
  rig.move_at(1, {10, 0, 0, 0, 0, 0});
  rig.submit_at(12'000, Stop{});
  rig.move_at(20'000, {0, 0, 0, 0, 0, 0});
  rig.run(60'000);
  std::set<double> rates;
  for (const Telemetry& row : rig.rows) {
    if (row.state == MotionState::kMoving) rates.insert(row.rate);
  }
  EXPECT_EQ(rates, std::set<double>{0.25});
  rig.expect_at({});
}

TEST(Override, OutOfRangeIsRefusedAndChangesNothing) {
  ControllerRig rig;
  for (const double share : {0.0, 0.001, 1.5, -1.0}) rig.submit_at(0, SetOverride{share});
  rig.move_at(1, {10, 0, 0, 0, 0, 0});
  rig.run(20'000);
  ASSERT_EQ(rig.refusals.size(), 4u);
  for (const MoveRefused& refusal : rig.refusals) EXPECT_EQ(refusal.reason, Refusal::kInvalidTarget);
  EXPECT_EQ(ticks_in(rig, MotionState::kMoving), rig.moves.at(0).duration.value());
}

TEST(Override, ToOnePercentAndBackWithinAMove) {
  ControllerRig rig;
  rig.move_at(0, kFigure9Deg);
  rig.submit_at(5'000, SetOverride{0.01});
  rig.submit_at(15'000, SetOverride{1.0});
  rig.run(40'000);
  EXPECT_EQ(rig.row(14'000).rate, 0.01);
  EXPECT_EQ(rig.moves_finished(), 1);
  expect_joint_limits(rig);
  rig.expect_at(kFigure9Deg);
  rig.expect_pulses_conserved();
}

// Everything at once, at random times: no limit is exceeded, no pulse lost, no move forgotten.
TEST(Hold, AnyMixOfHoldsOverridesAndStopsKeepsTheLimitsAndForgetsNoMove) {
  constexpr std::uint64_t kSeed = 41;
  test::Random random{kSeed};
  ControllerRig rig;
  constexpr std::int64_t kEnd = 120'000;
  std::size_t moves = 0;
  for (std::int64_t at = 5; at < kEnd; at += random.integer(1, 2'500)) {
    switch (random.integer(0, 14)) {
      case 0:
        rig.submit_at(at, Hold{});
        break;
      case 1:
      case 2:
        rig.submit_at(at, Resume{});
        break;
      case 3:
        rig.submit_at(at, SetOverride{random.real(0.05, 1.0)});
        break;
      case 4:
        rig.submit_at(at, SetOverride{1.0});
        break;
      case 5:
        rig.submit_at(at, Stop{});
        break;
      default:
        PerAxis<double> target_deg;
        for (double& target : target_deg) target = random.real(-20.0, 20.0);
        rig.move_at(at, target_deg, random.real(0.3, 1.0));
        ++moves;
    }
  }
  rig.submit_at(kEnd, SetOverride{1.0});
  rig.submit_at(kEnd, Resume{});
  rig.run(kEnd + 120'000);
  EXPECT_EQ(rig.moves.size() + rig.refusals.size(), moves) << "seed " << kSeed;
  EXPECT_GT(rig.moves_finished(), 5) << "seed " << kSeed;
  EXPECT_EQ(rig.last().state, MotionState::kIdle) << "seed " << kSeed;
  EXPECT_TRUE(rig.faults.empty()) << "seed " << kSeed;
  expect_joint_limits(rig);
  rig.expect_pulses_conserved();
}

}  // namespace
}  // namespace armature
