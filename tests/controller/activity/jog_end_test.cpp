// How a jog ends, and what is reported about it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "controller/activity/move_checks.hpp"
#include "controller/base/timebase.hpp"
#include "tests/controller/support/controller_rig.hpp"
#include "tests/controller/support/robots.hpp"
#include "tests/controller/support/six_r_rig.hpp"

namespace armature {
namespace {

using test::ControllerRig;
using test::kDeg;

constexpr std::int64_t kTicksPerSecond = 20'000;

Jog jog_of(std::size_t axis, double deg_s, std::int64_t ticks) {
  Jog jog{.duration = Ticks{ticks}};
  jog.joint_rad_s[axis] = deg_s * kDeg;
  return jog;
}

const JogEnded& only_end(const ControllerRig& rig) {
  static const JogEnded kNone{};
  EXPECT_EQ(rig.jogs.size(), 1u);
  EXPECT_EQ(rig.jogs_ended.size(), 1u);
  return rig.jogs_ended.empty() ? kNone : rig.jogs_ended.front();
}

// The tick of the last change of the reference before `end`.
std::int64_t last_motion(const ControllerRig& rig, std::int64_t end) {
  while (end > 1 && rig.row(end).reference == rig.row(end - 1).reference) --end;
  return end;
}

TEST(JogEnds, ByTheDurationOfItsOnlyCommand) {
  ControllerRig rig;
  Jog jog = jog_of(1, 10, kTicksPerSecond / 2);
  jog.tag = 7;
  rig.submit_at(10, jog);
  rig.run(kTicksPerSecond);
  const JogEnded& end = only_end(rig);
  EXPECT_EQ(end.how, JogEnd::kDuration);
  EXPECT_EQ(end.axis, 0);
  EXPECT_EQ(end.commands, 1u);
  EXPECT_EQ(end.tag, Tag{7});
  EXPECT_EQ(rig.jogs[0].tag, Tag{7});
  EXPECT_EQ(end.tick.value(), last_motion(rig, std::ssize(rig.rows) - 1));
  EXPECT_EQ(end.taken, end.tick - rig.jogs[0].tick + Ticks{1});
}

TEST(JogEnds, ByATimeOutWhenItsCommandsStopComing) {
  ControllerRig rig;
  for (int i = 0; i < 5; ++i) rig.submit_at(10 + 500 * i, jog_of(1, 10, 1'000));
  rig.run(kTicksPerSecond);
  EXPECT_EQ(only_end(rig).how, JogEnd::kTimeOut);
  EXPECT_EQ(only_end(rig).commands, 5u);
}

TEST(JogEnds, ByACommandWithoutAVelocity) {
  ControllerRig rig;
  rig.submit_at(10, jog_of(1, 10, kTicksPerSecond));
  rig.submit_at(1'000, jog_of(1, 0, kTicksPerSecond));
  rig.run(kTicksPerSecond);
  EXPECT_EQ(only_end(rig).how, JogEnd::kReleased);
  EXPECT_LT(only_end(rig).tick, Ticks{2'000});
}

TEST(JogEnds, AtASoftLimitExactlyWithTheNumberOfTheJoint) {
  for (const ProfileKind profile : {ProfileKind::kTrapezoid, ProfileKind::kSCurve}) {
    RobotModel robot = test::paper_robot();
    for (AxisModel& axis : robot.axes) axis.max_jerk_rad_s3 = 6'000 * kDeg;
    ControllerRig rig{robot};
    rig.move_at(10, {0, 0, 160, 0, 0, 0});
    Jog jog = jog_of(2, 60, kTicksPerSecond);
    jog.profile = profile;
    rig.submit_at(2 * kTicksPerSecond, jog);
    rig.run(4 * kTicksPerSecond);
    EXPECT_EQ(only_end(rig).how, JogEnd::kLimit);
    EXPECT_EQ(only_end(rig).axis, 3);
    EXPECT_EQ(rig.last().reference[2].value(), robot.axes[2].max_rad);
    for (const Telemetry& row : rig.rows) ASSERT_LE(row.reference[2].value(), robot.axes[2].max_rad);
  }
}

TEST(JogEnds, ByAStopOrAHoldOfWhichTheHoldKeepsTheAccelerationOfTheJog) {
  const auto braking_ticks = [](const Command& command, JogEnd how) {
    ControllerRig rig;
    Jog jog = jog_of(1, 60, kTicksPerSecond);
    jog.accel_share = 0.25;
    rig.submit_at(10, jog);
    rig.submit_at(kTicksPerSecond * 3 / 4, command);
    rig.run(2 * kTicksPerSecond);
    EXPECT_EQ(only_end(rig).how, how);
    return only_end(rig).tick.value() - kTicksPerSecond * 3 / 4;
  };
  // 60 deg/s with 600 deg/s^2, and with a quarter of it.
  EXPECT_NEAR(static_cast<double>(braking_ticks(Stop{}, JogEnd::kStop)), 0.1 * kTicksPerSecond, 3.0);
  EXPECT_NEAR(static_cast<double>(braking_ticks(Hold{}, JogEnd::kHold)), 0.4 * kTicksPerSecond, 3.0);
}

TEST(JogEnds, InTheTickOfAFaultAndOnce) {
  ControllerRig rig;
  rig.submit_at(10, jog_of(1, 60, kTicksPerSecond));
  rig.at(5'000, [&] { rig.logic.pins.estop_n = false; });
  rig.run(kTicksPerSecond);
  ASSERT_EQ(rig.faults.size(), 1u);
  EXPECT_EQ(rig.faults[0].cause, FaultCause::kEstop);
  EXPECT_EQ(only_end(rig).how, JogEnd::kFault);
  EXPECT_EQ(only_end(rig).tick, rig.faults[0].tick);
}

TEST(JogEnds, OfTheToolAtTheReachAndAtASoftLimit) {
  RobotModel robot = test::robot_with(test::irb120_geometry());
  for (const bool at_limit : {false, true}) {
    if (at_limit) robot.axes[0].max_rad = 12 * kDeg;
    ControllerRig rig{robot};
    rig.move_at(10, {0, 20, -30, 0, 40, 0});
    Jog jog{.kind = Jog::Kind::kTool, .duration = Ticks{4 * kTicksPerSecond}};
    jog.move_mm_s = at_limit ? Eigen::Vector3d{0, 80, 0} : Eigen::Vector3d{150, 0, 0};
    rig.submit_at(2 * kTicksPerSecond, jog);
    rig.run(8 * kTicksPerSecond);
    EXPECT_EQ(only_end(rig).how, at_limit ? JogEnd::kLimit : JogEnd::kCannotFollow);
    EXPECT_EQ(only_end(rig).axis, at_limit ? 1 : 0);
    rig.expect_pulses_conserved();
  }
}

TEST(JogEnds, OfARefusedCommandAreNotReported) {
  ControllerRig rig;
  rig.move_at(10, {10, 0, 0, 0, 0, 0});
  rig.submit_at(1'000, jog_of(1, 10, 100));
  rig.run(kTicksPerSecond);
  EXPECT_EQ(rig.refusals.size(), 1u);
  EXPECT_TRUE(rig.jogs.empty());
  EXPECT_TRUE(rig.jogs_ended.empty());
}

TEST(JogEnds, WhereItWouldWithoutAnOverride) {
  const auto end_of = [](bool with_override) {
    ControllerRig rig;
    if (with_override) rig.submit_at(5, SetOverride{.share = 0.5});
    rig.submit_at(10, jog_of(1, 60, kTicksPerSecond / 2));
    rig.run(kTicksPerSecond);
    return rig.last().reference;
  };
  EXPECT_EQ(end_of(true), end_of(false));
}

TEST(JogEnds, WithALimitedJerkForAnSCurve) {
  RobotModel robot = test::paper_robot();
  for (AxisModel& axis : robot.axes) axis.max_jerk_rad_s3 = 6'000 * kDeg;
  const auto peak_jerk = [&](ProfileKind profile) {
    ControllerRig rig{robot};
    Jog jog = jog_of(0, 60, kTicksPerSecond / 2);
    jog.profile = profile;
    rig.submit_at(10, jog);
    rig.run(kTicksPerSecond);
    double peak = 0.0;
    for (std::size_t k = 3; k < rig.rows.size(); ++k) {
      const auto q = [&](std::size_t back) { return rig.rows[k - back].reference[0].value(); };
      peak = std::max(peak, std::fabs(q(0) - 3 * q(1) + 3 * q(2) - q(3)));
    }
    return peak / (kTickSeconds * kTickSeconds * kTickSeconds);
  };
  EXPECT_LE(peak_jerk(ProfileKind::kSCurve), 1.001 * robot.axes[0].max_jerk_rad_s3 + 0.1);
  EXPECT_GT(peak_jerk(ProfileKind::kTrapezoid), 100 * robot.axes[0].max_jerk_rad_s3);
}

TEST(JogEnds, BeforeItBeginsIfItsLimitsAreNotValid) {
  RobotModel robot = test::robot_with(test::irb120_geometry());
  const auto reason = [&](const Jog& jog) { return find_refusal(robot, {}, jog)->reason; };
  Jog joints = jog_of(1, 10, 100);
  for (const double share : {0.0, -1.0, 1.5, std::nan("")}) {
    joints.accel_share = share;
    EXPECT_EQ(reason(joints), Refusal::kInvalidTarget);
  }
  joints.accel_share = 1.0;
  joints.profile = ProfileKind::kSCurve;
  EXPECT_EQ(reason(joints), Refusal::kNoJerkLimit);
  Jog tool{.kind = Jog::Kind::kTool, .move_mm_s = {1, 0, 0}, .duration = Ticks{1}};
  EXPECT_FALSE(find_refusal(robot, {}, tool));
  tool.profile = ProfileKind::kSCurve;
  EXPECT_EQ(reason(tool), Refusal::kInvalidTarget);
  tool.tool.jerk_mm_s3 = tool.tool.turn_jerk_rad_s3 = 100;
  EXPECT_FALSE(find_refusal(robot, {}, tool));
  tool.tool.accel_mm_s2 = 0;
  EXPECT_EQ(reason(tool), Refusal::kInvalidTarget);
}

}  // namespace
}  // namespace armature
