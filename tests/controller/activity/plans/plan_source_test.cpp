#include "controller/activity/plans/plan_source.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <variant>
#include <vector>

#include "controller/base/timebase.hpp"
#include "controller/trajectory/joint/joint_move.hpp"
#include "tests/controller/support/robots.hpp"

namespace armature {
namespace {

class Notes final : public EventListener {
 public:
  void on_event(const Event& event) noexcept override { events.push_back(event); }
  std::vector<Event> events;
};

// On a joint plan and at rest; see RetargetInMotion.
constexpr int kTicksToRetarget = 4;

struct PlanSourceTest : testing::Test {
  const SetPoint& tick() { return source.advance(Ticks{ticks++}, channel.control.view()); }
  static Request request_to(const PerAxis<double>& target_deg, std::uint32_t tag) {
    Request request;
    request.set(RetargetRequest{.goal = {.target = test::degrees(target_deg)}, .tag = Tag{tag}});
    return request;
  }

  RobotModel robot = test::paper_robot();
  Arm arm{robot};
  Channel channel;
  Notes notes;
  PlanSource source{robot, arm, channel, notes};
  std::int64_t ticks = 0;
};

TEST_F(PlanSourceTest, AStopUsesNoMoreThanTheRestOfThePath) {
  EXPECT_TRUE(source.at_rest());
  const JointPlan plan = plan_joint_move(robot, {}, test::degrees({40, -30, 20, 10, -10, 30}), 1.0, SyncRule::kFig9);
  ASSERT_TRUE(channel.plan_store.plans.try_push(Plan{Piece{plan}}));
  constexpr std::int64_t kAfter = 3'000;
  while (ticks < kAfter) tick();
  EXPECT_FALSE(source.at_rest());
  source.stop(StopKind::kQuick);
  double used = 0.0;
  while (true) {
    const SetPoint& next = tick();
    if (next.stopped) break;
    EXPECT_EQ(next.state, MotionState::kStopping);
    used += next.rate;
  }
  EXPECT_GT(used, 0.0);
  EXPECT_LE(used, static_cast<double>((plan.duration - Ticks{kAfter}).value()));
  EXPECT_TRUE(source.at_rest());
}

TEST_F(PlanSourceTest, ReleasesPlansInTheirOrderAlsoThoseThatAStopDrops) {
  const JointPlan plan = plan_joint_move(robot, {}, test::degrees({40, -30, 20, 10, -10, 30}), 1.0, SyncRule::kFig9);
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(channel.plan_store.plans.try_push(Plan{Piece{plan}}));
  while (ticks < 1'000) tick();
  EXPECT_EQ(channel.plan_store.progress.view().plan, 1u);
  source.stop(StopKind::kQuick);
  tick();
  EXPECT_TRUE(channel.plan_store.plans.empty());
  EXPECT_EQ(channel.plan_store.released.load(), 0u) << "the first one is still being executed";
  while (!tick().stopped) ASSERT_LT(ticks, 20'000);
  EXPECT_EQ(channel.plan_store.released.load(), 3u);
  ASSERT_TRUE(channel.plan_store.plans.try_push(Plan{Piece{plan}}));
  tick();
  EXPECT_EQ(channel.plan_store.progress.view().plan, 4u);
}

TEST_F(PlanSourceTest, AQuickStopReplacesASoftOneThatBrakesAndNotTheOtherWayRound) {
  RobotModel smooth = robot;
  for (AxisModel& axis : smooth.axes) axis.max_jerk_rad_s3 = 3'000.0 * test::kDeg;
  const auto ticks_to_stop = [&](const std::vector<StopKind>& stops) {
    PlanSource braking{smooth, arm, channel, notes};
    const JointPlan plan =
        plan_joint_move(smooth, {}, test::degrees({40, 0, 0, 0, 0, 0}), 1.0, SyncRule::kFig9, ProfileKind::kSCurve);
    EXPECT_TRUE(channel.plan_store.plans.try_push(Plan{Piece{plan}}));
    std::int64_t at = 0;
    while (at < 3'000) braking.advance(Ticks{++at}, {});
    for (const StopKind how : stops) {
      braking.stop(how);
      braking.advance(Ticks{++at}, {});
    }
    while (!braking.set_point().stopped) braking.advance(Ticks{++at}, {});
    return at;
  };
  using enum StopKind;
  const std::int64_t soft = ticks_to_stop({kSoft, kSoft}), quick = ticks_to_stop({kQuick, kSoft});
  EXPECT_LT(quick, soft);
  EXPECT_LT(ticks_to_stop({kSoft, kQuick}), soft);
  EXPECT_EQ(ticks_to_stop({kQuick, kQuick}), quick);
}

TEST_F(PlanSourceTest, ANewTargetInMotionReplacesThePlanWithinTheLimits) {
  JointPlan first = plan_joint_move(robot, {}, test::degrees({40, -30, 20, 10, -10, 30}), 1.0, SyncRule::kFig9);
  first.tag = Tag{1};
  ASSERT_TRUE(channel.plan_store.plans.try_push(Plan{Piece{first}}));
  std::vector<PerAxis<Radians>> points(2);
  const auto run = [&](std::int64_t count) {
    for (; count > 0; --count) points.push_back(tick().position);
  };
  run(3'000);
  source.feed(request_to({-20, 0, 10, 40, 10, 0}, 2));
  run(kTicksToRetarget);
  EXPECT_EQ(notes.events.size(), 1u) << "the first move continues until the new one is planned";
  run(1);
  EXPECT_TRUE(source.set_point().wake);
  ASSERT_EQ(notes.events.size(), 3u);
  EXPECT_EQ(std::get<MoveStarted>(notes.events[0]).tag, Tag{1});
  EXPECT_EQ(std::get<MoveFinished>(notes.events[1]).tag, Tag{1});
  EXPECT_EQ(std::get<MoveFinished>(notes.events[1]).how, MoveFinished::How::kCutShort);
  EXPECT_EQ(std::get<MoveStarted>(notes.events[2]).tag, Tag{2});
  const Ticks duration = std::get<MoveStarted>(notes.events[2]).duration;
  run(duration.value() - 2);
  EXPECT_FALSE(source.at_rest());
  run(1);
  EXPECT_TRUE(source.at_rest());
  EXPECT_EQ(points.back(), test::degrees({-20, 0, 10, 40, 10, 0}));
  ASSERT_EQ(notes.events.size(), 4u);
  EXPECT_EQ(std::get<MoveFinished>(notes.events[3]).how, MoveFinished::How::kReachedEnd);
  run(3);
  EXPECT_EQ(channel.plan_store.over.load(), 2u);
  for (std::size_t k = 2; k < points.size(); ++k) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const double step = (points[k][axis] - points[k - 1][axis]).value();
      const double last = (points[k - 1][axis] - points[k - 2][axis]).value();
      const double accel = robot.axes[axis].max_accel_rad_s2 * kTickSeconds * kTickSeconds;
      ASSERT_LE(std::fabs(step), robot.axes[axis].max_speed_rad_s * kTickSeconds * (1.0 + 1e-6)) << k;
      ASSERT_LE(std::fabs(step - last), accel * (1.0 + 1e-5)) << k << " axis " << axis;
    }
  }
}

TEST_F(PlanSourceTest, ATargetThatAJointCanOnlyReachBeyondItsLimitIsRefusedAndThePlanContinues) {
  JointPlan first = plan_joint_move(robot, {}, test::degrees({169, 0, 0, 0, 0, 0}), 1.0, SyncRule::kFig9);
  first.tag = Tag{1};
  ASSERT_TRUE(channel.plan_store.plans.try_push(Plan{Piece{first}}));
  while (ticks < first.duration.value() - 1'000) tick();
  // Braking already: 1.5 deg before its target. A slower move would have to brake more, but cannot.
  source.feed(request_to({0, 0, 0, 0, 0, 0}, 2));
  for (int i = 0; i <= kTicksToRetarget; ++i) tick();
  ASSERT_EQ(notes.events.size(), 3u) << "this one is possible";
  EXPECT_EQ(std::get<MoveStarted>(notes.events[2]).tag, Tag{2});
  while (!source.at_rest()) tick();
  notes.events.clear();

  // At the full speed, 5 deg before the limit.
  RobotModel narrow = robot;
  narrow.axes[0].max_rad = 60.0 * test::kDeg;
  PlanSource other{narrow, arm, channel, notes};
  ASSERT_TRUE(channel.plan_store.plans.try_push(Plan{Piece{first}}));
  std::int64_t at = 0;
  while (other.set_point().position[0] < Radians{55.0 * test::kDeg}) other.advance(Ticks{++at}, channel.control.view());
  other.feed(request_to({0, 0, 0, 0, 0, 0}, 3));
  for (int i = 0; i <= kTicksToRetarget; ++i) other.advance(Ticks{++at}, channel.control.view());
  ASSERT_EQ(notes.events.size(), 2u);
  const MoveRefused& refused = std::get<MoveRefused>(notes.events[1]);
  EXPECT_EQ(refused.reason, Refusal::kOutsideLimits);
  EXPECT_EQ(refused.axis, 1u);
  // At full speed on the way up: it needs v^2 / (2 a) to brake.
  const AxisModel& axis = narrow.axes[0];
  EXPECT_GT(refused.path.angle_rad, axis.max_rad);
  EXPECT_LT(refused.path.angle_rad,
            axis.max_rad + axis.max_speed_rad_s * axis.max_speed_rad_s / (2.0 * axis.max_accel_rad_s2));
  EXPECT_EQ(refused.path.limit_rad, axis.max_rad);
  EXPECT_EQ(refused.path.at, 0.0);
  EXPECT_EQ(refused.tag, Tag{3});
  while (!other.at_rest()) other.advance(Ticks{++at}, channel.control.view());
  EXPECT_EQ(other.set_point().position, first.target);
}

TEST_F(PlanSourceTest, ANewTargetAtRestIsAMove) {
  source.feed(request_to({10, 0, 0, 0, 0, 0}, 1));
  for (int i = 0; i <= kTicksToRetarget; ++i) tick();
  EXPECT_FALSE(source.at_rest());
  while (!source.at_rest()) tick();
  EXPECT_EQ(source.set_point().position, test::degrees({10, 0, 0, 0, 0, 0}));
}

TEST_F(PlanSourceTest, AStopWhileANewTargetIsPlannedDropsItAndBrakesOnThePlan) {
  const JointPlan plan = plan_joint_move(robot, {}, test::degrees({40, -30, 0, 0, 0, 0}), 1.0, SyncRule::kFig9);
  for (int into = 0; into <= kTicksToRetarget; ++into) {
    SCOPED_TRACE(into);
    notes.events.clear();
    PlanSource braking{robot, arm, channel, notes};
    ASSERT_TRUE(channel.plan_store.plans.try_push(Plan{Piece{plan}}));
    std::vector<PerAxis<Radians>> points(2);
    std::int64_t at = 0;
    const auto run = [&] { points.push_back(braking.advance(Ticks{++at}, {}).position); };
    while (at < 3'000) run();
    braking.feed(request_to({-20, 0, 10, 40, 10, 0}, 2));
    for (int i = 0; i < into; ++i) run();
    braking.stop(StopKind::kQuick);
    run();
    const std::int64_t asked = at;
    while (!braking.set_point().stopped && at < 20'000) run();
    EXPECT_LT(at - asked, 4'100) << "120 deg/s with 600 deg/s^2, and 3 ticks";
    ASSERT_EQ(notes.events.size(), 3u);
    EXPECT_EQ(std::get<MoveRefused>(notes.events[1]).tag, Tag{2});
    EXPECT_EQ(std::get<MoveFinished>(notes.events[2]).how, MoveFinished::How::kCutShort);
    for (std::size_t k = 2; k < points.size(); ++k) {
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const double step = (points[k][axis] - points[k - 1][axis]).value();
        const double bend = step - (points[k - 1][axis] - points[k - 2][axis]).value();
        const double accel = robot.axes[axis].max_accel_rad_s2 * kTickSeconds * kTickSeconds;
        ASSERT_LE(std::fabs(bend), accel * (1.0 + 1e-5)) << k << " axis " << axis;
      }
    }
  }
}

TEST_F(PlanSourceTest, AStopDropsANewTargetThatWaitsInAHold) {
  const JointPlan plan = plan_joint_move(robot, {}, test::degrees({40, 0, 0, 0, 0, 0}), 1.0, SyncRule::kFig9);
  ASSERT_TRUE(channel.plan_store.plans.try_push(Plan{Piece{plan}}));
  while (ticks < 2'000) tick();
  channel.control.set_hold(true);
  source.feed(request_to({-10, 0, 0, 0, 0, 0}, 2));
  while (ticks < 10'000) tick();
  EXPECT_EQ(notes.events.size(), 1u) << "no plan begins in a hold";
  EXPECT_EQ(source.set_point().state, MotionState::kHolding);
  source.stop(StopKind::kQuick);
  channel.control.set_hold(false);
  while (!tick().stopped) ASSERT_LT(ticks, 20'000);
  EXPECT_TRUE(channel.plan_store.plans.empty());
  EXPECT_TRUE(std::any_of(notes.events.begin(), notes.events.end(), [](const Event& event) {
    const auto* refused = std::get_if<MoveRefused>(&event);
    return refused != nullptr && refused->tag == Tag{2};
  }));
}

TEST_F(PlanSourceTest, StartsWhereItIsMadeToStand) {
  const PerAxis<Radians> place = test::degrees({1, 2, 3, 4, 5, 6});
  source.reset_to(place);
  EXPECT_EQ(source.set_point().position, place);
  EXPECT_EQ(tick().position, place);
  EXPECT_EQ(source.set_point().state, MotionState::kIdle);
}

}  // namespace
}  // namespace armature
