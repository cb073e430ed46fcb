// PathErrorMeter on rows made by hand: every distance is one that a reader can check in his head.
#include "cosim/report/measure/path_error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "cosim/report/measure/path_distance.hpp"
#include "tests/controller/support/random.hpp"
#include "tests/cosim/support/position_paths.hpp"

namespace armature::cosim {
namespace {

using Eigen::Vector3d;
using test::line_path;

RobotSpec robot() {
  RobotSpec spec;
  for (AxisSpec& axis : spec.axes) axis.drive.natural_hz = 1000;  // a memory of some 55 ticks
  return spec;
}

struct PathErrorTest : testing::Test {
  // A tick with the tool at these places; the joints move in it when `moves`.
  void tick(const Vector3d& reference, const Vector3d& encoder, bool moves = true) {
    if (moves) row.telemetry.reference[0] += Radians{1e-6};
    row.tool_point = ToolPoint{reference, encoder};
    meter.add(row);
    ++row.tick;
    row.cycle += 2500;
  }
  void rest(const Vector3d& place, std::int64_t ticks) {
    for (std::int64_t i = 0; i < ticks; ++i) tick(place, place, false);
  }
  void start(const PositionPath& path, bool continues = false) {
    MoveStarted move;
    move.tag = tag++;
    move.kind = path.shape == PositionPath::Shape::kArc ? MoveKind::kArc : MoveKind::kLine;
    move.path = path;
    move.continues = continues;
    meter.add(move);
  }
  void start_joint_move() { meter.add(MoveStarted{.tag = tag++}); }

  std::uint32_t tag = 0;

