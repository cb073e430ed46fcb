#include "controller/language/gcode/run/motion_commands.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <random>

#include "tests/controller/language/gcode/gcode_rig.hpp"

namespace armature::test {
namespace {

using gcode::Axes6;
using gcode::MotionCommands;
using gcode::MotionProblem;
using Mode = gcode::SetMotionControlMode::Mode;

struct GcodeMotion : testing::Test {
  // All commands of some calls.
  std::vector<Command> convert(const std::vector<gcode::CanonCall>& calls, const Axes6& from = {}) {
    MotionCommands commands{cell.setup};
    commands.begin(from);
    std::vector<Command> all;
    for (const gcode::CanonCall& call : calls) {
      problem = commands.convert(call);
      if (problem) break;
      all.insert(all.end(), commands.commands().begin(), commands.commands().end());
    }
    return all;
  }
  CartesianMove move(const Command& command) { return *std::get_if<CartesianMove>(&command); }

  Cell cell;
  std::optional<MotionProblem> problem;
};

// Where an arc about an axis ends: by a rotation matrix, which the converter does not use.
Eigen::Vector3d end_of_arc(const CartesianMove& arc, const Eigen::Vector3d& from) {
  const Eigen::Vector3d axis = arc.about.axis.normalized();
  return arc.via_mm + Eigen::AngleAxisd{arc.about.angle_rad, axis} * (from - arc.via_mm) + arc.about.advance_mm * axis;
}

TEST_F(GcodeMotion, EndsEachArcWhereTheProgramSays) {
  std::mt19937 random{15};
  std::uniform_real_distribution<double> draw{-50.0, 50.0};
  for (int i = 0; i < 300; ++i) {
    const auto plane = static_cast<gcode::Plane>(i % 3);
    const gcode::PlaneAxes axes = gcode::axes_of(plane);
    const gcode::Offsets offsets{.g5x = {draw(random), draw(random), draw(random)},
                                 .g92 = {draw(random), draw(random), draw(random)},
                                 .tool = {0.0, 0.0, draw(random)},
                                 .rotation_deg = 3.0 * draw(random)};
    Axes6 start{draw(random), draw(random), draw(random)};
    const double first = draw(random), second = draw(random), angle = draw(random) / 10.0;
    const Axes6 from = offsets.machine(start);
    // The end by the definition of a rotation in the plane.
    const double u = start[axes.first] - first, v = start[axes.second] - second;
    Axes6 end = start;
    end[axes.first] = first + u * std::cos(angle) - v * std::sin(angle);
    end[axes.second] = second + u * std::sin(angle) + v * std::cos(angle);
    end[axes.normal] += draw(random);
    const int turns = 1 + i % 4;
    const std::vector<Command> all =
        convert({gcode::SetG5xOffset{.offset = offsets.g5x}, gcode::SetG92Offset{offsets.g92},
                 gcode::UseToolLengthOffset{offsets.tool}, gcode::SetXyRotation{offsets.rotation_deg},
                 gcode::SelectPlane{plane}, gcode::SetFeedRate{.mm_min = 600.0, .number = 600.0},
                 gcode::ArcFeed{.first_end = end[axes.first],
                                .second_end = end[axes.second],
                                .first_axis = first,
                                .second_axis = second,
                                .rotation = i % 2 == 0 ? turns : -turns,
                                .axis_end = end[axes.normal]}},
                from);
    ASSERT_EQ(all.size(), 1U) << "draw " << i;
    const CartesianMove arc = move(all[0]);
    const Axes6 wanted = offsets.machine(end);
    const Eigen::Vector3d reached = end_of_arc(arc, {from[0], from[1], from[2]});
    EXPECT_NEAR((reached - Eigen::Vector3d(wanted[0], wanted[1], wanted[2])).norm(), 0.0, 1e-9) << "draw " << i;
    EXPECT_EQ(arc.about.angle_rad > 0.0, i % 2 == 0);
    EXPECT_EQ(std::ceil(std::fabs(arc.about.angle_rad) / (2.0 * kPi)), turns) << "draw " << i;
  }
}

TEST_F(GcodeMotion, EndsAnArcWithUnequalRadiiAtItsEnd) {
  const auto all = convert(
      {gcode::SetFeedRate{.mm_min = 60.0},
       gcode::ArcFeed{.first_end = 10.0, .second_end = 0.02, .first_axis = 5.0, .second_axis = 0.01, .rotation = -1},
       gcode::ArcFeed{.first_end = 20.02, .second_end = 0.02, .first_axis = 15.0, .second_axis = 0.02}});
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(move(all[2]).kind, SegmentRequest::Kind::kLine);
  EXPECT_NEAR(move(all[2]).target.position_mm.x(), 20.02, 1e-12);
}

TEST_F(GcodeMotion, PassesCornersAsThePathControlSays) {
  const auto blend = [&](Mode mode, double tolerance) {
    return move(convert({gcode::SetMotionControlMode{mode, tolerance}, gcode::StraightTraverse{{5.0}}}).at(0));
  };
  EXPECT_DOUBLE_EQ(blend(Mode::kContinuous, 0.2).blend_mm, 0.2);
  EXPECT_DOUBLE_EQ(blend(Mode::kContinuous, 0.0).blend_mm, cell.setup.settings.corner_mm);
  EXPECT_DOUBLE_EQ(blend(Mode::kExactPath, 0.0).blend_mm, 0.0);
  EXPECT_FALSE(blend(Mode::kExactPath, 0.0).exact_stop);
  EXPECT_DOUBLE_EQ(blend(Mode::kExactStop, 0.0).blend_mm, 0.0);
  EXPECT_TRUE(blend(Mode::kExactStop, 0.0).exact_stop);
}

TEST_F(GcodeMotion, SwitchesOutputsAtTheStartOfTheNextMotion) {
  const auto all = convert({gcode::SetDigitalOutput{.with_motion = true, .index = 2, .on = true},
                            gcode::SetDigitalOutput{.with_motion = true, .index = 4, .on = true},
                            gcode::SetDigitalOutput{.with_motion = true, .index = 4, .on = false},
                            gcode::StraightTraverse{{5.0}}, gcode::StraightTraverse{{6.0}}});
  ASSERT_EQ(all.size(), 2U);
  const PathOutputs outputs = move(all[0]).outputs;
  ASSERT_EQ(outputs.count, 2);
  EXPECT_EQ(outputs.list[0].pin, 3);
  EXPECT_TRUE(outputs.list[0].level);
  EXPECT_EQ(outputs.list[1].pin, 5);
  EXPECT_FALSE(outputs.list[1].level);
  EXPECT_EQ(outputs.list[0].from, PathOutput::From::kStart);
  EXPECT_EQ(outputs.list[0].offset, 0.0);
  EXPECT_EQ(move(all[1]).outputs.count, 0);
}

TEST_F(GcodeMotion, SwitchesWhatDoesNotFitBeforeTheMotion) {
  std::vector<gcode::CanonCall> calls;
  for (int i = 0; i < 6; ++i) calls.push_back(gcode::SetDigitalOutput{.with_motion = true, .index = i, .on = true});
  calls.push_back(gcode::StraightTraverse{{5.0}});
  const auto all = convert(calls);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(std::get_if<SetOutput>(&all[0])->pin, 5);
  EXPECT_EQ(std::get_if<SetOutput>(&all[1])->pin, 6);
  EXPECT_EQ(move(all[2]).outputs.count, 4);
}

TEST_F(GcodeMotion, WritesAnAnalogOutputAsABinaryNumber) {
  cell.setup.settings.analog[1] = {.first_pin = 5, .bits = 4, .full = 15.0};
  for (int value = 0; value < 16; ++value) {
    const auto all = convert({gcode::SetAnalogOutput{.index = 1, .value = static_cast<double>(value)}});
    int read = 0;
    for (const Command& command : all) {
      const SetOutput& output = *std::get_if<SetOutput>(&command);
      read += output.level ? 1 << (output.pin - 5) : 0;
    }
    EXPECT_EQ(read, value);
  }
  static_cast<void>(convert({gcode::SetAnalogOutput{.index = 0, .value = 1.0}}));
  EXPECT_EQ(problem, MotionProblem::kNoSuchAnalogOutput);
}

TEST_F(GcodeMotion, TiltsTheToolFromTheNormalOfTheFrame) {
  cell.setup.settings.orientation = gcode::MotionSettings::Orientation::kNormal;
  const auto all = convert({gcode::StraightTraverse{{5.0, 0.0, 0.0}}, gcode::StraightTraverse{{5.0, 0.0, 0.0, 30.0}},
                            gcode::StraightTraverse{{5.0, 0.0, 0.0, 30.0, 0.0, 90.0}}});
  ASSERT_EQ(all.size(), 3U);
  const auto approach = [&](const Command& command) { return Eigen::Vector3d(move(command).target.rotation->col(2)); };
  EXPECT_NEAR((approach(all[0]) - Eigen::Vector3d(0.0, 0.0, -1.0)).norm(), 0.0, 1e-12);
  // About X by 30 degrees: Z against the normal turns towards +Y; then about Z: +Y becomes -X.
  EXPECT_NEAR((approach(all[1]) - Eigen::Vector3d(0.0, 0.5, -std::sqrt(0.75))).norm(), 0.0, 1e-12);
  EXPECT_NEAR((approach(all[2]) - Eigen::Vector3d(-0.5, 0.0, -std::sqrt(0.75))).norm(), 0.0, 1e-12);
}

TEST_F(GcodeMotion, TiltsTheToolByAnyNumberOfTurns) {
  cell.setup.settings.orientation = gcode::MotionSettings::Orientation::kNormal;
  const auto all = convert({gcode::StraightTraverse{{5.0, 0.0, 0.0, 3'600'000'030.0}}});
  EXPECT_NEAR((move(all.at(0)).target.rotation->col(2) - Eigen::Vector3d(0.0, 0.5, -std::sqrt(0.75))).norm(), 0.0,
              1e-12);
}

TEST_F(GcodeMotion, RefusesToTurnAToolThatKeepsItsOrientation) {
  static_cast<void>(convert({gcode::StraightTraverse{{5.0, 0.0, 0.0, 30.0}}}));
  EXPECT_EQ(problem, MotionProblem::kTurnNotAllowed);
}

TEST_F(GcodeMotion, TurnsAtTheFeedInDegreesWhenOnlyTheToolTurns) {
  cell.setup.settings.orientation = gcode::MotionSettings::Orientation::kNormal;
  const auto all = convert(
      {gcode::SetFeedRate{.mm_min = 25.4 * 600.0, .number = 600.0}, gcode::StraightFeed{{0.0, 0.0, 0.0, 30.0}}});
  EXPECT_NEAR(move(all.at(0)).limits.turn_speed_rad_s, 10.0 * kDeg, 1e-12);
}

TEST_F(GcodeMotion, DwellsToTheTick) {
  const auto all = convert({gcode::Dwell{1.5}, gcode::Dwell{0.0}});
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(std::get_if<Dwell>(&all[0])->duration, Ticks{30'000});
  static_cast<void>(convert({gcode::Dwell{1e6}}));
  EXPECT_EQ(problem, MotionProblem::kDwellTooLong);
}

TEST_F(GcodeMotion, MakesNoMoveWithoutAWay) {
  EXPECT_TRUE(convert({gcode::StraightTraverse{}, gcode::StraightFeed{}}).empty());
}

}  // namespace
}  // namespace armature::test
