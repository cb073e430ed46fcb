// Each stage of the plans, by what it sends to core 0.
#include <gmock/gmock.h>

#include <optional>

#include "controller/activity/plans/move_events.hpp"
#include "controller/activity/plans/retarget_request.hpp"
#include "controller/trajectory/joint/joint_move.hpp"
#include "tests/controller/activity/plans/plan_bench.hpp"

namespace armature {
namespace {

using test::degrees;
using test::kReady;
using test::PlanBench;
using test::shift;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

JointMove joint_move(const PerAxis<double>& deg, std::uint32_t tag, double blend_share = 0.0) {
  return {.target = degrees(deg), .blend = {.share = blend_share}, .tag = tag};
}

// ---- JointStage ----

TEST(JointStage, AMoveThatJoinsNothingIsAnOrdinaryPlanFromTheEndOfTheOneBefore) {
  PlanBench bench;
  bench.accept_all(joint_move({10, 0, 0, 0, 90, 0}, 1), joint_move({20, 0, 0, 0, 90, 0}, 2));
  bench.work();
  ASSERT_EQ(bench.plans_sent(), 2u);
  ASSERT_NE(bench.plan(1)->pieces[0].joints, nullptr);
  EXPECT_EQ(bench.plan(1)->pieces[0].joints->start, degrees({10, 0, 0, 0, 90, 0}));
  EXPECT_EQ(bench.owner.end(), degrees({20, 0, 0, 0, 90, 0}));
}

TEST(JointStage, MovesWithABlendAreOneChainThatIsSentWhenNothingElseJoins) {
  PlanBench bench;
  bench.accept_all(joint_move({10, 0, 0, 0, 90, 0}, 1, 0.5), joint_move({20, 10, 0, 0, 90, 0}, 2, 0.5),
                   joint_move({30, 0, 0, 0, 90, 0}, 3), joint_move({40, 0, 0, 0, 90, 0}, 4));
  bench.work();
  ASSERT_EQ(bench.plans_sent(), 2u);
  ASSERT_NE(bench.plan(0)->pieces[0].chain, nullptr);
  EXPECT_EQ(bench.plan(0)->pieces[0].chain->count, 3u);
  EXPECT_NE(bench.plan(1)->pieces[0].joints, nullptr);
}

TEST(JointStage, AMoveAfterARefusedOneDoesNotJoin) {
  PlanBench bench;
  bench.accept_all(joint_move({10, 0, 0, 0, 90, 0}, 1, 0.5));
  EXPECT_TRUE(bench.accept(joint_move({900, 0, 0, 0, 90, 0}, 2)).has_value());
  bench.accept_all(joint_move({20, 0, 0, 0, 90, 0}, 3));
  bench.work();
  ASSERT_EQ(bench.plans_sent(), 2u);
  EXPECT_NE(bench.plan(0)->pieces[0].joints, nullptr);
}

// ---- PathStage ----

TEST(PathStage, MovesWithACornerBetweenThemAreOnePath) {
  PlanBench bench;
  bench.accept_all(shift(30, 0, 0, 5.0, 1), shift(0, 30, 0, 5.0, 2), shift(0, 0, 20, 0.0, 3));
  bench.work();
  ASSERT_EQ(bench.plans_sent(), 1u);
  ASSERT_NE(bench.plan()->only_path(), nullptr);
  EXPECT_EQ(bench.plan()->only_path()->count, 3u);
}

TEST(PathStage, AMoveOutOfReachRefusesItsChainAndNoOther) {
  PlanBench bench;
  bench.accept_all(shift(30, 0, 0, 5.0, 1), shift(900, 0, 0, 0.0, 2), joint_move({10, 0, 0, 0, 90, 0}, 3));
  bench.work();
  EXPECT_THAT(bench.refused(Refusal::kUnreachable), ElementsAre(2u));
  EXPECT_THAT(bench.refused(Refusal::kChainRefused), ElementsAre(1u));
  ASSERT_EQ(bench.plans_sent(), 1u);
  EXPECT_EQ(bench.plan()->pieces[0].joints->start, kReady);
}

TEST(PathStage, AStopWhileItPlansRefusesAllItsMoves) {
  PlanBench bench;
  bench.accept_all(shift(30, 0, 0, 5.0, 1), shift(0, 30, 0, 0.0, 2));
  (void)bench.plans.execute(std::get<CartesianMove>(*bench.queue.front()), bench.bus);
  (void)bench.plans.work(bench.bus);
  bench.owner.drop(Refusal::kNotReady);
  EXPECT_THAT(bench.refused(Refusal::kNotReady), ElementsAre(1u, 2u));
  bench.work();
  EXPECT_TRUE(bench.channel->plan_store.plans.empty());
}

// ---- WindowStage ----

class WindowStageTest : public testing::Test {
 protected:
  // The first lines are sent as a plan that can be continued, and `more` lines wait.
  void begin(std::size_t more) {
    for (std::size_t i = 0; i < CartesianPlan::kMaxFirstSegments + more; ++i) {
      ASSERT_FALSE(bench.accept(line(i)).has_value());
      if (bench.queue.full()) bench.work();
    }
    bench.work();
    ASSERT_EQ(bench.plans_sent(), 1u);
    ASSERT_EQ(bench.plan()->only_path()->count, CartesianPlan::kMaxFirstSegments);
    bench.take_plan();
  }
  static CartesianMove line(std::size_t i) {
    return shift(i % 2 == 0 ? 4 : 0, i % 2 == 0 ? 0 : 4, 0, 0.5, static_cast<std::uint32_t>(i + 1));
  }
  [[nodiscard]] std::uint32_t ticks() const {
    return static_cast<std::uint32_t>(bench.plan()->only_path()->duration.value());
  }