  std::int64_t memory = memory_ticks(robot());
  PathErrorMeter meter{memory};
  TraceRow row;
  PositionPath along_x = line_path({0, 0, 0}, {10, 0, 0});
  PositionPath along_y = line_path({10, 0, 0}, {10, 10, 0});
};

TEST_F(PathErrorTest, MemoryCoversTheDecayOfTheSlowestDrive) {
  // Critically damped: (1 + wn t) exp(-wn t).
  const double wn_t = 2 * std::numbers::pi * 1000 * static_cast<double>(memory) * 50e-6;
  EXPECT_LT((1 + wn_t) * std::exp(-wn_t), 2e-6);
  EXPECT_LT(memory, 65);
  RobotSpec slow = robot();
  slow.axes[2].drive.natural_hz = 100;
  EXPECT_GT(memory_ticks(slow), 9 * memory);
  slow = robot();
  slow.axes[2].drive.damping = 0.1;
  EXPECT_GT(memory_ticks(slow), 9 * memory);
  slow.axes[2].drive.damping = 10;  // slower pole at 0.0501 wn
  EXPECT_GT(memory_ticks(slow), 18 * memory);
  slow.axis_count = 2;
  EXPECT_EQ(memory_ticks(slow), memory);
}

TEST_F(PathErrorTest, NothingIsJudgedWithoutAPath) {
  tick({0, 0, 0}, {5, 5, 5});
  start_joint_move();
  tick({1, 1, 1}, {5, 5, 5});
  EXPECT_FALSE(meter.of_set_points());
  EXPECT_FALSE(meter.of_encoders());
}

TEST_F(PathErrorTest, TheLargestOfEachSideIsKeptWithItsPlace) {
  rest({0, 0, 0}, 5);
  start(along_x);
  tick({1, 0.25, 0}, {0, 0, 0});
  tick({2, 0, 0.5}, {1, 0, 3});
  tick({3, 0, 0.125}, {2, 1, 0});
  ASSERT_TRUE(meter.of_set_points());
  EXPECT_DOUBLE_EQ(meter.of_set_points()->mm, 0.5);
  EXPECT_EQ(meter.of_set_points()->where.tick, 6);
  EXPECT_EQ(meter.of_set_points()->where.at, Cycles{6 * 2500});
  EXPECT_EQ(meter.of_set_points()->move, 0u);
  EXPECT_DOUBLE_EQ(meter.of_encoders()->mm, 3);
  EXPECT_EQ(meter.of_encoders()->where.tick, 6);
  EXPECT_DOUBLE_EQ(meter.latest().set_point_mm.value(), 0.125);
  EXPECT_DOUBLE_EQ(meter.latest().encoder_mm.value(), 1);
  start_joint_move();
  tick({9, 0, 0}, {9, 0, 0});
  EXPECT_FALSE(meter.latest().set_point_mm);
  EXPECT_FALSE(meter.latest().encoder_mm);
}

TEST_F(PathErrorTest, OfASplineIsThatFromTheCurveThroughItsPoints) {
  // Points on a straight line, so that the curve is the line.
  MoveStarted move;
  move.tag = tag++;
  move.kind = MoveKind::kSpline;
  move.path.shape = PositionPath::Shape::kSpline;
  move.path.start_mm = {0, 0, 0};
  move.path.end_mm = {30, 0, 0};
  move.path.length_mm = 30;
  move.through.count = 2;
  move.through.mm[0] = {10, 0, 0};
  move.through.mm[1] = {15, 0, 0};
  meter.add(move);
  tick({12, 0.25, 0}, {11, 0, 3});
  EXPECT_NEAR(meter.of_set_points()->mm, 0.25, 1e-9);
  EXPECT_NEAR(meter.of_encoders()->mm, 3, 1e-9);
}

TEST_F(PathErrorTest, LaggingBehindOnThePathIsNoError) {
  start(along_x);
  tick({8, 0, 0}, {2, 0, 0});
  EXPECT_EQ(meter.of_encoders()->mm, 0);
}

TEST_F(PathErrorTest, TheNearestPathOfABlendedChainCounts) {
  start(along_x);
  tick({9, 0, 0}, {8, 0, 0});
  start(along_y, true);
  tick({9.75, 0.5, 0}, {9.5, 0.125, 0});
  EXPECT_DOUBLE_EQ(meter.of_set_points()->mm, 0.25);  // to the second
  EXPECT_EQ(meter.of_set_points()->move, 1u);
  EXPECT_DOUBLE_EQ(meter.of_encoders()->mm, 0.125);  // to the first
  EXPECT_EQ(meter.of_encoders()->move, 0u);
}

TEST_F(PathErrorTest, APathThatHasNotBegunDoesNotCount) {
  start(along_x);
  tick({10, 5, 0}, {10, 0, 0});
  EXPECT_DOUBLE_EQ(meter.of_set_points()->mm, 5);
}

TEST_F(PathErrorTest, EncodersMayStillBeOnTheMoveBefore) {
  start(along_x);
  tick({10, 0, 0}, {8, 0, 0});
  start(along_y);  // after an exact stop
  tick({10, 1, 0}, {9, 0, 0});
  EXPECT_EQ(meter.of_encoders()->mm, 0);
  EXPECT_EQ(meter.of_set_points()->mm, 0);
  tick({9, 0, 0}, {10, 0, 0});  // but set-points may not
  EXPECT_DOUBLE_EQ(meter.of_set_points()->mm, 1);
  for (std::int64_t i = 0; i < memory; ++i) tick({10, 2, 0}, {10, 1, 0});
  tick({10, 3, 0}, {7, 0, 0});  // forgotten by the drives
  EXPECT_DOUBLE_EQ(meter.of_encoders()->mm, 3);
}

TEST_F(PathErrorTest, EncodersCountWhileTheyFollowAfterTheEnd) {
  start(along_x);
  tick({10, 0, 0}, {9, 0, 0});
  tick({10, 0, 0}, {10, 0, 0.5}, false);
  EXPECT_DOUBLE_EQ(meter.of_encoders()->mm, 0.5);
}

TEST_F(PathErrorTest, EncodersDoNotCountUntilTheyHaveForgottenAJointMove) {
  rest({0, -5, 0}, 1);
  start_joint_move();
  tick({0, 0, 0}, {0, -5, 0});
  start(along_x);
  for (std::int64_t i = 0; i < memory; ++i) tick({1, 0, 0}, {0, -4, 0});
  EXPECT_FALSE(meter.of_encoders());
  EXPECT_EQ(meter.of_set_points()->mm, 0);
  tick({2, 0, 0}, {1, -3, 0});
  EXPECT_DOUBLE_EQ(meter.of_encoders()->mm, 3);
}

TEST_F(PathErrorTest, AJointMoveAndAFaultEndThePath) {
  start(along_x);
  tick({1, 0, 0}, {1, 0, 0});
  start_joint_move();
  tick({5, 5, 5}, {5, 5, 5});
  start(along_x);
  rest({1, 0, 0}, 2 * memory);
  row.telemetry.state = MotionState::kFault;
  tick({5, 5, 5}, {5, 5, 5});
  row.telemetry.state = MotionState::kIdle;
  rest({5, 5, 5}, 2 * memory);
  EXPECT_EQ(meter.of_set_points()->mm, 0);
  EXPECT_EQ(meter.of_encoders()->mm, 0);
}

TEST_F(PathErrorTest, RowsWithoutAToolPointAreNotJudged) {
  start(along_x);
  meter.add(row);
  EXPECT_FALSE(meter.of_set_points());
  EXPECT_FALSE(meter.of_encoders());
}

TEST_F(PathErrorTest, OfALongChainIsTheLeastOfAllItsPaths) {
  armature::test::Random random{167};
  const auto near = [&](const Vector3d& place, double mm) -> Vector3d {
    return place + Vector3d{random.real(-mm, mm), random.real(-mm, mm), random.real(-mm, mm)};
  };
  std::vector<PositionPath> chain;
  Vector3d from = Vector3d::Zero();
  for (int i = 0; i < 60; ++i) {
    const Vector3d to = near(from, i % 7 == 0 ? 20 : 0.5);
    const auto bow = arc(from, near((from + to) / 2, 0.2), to);
    chain.push_back(i % 3 == 0 && bow ? *bow : line_path(from, to));
    start(chain.back(), i > 0);
    from = to;
  }
  const auto least_mm = [&](const Vector3d& point) {
    double least = distance_mm(chain.front(), point);
    for (const PositionPath& path : chain) least = std::min(least, distance_mm(path, point));
    return least;
  };
  for (int i = 0; i < 500; ++i) {
    const PositionPath& by = chain[static_cast<std::size_t>(random.real(0, 59.9))];
    const Vector3d set_point = near(by.start_mm, i % 5 == 0 ? 30 : 0.1), encoder = near(by.end_mm, 2);
    tick(set_point, encoder);
    ASSERT_EQ(meter.latest().set_point_mm, least_mm(set_point)) << i;
    ASSERT_EQ(meter.latest().encoder_mm, least_mm(encoder)) << i;
  }
}

}  // namespace
}  // namespace armature::cosim
