#include "controller/motion/feedback.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "tests/controller/support/controller_rig.hpp"
#include "tests/controller/support/robots.hpp"

namespace armature {
namespace {

using test::ControllerRig;

constexpr std::int64_t kMoveStart = 10;
constexpr std::int64_t kFigure9Ticks = 17'400;
// The first tick whose set-point no longer changes.
constexpr std::int64_t kStandstill = kMoveStart + kFigure9Ticks;
constexpr std::int64_t k100Milliseconds = 2'000;

std::int64_t error_counts(const Telemetry& row, std::size_t axis) {
  return row.reference_pulses[axis].value() - row.encoder[axis].value();
}

std::int64_t largest_correction(const ControllerRig& rig) {
  std::int64_t largest = 0;
  for (const Telemetry& row : rig.rows) {
    for (const Pulses correction : row.correction)
      largest = std::max<std::int64_t>(largest, std::llabs(correction.value()));
  }
  return largest;
}

struct RealDrive {
  double bandwidth;  // over nominal
  double damping;
};

class FeedbackWithoutLoss : public testing::TestWithParam<RealDrive> {};

TEST_P(FeedbackWithoutLoss, LeavesADriveAloneThatIsNotExactlyNominal) {
  ControllerRig rig;
  for (auto& drive : rig.logic.drives) {
    drive.natural_rad_s *= GetParam().bandwidth;
    drive.damping = GetParam().damping;
  }
  rig.move_at(kMoveStart - 1, test::kFigure9Deg);
  rig.run(kStandstill + 2 * k100Milliseconds);
  EXPECT_EQ(largest_correction(rig), 0);
  EXPECT_TRUE(rig.faults.empty());
  rig.expect_at(test::kFigure9Deg);
}

INSTANTIATE_TEST_SUITE_P(Drives, FeedbackWithoutLoss,
                         testing::Values(RealDrive{1.0, 1.0}, RealDrive{0.8, 1.0}, RealDrive{1.2, 1.0},
                                         RealDrive{1.0, 0.8}, RealDrive{1.0, 1.2}),
                         [](const auto& drive) { return "Drive" + std::to_string(drive.index); });

struct Loss {
  std::size_t axis;
  std::int64_t at;
  double bandwidth;
};

class FeedbackWithLoss : public testing::TestWithParam<Loss> {};

TEST_P(FeedbackWithLoss, RecoversFiveHundredPulsesWithin100MillisecondsOfStandstill) {
  const auto [axis, at, bandwidth] = GetParam();
  ControllerRig rig;
  for (auto& drive : rig.logic.drives) drive.natural_rad_s *= bandwidth;
  rig.move_at(kMoveStart - 1, test::kFigure9Deg);
  rig.at(at, [&] { rig.logic.drives[GetParam().axis].lose = 500; });
  rig.run(kStandstill + 2 * k100Milliseconds);
  ASSERT_EQ(std::llabs(rig.logic.drives[axis].dropped), 500);
  const bool forward = test::kFigure9Deg[axis] > 0.0;
  for (std::int64_t tick = kStandstill; tick < static_cast<std::int64_t>(rig.rows.size()); ++tick) {
    const std::int64_t error = error_counts(rig.row(tick), axis);
    if (tick >= kStandstill + k100Milliseconds) {
      ASSERT_LE(std::llabs(error), 1) << "tick " << tick;
    }
    ASSERT_GE(forward ? error : -error, bandwidth == 1.0 ? -2 : -5) << "overshoot in tick " << tick;
  }
  for (std::size_t other = 0; other < kAxes; ++other) {
    if (other == axis) continue;
    EXPECT_EQ(rig.last().correction[other], Pulses{0}) << "axis " << other + 1;
  }
  rig.expect_pulses_conserved();
}

INSTANTIATE_TEST_SUITE_P(Losses, FeedbackWithLoss,
                         testing::Values(Loss{2, 6'000, 1.0},   // as in the scenario: axis 3, 0.3 s
                                         Loss{0, 1'000, 1.0},   // fast axis, speeding up
                                         Loss{0, 9'000, 1.0},   // cruising
                                         Loss{1, 16'000, 1.0},  // braking, negative
                                         Loss{3, 8'700, 1.0},   // top of a triangle
                                         Loss{4, 14'000, 1.0}, Loss{5, 12'000, 1.0}, Loss{2, 6'000, 0.8},
                                         Loss{2, 6'000, 1.2}),
                         [](const auto& loss) { return "Loss" + std::to_string(loss.index); });

TEST(Feedback, SwitchedOffLeavesTheLoss) {
  ControllerRig rig{test::paper_robot(), {.feedback = false}};
  rig.move_at(kMoveStart - 1, test::kFigure9Deg);
  rig.at(6'000, [&] { rig.logic.drives[2].lose = 500; });
  rig.run(kStandstill + k100Milliseconds);
  EXPECT_EQ(error_counts(rig.last(), 2), 500);
  EXPECT_EQ(largest_correction(rig), 0);
}

TEST(Feedback, RecoversALossInEachOfTwoMoves) {
  ControllerRig rig;
  rig.move_at(0, test::kFigure9Deg);
  rig.move_at(1, {});
  rig.at(6'000, [&] { rig.logic.drives[2].lose = 500; });
  rig.at(25'000, [&] { rig.logic.drives[2].lose = 300; });
  rig.run(2 * kFigure9Ticks + 2 * k100Milliseconds);
  EXPECT_EQ(rig.last().correction[2], Pulses{500 - 300});
  EXPECT_LE(std::llabs(error_counts(rig.last(), 2)), 1);
}

TEST(Feedback, KeepsItsCorrectionWhenTheAxisMovesAgain) {
  ControllerRig rig;
  rig.move_at(0, {0, 0, 10, 0, 0, 0});
  rig.at(1'000, [&] { rig.logic.drives[2].lose = 500; });
  rig.move_at(10'000, test::kFigure9Deg);
  rig.run(10'000 + kFigure9Ticks + k100Milliseconds);
  for (std::int64_t tick = 9'999; tick < static_cast<std::int64_t>(rig.rows.size()); ++tick) {
    ASSERT_EQ(rig.row(tick).correction[2], Pulses{500}) << "tick " << tick;
  }
}

TEST(Feedback, WorksWithAGearThatTurnsTheOtherWayAndACoarserEncoder) {
  RobotModel robot = test::paper_robot();
  robot.axes[2].gear_ratio = -50.0;
  robot.axes[2].counts_per_rev = 4'000;
  ControllerRig rig{robot};
  rig.move_at(kMoveStart - 1, test::kFigure9Deg);
  rig.at(6'000, [&] { rig.logic.drives[2].lose = 500; });
  rig.run(kStandstill + k100Milliseconds);
  EXPECT_LT(rig.last().encoder[2], Counts{0});
  // Within one count: 1.8e-3 deg.
  EXPECT_NEAR(rig.last().actual[2].value() / test::kDeg, 50.0, 1.81e-3);
}

TEST(Feedback, SlewsWithinTheAxisLimits) {
  const AxisModel model = test::paper_robot().axes[0];
  const AxisUnits units{model};
  Feedback feedback{model, units};
  feedback.restart(Pulses{0}, Counts{0});
  double last = 0.0, fastest = 0.0;
  for (int tick = 1; tick <= 60'000; ++tick) {
    feedback.tick_emitted(Pulses{0});
    const double now = static_cast<double>(feedback.correct(Counts{-60'000}, 0.0).value());
    fastest = std::max(fastest, now - last);
    ASSERT_LE(now, 0.5 * units.max_pulses_per_tick2() * tick * (tick + 1.0) + 0.5) << "acceleration, tick " << tick;
    ASSERT_LE(now - last, units.max_pulses_per_tick() + 1.0) << "speed, tick " << tick;
    ASSERT_LE(now, 60'000.0) << "overshoot, tick " << tick;
    last = now;
  }
  EXPECT_EQ(last, 60'000.0);
  EXPECT_GE(fastest, std::floor(units.max_pulses_per_tick()));
}

TEST(Feedback, LeavesAloneWhatAnEncoderCannotTell) {
  const AxisModel model = test::paper_robot().axes[0];
  Feedback feedback{model, AxisUnits{model}};
  feedback.restart(Pulses{0}, Counts{0});
  const auto settle_at = [&](Counts measured) {
    Pulses correction{};
    for (int tick = 0; tick < 2'000; ++tick) {
      feedback.tick_emitted(Pulses{0});
      correction = feedback.correct(measured, 0.0);
    }
    return correction;
  };
  EXPECT_EQ(settle_at(Counts{1}), Pulses{0});
  EXPECT_EQ(settle_at(Counts{-1}), Pulses{0});
  EXPECT_EQ(settle_at(Counts{-2}), Pulses{2});
  EXPECT_EQ(settle_at(Counts{-1}), Pulses{2});
}

TEST(Feedback, LeavesTheSpeedLimitToTheReference) {
  const AxisModel model = test::paper_robot().axes[0];
  const AxisUnits units{model};
  Feedback feedback{model, units};
  feedback.restart(Pulses{0}, Counts{0});
  Pulses correction{};
  for (int tick = 0; tick < 1'000; ++tick) {
    feedback.tick_emitted(Pulses{0});
    correction = feedback.correct(Counts{-5'000}, units.max_pulses_per_tick());
  }
  EXPECT_EQ(correction, Pulses{0});
  for (int tick = 0; tick < 20'000; ++tick) {
    feedback.tick_emitted(Pulses{0});
    correction = feedback.correct(Counts{-5'000}, -units.max_pulses_per_tick());
  }
  EXPECT_EQ(correction, Pulses{5'000});
}

}  // namespace
}  // namespace armature
