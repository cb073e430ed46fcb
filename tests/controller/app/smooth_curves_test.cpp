// Long curves of short lines, through a core 1 that takes its time to plan them: the arm stops only at their end,
// unless they come late or core 1 is far too slow.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "controller/language/gcode/run/program_runner.hpp"
#include "tests/controller/support/draws.hpp"
#include "tests/controller/support/path_rig.hpp"
#include "tests/controller/support/two_cores.hpp"

namespace armature {
namespace {

using test::kDeg;

// With the accelerations of scenarios/robots/abb_irb120.toml, which are a sixth: the joints slow the tool down.
RobotModel slow_irb120() {
  RobotModel robot = test::irb120();
  const PerAxis<double> accel_deg_s2{1'000, 1'000, 1'000, 1'600, 1'600, 2'100};
  for (std::size_t axis = 0; axis < kAxes; ++axis) robot.axes[axis].max_accel_rad_s2 = accel_deg_s2[axis] * kDeg;
  return robot;
}

// Around the origin of the frame, with a radius that waves.
struct Curve {
  double step_mm = 0.2, radius_mm = 40.0, wave_mm = 3.0, wave_length_mm = 6.0, phase = 0.0;
  std::size_t count = 600;
  double speed_mm_s = 100.0, accel_mm_s2 = 2'000.0, blend_mm = 0.02;

  [[nodiscard]] Eigen::Vector3d at(std::size_t i) const {
    const double s = step_mm * static_cast<double>(i), r = radius_mm + wave_mm * std::sin(s / wave_length_mm + phase);
    return {r * std::cos(s / radius_mm), r * std::sin(s / radius_mm), 0.0};
  }
};

std::ostream& operator<<(std::ostream& out, const Curve& curve) {
  return out << curve.count << " lines of " << curve.step_mm << " mm at " << curve.speed_mm_s << " mm/s, radius "
             << curve.radius_mm << " + " << curve.wave_mm << " sin(s / " << curve.wave_length_mm << " + " << curve.phase
             << ") mm";
}

Curve random_curve(test::Random& random) {
  Curve curve;
  curve.step_mm = random.real(0.15, 0.4);
  curve.radius_mm = random.real(25.0, 50.0);
  curve.wave_mm = random.real(0.0, 4.0);
  curve.wave_length_mm = random.real(5.0, 12.0);
  curve.phase = random.real(0.0, 2.0 * test::kPi);
  curve.count = static_cast<std::size_t>(random.integer(300, 700));
  curve.speed_mm_s = random.real(50.0, 150.0);
  return curve;
}

constexpr std::int64_t kMaxTicks = 400'000;
// Cycles for an inverse kinematics. With the default of 350 the arm draws some of the curves faster than core 1 plans.
constexpr std::int64_t kFast = 150, kSlow = 1'500;

struct SmoothCurves : testing::Test {
  // A table in front of the arm, tilted by 45 degrees, and a pen.
  SmoothCurves() {
    config.flange_T_tool.position_mm.z() = 100.0;
    config.base_T_user[0] =
        Transform{Eigen::AngleAxisd{-45.0 * kDeg, Eigen::Vector3d::UnitY()}.toRotationMatrix(), {430.0, 0.0, 430.0}};
  }
  [[nodiscard]] JointAngles joints_at(const Eigen::Vector3d& place_mm) const {
    const Eigen::Matrix3d down = Eigen::AngleAxisd{180.0 * kDeg, Eigen::Vector3d::UnitY()}.toRotationMatrix();
    const Transform pose = *config.base_T_user[0] * Transform{down, place_mm};
    const IkSolutions found = Arm{robot}.inverse(pose * inverse(config.flange_T_tool), {});
    EXPECT_GE(found.selected, 0);
    return found.branches[static_cast<std::size_t>(std::max<int>(found.selected, 0))].joints;
  }
  [[nodiscard]] std::unique_ptr<test::TwoCores> cores_at_start_of(const Curve& curve) const {
    auto cores = std::make_unique<test::TwoCores>(robot, config, joints_at(curve.at(0)));
    cores->cost.inverse_compute_cycles = kFast;
    return cores;
  }
  static void expect_no_stop(test::TwoCores& cores, const Curve& curve) {
    EXPECT_TRUE(cores.run(kMaxTicks));
    EXPECT_TRUE(cores.refused.empty());
    ASSERT_EQ(cores.finished.size(), curve.count);
    for (std::size_t i = 1; i < cores.started.size(); ++i) {
      EXPECT_TRUE(cores.started[i].continues) << "a stop before line " << i + 1;
      EXPECT_FALSE(cores.started[i].unasked_stop) << "before line " << i + 1;
    }
  }

