// [[move]], [[frame]] and [tool] of a scenario file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cosim/scenario/files/scenario_loader.hpp"
#include "tests/cosim/support/scenario_files.hpp"
#include "tests/cosim/support/temp_folder.hpp"

namespace armature::cosim {
namespace {

using test::shipped;
using test::TempFolder;
using testing::ElementsAre;

constexpr const char* kEveryPose = R"(
description = "every key of moves to poses"
robot = "vo2021_6r"
duration_s = 2
[tool]
xyz_mm = [1, 2, 3]
rpy_deg = [4, 5, 6]
[[frame]]
name = "table"
xyz_mm = [7, 8, 9]
rpy_deg = [10, 11, 12]
[[frame]]
name = "box"
[[move]]
at_s = 0.0
type = "joint"
xyz_mm = [400, 0, 300]
rpy_deg = [0, 90, 0]
shoulder = "back"
elbow = "down"
wrist = "flip"
turns = [0, 0, 0, -1, 0, 1]
profile = "scurve"
[[move]]
at_s = 0.1
type = "line"
xyz_mm = [1, 0, 0]
frame = "tool"
exact_stop = true
[[move]]
at_s = 0.2
type = "arc"
via_mm = [1, 2, 0]
xyz_mm = [3, 4, 0]
frame = "box"
speed_mm_s = 11
accel_mm_s2 = 12
jerk_mm_s3 = 13
turn_speed_deg_s = 14
turn_accel_deg_s2 = 15
turn_jerk_deg_s3 = 16
profile = "scurve"
blend_mm = 17
orientation = "tangent"
singularity = "bend"
orientation_tolerance_deg = 3
[[move]]
at_s = 0.3
type = "circle"
via_mm = [1, 2, 0]
xyz_mm = [3, 4, 0]
frame = "base"
[[move]]
at_s = 0.4
type = "hold"
[[move]]
at_s = 0.5
type = "resume"
[[move]]
at_s = 0.6
type = "override"
speed_percent = 30
[[move]]
at_s = 0.7
type = "arc_about"
center_mm = [1, 2, 3]
rpy_deg = [4, 5, 6]
frame = "box"
axis = [0, 1, 0]
angle_deg = -720
advance_mm = 7
speed_mm_s = 8
[[move]]
at_s = 0.8
type = "spline"
through_mm = [[1, 2, 3], [4, 5, 6]]
xyz_mm = [7, 8, 9]
frame = "box"
accel_percent = 40
[[move.output]]
pin = 2
level = 1
before_s = 0.01
[[move.output]]
pin = 2
level = 0
from = "start"
)";

TEST(ScenarioLoader, ReadsMovesToPoses) {
  const TempFolder folder;
  const Scenario s = load_scenario(folder.write("poses/scenario.toml", kEveryPose), shipped());
  EXPECT_THAT(s.tool.xyz_mm, ElementsAre(1, 2, 3));
  EXPECT_THAT(s.tool.rpy_deg, ElementsAre(4, 5, 6));
  ASSERT_EQ(s.frames.size(), 2u);
  EXPECT_EQ(s.frames[0].name, "table");
  EXPECT_THAT(s.frames[0].pose.xyz_mm, ElementsAre(7, 8, 9));
  EXPECT_THAT(s.frames[0].pose.rpy_deg, ElementsAre(10, 11, 12));
  EXPECT_EQ(s.frames[1].name, "box");

  ASSERT_EQ(s.moves.size(), 9u);
  const auto& joint = std::get<JointSpec>(s.moves[0].kind);
  EXPECT_FALSE(joint.target_deg);
  EXPECT_THAT(joint.pose.xyz_mm, ElementsAre(400, 0, 300));
  EXPECT_THAT(joint.pose.rpy_deg.value(), ElementsAre(0, 90, 0));
  EXPECT_EQ(joint.pose.frame, 0u);
  EXPECT_EQ(joint.pose.shoulder, ShoulderSide::kBack);
  EXPECT_EQ(joint.pose.elbow, ElbowSide::kDown);
  EXPECT_EQ(joint.pose.wrist, WristSide::kFlip);
  EXPECT_THAT(joint.pose.turns.value(), ElementsAre(0, 0, 0, -1, 0, 1));
  EXPECT_EQ(joint.profile, ProfileKind::kSCurve);

  const PathSpec& line = std::get<LineSpec>(s.moves[1].kind).path;
  EXPECT_EQ(line.pose.frame, kToolFrameIndex);
  EXPECT_FALSE(line.pose.rpy_deg);
  EXPECT_EQ(line.at_singularity, AtSingularity::kSlow);
  EXPECT_EQ(line.pose.elbow, ElbowSide::kNearest);
  EXPECT_FALSE(line.pose.turns);
  EXPECT_EQ(line.profile, ProfileKind::kTrapezoid);
  EXPECT_EQ(line.speed_mm_s, 100);
  EXPECT_EQ(line.accel_mm_s2, 1000);
  EXPECT_EQ(line.turn_speed_deg_s, 90);
  EXPECT_EQ(line.turn_accel_deg_s2, 900);
  EXPECT_EQ(line.blend_mm, 0);
  EXPECT_TRUE(line.exact_stop);

  const auto& arc = std::get<ArcSpec>(s.moves[2].kind);
  EXPECT_THAT(arc.via_mm, ElementsAre(1, 2, 0));
  EXPECT_EQ(arc.path.pose.frame, 2u);
  EXPECT_EQ(arc.path.speed_mm_s, 11);
  EXPECT_EQ(arc.path.accel_mm_s2, 12);
  EXPECT_EQ(arc.path.jerk_mm_s3, 13);
  EXPECT_EQ(arc.path.turn_speed_deg_s, 14);
  EXPECT_EQ(arc.path.turn_accel_deg_s2, 15);
  EXPECT_EQ(arc.path.turn_jerk_deg_s3, 16);
  EXPECT_EQ(arc.path.blend_mm, 17);
  EXPECT_FALSE(arc.path.exact_stop);

  EXPECT_EQ(std::get<CircleSpec>(s.moves[3].kind).path.pose.frame, 0u);
  EXPECT_TRUE(std::holds_alternative<HoldSpec>(s.moves[4].kind));
  EXPECT_TRUE(std::holds_alternative<ResumeSpec>(s.moves[5].kind));
  EXPECT_EQ(std::get<OverrideSpec>(s.moves[6].kind).speed_percent, 30);

  const auto& about = std::get<ArcAboutSpec>(s.moves[7].kind);
  EXPECT_THAT(about.center_mm, ElementsAre(1, 2, 3));
  EXPECT_THAT(about.path.pose.rpy_deg.value(), ElementsAre(4, 5, 6));
  EXPECT_EQ(about.path.pose.frame, 2u);
  EXPECT_THAT(about.axis, ElementsAre(0, 1, 0));
  EXPECT_EQ(about.angle_deg, -720);
  EXPECT_EQ(about.advance_mm, 7);
  EXPECT_EQ(about.path.speed_mm_s, 8);

  const auto& spline = std::get<SplineSpec>(s.moves[8].kind);
  EXPECT_THAT(spline.through_mm, ElementsAre(ElementsAre(1, 2, 3), ElementsAre(4, 5, 6)));
  EXPECT_THAT(spline.path.pose.xyz_mm, ElementsAre(7, 8, 9));
  EXPECT_EQ(spline.path.pose.frame, 2u);
  EXPECT_EQ(spline.path.accel_percent, 40);
  ASSERT_EQ(s.moves[8].outputs.size(), 2u);
  EXPECT_EQ(s.moves[8].outputs[0].before_s, 0.01);
  EXPECT_EQ(s.moves[8].outputs[0].from, "end");
  EXPECT_EQ(s.moves[8].outputs[1].from, "start");
  EXPECT_FALSE(s.moves[8].outputs[1].after_mm);
}

TEST(ScenarioLoader, TakesOneNumberForEachOfFiveAxes) {
  const TempFolder folder;
  const Scenario s = load_scenario(folder.write("five/scenario.toml", R"(
description = "d"
robot = "hu2012_5r"
duration_s = 1
[[move]]
at_s = 0.1
type = "joint"
target_deg = [1, -2, 3, 4, 5]
[expect]
total_pulses = [1, 2, 3, 4, 5]
profile = ["none", "none", "none", "none", "scurve"]
)"),
                                   shipped());
  EXPECT_EQ(s.robot.axis_count, 5u);
  EXPECT_THAT(std::get<JointSpec>(s.moves[0].kind).target_deg.value(), ElementsAre(1, -2, 3, 4, 5, 0));
  EXPECT_THAT(s.expect.total_pulses.value(), ElementsAre(1, 2, 3, 4, 5, 0));
  EXPECT_EQ(s.expect.profile->size(), 5u);
}

}  // namespace
}  // namespace armature::cosim
