// The seam between the motion loop and what gives it set-points, from both sides.
#include "controller/motion/motion_source.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <variant>
#include <vector>

#include "controller/base/timebase.hpp"
#include "controller/motion/count_logic_port.hpp"
#include "controller/motion/motion_loop.hpp"
#include "controller/motion/plan_runner.hpp"
#include "controller/robot/axis_units.hpp"
#include "controller/trajectory/plan/joint_move.hpp"
#include "tests/controller/support/fake_logic.hpp"
#include "tests/controller/support/robots.hpp"

namespace armature {
namespace {

class Notes final : public ControllerObserver {
 public:
  void on_tick(const Telemetry& telemetry) noexcept override { rows.push_back(telemetry); }
  void on_event(const Event& event) noexcept override { events.push_back(event); }
  std::vector<Telemetry> rows;
  std::vector<Event> events;
};

// Turns axis 1 by one and a half pulses in every tick: a source that has never heard of plans.
class Turning final : public MotionSource {
 public:
  explicit Turning(double step_rad) : step_rad_{step_rad} {}
  const SetPoint& advance(Ticks) noexcept override {
    set_point_.position[0] += Radians{step_rad_};
    set_point_.state = MotionState::kMoving;
    set_point_.rate = 1.0;
    return set_point_;
  }
  void reset_to(const PerAxis<Radians>& position) noexcept override { set_point_ = {.position = position}; }
  void cut_short(Ticks tick) noexcept override { cut_at = tick; }
  void cancel(Ticks) noexcept override {
    ++given_up;
    set_point_.rate = 0.0;
  }
  Stopping stopping() const noexcept override { return {.possible = false, .within_ticks = 1.0}; }

  Ticks cut_at{};
  int given_up = 0;

 private:
  double step_rad_;
};

struct MotionSourceTest : testing::Test {
  MotionSourceTest() {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const AxisModel& from = robot.axes[axis];
      logic.drives[axis].counts_per_pulse = static_cast<double>(from.counts_per_rev) / from.pulses_per_rev;
    }
  }
  void run(MotionSource& source, std::int64_t triggers) {
    logic.triggers_to_run = triggers;
    CountLogicPort port{logic};
    MotionLoop{robot, false, port, logic, mailbox, source, notes}.run();
  }