  [[nodiscard]] std::unique_ptr<test::TwoCores> cores_with_moves(const Curve& curve) const {
    auto cores = cores_at_start_of(curve);
    for (std::size_t i = 1; i <= curve.count; ++i) {
      CartesianMove line;
      line.target = {.frame = FrameId{1}, .position_mm = curve.at(i)};
      line.limits = {.speed_mm_s = curve.speed_mm_s,
                     .accel_mm_s2 = curve.accel_mm_s2,
                     .turn_speed_rad_s = 3.0,
                     .turn_accel_rad_s2 = 30.0};
      line.blend_mm = i == curve.count ? 0.0 : curve.blend_mm;
      line.tag = Tag{Source::kProgram, static_cast<std::uint32_t>(i)};
      cores->commands.emplace_back(line);
    }
    cores->is_over = [&cores = *cores, curve] { return cores.finished.size() == curve.count; };
    return cores;
  }
  void expect_no_stop_of_moves(const Curve& curve) const { expect_no_stop(*cores_with_moves(curve), curve); }
  void expect_no_stop_of_gcode(const Curve& curve) const {
    const auto cores = cores_at_start_of(curve);
    std::string text =
        "G21 G90 G64 P" + std::to_string(curve.blend_mm) + " F" + std::to_string(60.0 * curve.speed_mm_s) + "\n";
    for (std::size_t i = 1; i <= curve.count; ++i) {
      text += "G1 X" + std::to_string(curve.at(i).x()) + " Y" + std::to_string(curve.at(i).y()) + " Z0\n";
    }
    text += "M2\n";
    gcode::MotionSetup setup{.cell = {.robot = cores->robot, .arm = cores->arm}};
    setup.cell.flange_T_tool = config.flange_T_tool;
    setup.cell.base_T_user = config.base_T_user;
    setup.settings.frame = FrameId{1};
    setup.settings.accel_mm_s2 = curve.accel_mm_s2;
    const auto runner = std::make_unique<gcode::ProgramRunner>(setup);
    runner->load({.text = text});
    cores->program.set(*runner, Ticks{});
    cores->is_over = [&] { return cores->program.state() == ProgramClient::State::kEnded; };
    expect_no_stop(*cores, curve);
  }

