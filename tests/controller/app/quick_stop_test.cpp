// A quick stop brakes with the full acceleration of the joints, whatever moves the arm and whatever brakes it already.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "controller/base/timebase.hpp"
#include "tests/controller/support/controller_rig.hpp"
#include "tests/controller/support/conveyor_rig.hpp"
#include "tests/controller/support/homing_rig.hpp"
#include "tests/controller/support/path_rig.hpp"

namespace armature {
namespace {

using test::ControllerRig;
using test::kDeg;

// An arm in motion at the trigger `stop_at`.
struct MovingArm {
  std::shared_ptr<void> owner;
  ControllerRig* rig = nullptr;
  std::int64_t stop_at = 0;
};
struct StopCase {
  std::string name;
  std::function<MovingArm()> begin;
  bool soft_is_gentle = true;  // a soft stop brakes with less
};

MovingArm arm_with(const std::vector<Command>& commands, std::int64_t stop_at = 8'000) {
  auto rig =
      std::make_shared<ControllerRig>(test::irb120(), ControllerConfig{.flange_T_tool = {.position_mm = {0, 0, 100}}});
  rig->submit_at(10, JointMove{.target = test::degrees({0, 10, 20, 0, 60, 0})});
  std::int64_t at = 6'000;
  for (const Command& command : commands) rig->submit_at(at++, command);
  return {rig, rig.get(), stop_at};
}

constexpr PathLimits kSlowBrake{.speed_mm_s = 100.0,
                                .accel_mm_s2 = 150.0,
                                .jerk_mm_s3 = 3'000.0,
                                .turn_speed_rad_s = 1.0,
                                .turn_accel_rad_s2 = 1.0,
                                .turn_jerk_rad_s3 = 20.0,
                                .joint_accel = 1.0};

MovingArm along_path(ProfileKind profile, bool program) {
  CartesianMove line{.target = {.frame = kToolFrame, .position_mm = {0, 200, 0}}};
  line.limits = kSlowBrake;
  line.profile = profile;
  MovingArm arm = arm_with({}, 14'000);
  if (!program) {
    arm.rig->submit_at(6'000, line);
  } else {
    arm.rig->at(6'000, [rig = arm.rig, line] { EXPECT_TRUE(rig->submit_program(line)); });
  }
  return arm;
}

MovingArm with_joint_move(JointMove move) {
  move.target = test::degrees({60, 10, 20, 0, 60, 0});
  move.speed = 0.1;
  move.accel = 0.02;
  return arm_with({move}, 12'000);
}

MovingArm with_stream(ProfileKind profile) {
  MovingArm arm = arm_with({});
  for (std::int64_t i = 0; i <= 500; ++i) {
    const double share = static_cast<double>(i) / 500.0;
    const double deg = 1.5 * (1.0 - std::cos(2.0 * std::numbers::pi * share));
    arm.rig->submit_at(6'000 + 20 * i, StreamPoint{.first = i == 0,
                                                   .last = i == 500,
                                                   .joints = test::degrees({deg, 10, 20, 0, 60, 0}),
                                                   .time = Ticks{20 * i},
                                                   .delay = Ticks{50},
                                                   .profile = profile,
                                                   .tag = 7u});
  }
  return arm;
}

MovingArm with_homing() {
  auto homing = std::make_shared<test::HomingRig>();
  for (auto& world : homing->worlds) world.start_deg = 20.16;
  homing->rig.submit_at(10, Home{.axes = 1, .tag = 7u});
  return {homing, &homing->rig, 3'000};
}

MovingArm arm_at_conveyor() {
  auto belt = std::make_shared<test::conveyor::ConveyorRig>(test::conveyor::hundred);
  belt->pick();
  belt->leave();
  return {belt, &belt->rig, 0};
}

// The trigger at which the arm at the conveyor has entered a phase, of a run without a stop.
std::int64_t begin_of(PartPhase phase) {
  static const std::vector<PartFollowed> parts = [] {
    const MovingArm arm = arm_at_conveyor();
    arm.rig->run(5 * test::conveyor::kSecond);
    return arm.rig->parts;
  }();
  const auto found = std::ranges::find(parts, phase, &PartFollowed::phase);
  EXPECT_NE(found, parts.end());
  return found == parts.end() ? 0 : found->tick.value();
}

// While the arm follows the part, or while it leaves it.
MovingArm arm_at_phase(PartPhase phase) {
  MovingArm arm = arm_at_conveyor();
  arm.stop_at = begin_of(phase) + 100;
  return arm;
}

std::vector<StopCase> stop_cases() {
  using P = ProfileKind;
  const auto joint_jog = [](P profile) {
    return arm_with(
        {Jog{.joint_rad_s = {0.5, 0, 0, 0, 0, 0}, .duration = Ticks{40'000}, .profile = profile, .accel_share = 0.02}});
  };
  const auto tool_jog = [](P profile) {
    return arm_with(
        {Jog{
            .kind = Jog::Kind::kTool,
            .move_mm_s = {0, 100, 0},
            .duration = Ticks{40'000},
            .profile = profile,
            .tool = {.accel_mm_s2 = 200.0, .turn_accel_rad_s2 = 1.0, .jerk_mm_s3 = 3'000.0, .turn_jerk_rad_s3 = 20.0}}},
        16'000);
  };
  return {
      {"JointJog", [=] { return joint_jog(P::kTrapezoid); }},
      {"SmoothJointJog", [=] { return joint_jog(P::kSCurve); }},
      {"ToolJog", [=] { return tool_jog(P::kTrapezoid); }},
      {"SmoothToolJog", [=] { return tool_jog(P::kSCurve); }},
      {"Stream", [] { return with_stream(P::kTrapezoid); }, false},
      {"SmoothStream", [] { return with_stream(P::kSCurve); }},
      {"Homing", with_homing, false},
      {"FollowedPart", [] { return arm_at_phase(PartPhase::kSynchronised); }, false},
      {"LeftPart", [] { return arm_at_phase(PartPhase::kLeaving); }},
      {"Path", [] { return along_path(P::kTrapezoid, false); }},
      {"SmoothPath", [] { return along_path(P::kSCurve, false); }},
      {"PathOfAProgram", [] { return along_path(P::kTrapezoid, true); }},
      {"JointMove", [] { return with_joint_move({}); }, false},
      {"SmoothJointMove", [] { return with_joint_move({.profile = P::kSCurve}); }},
      {"JointMoveAtOnce", [] { return with_joint_move({.now = true}); }, false},
  };
}

// Ticks from a trigger to the last motion of a joint.
std::int64_t ticks_to_rest(const ControllerRig& rig, std::int64_t from) {
  auto last = static_cast<std::int64_t>(rig.rows.size()) - 1;
  while (last > from && rig.row(last).reference == rig.row(last - 1).reference) --last;
  return last - from;
}

// Ticks in which every joint alone stops with its full acceleration.
double fastest_stop(const ControllerRig& rig, std::int64_t from) {
  double ticks = 0.0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const double step_rad = (rig.row(from).reference[axis] - rig.row(from - 1).reference[axis]).value();
    const double change_rad = rig.robot.axes[axis].max_accel_rad_s2 * kTickSeconds * kTickSeconds;
    ticks = std::max(ticks, std::fabs(step_rad) / change_rad);
  }
  return ticks;
}

constexpr std::int64_t kAfterSoft = 8;  // ticks
constexpr std::int64_t kRest = 6'000;
// A joint that begins to brake where its acceleration is along its velocity needs some ticks more. On a path the joints
// wait for the slowest one.
constexpr double kMaxOfFastest = 1.6, kMoreTicks = 8.0;

struct QuickStop : testing::TestWithParam<std::size_t> {
  // Ticks to rest after `later`, as a share of those that the joints need.
  static double stops(const StopCase& tested, const std::vector<Command>& earlier, const std::vector<Command>& later) {
    MovingArm arm = tested.begin();
    for (const Command& command : earlier) arm.rig->submit_at(arm.stop_at, command);
    const std::int64_t at = arm.stop_at + kAfterSoft;
    for (const Command& command : later) arm.rig->submit_at(at, command);
    arm.rig->run(at + kRest);
    const double fastest = fastest_stop(*arm.rig, at);
    EXPECT_GT(fastest, 5.0) << "the arm hardly moves";
    EXPECT_TRUE(arm.rig->faults.empty());
    return (static_cast<double>(ticks_to_rest(*arm.rig, at)) - kMoreTicks) / fastest;
  }
};

TEST_P(QuickStop, BrakesWithFullAccelerationAlsoBehindASoftStopOrAHold) {
  const StopCase tested = stop_cases()[GetParam()];
  const Stop quick{}, soft{.kind = Stop::Kind::kSoft};
  EXPECT_LE(stops(tested, {}, {quick}), kMaxOfFastest);
  EXPECT_LE(stops(tested, {soft}, {quick}), kMaxOfFastest);
  EXPECT_LE(stops(tested, {Hold{}}, {quick}), kMaxOfFastest);
  EXPECT_LE(stops(tested, {Hold{}, soft}, {quick}), kMaxOfFastest);
  if (!tested.soft_is_gentle) return;
  EXPECT_GT(stops(tested, {soft}, {}), 2.0 * kMaxOfFastest) << "a soft stop is hardly softer";
}

TEST_P(QuickStop, IsNotSoftenedByALaterOne) {
  const StopCase tested = stop_cases()[GetParam()];
  MovingArm arm = tested.begin();
  arm.rig->submit_at(arm.stop_at, Stop{});
  arm.rig->submit_at(arm.stop_at + 2, Stop{.kind = Stop::Kind::kSoft});
  arm.rig->submit_at(arm.stop_at + 3, Hold{});
  arm.rig->run(arm.stop_at + kRest);
  const double fastest = fastest_stop(*arm.rig, arm.stop_at);
  EXPECT_LE(static_cast<double>(ticks_to_rest(*arm.rig, arm.stop_at)), kMaxOfFastest * fastest + kMoreTicks);
}

INSTANTIATE_TEST_SUITE_P(Sources, QuickStop, testing::Range<std::size_t>(0, stop_cases().size()),
                         [](const auto& test) { return stop_cases()[test.param].name; });

}  // namespace
}  // namespace armature