  RobotModel robot = test::paper_robot();
  test::FakeLogic logic;
  MotionMailbox mailbox;
  Notes notes;
};

TEST_F(MotionSourceTest, TheMotionLoopFollowsAnySource) {
  Turning source{1.5 * AxisUnits{robot.axes[0]}.rad_per_pulse()};
  run(source, 1'002);
  ASSERT_GT(notes.rows.size(), 1'000u);
  EXPECT_EQ(notes.rows[999].reference_pulses[0], Pulses{1'500});
  EXPECT_EQ(notes.rows[999].state, MotionState::kMoving);
  EXPECT_EQ(notes.rows[999].rate, 1.0);
  EXPECT_EQ(source.given_up, 0);
  EXPECT_FALSE(source.at_rest());
}

TEST_F(MotionSourceTest, AFaultCutsItShortOnceAndGivesItUpInEveryTickAfterThat) {
  logic.on_trigger = [&](std::int64_t trigger) {
    if (trigger == 40) logic.alarm = 1;
  };
  Turning source{0.0};
  run(source, 60);
  ASSERT_EQ(notes.events.size(), 1u);
  const Ticks fault = std::get<Faulted>(notes.events[0]).tick;
  EXPECT_EQ(source.cut_at, fault);
  EXPECT_EQ(source.given_up, static_cast<int>(notes.rows.size()) - static_cast<int>(fault.value()) - 1);
  EXPECT_EQ(notes.rows.back().rate, 0.0);
}

struct PlanRunnerTest : testing::Test {
  const SetPoint& tick() { return runner.advance(Ticks{ticks++}); }

  RobotModel robot = test::paper_robot();
  Arm arm{robot};
  MotionMailbox mailbox;
  Notes notes;
  PlanRunner runner{robot, arm, mailbox, notes};
  std::int64_t ticks = 0;
};

TEST_F(PlanRunnerTest, AStopUsesNoMoreOfThePathThanTheSourceSays) {
  EXPECT_TRUE(runner.at_rest());
  const JointPlan plan = plan_joint_move(robot, {}, test::degrees({40, -30, 20, 10, -10, 30}), 1.0, SyncRule::kFig9);
  ASSERT_TRUE(mailbox.plans.try_push(plan));
  for (const std::int64_t after : {1, 100, 3'000}) {
    while (ticks < after) tick();
    EXPECT_FALSE(runner.at_rest());
    EXPECT_DOUBLE_EQ(runner.stopping().within_ticks, static_cast<double>((plan.duration - Ticks{after}).value()));
  }
  const Stopping stopping = runner.stopping();
  EXPECT_TRUE(stopping.possible);
  ASSERT_TRUE(mailbox.orders.try_push(MotionOrder::kStop));
  double used = 0.0;
  while (true) {
    const SetPoint& next = tick();
    if (next.stopped) break;
    EXPECT_EQ(next.state, MotionState::kStopping);
    used += next.rate;
  }
  EXPECT_GT(used, 0.0);
  EXPECT_LE(used, stopping.within_ticks);
  EXPECT_TRUE(runner.at_rest());
}

RetargetRequest request_to(const PerAxis<double>& target_deg, std::uint32_t tag) {
  return {.target = test::degrees(target_deg), .tag = Tag{tag}};
}

TEST_F(PlanRunnerTest, ANewTargetInMotionReplacesThePlanWithinTheLimits) {
  JointPlan first = plan_joint_move(robot, {}, test::degrees({40, -30, 20, 10, -10, 30}), 1.0, SyncRule::kFig9);
  first.tag = Tag{1};
  ASSERT_TRUE(mailbox.plans.try_push(first));
  std::vector<PerAxis<Radians>> points(2);
  const auto run = [&](std::int64_t count) {
    for (; count > 0; --count) points.push_back(tick().position);
  };
  run(3'000);
  ASSERT_TRUE(mailbox.retargets.try_push(request_to({-20, 0, 10, 40, 10, 0}, 2)));
  run(1);
  EXPECT_TRUE(runner.last().wake);
  ASSERT_EQ(notes.events.size(), 3u);
  EXPECT_EQ(std::get<MoveStarted>(notes.events[0]).tag, Tag{1});
  EXPECT_EQ(std::get<MoveFinished>(notes.events[1]).tag, Tag{1});
  EXPECT_EQ(std::get<MoveFinished>(notes.events[1]).how, MoveFinished::How::kCutShort);
  EXPECT_EQ(std::get<MoveStarted>(notes.events[2]).tag, Tag{2});
  const Ticks duration = std::get<MoveStarted>(notes.events[2]).duration;
  run(duration.value() - 2);
  EXPECT_FALSE(runner.at_rest());
  run(1);
  EXPECT_TRUE(runner.at_rest());
  EXPECT_EQ(points.back(), test::degrees({-20, 0, 10, 40, 10, 0}));
  ASSERT_EQ(notes.events.size(), 4u);
  EXPECT_EQ(std::get<MoveFinished>(notes.events[3]).how, MoveFinished::How::kReachedEnd);
  run(3);
  EXPECT_EQ(mailbox.plans_over.load(), 2u);
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

TEST_F(PlanRunnerTest, ATargetThatAJointCanOnlyReachBeyondItsLimitIsRefusedAndThePlanContinues) {
  JointPlan first = plan_joint_move(robot, {}, test::degrees({169, 0, 0, 0, 0, 0}), 1.0, SyncRule::kFig9);
  first.tag = Tag{1};
  ASSERT_TRUE(mailbox.plans.try_push(first));
  while (ticks < first.duration.value() - 1'000) tick();
  // Braking already: 1.5 deg before its target. A slower move would have to brake more, but cannot.
  ASSERT_TRUE(mailbox.retargets.try_push(request_to({0, 0, 0, 0, 0, 0}, 2)));
  tick();
  ASSERT_EQ(notes.events.size(), 3u) << "this one is possible";
  EXPECT_EQ(std::get<MoveStarted>(notes.events[2]).tag, Tag{2});
  while (!runner.at_rest()) tick();
  notes.events.clear();

  // At the full speed, 5 deg before the limit.
  RobotModel narrow = robot;
  narrow.axes[0].max_rad = 60.0 * test::kDeg;
  PlanRunner other{narrow, arm, mailbox, notes};
  ASSERT_TRUE(mailbox.plans.try_push(first));
  std::int64_t at = 0;
  while (other.last().position[0] < Radians{55.0 * test::kDeg}) other.advance(Ticks{++at});
  ASSERT_TRUE(mailbox.retargets.try_push(request_to({0, 0, 0, 0, 0, 0}, 3)));
  other.advance(Ticks{++at});
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
  while (!other.at_rest()) other.advance(Ticks{++at});
  EXPECT_EQ(other.last().position, first.target);
}

TEST_F(PlanRunnerTest, ANewTargetAtRestIsAMove) {
  ASSERT_TRUE(mailbox.retargets.try_push(request_to({10, 0, 0, 0, 0, 0}, 1)));
  tick();
  EXPECT_FALSE(runner.at_rest());
  while (!runner.at_rest()) tick();
  EXPECT_EQ(runner.last().position, test::degrees({10, 0, 0, 0, 0, 0}));
}

TEST_F(PlanRunnerTest, AStopDropsANewTargetThatWaitsInAHold) {
  ASSERT_TRUE(
      mailbox.plans.try_push(plan_joint_move(robot, {}, test::degrees({40, 0, 0, 0, 0, 0}), 1.0, SyncRule::kFig9)));
  while (ticks < 2'000) tick();
  mailbox.control.set_hold(true);
  ASSERT_TRUE(mailbox.retargets.try_push(request_to({-10, 0, 0, 0, 0, 0}, 2)));
  while (ticks < 10'000) tick();
  EXPECT_EQ(notes.events.size(), 1u) << "no plan begins in a hold";
  EXPECT_EQ(runner.last().state, MotionState::kHolding);
  ASSERT_TRUE(mailbox.orders.try_push(MotionOrder::kStop));
  mailbox.control.set_hold(false);
  while (!tick().stopped) ASSERT_LT(ticks, 20'000);
  EXPECT_TRUE(mailbox.plans.empty());
  EXPECT_TRUE(mailbox.retargets.empty());
  EXPECT_TRUE(std::any_of(notes.events.begin(), notes.events.end(), [](const Event& event) {
    const auto* refused = std::get_if<MoveRefused>(&event);
    return refused != nullptr && refused->tag == Tag{2};
  }));
}

TEST_F(PlanRunnerTest, StartsWhereItIsMadeToStand) {
  const PerAxis<Radians> place = test::degrees({1, 2, 3, 4, 5, 6});
  runner.reset_to(place);
  EXPECT_EQ(runner.last().position, place);
  EXPECT_EQ(tick().position, place);
  EXPECT_EQ(runner.last().state, MotionState::kIdle);
}

}  // namespace
}  // namespace armature