  const RobotModel robot = slow_irb120();
  PlanningConfig config;
};

TEST_F(SmoothCurves, OfAFastCoreAreExecutedWithoutAStop) {
  expect_no_stop_of_moves({});
  expect_no_stop_of_gcode({});
}

TEST_F(SmoothCurves, AtRandomOfAFastCoreAreExecutedWithoutAStop) {
  constexpr std::uint64_t kSeed = 20261126;
  test::Random random{kSeed};
  for (int i = 0; i < test::draws(100); ++i) {
    const Curve curve = random_curve(random);
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", draw " << i << ": " << curve);
    expect_no_stop_of_moves(curve);
    expect_no_stop_of_gcode(curve);
  }
}

// The places of a run, in the order of time, where the set-points stand still.
std::size_t rests_between(const std::vector<JointAngles>& joints) {
  std::vector<std::size_t> moving;
  for (std::size_t i = 1; i < joints.size(); ++i) {
    const auto moves = [&](std::size_t axis) { return joints[i][axis] != joints[i - 1][axis]; };
    bool any = false;
    for (std::size_t axis = 0; axis < kAxes; ++axis) any = any || moves(axis);
    if (any) moving.push_back(i);
  }
  std::size_t rests = 0;
  for (std::size_t i = 1; i < moving.size(); ++i) rests += moving[i] > moving[i - 1] + 1 ? 1 : 0;
  return rests;
}

TEST_F(SmoothCurves, OfAMuchTooSlowCoreStopAndEveryStopIsReported) {
  const auto cores = cores_with_moves({});
  cores->cost.inverse_compute_cycles = kSlow;
  ASSERT_TRUE(cores->run(kMaxTicks));
  ASSERT_TRUE(cores->refused.empty());
  std::size_t stops = 0;
  for (std::size_t i = 1; i < cores->started.size(); ++i) {
    EXPECT_EQ(cores->started[i].unasked_stop, !cores->started[i].continues) << "before line " << i + 1;
    stops += cores->started[i].unasked_stop ? 1 : 0;
  }
  EXPECT_FALSE(cores->started[0].unasked_stop);
  EXPECT_GT(stops, 2u);
  EXPECT_EQ(stops, rests_between(cores->joints));
}

// Lines with rounded corners of at most 150 degrees: nothing in them demands a stop.
std::vector<CartesianMove> random_polygon(test::Random& random) {
  const std::size_t count = static_cast<std::size_t>(random.integer(30, 120));
  const double longest_mm = random.real(1.0, 30.0), sharpest_rad = random.real(10.0, 150.0) * kDeg;
  const PathLimits limits{.speed_mm_s = random.real(20.0, 400.0),
                          .accel_mm_s2 = random.real(500.0, 4'000.0),
                          .turn_speed_rad_s = 3.0,
                          .turn_accel_rad_s2 = 30.0};
  const double blend_mm = random.real(0.02, 1.0);
  std::vector<CartesianMove> lines;
  Eigen::Vector3d place_mm{40.0, 0.0, 0.0};
  double direction_rad = random.real(0.0, 2.0 * test::kPi), time_s = 0.0;
  for (std::size_t i = 1; i <= count; ++i) {
    const double length_mm = random.real(0.5, longest_mm);
    // Back to the middle rather than off the table.
    double turn_rad = random.real(-sharpest_rad, sharpest_rad);
    const auto end_mm = [&] {
      const double angle = direction_rad + turn_rad;
      return Eigen::Vector3d{place_mm.x() + length_mm * std::cos(angle), place_mm.y() + length_mm * std::sin(angle),
                             0.0};
    };
    if (end_mm().norm() > 60.0) turn_rad = -turn_rad;
    time_s += length_mm / limits.speed_mm_s;
    if (i > 2 && (end_mm().norm() > 80.0 || time_s > 2.0)) break;
    place_mm = end_mm();
    direction_rad += turn_rad;
    CartesianMove line;
    line.target = {.frame = FrameId{1}, .position_mm = place_mm};
    line.limits = limits;
    line.blend_mm = blend_mm;
    line.tag = Tag{Source::kProgram, static_cast<std::uint32_t>(i)};
    lines.push_back(line);
  }
  lines.back().blend_mm = 0.0;
  return lines;
}

TEST_F(SmoothCurves, EveryStopInARandomPolygonIsReported) {
  constexpr std::uint64_t kSeed = 20261127;
  test::Random random{kSeed};
  int stops = 0;
  for (int i = 0; i < test::draws(100); ++i) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", draw " << i);
    const std::vector<CartesianMove> lines = random_polygon(random);
    const std::int64_t inverse_cycles = random.integer(0, 1) == 0 ? kFast : kSlow;
    const auto cores = cores_at_start_of({});
    for (const CartesianMove& line : lines) cores->commands.emplace_back(line);
    cores->cost.inverse_compute_cycles = inverse_cycles;
    cores->is_over = [&] { return cores->finished.size() + cores->refused.size() == lines.size(); };
    ASSERT_TRUE(cores->run(kMaxTicks));
    EXPECT_TRUE(cores->refused.empty());
    for (std::size_t k = 1; k < cores->started.size(); ++k) {
      EXPECT_EQ(cores->started[k].unasked_stop, !cores->started[k].continues) << "before line " << k + 1;
      stops += cores->started[k].unasked_stop ? 1 : 0;
    }
  }
  RecordProperty("stops", stops);
  EXPECT_GT(stops, 0);
}

// The arm begins to brake half-way through the lines that it has.
TEST_F(SmoothCurves, OfATooSlowCoreStopUnaskedOnlyIfTheirRestCameBeforeTheArmBraked) {
  constexpr std::size_t kFirst = CartesianPlan::kMaxFirstSegments;
  const auto rest_starts = [this](std::size_t finished) {
    const auto cores = cores_with_moves({.count = 2 * kFirst});
    cores->cost.inverse_compute_cycles = kSlow;
    cores->may_send = [&](std::size_t i) { return i < kFirst || cores->finished.size() >= finished; };
    EXPECT_TRUE(cores->run(kMaxTicks));
    EXPECT_EQ(cores->started.size(), 2 * kFirst);
    return cores->started.at(kFirst);
  };
  const MoveStarted in_time = rest_starts(1), while_braking = rest_starts(kFirst - 1), at_rest = rest_starts(kFirst);
  for (const MoveStarted& move : {in_time, while_braking, at_rest}) EXPECT_FALSE(move.continues);
  EXPECT_TRUE(in_time.unasked_stop);
  EXPECT_FALSE(while_braking.unasked_stop);
  EXPECT_FALSE(at_rest.unasked_stop);
}

}  // namespace
}  // namespace armature
