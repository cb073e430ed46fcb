#include "cosim/scenario/to_controller.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

#include "cosim/scenario/files/robot_loader.hpp"

namespace armature::cosim {
namespace {

TEST(ToController, ConvertsEveryFieldOfAnAxis) {
  RobotSpec robot;
  AxisSpec& axis = robot.axes[4];
  axis.gear_ratio = -81.5;
  axis.pulses_per_rev = 8000;
  axis.encoder_lines = 1024;
  axis.min_deg = -90;
  axis.max_deg = 180;
  axis.max_speed_deg_s = 360;
  axis.max_accel_deg_s2 = 720;
  axis.following_error_deg = 4.5;
  axis.drive.natural_hz = 25;
  axis.drive.damping = 0.75;
  axis.drive.dir_setup_ns = 1000;
  axis.drive.dir_hold_ns = 1000.5;
  axis.drive.min_step_high_ns = 120;
  axis.drive.min_step_low_ns = 121;
  const AxisModel model = to_robot_model(robot).axes[4];
  constexpr double kPi = 3.14159265358979323846;
  EXPECT_EQ(model.gear_ratio, -81.5);
  EXPECT_EQ(model.pulses_per_rev, 8000);
  EXPECT_EQ(model.counts_per_rev, 4096);
  EXPECT_DOUBLE_EQ(model.min_rad, -kPi / 2);
  EXPECT_DOUBLE_EQ(model.max_rad, kPi);
  EXPECT_DOUBLE_EQ(model.max_speed_rad_s, 2 * kPi);
  EXPECT_DOUBLE_EQ(model.max_accel_rad_s2, 4 * kPi);
  EXPECT_DOUBLE_EQ(model.following_error_limit_rad, kPi / 40);
  EXPECT_DOUBLE_EQ(model.drive_natural_rad_s, 50 * kPi);
  EXPECT_EQ(model.drive_damping, 0.75);
  EXPECT_EQ(model.dir_setup_cycles, 50);
  EXPECT_EQ(model.dir_hold_cycles, 51);
  EXPECT_EQ(model.min_step_high_cycles, 6);
  EXPECT_EQ(model.min_step_low_cycles, 7);
}

ControllerConfig config_of(const ControllerSpec& controller) {
  Scenario scenario;
  scenario.controller = controller;
  return to_controller_config(scenario);
}

TEST(ToController, NamesEverySynchronisationRule) {
  EXPECT_EQ(config_of({.sync = "fig9"}).sync, SyncRule::kFig9);
  EXPECT_EQ(config_of({.sync = "const_acc"}).sync, SyncRule::kConstAcc);
  EXPECT_EQ(config_of({.sync = "time_scale"}).sync, SyncRule::kTimeScale);
  EXPECT_TRUE(config_of({.feedback = true}).feedback);
  EXPECT_FALSE(config_of({.feedback = false}).feedback);
  EXPECT_EQ(config_of({.max_stretch = 7.5}).max_stretch, 7.5);
}

TEST(ToController, TellsWhatSolvesTheSetPoints) {
  Scenario scenario;
  EXPECT_FALSE(to_controller_config(scenario).cordic);
  scenario.kinematics.solver = SetPointSolver::kCordic;
  EXPECT_TRUE(to_controller_config(scenario).cordic);
}

TEST(ToController, TellsWhatTheOneDecoderWatches) {
  Scenario scenario;
  EXPECT_FALSE(to_controller_config(scenario).paper);
  scenario.variant = Variant::kPaper;
  scenario.paper = PaperSpec{.encoder_axis = 4, .switch_every_ticks = std::nullopt};
  ASSERT_TRUE(to_controller_config(scenario).paper);
  EXPECT_EQ(to_controller_config(scenario).paper->axis, 3u);
  EXPECT_EQ(to_controller_config(scenario).paper->switch_every, Ticks{0});
  scenario.paper.switch_every_ticks = 20;
  EXPECT_EQ(to_controller_config(scenario).paper->switch_every, Ticks{20});
}

TEST(ToController, PutsToolAndFramesWhereTheMovesLookForThem) {
  Scenario scenario;
  scenario.tool = {.xyz_mm = {1, 2, 3}, .rpy_deg = {}};
  scenario.frames = {{.name = "first", .pose = {}}, {.name = "second", .pose = {.xyz_mm = {4, 5, 6}, .rpy_deg = {}}}};
  const ControllerConfig config = to_controller_config(scenario);
  EXPECT_EQ(config.flange_T_tool.position_mm, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(config.flange_T_tool.rotation, Eigen::Matrix3d::Identity());
  EXPECT_EQ(config.base_T_user[1].value().position_mm, Eigen::Vector3d(4, 5, 6));
}

// x of the rotated frame points along z, its y along x, its z along y: only the right order of the three turns does it.
TEST(ToController, TurnsAboutTheFixedAxesXThenYThenZ) {
  const Transform pose = to_transform({.xyz_mm = {}, .rpy_deg = {90, 0, 90}});
  Eigen::Matrix3d expected;
  expected << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  EXPECT_LT((pose.rotation - expected).cwiseAbs().maxCoeff(), 1e-15) << pose.rotation;
}

TEST(ToController, ConvertsJointMoves) {
  JointSpec move{.target_deg = PerAxis<double>{90, 0, 0, 0, 0, -180}, .speed_percent = 25};
  const auto joint = std::get<JointMove>(to_command({.kind = move, .index = 7}));
  EXPECT_EQ(joint.tag.number(), 7u);
  EXPECT_DOUBLE_EQ(joint.target[0].value(), 1.57079632679489661923);
  EXPECT_DOUBLE_EQ(joint.target[5].value(), -3.14159265358979323846);
  EXPECT_EQ(joint.speed, 0.25);
  EXPECT_EQ(joint.profile, ProfileKind::kTrapezoid);
  move.profile = ProfileKind::kSCurve;
  EXPECT_EQ(std::get<JointMove>(to_command({.kind = move})).profile, ProfileKind::kSCurve);

  move.target_deg.reset();
  move.pose = {.xyz_mm = {1, 2, 3},
               .frame = kToolFrameIndex,
               .shoulder = ShoulderSide::kFront,
               .wrist = WristSide::kFlip,
               .turns = {{0, 0, 0, -1, 0, 2}}};
  const auto pose = std::get<PoseMove>(to_command({.kind = move}));
  EXPECT_EQ(pose.target.frame, kToolFrame);
  EXPECT_EQ(pose.target.position_mm, Eigen::Vector3d(1, 2, 3));
  EXPECT_FALSE(pose.target.rotation);
  const Configuration expected{
      .shoulder = ShoulderSide::kFront, .wrist = WristSide::kFlip, .turns = Turns{0, 0, 0, -1, 0, 2}};
  EXPECT_EQ(pose.target.configuration, expected);
  EXPECT_EQ(pose.speed, 0.25);
  EXPECT_EQ(pose.profile, ProfileKind::kSCurve);
}

TEST(ToController, ConvertsEveryFieldOfAPath) {
  const PathSpec spec{.pose = {.xyz_mm = {1, 2, 3}, .rpy_deg = {{0, 0, 90}}, .frame = 3},
                      .profile = ProfileKind::kSCurve,
                      .speed_mm_s = 7,
                      .accel_mm_s2 = 8,
                      .jerk_mm_s3 = 9,
                      .turn_speed_deg_s = 180,
                      .turn_accel_deg_s2 = 360,
                      .turn_jerk_deg_s3 = 540,
                      .accel_percent = 50,
                      .blend_mm = 10,
                      .orientation = CartesianMove::Orientation::kTangent,
                      .at_singularity = AtSingularity::kBend,
                      .orientation_tolerance_deg = 18};
  const auto command = [](const CommandKind& kind) { return to_command({.kind = kind}); };
  const auto path = std::get<CartesianMove>(command(ArcSpec{.path = spec, .via_mm = {4, 5, 6}}));
  constexpr double kPi = 3.14159265358979323846;
  EXPECT_EQ(path.kind, SegmentRequest::Kind::kArc);
  EXPECT_EQ(path.target.frame, FrameId{3});
  EXPECT_EQ(path.target.position_mm, Eigen::Vector3d(1, 2, 3));
  EXPECT_NEAR((*path.target.rotation)(1, 0), 1, 1e-15);
  EXPECT_EQ(path.via_mm, Eigen::Vector3d(4, 5, 6));
  EXPECT_EQ(path.profile, ProfileKind::kSCurve);
  EXPECT_EQ(path.limits.speed_mm_s, 7);
  EXPECT_EQ(path.limits.accel_mm_s2, 4);
  EXPECT_EQ(path.limits.jerk_mm_s3, 9);
  EXPECT_DOUBLE_EQ(path.limits.turn_speed_rad_s, kPi);
  EXPECT_DOUBLE_EQ(path.limits.turn_accel_rad_s2, kPi);
  EXPECT_EQ(path.limits.joint_accel, 0.5);
  EXPECT_DOUBLE_EQ(path.limits.turn_jerk_rad_s3, 3 * kPi);
  EXPECT_EQ(path.blend_mm, 10);
  EXPECT_EQ(path.at_singularity, AtSingularity::kBend);
  EXPECT_EQ(path.orientation, CartesianMove::Orientation::kTangent);
  EXPECT_DOUBLE_EQ(path.orientation_tolerance_rad, kPi / 10);
  EXPECT_EQ(std::get<CartesianMove>(command(LineSpec{.path = spec})).kind, SegmentRequest::Kind::kLine);
  const auto circle = std::get<CartesianMove>(command(CircleSpec{.path = spec, .via_mm = {4, 5, 6}}));
  EXPECT_EQ(circle.kind, SegmentRequest::Kind::kCircle);
  EXPECT_EQ(circle.via_mm, Eigen::Vector3d(4, 5, 6));
  const auto about = std::get<CartesianMove>(command(
      ArcAboutSpec{.path = spec, .center_mm = {4, 5, 6}, .axis = {0, 1, 0}, .angle_deg = 540, .advance_mm = 11}));
  EXPECT_EQ(about.kind, SegmentRequest::Kind::kArcAbout);
  EXPECT_EQ(about.via_mm, Eigen::Vector3d(4, 5, 6));
  EXPECT_EQ(about.about.axis, Eigen::Vector3d(0, 1, 0));
  EXPECT_DOUBLE_EQ(about.about.angle_rad, 3 * kPi);
  EXPECT_EQ(about.about.advance_mm, 11);
  const auto spline = std::get<CartesianMove>(command(SplineSpec{.path = spec, .through_mm = {{4, 5, 6}, {7, 8, 9}}}));
  EXPECT_EQ(spline.kind, SegmentRequest::Kind::kSpline);
  EXPECT_EQ(spline.through.count, 2);
  EXPECT_EQ(spline.through.mm[0], Eigen::Vector3d(4, 5, 6));
  EXPECT_EQ(spline.through.mm[1], Eigen::Vector3d(7, 8, 9));
}

TEST(ToController, ConvertsOutputsOnAPath) {
  CommandSpec move;
  move.kind = LineSpec{};
  move.outputs = {{.pin = 3, .level = true, .before_mm = 5},
                  {.pin = 4, .from = "start", .after_mm = 6},
                  {.pin = 5, .before_s = 0.7},
                  {.pin = 6, .from = "start", .after_s = 0.8}};
  const PathOutputs outputs = std::get<CartesianMove>(to_command(move)).outputs;
  ASSERT_EQ(outputs.count, 4);
  EXPECT_EQ(outputs.list[0].pin, 3);
  EXPECT_TRUE(outputs.list[0].level);
  EXPECT_EQ(outputs.list[0].from, PathOutput::From::kEnd);
  EXPECT_EQ(outputs.list[0].unit, PathOutput::Unit::kMm);
  EXPECT_EQ(outputs.list[0].offset, -5);
  EXPECT_EQ(outputs.list[1].from, PathOutput::From::kStart);
  EXPECT_EQ(outputs.list[1].offset, 6);
  EXPECT_EQ(outputs.list[2].unit, PathOutput::Unit::kSeconds);
  EXPECT_EQ(outputs.list[2].offset, -0.7);
  EXPECT_EQ(outputs.list[3].offset, 0.8);
}

// Also those without a distance or time.
TEST(ToController, OutputsOfJointMovesAreInTime) {
  for (const bool to_pose : {false, true}) {
    JointSpec joint;
    if (!to_pose) joint.target_deg = PerAxis<double>{};
    CommandSpec move;
    move.kind = joint;
    move.outputs = {{.pin = 3, .level = true, .before_s = 0.5}, {.pin = 4}};
    const Command command = to_command(move);
    const PathOutputs outputs = to_pose ? std::get<PoseMove>(command).outputs : std::get<JointMove>(command).outputs;
    ASSERT_EQ(outputs.count, 2);
    EXPECT_EQ(outputs.list[0].offset, -0.5);
    EXPECT_EQ(outputs.list[1].offset, 0.0);
    for (const PathOutput& output : {outputs.list[0], outputs.list[1]}) {
      EXPECT_EQ(output.unit, PathOutput::Unit::kSeconds);
    }
  }
}

TEST(ToController, ConvertsAccelerationsOfJointsAndDwells) {
  JointSpec move;
  move.target_deg = PerAxis<double>{1, 2, 3, 4, 5, 6};
  move.accel_percent = 30;
  EXPECT_EQ(std::get<JointMove>(to_command({.kind = move})).accel, 0.3);
  move.target_deg.reset();
  EXPECT_EQ(std::get<PoseMove>(to_command({.kind = move})).accel, 0.3);
  const auto dwell = std::get<Dwell>(to_command({.kind = DwellSpec{.duration_s = 0.25}, .index = 7}));
  EXPECT_EQ(dwell.duration, Ticks{5'000});
  EXPECT_EQ(dwell.tag, Tag{7});
}

TEST(ToController, ConvertsWhatIsNoMove) {
  const auto command = [](const CommandKind& kind) { return to_command({.kind = kind}); };
  EXPECT_TRUE(std::holds_alternative<Stop>(command(StopSpec{})));
  EXPECT_TRUE(std::holds_alternative<ClearFault>(command(ClearFaultSpec{})));
  EXPECT_TRUE(std::holds_alternative<Hold>(command(HoldSpec{})));
  EXPECT_TRUE(std::holds_alternative<Resume>(command(ResumeSpec{})));
  EXPECT_EQ(std::get<SetOverride>(command(OverrideSpec{.speed_percent = 30})).share, 0.3);
}

TEST(ToController, ConvertsHomeToAMaskOfAxes) {
  const auto home = [](std::vector<std::int64_t> axes) {
    return std::get<Home>(to_command({.kind = HomeSpec{.axes = std::move(axes)}, .index = 3}));
  };
  EXPECT_EQ(home({}).axes, 0);
  EXPECT_EQ(home({1, 6, 3}).axes, 0b100101);
  EXPECT_EQ(home({}).tag.number(), 3u);
}

TEST(ToController, AnUnreferencedStartMakesAControllerThatKnowsNoAngle) {
  Scenario scenario;
  EXPECT_TRUE(to_controller_config(scenario).referenced);
  scenario.unreferenced_start_deg = PerAxis<double>{};
  EXPECT_FALSE(to_controller_config(scenario).referenced);
}

TEST(ToController, ConvertsTheBlendsOfJointMovesAndMovesThatBeginAtOnce) {
  const auto joints = [](const JointSpec& spec) { return std::get<JointMove>(to_command({.kind = spec})); };
  const PerAxis<double> target{};
  EXPECT_FALSE(joints({.target_deg = target}).blend.wanted());
  EXPECT_FALSE(joints({.target_deg = target}).now);
  EXPECT_TRUE(joints({.target_deg = target, .when = JointSpec::When::kNow}).now);
  EXPECT_DOUBLE_EQ(joints({.target_deg = target, .blend_deg = 180}).blend.rad, 3.14159265358979323846);
  EXPECT_EQ(joints({.target_deg = target, .blend_percent = 25}).blend.share, 0.25);
  EXPECT_EQ(std::get<PoseMove>(to_command({.kind = JointSpec{.blend_percent = 25}})).blend.share, 0.25);
}

TEST(ToController, ConvertsJogs) {
  const auto joints = std::get<Jog>(to_command(
      {.kind = JogSpec{.joint_deg_s = PerAxis<double>{90, 0, 0, 0, 0, -180}, .duration_s = 0.5}, .index = 3}));
  EXPECT_EQ(joints.kind, Jog::Kind::kJoints);
  EXPECT_DOUBLE_EQ(joints.joint_rad_s[0], 1.57079632679489661923);
  EXPECT_DOUBLE_EQ(joints.joint_rad_s[5], -3.14159265358979323846);
  EXPECT_EQ(joints.duration, Ticks{10'000});
  EXPECT_EQ(joints.tag.number(), 3u);
  EXPECT_EQ(joints.profile, ProfileKind::kTrapezoid);
  EXPECT_EQ(joints.accel_share, 1.0);

  const auto tool = std::get<Jog>(to_command(
      {.kind = JogSpec{.tool_mm_s = {1, 2, 3}, .tool_deg_s = {0, 0, 180}, .frame = kToolFrameIndex, .duration_s = 1}}));
  EXPECT_EQ(tool.kind, Jog::Kind::kTool);
  EXPECT_EQ(tool.frame, kToolFrame);
  EXPECT_EQ(tool.move_mm_s, Eigen::Vector3d(1, 2, 3));
  EXPECT_DOUBLE_EQ(tool.turn_rad_s.z(), 3.14159265358979323846);

  const auto limited = std::get<Jog>(to_command({.kind = JogSpec{.profile = ProfileKind::kSCurve,
                                                                 .accel_percent = 25,
                                                                 .accel_mm_s2 = 1,
                                                                 .jerk_mm_s3 = 2,
                                                                 .turn_accel_deg_s2 = 180,
                                                                 .turn_jerk_deg_s3 = 360}}));
  EXPECT_EQ(limited.profile, ProfileKind::kSCurve);
  EXPECT_EQ(limited.accel_share, 0.25);
  EXPECT_EQ(limited.tool.accel_mm_s2, 1);
  EXPECT_EQ(limited.tool.jerk_mm_s3, 2);
  EXPECT_DOUBLE_EQ(limited.tool.turn_accel_rad_s2, 3.14159265358979323846);
  EXPECT_DOUBLE_EQ(limited.tool.turn_jerk_rad_s3, 2 * 3.14159265358979323846);
}

}  // namespace
}  // namespace armature::cosim