  PlanBench bench;
};

TEST_F(WindowStageTest, ContinuesThePlanThatIsBeingExecuted) {
  begin(4);
  bench.execute(0);
  bench.work();
  for (std::uint32_t tick = 0; bench.plans_sent() == 1 && tick < ticks(); tick += 20) {
    bench.execute(tick);
    bench.work();
  }
  ASSERT_EQ(bench.plans_sent(), 2u);
  EXPECT_TRUE(bench.plan(1)->only_path()->continues);
  EXPECT_GT(bench.plan(1)->only_path()->count, 4u);  // with moves of the present plan that are not over
}

TEST_F(WindowStageTest, DoesNotPlanBeforeThePresentPlanHasStarted) {
  begin(4);
  bench.work();
  EXPECT_EQ(bench.plans_sent(), 1u);
}

TEST_F(WindowStageTest, PlansItsMovesFromRestWhenItCameTooLate) {
  begin(4);
  for (std::uint32_t tick = 0; bench.plans_sent() == 1 && tick < ticks(); tick += 20) {
    bench.execute(tick);
    bench.work();
  }
  ASSERT_EQ(bench.plans_sent(), 2u);
  bench.channel->plan_store.late.store(1);  // core 0 has dropped it
  bench.finish(2);
  bench.work();
  ASSERT_EQ(bench.plans_sent(), 1u);
  EXPECT_FALSE(bench.plan()->only_path()->continues);
  EXPECT_EQ(bench.plan()->only_path()->count, 4u);
  EXPECT_TRUE(started(*bench.plan(), 0, Ticks{0}).unasked_stop);
}

TEST_F(WindowStageTest, AStopReportsOnlyTheMovesThatCore0DoesNotHave) {
  begin(4);
  bench.owner.drop(Refusal::kNotReady);
  constexpr auto kFirst = static_cast<std::uint32_t>(CartesianPlan::kMaxFirstSegments);
  EXPECT_THAT(bench.refused(Refusal::kNotReady), ElementsAre(kFirst + 1, kFirst + 2, kFirst + 3, kFirst + 4));
}

// ---- CornerStage ----

TEST(CornerStage, JoinsAPathAndTheJointMoveBehindItIntoOnePlan) {
  PlanBench bench;
  bench.accept_all(shift(60, 0, 0, 10.0, 1), joint_move({20, 10, 0, 0, 80, 0}, 2, 0.5));
  bench.work();
  ASSERT_EQ(bench.plans_sent(), 1u);
  EXPECT_EQ(bench.plan()->count, 2u);
  EXPECT_EQ(target_of(*bench.plan()), degrees({20, 10, 0, 0, 80, 0}));
}

TEST(CornerStage, JoinsAJointMoveBetweenTwoPathsWithBoth) {
  PlanBench bench;
  bench.accept_all(shift(60, 0, 0, 10.0, 1), joint_move({20, 10, 0, 0, 80, 0}, 2, 0.5), shift(0, 40, 0, 0.0, 3));
  bench.work();
  ASSERT_EQ(bench.plans_sent(), 1u);
  const Plan& plan = *bench.plan();
  ASSERT_EQ(plan.count, 3u);
  EXPECT_NE(plan.pieces[0].path, nullptr);
  EXPECT_NE(plan.pieces[1].chain, nullptr);
  EXPECT_NE(plan.pieces[2].path, plan.pieces[0].path);
  EXPECT_EQ(plan.stores(), 2u);
}

TEST(CornerStage, AJointMoveThatIsNotThereYetIsNotWaitedFor) {
  PlanBench bench;
  bench.accept_all(shift(60, 0, 0, 10.0, 1), SetOutput{.pin = 1, .tag = 2});
  bench.work();
  ASSERT_EQ(bench.plans_sent(), 1u);
  EXPECT_NE(bench.plan()->only_path(), nullptr);
}

TEST(CornerStage, AStopRefusesWhatIsJoinedInItsOrder) {
  for (int step = 0; step < 10'000; step += 7) {
    PlanBench stopped;
    stopped.accept_all(shift(60, 0, 0, 10.0, 1), joint_move({20, 10, 0, 0, 80, 0}, 2, 0.5));
    int left = step;
    while (left-- > 0 && stopped.step()) {
    }
    if (!stopped.channel->plan_store.plans.empty()) return;
    stopped.owner.drop(Refusal::kNotReady);
    ASSERT_THAT(stopped.refused(Refusal::kNotReady), ElementsAre(1u, 2u)) << "after " << step << " steps";
    stopped.work();
    ASSERT_TRUE(stopped.channel->plan_store.plans.empty());
  }
  FAIL() << "the plan was never sent";
}

// ---- RetargetStage ----

TEST(RetargetStage, SendsTheLatestMoveAndPlanningWaitsForTheAnswer) {
  PlanBench bench;
  JointMove first = joint_move({10, 0, 0, 0, 90, 0}, 1), latest = joint_move({20, 0, 0, 0, 90, 0}, 2);
  first.now = latest.now = true;
  bench.accept_all(first, latest, joint_move({30, 0, 0, 0, 90, 0}, 3));
  bench.plans.retarget().send();
  EXPECT_THAT(bench.refused(Refusal::kReplaced), ElementsAre(1u));
  ASSERT_NE(bench.channel->requests.front(), nullptr);
  EXPECT_EQ(bench.channel->requests.front()->get<RetargetRequest>().tag.number(), 2u);
  bench.work();
  EXPECT_TRUE(bench.channel->plan_store.plans.empty());
  bench.plans.retarget().on_answer({.kind = Answer::Kind::kRetargeted, .position = latest.target});
  bench.work();
  ASSERT_EQ(bench.plans_sent(), 1u);
  EXPECT_EQ(bench.plan()->pieces[0].joints->start, latest.target);
}

TEST(RetargetStage, DropsTheMovesBeforeItOnlyWhenCore0HasReplacedThem) {
  for (const bool replaced : {true, false}) {
    PlanBench bench;
    bench.accept_all(joint_move({10, 0, 0, 0, 90, 0}, 1));
    JointMove now = joint_move({20, 0, 0, 0, 90, 0}, 2);
    now.now = true;
    bench.accept_all(now, joint_move({30, 0, 0, 0, 90, 0}, 3));
    bench.plans.retarget().send();
    using Kind = Answer::Kind;
    bench.plans.retarget().on_answer({.kind = replaced ? Kind::kRetargeted : Kind::kNotRetargeted});
    if (replaced) {
      EXPECT_THAT(bench.refused(Refusal::kReplaced), ElementsAre(1u));
    } else {
      EXPECT_THAT(bench.refusals, IsEmpty());
    }
  }
}

TEST(RetargetStage, IsRefusedWhileAJogHasTheArm) {
  PlanBench bench;
  bench.owner.lend(ActivityId::kJog);
  JointMove now = joint_move({20, 0, 0, 0, 90, 0}, 2);
  now.now = true;
  const std::optional<MoveRefused> refusal = bench.accept(now);
  ASSERT_TRUE(refusal.has_value());
  EXPECT_EQ(refusal->reason, Refusal::kNotReady);
}

TEST(RetargetStage, AnAnswerAfterAStopHasNoEffect) {
  PlanBench bench;
  JointMove now = joint_move({20, 0, 0, 0, 90, 0}, 2);
  now.now = true;
  bench.accept_all(now);
  bench.plans.retarget().send();
  (void)bench.owner.accept(Stop{});
  bench.plans.retarget().on_answer({.kind = Answer::Kind::kRetargeted, .position = now.target});
  EXPECT_EQ(bench.owner.end(), kReady);
}

}  // namespace
}  // namespace armature
