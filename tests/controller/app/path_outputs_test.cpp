// Outputs at places of a path, through the whole controller: where the pulses were at the edge of the pin. The drives
// follow them with a lag.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/controller/support/output_edges.hpp"
#include "tests/controller/support/random.hpp"

namespace armature {
namespace {

using Eigen::Vector3d;
using test::degrees;
using test::kPostureDeg;
using test::kThere;
using From = PathOutput::From;
using Unit = PathOutput::Unit;

using PathOutputsTest = test::OutputEdgesTest;
using test::Edge;

TEST_F(PathOutputsTest, SwitchAtDistancesOfOwnAndOtherSegmentsWithoutAStop) {
  CartesianMove first = fast(60, 0, 2.0), second = fast(0, 60);
  add(first, 1, true, From::kStart, Unit::kMm, 20.0);
  add(first, 2, true, From::kEnd, Unit::kMm, -10.0);
  add(first, 3, true, From::kEnd, Unit::kMm, 25.0);       // on the second one
  add(second, 1, false, From::kStart, Unit::kMm, -15.0);  // on the first one
  add(second, 2, false, From::kEnd, Unit::kMm, 0.0);
  add(second, 4, true, From::kEnd, Unit::kMm, -12.34);
  rig.at(kThere, [&] {
    rig.submit(first);
    rig.submit(second);
  });
  watch(20'000);
  ASSERT_TRUE(rig.refusals.empty());
  ASSERT_EQ(edges.size(), 6u);
  const std::vector<std::pair<int, Vector3d>> expected{{1, at(20, 0)},  {1, at(45, 0)},     {2, at(50, 0)},
                                                       {3, at(60, 25)}, {4, at(60, 47.66)}, {2, at(60, 60)}};
  for (std::size_t i = 0; i < edges.size(); ++i) {
    EXPECT_EQ(edges[i].pin, expected[i].first) << i;
    expect_edge_at(edges[i], expected[i].second, kSpeed);
  }
  // The events name the moves, and the ticks in which the pins were written.
  ASSERT_EQ(rig.switched.size(), 6u);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    EXPECT_EQ(rig.switched[i].pin, edges[i].pin);
    EXPECT_EQ(rig.switched[i].level, edges[i].level);
    EXPECT_EQ(rig.switched[i].tick, Ticks{edges[i].trigger});
  }
  EXPECT_TRUE(rig.moves[2].continues);
}

TEST_F(PathOutputsTest, AreWithinHalfATickOfTheirPlaceWhereverItIs) {
  test::Random random{161};
  std::vector<Vector3d> places;
  double y_mm = 0.0;
  rig.at(kThere, [&] {
    for (int i = 0; i < 8; ++i) {
      CartesianMove move = fast(0, 10, 1.0);  // collinear: passed at speed
      for (int k = 0; k < 4; ++k) {
        const double mm = random.real(0.0, 10.0);
        add(move, 1 + k, i % 2 == 0, From::kStart, Unit::kMm, mm);
        places.push_back(at(0, y_mm + mm));
      }
      y_mm += 10.0;
      rig.submit(move);
    }
  });
  watch(20'000);
  ASSERT_TRUE(rig.refusals.empty());
  ASSERT_EQ(edges.size(), places.size());
  std::vector<int> seen(5, 0);
  for (const Edge& edge : edges) {
    const auto i = static_cast<std::size_t>(4 * seen[static_cast<std::size_t>(edge.pin)]++ + edge.pin - 1);
    expect_edge_at(edge, places[i], kSpeed);
  }
}

TEST_F(PathOutputsTest, TimesAreThoseOfThePlannedMotion) {
  CartesianMove move = fast(0, 80);
  add(move, 1, true, From::kEnd, Unit::kSeconds, -0.05);
  add(move, 2, true, From::kStart, Unit::kSeconds, 0.025);
  rig.submit_at(kThere, move);
  watch(20'000);
  ASSERT_EQ(edges.size(), 2u);
  // The set-point of the move's first tick is reached at the end of the tick after it.
  const std::int64_t start = rig.moves[1].start_tick.value() + 1, end = start + rig.moves[1].duration.value();
  EXPECT_EQ(edges[0].trigger, start + 500);
  EXPECT_EQ(edges[1].trigger, end - 1'000);
}

TEST_F(PathOutputsTest, KeepTheirPlaceUnderOverrideAndHold) {
  for (const Unit unit : {Unit::kMm, Unit::kSeconds}) {
    CartesianMove move = fast(0, 80);
    // At 500 mm/s the last 0.0625 s at 8000 mm/s^2 take 15.625 mm; another 0.02 s take 10 mm.
    add(move, unit == Unit::kMm ? 1 : 2, true, From::kEnd, unit, unit == Unit::kMm ? -25.625 : -0.0825);
    CartesianMove back = fast(0, -80);
    rig.submit_at(unit == Unit::kMm ? kThere : 30'000, move);
    rig.submit_at(unit == Unit::kMm ? 22'000 : 44'000, back);
  }
  rig.submit_at(kThere - 10, SetOverride{.share = 0.5});
  rig.submit_at(kThere + 4'000, Hold{});
  rig.submit_at(kThere + 6'000, Resume{});
  watch(60'000);
  ASSERT_TRUE(rig.refusals.empty());
  ASSERT_EQ(edges.size(), 2u);
  for (const Edge& edge : edges) expect_edge_at(edge, at(0, 80 - 25.625), 0.5 * kSpeed);
}

TEST_F(PathOutputsTest, OneOutsideItsChainRefusesTheChain) {
  for (const double offset : {1.0, -81.0}) {
    CartesianMove move = fast(0, 80);
    add(move, 1, true, From::kEnd, Unit::kMm, offset);
    rig.submit_at(offset > 0 ? kThere : kThere + 3'000, move);
  }
  CartesianMove late = fast(0, 80);
  add(late, 1, true, From::kEnd, Unit::kSeconds, 0.001);
  rig.submit_at(kThere + 6'000, late);
  watch(20'000);
  ASSERT_EQ(rig.refusals.size(), 3u);
  for (const MoveRefused& refusal : rig.refusals) EXPECT_EQ(refusal.reason, Refusal::kOutputOutside);
  EXPECT_TRUE(edges.empty());
}

TEST_F(PathOutputsTest, AStopLeavesOutThosePlacesThatTheArmDoesNotReach) {
  CartesianMove move = fast(0, 80);
  add(move, 1, true, From::kStart, Unit::kMm, 5.0);
  add(move, 2, true, From::kEnd, Unit::kMm, -5.0);
  rig.submit_at(kThere, move);
  rig.at(kThere + 1'900, [&] { rig.submit(Stop{}); });
  watch(20'000);
  ASSERT_EQ(edges.size(), 1u);
  EXPECT_EQ(edges[0].pin, 1);
  EXPECT_EQ(rig.switched.size(), 1u);
}

TEST_F(PathOutputsTest, SharePinsWithCommandsBetweenTheMoves) {
  CartesianMove move = fast(0, 40);
  add(move, 1, true, From::kEnd, Unit::kMm, 0.0);
  add(move, 2, true, From::kEnd, Unit::kMm, -0.001);
  rig.at(kThere, [&] {
    rig.submit(move);
    rig.submit(SetOutput{.pin = 3, .level = true});
    rig.submit(SetOutput{.pin = 1, .level = false});
  });
  watch(20'000);
  EXPECT_EQ(rig.logic.tool_outputs(), 0b110u);
  ASSERT_EQ(rig.switched.size(), 2u);
  ASSERT_EQ(rig.io.size(), 2u);
}

TEST_F(PathOutputsTest, ADwellLastsExactlyItsTicksAlsoUnderAnOverride) {
  rig.at(kThere, [&] {
    rig.submit(SetOverride{.share = 0.5});
    rig.submit(fast(0, 20));
    rig.submit(Dwell{.duration = Ticks{1'234}});
    rig.submit(fast(0, 20));
    rig.submit(Dwell{.duration = Ticks{1}});
    rig.submit(JointMove{.target = degrees(kPostureDeg), .accel = 0.25});
  });
  watch(40'000);
  ASSERT_TRUE(rig.refusals.empty());
  ASSERT_EQ(rig.moves.size(), 6u);
  ASSERT_EQ(rig.finished.size(), 6u);
  EXPECT_EQ(rig.moves[2].kind, MoveKind::kDwell);
  EXPECT_EQ(rig.moves[2].start_tick, rig.finished[1].tick + Ticks{1});
  EXPECT_EQ(rig.finished[2].taken, Ticks{1'234});
  EXPECT_EQ(rig.moves[3].start_tick, rig.moves[2].start_tick + Ticks{1'234});
  EXPECT_EQ(rig.finished[4].taken, Ticks{1});
  EXPECT_EQ(rig.moves[5].start_tick, rig.moves[4].start_tick + Ticks{1});
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    EXPECT_LE(rig.moves[5].accel_rad_s2[axis], 0.25 * rig.robot.axes[axis].max_accel_rad_s2 * (1 + 1e-9));
  }
}

TEST_F(PathOutputsTest, AHoldInterruptsADwell) {
  rig.at(kThere, [&] {
    rig.submit(Dwell{.duration = Ticks{1'000}});
    rig.submit(fast(0, 20));
  });
  rig.submit_at(kThere + 300, Hold{});
  rig.submit_at(kThere + 800, Resume{});
  watch(20'000);
  ASSERT_EQ(rig.moves.size(), 3u);
  EXPECT_EQ(rig.moves[2].start_tick - rig.moves[1].start_tick, Ticks{1'500});
}

}  // namespace
}  // namespace armature
