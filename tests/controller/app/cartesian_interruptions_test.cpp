// Stops, holds and faults while the tool moves or its moves are planned, through the whole controller.
#include "tests/controller/support/cartesian_moves.hpp"
#include "tests/controller/support/random.hpp"

namespace armature {
namespace {

using test::ControllerRig;
using test::degrees;
using test::kPostureDeg;
using test::kThere;
using CartesianInterruptions = test::CartesianMovesTest;

TEST_F(CartesianInterruptions, AStopIsHeardBetweenAnyTwoSlicesOfPlanning) {
  int slices = 0;
  std::int64_t before = 0;
  rig.at(kThere, [&] {
    before = emitted();
    rig.submit(shift(60, 0, 0, 5.0));
    rig.submit(shift(0, 60, 0, 5.0));
    rig.submit(shift(0, 0, 60, 5.0));
    rig.submit(JointMove{});
  });
  rig.on_core1_work = [&](Work work, std::int64_t times) {
    if (work != Work::kInverse) return;
    EXPECT_LE(times, PathStage::kSlice + PathPass::kMaxInverses);
    if (++slices == 4) rig.submit(Stop{});
  };
  rig.at(kThere + 1'000, [&] { EXPECT_EQ(emitted(), before); });
  rig.submit_at(kThere + 1'001, JointMove{.target = degrees({1, 2, 3, 4, 5, 6})});
  rig.run(25'000);
  EXPECT_EQ(slices, 4);
  ASSERT_EQ(rig.refusals.size(), 4u);
  for (const MoveRefused& refusal : rig.refusals) EXPECT_EQ(refusal.reason, Refusal::kNotReady);
  rig.expect_at({1, 2, 3, 4, 5, 6});
}

TEST_F(CartesianInterruptions, AHoldIsHeardWhileTheNextMoveIsPlanned) {
  rig.submit_at(kThere, shift(60, 0, 0));
  std::int64_t held_at = -1;
  int slices = 0;
  rig.at(kThere + 1'000, [&] {
    rig.on_core1_work = [&](Work, std::int64_t) {
      if (++slices == 2) {
        rig.submit(Hold{});
        held_at = rig.logic.triggers();
      }
    };
    rig.submit(shift(0, 60, 0));
  });
  rig.submit_at(kThere + 5'000, Resume{});
  rig.run(50'000);
  EXPECT_GT(slices, 3);  // planning continues in a hold
  ASSERT_GT(held_at, 0);
  EXPECT_EQ(rig.row(held_at + 2).state, MotionState::kHolding);
  EXPECT_EQ(rig.moves_finished(), 3);
}

TEST_F(CartesianInterruptions, AStopInAChainReportsTheMovesThatHaveNotBegun) {
  rig.at(kThere, [&] {
    for (const double side : {1.0, -1.0}) {
      rig.submit(shift(30 * side, 0, 0, 3.0));
      rig.submit(shift(0, 30 * side, 0, 3.0));
    }
  });
  rig.submit_at(kThere + 9'500, Stop{});  // in the second one
  rig.run(30'000);
  EXPECT_EQ(rig.moves.size(), 3u);
  EXPECT_EQ(rig.refusals.size(), 2u);
  EXPECT_EQ(rig.moves_finished(), 2);
  EXPECT_EQ(rig.last().state, MotionState::kIdle);
  EXPECT_LT(path_error_mm(), 3.0);
  rig.expect_pulses_conserved();
}

TEST_F(CartesianInterruptions, AFaultInAChainReportsTheMovesThatHaveNotBegun) {
  rig.at(kThere, [&] {
    rig.submit(shift(30, 0, 0, 3.0));
    rig.submit(shift(0, 30, 0, 3.0));
    rig.submit(shift(0, 0, 30));
  });
  rig.at(kThere + 2'000, [&] { rig.logic.pins.drive_alarm = 1; });
  rig.run(kThere + 3'000);
  EXPECT_EQ(rig.moves.size(), 2u);
  EXPECT_EQ(rig.refusals.size(), 2u);
}

TEST_F(CartesianInterruptions, HoldAndResumeInTheCornerOfAChainKeepItsGeometry) {
  const auto drive = [&](ControllerRig& on, bool hold) {
    on.at(kThere, [&] {
      on.submit(shift(30, 0, 0, 8.0));
      on.submit(shift(0, 30, 0));
    });
    if (hold) {
      for (const std::int64_t at : {1'000, 5'600, 5'900, 8'000}) {
        on.submit_at(kThere + at, Hold{});
        on.submit_at(kThere + at + 150, Resume{});
      }
    }
    on.run(40'000);
  };
  ControllerRig without{test::irb120(), config()};
  without.move_at(0, kPostureDeg);
  drive(rig, true);
  drive(without, false);
  EXPECT_GT(std::count_if(rig.rows.begin(), rig.rows.end(),
                          [](const Telemetry& row) { return row.state == MotionState::kHolding; }),
            400);
  EXPECT_EQ(rig.last().reference, without.last().reference);
  // Every tool position of the interrupted run is on the curve of the other one: within the sagitta between its ticks.
  std::size_t nearest = 0;
  const auto at = [&](std::size_t i) { return tool(without.rows[i].reference).position_mm; };
  for (std::size_t k = kThere; k < rig.rows.size(); k += 37) {
    const Eigen::Vector3d p = tool(rig.rows[k].reference).position_mm;
    while (nearest + 1 < without.rows.size() && (at(nearest + 1) - p).norm() <= (at(nearest) - p).norm()) ++nearest;
    double off_mm = (at(nearest) - p).norm();
    for (const std::size_t from : {nearest - 1, nearest}) {
      if (from + 1 >= without.rows.size()) continue;
      const Eigen::Vector3d way = at(from + 1) - at(from);
      const double length2 = way.squaredNorm();
      const double s = length2 == 0.0 ? 0.0 : std::clamp(way.dot(p - at(from)) / length2, 0.0, 1.0);
      off_mm = std::min(off_mm, (p - at(from) - s * way).norm());
    }
    ASSERT_LT(off_mm, 1e-6) << "tick " << k;
  }
}

TEST_F(CartesianInterruptions, EveryMoveIsStartedOrReportedWhateverHappens) {
  constexpr std::uint64_t kSeed = 71;
  test::Random random{kSeed};
  constexpr std::int64_t kEnd = 90'000;
  constexpr std::uint32_t kNoMove = 1'000'000;  // the tag of what is no move
  std::uint32_t moves = 1;                      // the fixture's own has tag 0
  for (std::int64_t at = kThere; at < kEnd; at += random.integer(0, 600)) {
    switch (random.integer(0, 15)) {
      case 0:
        rig.submit_at(at, Stop{});
        break;
      case 1:
        rig.submit_at(at, Hold{});
        rig.submit_at(at + random.integer(0, 500), Resume{});
        break;
      case 2:
        rig.submit_at(at, SetOverride{.share = random.real(0.2, 1.0), .tag = kNoMove});
        break;
      case 3:
        if (random.integer(0, 3) != 0) break;
        rig.at(at, [&] { rig.logic.pins.drive_alarm = 1; });
        rig.at(at + 2, [&] { rig.logic.pins.drive_alarm = 0; });
        break;
      case 4:
        rig.submit_at(at, ClearFault{.tag = kNoMove});
        break;
      case 5:
        rig.submit_at(
            at, PoseMove{.target = {.frame = kToolFrame, .position_mm = {0, 0, random.real(-20, 20)}}, .tag = moves++});
        break;
      case 6:
        rig.submit_at(at, JointMove{.target = degrees(kPostureDeg), .tag = moves++});
        break;
      default:
        CartesianMove move = shift(random.real(-15, 15), random.real(-15, 15), random.real(-15, 15),
                                   random.integer(0, 2) == 0 ? 0.0 : 3.0);
        move.limits = test::kBrisk;
        if (random.integer(0, 15) == 0) move.target.position_mm.z() = 4'000.0;
        move.tag = moves++;
        rig.submit_at(at, move);
    }
  }
  rig.submit_at(kEnd + 2'000, Resume{});
  rig.submit_at(kEnd + 2'000, SetOverride{.share = 1.0, .tag = kNoMove});
  rig.submit_at(kEnd + 2'000, ClearFault{.tag = kNoMove});
  rig.run(kEnd + 40'000);
  std::vector<int> told(moves);
  for (const MoveStarted& started : rig.moves) ++told.at(started.tag.number());
  for (const MoveRefused& refused : rig.refusals) {
    if (refused.tag != kNoMove) ++told.at(refused.tag.number());
  }
  for (std::uint32_t tag = 0; tag < moves; ++tag) EXPECT_EQ(told[tag], 1) << "move " << tag << ", seed " << kSeed;
  EXPECT_GT(rig.moves.size(), 20u) << "seed " << kSeed;
  EXPECT_EQ(rig.last().state, MotionState::kIdle) << "seed " << kSeed;
}

}  // namespace
}  // namespace armature
