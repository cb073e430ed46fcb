// Streams of set-points, from the command to the pulses.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <vector>

#include "controller/base/timebase.hpp"
#include "tests/controller/support/controller_rig.hpp"
#include "tests/controller/support/dispatcher_bench.hpp"
#include "tests/controller/support/six_r_rig.hpp"

namespace armature {
namespace {

using test::ControllerRig;
using test::kDeg;
using How = StreamEnded::How;

constexpr std::int64_t kEvery = 20;  // 1 kHz
constexpr std::int64_t kDelay = 50;
constexpr std::int64_t kSent = 10;

// At rest at both ends of a turn. With 500 set-points 474 deg/s^2 at most.
double swing_deg(double share) {
  return 3.0 * (1.0 - std::cos(2.0 * std::numbers::pi * share));
}

StreamPoint stream_point(std::int64_t i, std::int64_t count, const PerAxis<double>& deg) {
  return {.first = i == 0,
          .last = i == count,
          .joints = test::degrees(deg),
          .time = Ticks{i * kEvery},
          .delay = Ticks{kDelay},
          .tag = 7u};
}

// Set-points 0 to count, each at its time, except for those that `lost` names.
void submit_swing(ControllerRig& rig, std::int64_t count, const std::function<bool(std::int64_t)>& lost = {}) {
  for (std::int64_t i = 0; i <= count; ++i) {
    if (lost && lost(i)) continue;
    const double deg = swing_deg(static_cast<double>(i) / static_cast<double>(count));
    rig.submit_at(kSent + i * kEvery, stream_point(i, count, {0, deg, 0, 0, 0, -deg}));
  }
}

double stream_degrees(const ControllerRig& rig, std::int64_t tick, std::size_t axis = 1) {
  return rig.row(tick).reference[axis].value() / kDeg;
}

TEST(Stream, IsFollowedExactlyWithItsDelayAndEndsAtItsLastSetPoint) {
  ControllerRig rig;
  submit_swing(rig, 500);
  rig.run(kSent + 500 * kEvery + 500);
  EXPECT_TRUE(rig.refusals.empty());
  ASSERT_EQ(rig.streams.size(), 1u);
  EXPECT_EQ(rig.streams[0].how, How::kComplete);
  EXPECT_EQ(rig.streams[0].tag, Tag{7u});
  for (std::size_t axis = 0; axis < kAxes; ++axis) EXPECT_LT(rig.streams[0].deviation_rad[axis], 1e-15);
  // The tick in which the arm is at the first set-point; from there all others follow in their interval.
  std::int64_t first = 0;
  while (stream_degrees(rig, first + 1) == 0.0) ++first;
  for (std::int64_t i = 0; i <= 500; ++i) {
    EXPECT_NEAR(stream_degrees(rig, first + i * kEvery), swing_deg(static_cast<double>(i) / 500.0), 1e-9) << i;
  }
  EXPECT_NEAR(static_cast<double>(first), kSent + kDelay, 2.0);
  rig.expect_at({0, 0, 0, 0, 0, 0});
  rig.expect_pulses_conserved();
}

TEST(Stream, ThatIsLateStopsWithinTheLimitsAndTheArmMovesAgain) {
  ControllerRig rig;
  submit_swing(rig, 500, [](std::int64_t i) { return i > 100; });
  rig.move_at(3 * 500 * kEvery, {1, 0, 0, 0, 0, 0});
  rig.run(4 * 500 * kEvery);
  ASSERT_EQ(rig.streams.size(), 1u);
  EXPECT_EQ(rig.streams[0].how, How::kLate);
  const double braked_deg = stream_degrees(rig, 2 * 500 * kEvery);
  EXPECT_GT(braked_deg, swing_deg(0.2));
  EXPECT_LT(braked_deg, swing_deg(0.2) + 1.3);
  const double most = 600.0 * kTickSeconds * kTickSeconds * (1 + 1e-6);
  for (std::int64_t tick = 2; tick < 500 * kEvery; ++tick) {
    const double change = stream_degrees(rig, tick) - 2 * stream_degrees(rig, tick - 1) + stream_degrees(rig, tick - 2);
    ASSERT_LE(std::fabs(change), most) << tick;
  }
  EXPECT_EQ(rig.moves_finished(), 1);
  rig.expect_at({1, 0, 0, 0, 0, 0});
}

// Core 0 reads none of them in between.
TEST(Stream, AStopReachesCore0AlsoBehindManySetPoints) {
  test::DispatcherBench bench;
  bench.at_rest(0);
  for (std::int64_t i = 0; i < 40; ++i) bench.submit(stream_point(i, 100, {}));
  bench.submit(Hold{});
  bench.submit(Stop{.kind = Stop::Kind::kSoft});
  bench.submit(Stop{});
  bench.submit(Stop{});
  std::vector<StopKind> stops;
  std::size_t points = 0;
  for (; const Request* request = bench.channel->requests.front(); bench.channel->requests.drop_front()) {
    if (request->kind == Request::Kind::kStop)
      stops.push_back(request->stop);
    else
      ++points;
  }
  EXPECT_EQ(points, Channel::kStream);
  EXPECT_EQ(stops, (std::vector{StopKind::kHold, StopKind::kSoft, StopKind::kQuick}));
}

TEST(Stream, OneMissingSetPointOfAStreamWithDelayIsBridged) {
  ControllerRig rig;
  submit_swing(rig, 500, [](std::int64_t i) { return i == 130; });
  rig.run(kSent + 500 * kEvery + 500);
  ASSERT_EQ(rig.streams.size(), 1u);
  EXPECT_EQ(rig.streams[0].how, How::kComplete);
  rig.expect_at({0, 0, 0, 0, 0, 0});
}

TEST(Stream, IsStoppedByAStopAndByAHold) {
  for (const Command& command : {Command{Stop{}}, Command{Hold{}}}) {
    ControllerRig rig;
    submit_swing(rig, 500);
    rig.submit_at(kSent + 100 * kEvery + 5, command);
    rig.run(2 * 500 * kEvery);
    EXPECT_TRUE(rig.refusals.empty());
    ASSERT_EQ(rig.streams.size(), 1u);
    EXPECT_EQ(rig.streams[0].how, How::kStopped);
    EXPECT_LT(stream_degrees(rig, 500 * kEvery), swing_deg(0.2) + 1.3);
    EXPECT_EQ(rig.last().state, MotionState::kIdle);
    rig.expect_pulses_conserved();
  }
}

TEST(Stream, IsRefusedOnceBesideAMove) {
  ControllerRig rig;
  rig.move_at(5, {10, 0, 0, 0, 0, 0});
  submit_swing(rig, 100);
  rig.run(20'000);
  ASSERT_EQ(rig.refusals.size(), 1u);
  EXPECT_EQ(rig.refusals[0].reason, Refusal::kNotReady);
  EXPECT_TRUE(rig.streams.empty());
  rig.expect_at({10, 0, 0, 0, 0, 0});
}

TEST(Stream, EndsInAFaultAndTheArmMovesAgainAfterIt) {
  ControllerRig rig;
  submit_swing(rig, 500);
  rig.at(2'000, [&] { rig.logic.pins.drive_alarm = 1; });
  rig.at(6'000, [&] { rig.logic.pins.drive_alarm = 0; });
  rig.submit_at(12'000, ClearFault{});
  rig.move_at(13'000, {1, 0, 0, 0, 0, 0});
  rig.run(30'000);
  ASSERT_EQ(rig.streams.size(), 1u);
  EXPECT_EQ(rig.streams[0].how, How::kFault);
  EXPECT_EQ(rig.moves_finished(), 1);
}

TEST(Stream, BeyondTheRangeOfAnAxisWaitsAtItsEndAndReportsTheDistance) {
  ControllerRig rig;
  for (std::int64_t i = 0; i <= 2'000; ++i) {
    const double deg = 200.0 * (0.5 - 0.5 * std::cos(std::numbers::pi * static_cast<double>(i) / 2'000.0));
    rig.submit_at(kSent + i * kEvery, stream_point(i, 2'000, {0, deg, 0, 0, 0, 0}));
  }
  rig.run(2'100 * kEvery);
  ASSERT_EQ(rig.streams.size(), 1u);
  EXPECT_EQ(rig.streams[0].how, How::kComplete);
  EXPECT_NEAR(rig.streams[0].deviation_rad[1], 30.0 * kDeg, 1e-3 * kDeg);
  for (const Telemetry& row : rig.rows) ASSERT_LE(row.reference[1].value(), 170.0 * kDeg + 1e-11);
  rig.expect_pulses_conserved();
}

TEST(Stream, OfTheToolIsConvertedToJoints) {
  ControllerRig rig{test::robot_with(test::irb120_geometry())};
  const Arm arm{rig.robot};
  rig.move_at(5, {10, 20, -30, 20, 40, 30});
  const Transform start = arm.forward(test::degrees({10, 20, -30, 20, 40, 30}));
  constexpr std::int64_t kBegin = 20'000, kCount = 500;
  for (std::int64_t i = 0; i <= kCount; ++i) {
    StreamPoint point = stream_point(i, kCount, {});
    point.kind = StreamPoint::Kind::kTool;
    point.rotation = start.rotation;
    point.position_mm =
        start.position_mm + Eigen::Vector3d{2.0 * swing_deg(0.5 * static_cast<double>(i) / kCount), 0, 0};
    rig.submit_at(kBegin + i * kEvery, point);
  }
  rig.run(kBegin + kCount * kEvery + 500);
  EXPECT_TRUE(rig.refusals.empty());
  ASSERT_EQ(rig.streams.size(), 1u);
  EXPECT_EQ(rig.streams[0].how, How::kComplete);
  const Transform end = arm.forward(rig.last().reference);
  EXPECT_LT((end.position_mm - start.position_mm - Eigen::Vector3d{12, 0, 0}).norm(), 1e-9);
  EXPECT_LT((end.rotation - start.rotation).norm(), 1e-12);
  rig.expect_pulses_conserved();
}

TEST(Stream, WithAPoseOutOfReachIsRefusedThereAndStops) {
  ControllerRig rig{test::robot_with(test::irb120_geometry())};
  const Arm arm{rig.robot};
  const Transform start = arm.forward({});
  for (std::int64_t i = 0; i <= 200; ++i) {
    StreamPoint point = stream_point(i, 200, {});
    point.kind = StreamPoint::Kind::kTool;
    point.rotation = start.rotation;
    point.position_mm = start.position_mm + Eigen::Vector3d{i < 50 ? 0.0 : 2'000.0, 0, 0};
    rig.submit_at(kSent + i * kEvery, point);
  }
  rig.run(300 * kEvery);
  ASSERT_EQ(rig.refusals.size(), 1u);
  EXPECT_EQ(rig.refusals[0].reason, Refusal::kUnreachable);
  EXPECT_EQ(rig.refusals[0].tag, Tag{7u});
  ASSERT_EQ(rig.streams.size(), 1u);
  EXPECT_EQ(rig.streams[0].how, How::kStopped);
  EXPECT_EQ(rig.last().state, MotionState::kIdle);
}

TEST(Stream, IsRefusedWithAValueThatIsNoNumberAndWithoutJerkLimits) {
  ControllerRig rig;
  StreamPoint bad = stream_point(0, 2, {0, 0, NAN, 0, 0, 0});
  rig.submit_at(10, bad);
  bad = stream_point(0, 2, {});
  bad.profile = ProfileKind::kSCurve;
  rig.submit_at(20, bad);
  bad = stream_point(0, 2, {});
  bad.delay = Ticks{};
  rig.submit_at(30, bad);
  rig.run(100);
  ASSERT_EQ(rig.refusals.size(), 3u);
  EXPECT_EQ(rig.refusals[0].reason, Refusal::kInvalidTarget);
  EXPECT_EQ(rig.refusals[0].axis, 3);
  EXPECT_EQ(rig.refusals[1].reason, Refusal::kNoJerkLimit);
  EXPECT_EQ(rig.refusals[2].reason, Refusal::kInvalidTarget);
  EXPECT_TRUE(rig.streams.empty());
}

}  // namespace
}  // namespace armature
