#include "tests/bench/tick_scripts.hpp"

#include <cmath>
#include <utility>
#include <variant>
#include <vector>

#include "tests/controller/support/path_rig.hpp"

namespace armature::bench {
namespace {

constexpr PathLimits kLimits{.speed_mm_s = 250.0,
                             .accel_mm_s2 = 2'500.0,
                             .jerk_mm_s3 = 50'000.0,
                             .turn_speed_rad_s = 1.5,
                             .turn_accel_rad_s2 = 15.0,
                             .turn_jerk_rad_s3 = 300.0};
const PerAxis<double> kPostureDeg{10, 20, 10, 5, 40, -20};
const Transform kTool{.rotation = rotation_from_rpy(0.1, -0.2, 0.3), .position_mm = {5, -3, 80}};

CartesianMove shift(double x_mm, double y_mm, double z_mm, double blend_mm = 0.0) {
  return {.target = {.frame = kToolFrame, .position_mm = {x_mm, y_mm, z_mm}}, .limits = kLimits, .blend_mm = blend_mm};
}
CartesianMove curved_arc() {
  CartesianMove arc = shift(40, 40, 0);
  arc.kind = SegmentRequest::Kind::kArc;
  arc.via_mm = {28.3, 11.7, 0};
  arc.target.rotation = rotation_from_rpy(0.2, 0.1, 0.3);
  arc.profile = ProfileKind::kSCurve;
  return arc;
}

TickScript six_axes(std::size_t ticks, const std::vector<Command>& at_the_posture) {
  TickScript script{.robot = test::irb120(), .flange_T_tool = kTool, .commands = {}, .ticks = ticks};
  script.commands.emplace_back(1, JointMove{.target = test::degrees(kPostureDeg)});
  for (const Command& command : at_the_posture) script.commands.emplace_back(kThere, command);
  return script;
}

}  // namespace

TickScript idle() {
  return {.robot = test::irb120(), .flange_T_tool = kTool, .commands = {}, .ticks = 5'000};
}
TickScript joint_move() {
  return six_axes(25'000, {JointMove{.target = test::degrees({-60, -20, 40, 60, -40, 150}), .speed = 0.5}});
}
TickScript joint_scurve() {
  return six_axes(25'000, {JointMove{.target = test::degrees({-60, -20, 40, 60, -40, 150}),
                                     .speed = 0.5,
                                     .profile = ProfileKind::kSCurve}});
}
TickScript line() {
  return six_axes(15'000, {shift(30, 40, -50)});
}
TickScript corners() {
  return six_axes(25'000, {shift(40, 0, 0, 8), shift(0, 40, 0, 8), shift(-40, 0, 0, 8), shift(0, -40, 0)});
}
TickScript arc() {
  return six_axes(20'000, {curved_arc()});
}
TickScript short_lines() {
  constexpr std::size_t kLines = 1'500;
  constexpr double kRadius_mm = 30.0, kStep_mm = 0.3;
  TickScript script = six_axes(90'000, {});
  script.commands.emplace_back(kThere, SetOverride{});
  const Transform from = Arm{script.robot}.forward(test::degrees(kPostureDeg)) * kTool;
  for (std::size_t i = 1; i <= kLines; ++i) {
    const double angle = kStep_mm / kRadius_mm * static_cast<double>(i);
    CartesianMove line = shift(0, 0, 0, i == kLines ? 0.0 : 0.02);
    line.target = {.position_mm =
                       from.position_mm + kRadius_mm * Eigen::Vector3d{0.0, std::sin(angle), 1.0 - std::cos(angle)}};
    line.limits.speed_mm_s = 200.0;
    script.program.emplace_back(line);
  }
  return script;
}
TickScript holds() {
  TickScript script = arc();
  for (std::size_t tick = kThere + 300; tick < kThere + 12'000; tick += 800) {
    script.commands.emplace_back(tick, Hold{});
    script.commands.emplace_back(tick + 400, Resume{});
  }
  script.ticks = 30'000;
  return script;
}
TickScript five_axis_line() {
  TickScript script{.robot = test::hu2012(1e-4), .flange_T_tool = {}, .commands = {}, .ticks = 15'000};
  script.commands.emplace_back(1, JointMove{.target = test::degrees({20, 40, -60, -50, 30, 0})});
  script.commands.emplace_back(kThere, shift(0, 0, -40));
  return script;
}

bool all(const TickRun&, std::size_t) {
  return true;
}
bool in_lines(const TickRun& run, std::size_t tick) {
  const TickFacts& facts = run.ticks[tick];
  return tick > kThere && facts.state == MotionState::kMoving;
}
bool in_last_move(const TickRun& run, std::size_t tick) {
  return run.ticks[tick].state == MotionState::kMoving &&
         tick >= static_cast<std::size_t>(run.moves.back().start_tick.value());
}
bool in_corners(const TickRun& run, std::size_t tick) {
  const Ticks now{static_cast<std::int64_t>(tick)};
  for (std::size_t i = 2; i < run.moves.size(); ++i) {
    const MoveStarted& before = run.moves[i - 1];
    if (now >= run.moves[i].start_tick && now < before.start_tick + before.duration) return true;
  }
  return false;
}
bool on_ramps(const TickRun& run, std::size_t tick) {
  return run.ticks[tick].rate > 0.0 && run.ticks[tick].rate < 1.0;
}

PathCase path_of(const TickScript& script) {
  const JointAngles& start = std::get<JointMove>(script.commands.at(0).second).target;
  const auto& move = std::get<CartesianMove>(script.commands.at(1).second);
  const Transform base_T_tool = Arm{script.robot}.forward(start) * script.flange_T_tool;
  PathCase path{.robot = script.robot, .flange_T_tool = script.flange_T_tool, .start = start, .request = {}};
  path.request.kind = move.kind;
  path.request.via_mm = base_T_tool * move.via_mm;
  path.request.target.position_mm = base_T_tool * move.target.position_mm;
  path.request.target.rotation = base_T_tool.rotation;
  if (move.target.rotation) path.request.target.rotation *= *move.target.rotation;
  path.request.limits = move.limits;
  path.request.profile = move.profile;
  return path;
}

}  // namespace armature::bench
