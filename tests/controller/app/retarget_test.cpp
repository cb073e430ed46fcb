// Joint moves that begin at once and replace the motion.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "controller/base/timebase.hpp"
#include "tests/controller/support/controller_rig.hpp"
#include "tests/controller/support/path_rig.hpp"
#include "tests/controller/support/retarget_rig.hpp"
#include "tests/controller/support/robots.hpp"

namespace armature {
namespace {

using test::ControllerRig;
using test::degrees;
using test::expect_limits;
using test::kDeg;
using test::kPathLimits;
using test::now_to;
using test::robot_to_retarget;

constexpr std::int64_t kSecondTicks = 20'000;

TEST(Retarget, ReplacesTheMoveInMotionWithoutAStop) {
  ControllerRig rig{robot_to_retarget()};
  rig.submit_at(10, JointMove{.target = degrees({60, 0, 0, 0, 0, 0}), .tag = 1});
  rig.submit_at(6'000, now_to({70, 30, 0, 0, 0, 0}, 2));
  rig.run(2 * kSecondTicks);
  EXPECT_TRUE(rig.refusals.empty());
  ASSERT_EQ(rig.finished.size(), 2u);
  EXPECT_EQ(rig.finished[0].how, MoveFinished::How::kCutShort);
  EXPECT_EQ(rig.finished[0].tag, Tag{1});
  EXPECT_EQ(rig.finished[1].how, MoveFinished::How::kReachedEnd);
  EXPECT_EQ(rig.finished[1].taken, rig.moves[1].duration);
  EXPECT_LE(rig.moves[1].start_tick, Ticks{6'005});
  rig.expect_at({70, 30, 0, 0, 0, 0});
  expect_limits(rig, "over a joint move");
  // Joint 1 is the slowest. It keeps its 120 deg/s and brakes with 600 deg/s^2: the optimum, rounded up to whole ticks.
  const long double way = 70.0L - rig.row(rig.moves[1].start_tick.value() - 1).reference[0].value() / kDeg;
  const long double optimum = (way - 120.0L * 120 / (2 * 600)) / 120 + 120.0L / 600;
  const auto ticks = static_cast<long double>(rig.moves[1].duration.value());
  EXPECT_GE(ticks, optimum * kSecondTicks - 1e-3L);
  EXPECT_LT(ticks, optimum * kSecondTicks + 1);
  rig.expect_pulses_conserved();
}

TEST(Retarget, DropsTheMovesThatCameBeforeAndKeepsThoseThatComeAfter) {
  ControllerRig rig{robot_to_retarget()};
  for (std::uint32_t tag = 1; tag < 14; ++tag) {  // planned, and waiting for room
    rig.submit_at(10, JointMove{.target = degrees({10.0 * (tag % 2), 20, -30, 0, 40, 0}), .tag = tag});
  }
  CartesianMove line{.target = {.frame = kToolFrame, .position_mm = {0, 10, 0}}, .tag = 14};
  line.limits = kPathLimits;
  rig.submit_at(10, line);
  rig.submit_at(3'000, now_to({5, 20, -30, 0, 40, 0}, 50));
  rig.submit_at(3'000, JointMove{.target = degrees({-5, 20, -30, 0, 40, 0}), .tag = 51});
  rig.run(3 * kSecondTicks);
  EXPECT_TRUE(std::ranges::all_of(rig.refusals, [](const MoveRefused& r) { return r.reason == Refusal::kReplaced; }));
  EXPECT_EQ(rig.refusals.size() + rig.moves.size(), 16u);
  ASSERT_GE(rig.moves.size(), 2u);
  EXPECT_EQ(rig.moves[rig.moves.size() - 2].tag, Tag{50});
  EXPECT_EQ(rig.moves.back().tag, Tag{51});
  rig.expect_at({-5, 20, -30, 0, 40, 0});
}

TEST(Retarget, ThatCannotStopBeforeASoftLimitIsRefusedAndEverythingGoesOn) {
  RobotModel robot = robot_to_retarget();
  ControllerRig rig{robot};
  rig.submit_at(10, JointMove{.target = degrees({170, 0, 0, 0, 0, 0}), .tag = 1});
  rig.submit_at(20, JointMove{.target = degrees({160, 0, 0, 0, 0, 0}), .tag = 2});
  JointMove late = now_to({165, 0, 0, 120, 0, 0}, 3);
  late.profile = ProfileKind::kSCurve;
  // 170 deg take 1.62 s; joint 1 brakes for the last 0.2 s.
  rig.submit_at(10 + kSecondTicks * 152 / 100, late);
  rig.run(3 * kSecondTicks);
  ASSERT_EQ(rig.refusals.size(), 1u);
  EXPECT_EQ(rig.refusals[0].reason, Refusal::kOutsideLimits);
  EXPECT_EQ(rig.refusals[0].axis, 1);
  EXPECT_EQ(rig.refusals[0].tag, Tag{3});
  EXPECT_EQ(rig.moves_finished(), 2);
  rig.expect_at({160, 0, 0, 0, 0, 0});
}

TEST(Retarget, WaitsInAHoldAndForTheRestOfAStop) {
  for (const bool stop : {false, true}) {
    ControllerRig rig{robot_to_retarget()};
    rig.move_at(10, {60, 0, 0, 0, 0, 0});
    rig.submit_at(5'000, stop ? Command{Stop{}} : Command{Hold{}});
    rig.submit_at(5'001, now_to({0, 0, 30, 0, 0, 0}));
    rig.submit_at(kSecondTicks, Resume{});
    rig.run(3 * kSecondTicks);
    EXPECT_TRUE(rig.refusals.empty());
    ASSERT_EQ(rig.moves.size(), 2u);
    const auto begin = static_cast<double>(rig.moves[1].start_tick.value());
    EXPECT_NEAR(begin, stop ? 9'000.0 : kSecondTicks, 200.0);  // 120 deg/s brake in 0.2 s
    expect_limits(rig, stop ? "stop" : "hold");
    rig.expect_at({0, 0, 30, 0, 0, 0});
  }
}

TEST(Retarget, OfSeveralThatComeTogetherTheLastOneIsFollowed) {
  ControllerRig rig{robot_to_retarget()};
  rig.move_at(10, {60, 0, 0, 0, 0, 0});
  rig.submit_at(5'000, now_to({0, 10, 0, 0, 0, 0}, 1));
  rig.submit_at(5'000, now_to({0, 20, 0, 0, 0, 0}, 2));
  rig.run(3 * kSecondTicks);
  ASSERT_EQ(rig.refusals.size(), 1u);
  EXPECT_EQ(rig.refusals[0].reason, Refusal::kReplaced);
  EXPECT_EQ(rig.refusals[0].tag, Tag{1});
  rig.expect_at({0, 20, 0, 0, 0, 0});
}

TEST(Retarget, IsRefusedDuringAJogAndInAFault) {
  ControllerRig rig{robot_to_retarget()};
  Jog jog{.duration = Ticks{5'000}};
  jog.joint_rad_s[0] = 0.1;
  rig.submit_at(10, jog);
  rig.submit_at(2'000, now_to({10, 0, 0, 0, 0, 0}, 1));
  rig.at(15'000, [&] { rig.logic.pins.drive_alarm = 1; });
  rig.submit_at(15'010, now_to({10, 0, 0, 0, 0, 0}, 2));
  rig.run(kSecondTicks);
  ASSERT_EQ(rig.refusals.size(), 2u);
  for (const MoveRefused& refused : rig.refusals) EXPECT_EQ(refused.reason, Refusal::kNotReady);
  EXPECT_TRUE(rig.moves.empty());
}

}  // namespace
}  // namespace armature
