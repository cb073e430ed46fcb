// Moves of the tool through the whole controller: frames, chains, refusals, and what is reported of them.
#include "tests/controller/support/cartesian_moves.hpp"

namespace armature {
namespace {

using test::ControllerRig;
using test::degrees;
using test::kPostureDeg;
using test::kThere;
using CartesianMoves = test::CartesianMovesTest;

TEST_F(CartesianMoves, ALineIsDrivenReportedAndEndsExactly) {
  rig.submit_at(kThere, shift(10, 20, -30));
  rig.run(30'000);
  ASSERT_TRUE(rig.refusals.empty());
  ASSERT_EQ(rig.moves.size(), 2u);
  const MoveStarted& line = rig.moves[1];
  const Eigen::Vector3d goal = posture() * Eigen::Vector3d{10, 20, -30};
  EXPECT_EQ(line.kind, MoveKind::kLine);
  EXPECT_LT((line.path.start_mm - posture().position_mm).norm(), 1e-9);
  EXPECT_LT((line.path.end_mm - goal).norm(), 1e-9);
  EXPECT_GE(line.stretch, 1.0);
  EXPECT_FALSE(line.continues);
  EXPECT_EQ(line.shape, (PerAxis<ProfileShape>{}));
  EXPECT_EQ(std::count_if(
                rig.rows.begin(), rig.rows.end(),
                [](const Telemetry& row) { return row.tick >= Ticks{kThere} && row.state == MotionState::kMoving; }),
            line.duration.value());
  const Transform end = tool(rig.last().reference);
  EXPECT_LT((end.position_mm - goal).norm(), 1e-9);
  EXPECT_LT((end.rotation - posture().rotation).norm(), 1e-12);  // kept in space
  EXPECT_LT(path_error_mm(), 1e-9);
  EXPECT_EQ(rig.moves_finished(), 2);
  rig.expect_pulses_conserved();
}

TEST_F(CartesianMoves, BlendedMovesGoThroughTheCornersWithoutStopping) {
  rig.at(kThere, [&] {
    rig.submit(shift(30, 0, 0, 5.0));
    rig.submit(shift(0, 30, 0, 5.0));
    rig.submit(shift(-30, 0, 0, 5.0));  // nothing follows it
    rig.submit(JointMove{.target = degrees(kPostureDeg)});
  });
  rig.run(60'000);
  ASSERT_EQ(rig.moves.size(), 5u);
  EXPECT_FALSE(rig.moves[1].continues);
  for (const std::size_t i : {2u, 3u}) {
    EXPECT_TRUE(rig.moves[i].continues);
    EXPECT_LT(rig.moves[i].start_tick, rig.moves[i - 1].start_tick + rig.moves[i - 1].duration);
  }
  EXPECT_EQ(rig.moves[4].start_tick, rig.moves[3].start_tick + rig.moves[3].duration);
  // Finished one by one, each at its own end.
  for (const std::size_t i : {1u, 2u, 3u}) {
    const std::int64_t end = (rig.moves[i].start_tick + rig.moves[i].duration).value();
    EXPECT_EQ(rig.moves_finished(end - 2), static_cast<std::int64_t>(i));
    EXPECT_EQ(rig.moves_finished(end - 1), static_cast<std::int64_t>(i) + 1);
  }
  EXPECT_GT(path_error_mm(), 0.1);
  EXPECT_LT(path_error_mm(), 5.0);
  EXPECT_EQ(rig.moves_finished(), 5);
  rig.expect_at(kPostureDeg);
}

TEST_F(CartesianMoves, TangentMovesGoOnWithoutStoppingUnlessAStopIsAskedFor) {
  const auto slowest_mm_s = [&](bool exact_stop) {
    ControllerRig own{test::irb120(), config()};
    own.move_at(0, kPostureDeg);
    CartesianMove first = shift(40, 0, 0);
    first.exact_stop = exact_stop;
    own.at(kThere, [&] {
      own.submit(first);
      own.submit(shift(30, 0, 0));
    });
    own.run(40'000);
    EXPECT_EQ(own.moves.size(), 3u);
    EXPECT_EQ(own.moves.back().continues, !exact_stop);
    EXPECT_EQ(own.moves_finished(), 3);
    // Around the end of the first move.
    const std::int64_t end = own.moves.back().start_tick.value();
    double slowest = 1e9;
    for (std::size_t i = 1; i < own.rows.size(); ++i) {
      if (std::abs(own.rows[i].tick.value() - end) > 3) continue;
      const auto at = [&](std::size_t row) { return tool(own.rows[row].reference).position_mm; };
      slowest = std::min(slowest, (at(i) - at(i - 1)).norm() / kTickSeconds);
    }
    return slowest;
  };
  EXPECT_NEAR(slowest_mm_s(false), test::kGentle.speed_mm_s, 0.01 * test::kGentle.speed_mm_s);
  EXPECT_LT(slowest_mm_s(true), 1.0);
}

TEST_F(CartesianMoves, ACornerWithoutABlendIsAnExactStopBetweenTwoChains) {
  rig.at(kThere, [&] {
    rig.submit(shift(30, 0, 0));
    rig.submit(shift(0, 5'000, 0));  // beyond the reach
    rig.submit(shift(0, 0, -30));
  });
  rig.run(60'000);
  ASSERT_EQ(rig.moves.size(), 3u);
  ASSERT_EQ(rig.refusals.size(), 1u);
  EXPECT_FALSE(rig.moves[2].continues);
}

TEST_F(CartesianMoves, AMoveThatArrivesWhileItsChainIsBeingPlannedStillJoinsIt) {
  int slices = 0;
  rig.submit_at(kThere, shift(30, 0, 0, 5.0));
  rig.on_core1_work = [&](Work work, std::int64_t) {
    if (work == Work::kInverse && ++slices == 3) rig.submit(shift(0, 30, 0));
  };
  rig.run(30'000);
  ASSERT_EQ(rig.moves.size(), 3u);
  EXPECT_TRUE(rig.moves[2].continues);
}

TEST_F(CartesianMoves, AMoveThatArrivesWhileTheArmMovesStillJoinsItsChain) {
  rig.submit_at(kThere, shift(30, 0, 0, 5.0));
  rig.submit_at(kThere + 100, shift(0, 30, 0));
  rig.run(30'000);
  ASSERT_EQ(rig.moves.size(), 3u);
  EXPECT_TRUE(rig.moves[2].continues);
  EXPECT_GT(path_error_mm(), 0.1);
  EXPECT_LT(path_error_mm(), 5.0);
  EXPECT_EQ(rig.moves_finished(), 3);
  rig.expect_pulses_conserved();
}

TEST_F(CartesianMoves, AMoveThatArrivesShortlyBeforeTheArmRestsBeginsWithAnExactStop) {
  const double taken_s = 30.0 / test::kGentle.speed_mm_s + test::kGentle.speed_mm_s / test::kGentle.accel_mm_s2;
  rig.submit_at(kThere, shift(30, 0, 0, 5.0));
  rig.submit_at(kThere + static_cast<std::int64_t>(taken_s / kTickSeconds) - 20, shift(0, 30, 0));
  rig.run(30'000);
  ASSERT_EQ(rig.moves.size(), 3u);
  EXPECT_FALSE(rig.moves[2].continues);
  EXPECT_LT(path_error_mm(), 1e-9);
}

TEST_F(CartesianMoves, NeighboursOfARefusedMoveAreNotBlended) {
  rig.at(kThere, [&] {
    rig.submit(shift(30, 0, 0, 5.0));
    rig.submit(shift(0, std::nan(""), 0, 5.0));
    rig.submit(shift(0, 30, 0));
  });
  rig.run(30'000);
  ASSERT_EQ(rig.refusals.size(), 1u);
  EXPECT_EQ(rig.refusals[0].reason, Refusal::kInvalidTarget);
  ASSERT_EQ(rig.moves.size(), 3u);
  EXPECT_FALSE(rig.moves[2].continues);
  EXPECT_LT(path_error_mm(), 1e-9);
}

TEST_F(CartesianMoves, ARefusedChainMovesNothingAndEverySegmentIsReported) {
  std::int64_t before = 0;
  rig.at(kThere - 1, [&] { before = emitted(); });
  rig.at(kThere, [&] {
    rig.submit(shift(10, 0, 0, 2.0));
    rig.submit(shift(0, 0, 5'000, 2.0));
    rig.submit(shift(0, 10, 0));
  });
  rig.at(kThere + 2'000, [&] { EXPECT_EQ(emitted(), before); });
  rig.submit_at(kThere + 2'001, shift(0, 10, 0));  // from where the arm stands
  rig.run(20'000);
  ASSERT_EQ(rig.refusals.size(), 3u);
  EXPECT_EQ(rig.refusals[0].reason, Refusal::kChainRefused);
  EXPECT_EQ(rig.refusals[1].reason, Refusal::kUnreachable);
  EXPECT_EQ(rig.refusals[1].path.kind, PathProblem::Kind::kUnreachable);
  EXPECT_EQ(rig.refusals[1].path.segment, 1);
  EXPECT_GT(rig.refusals[1].path.margin_mm, 1'000.0);
  EXPECT_EQ(rig.refusals[1].path.at, 1.0);  // its end, found before the path to it
  EXPECT_EQ(rig.refusals[2].reason, Refusal::kChainRefused);
  ASSERT_EQ(rig.moves.size(), 2u);
  EXPECT_LT((rig.moves[1].path.start_mm - posture().position_mm).norm(), 1e-9);
  EXPECT_LT((tool(rig.last().reference).position_mm - posture() * Eigen::Vector3d{0, 10, 0}).norm(), 1e-9);
}

TEST_F(CartesianMoves, FramesAreResolvedWhereTheMoveBegins) {
  const Transform frame = *config().base_T_user[1];
  const Eigen::Vector3d at_mm = inverse(frame) * (posture() * Eigen::Vector3d{5, 5, 5});
  CartesianMove in_frame = shift(0, 0, 0);
  in_frame.target = {.frame = FrameId{2}, .position_mm = at_mm};
  CartesianMove undefined = in_frame;
  undefined.target.frame = FrameId{1};
  rig.submit_at(kThere, in_frame);
  rig.submit_at(kThere, undefined);
  rig.submit_at(kThere, shift(0, 0, 5));  // relative to where the first one will end
  rig.run(20'000);
  ASSERT_EQ(rig.refusals.size(), 1u);
  EXPECT_EQ(rig.refusals[0].reason, Refusal::kInvalidTarget);
  EXPECT_LT((tool(rig.last().reference).position_mm - posture() * Eigen::Vector3d{5, 5, 10}).norm(), 1e-9);
}

TEST_F(CartesianMoves, APoseMoveIsAJointMoveToThePose) {
  const Transform goal = test::turned_by(test::moved(posture(), 30, -40, 20), 0.5, {1, 2, 3});
  rig.submit_at(kThere, PoseMove{.target = {.position_mm = goal.position_mm, .rotation = goal.rotation}});
  rig.submit_at(kThere, PoseMove{.target = {.position_mm = {5'000, 0, 0}}});
  rig.run(20'000);
  ASSERT_EQ(rig.moves.size(), 2u);
  EXPECT_EQ(rig.moves[1].kind, MoveKind::kJoint);
  ASSERT_EQ(rig.refusals.size(), 1u);
  EXPECT_EQ(rig.refusals[0].reason, Refusal::kUnreachable);
  EXPECT_EQ(rig.refusals[0].path.kind, PathProblem::Kind::kUnreachable);
  EXPECT_GT(rig.refusals[0].path.margin_mm, 3'000.0);
  const Transform end = tool(rig.last().reference);
  EXPECT_LT((end.position_mm - goal.position_mm).norm(), 1e-9);
  EXPECT_LT((end.rotation - goal.rotation).norm(), 1e-12);
}

TEST_F(CartesianMoves, APoseMoveReachesTheRequestedConfiguration) {
  const Transform goal = test::turned_by(test::moved(posture(), 30, -40, 20), 0.9, {1, 0, 0});
  PoseMove move{.target = {.position_mm = goal.position_mm, .rotation = goal.rotation}};
  for (const WristSide side : {WristSide::kFlip, WristSide::kNoflip}) {
    move.target.configuration = {.elbow = ElbowSide::kUp, .wrist = side};
    rig.submit_at(kThere, move);
  }
  move.target.configuration = {.turns = Turns{0, 0, 0, 0, 0, 2}};
  rig.submit_at(kThere, move);
  CartesianMove line = shift(5, 0, 0);
  line.target.configuration = {.wrist = WristSide::kFlip};
  rig.submit_at(kThere, line);
  rig.run(45'000);
  ASSERT_EQ(rig.moves.size(), 3u);
  EXPECT_EQ(arm.configuration(rig.last().reference).wrist, WristSide::kNoflip);
  EXPECT_GT((rig.moves[2].duration).value(), 2'000) << "from the flipped side to the other one";
  ASSERT_EQ(rig.refusals.size(), 2u);
  EXPECT_EQ(rig.refusals[0].reason, Refusal::kOutsideLimits);
  EXPECT_EQ(rig.refusals[0].axis, 6);
  EXPECT_EQ(rig.refusals[1].reason, Refusal::kConfiguration);
  EXPECT_EQ(rig.refusals[1].path.kind, PathProblem::Kind::kOtherConfiguration);
  EXPECT_EQ(rig.refusals[1].path.configuration, kWristPart);
}

TEST(CartesianMovesWithoutGeometry, AreRefused) {
  ControllerRig rig;
  rig.submit_at(0, PoseMove{});
  rig.submit_at(0, CartesianMove{});
  rig.run(100);
  ASSERT_EQ(rig.refusals.size(), 2u);
  for (const MoveRefused& refusal : rig.refusals) EXPECT_EQ(refusal.reason, Refusal::kNoKinematics);
}

// The corner would be rounded without the output; with it the arm stands there, and the output is switched then.
TEST_F(CartesianMoves, AnOutputBetweenBlendedMovesEndsTheirChain) {
  rig.submit_at(kThere, shift(40, 0, 0, 5.0));
  rig.submit_at(kThere, SetOutput{.pin = 1, .level = true});
  rig.submit_at(kThere, shift(0, 40, 0));
  rig.run(kThere + 20'000);
  ASSERT_EQ(rig.moves.size(), 3u);
  EXPECT_FALSE(rig.moves[2].continues);
  ASSERT_EQ(rig.io.size(), 1u);
  EXPECT_GT(rig.io[0].first, (rig.moves[1].start_tick + rig.moves[1].duration).value());
  EXPECT_LE(rig.io[0].first, rig.moves[2].start_tick.value() + 1);  // the same trigger
  EXPECT_LT(path_error_mm(), 1e-6);
}

}  // namespace
}  // namespace armature
