// [[stream]], its file, and what the controller gets.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cosim/scenario/files/stream_file.hpp"
#include "cosim/scenario/to_controller.hpp"
#include "tests/cosim/support/scenario_files.hpp"

namespace armature::cosim {
namespace {

using testing::HasSubstr;

constexpr const char* kStreamScenario = R"(description = "test"
robot = "vo2021_6r"
duration_s = 1
[[stream]]
at_s = 0.5
file = "points.csv"
)";

Scenario scenario_with_points(const std::string& points, const std::string& more = "") {
  const test::TempFolder folder;
  folder.write("s/points.csv", points);
  return load_scenario(folder.write("s/scenario.toml", kStreamScenario + more), test::shipped());
}

std::string error_of_points(const std::string& points) {
  try {
    (void)scenario_with_points(points);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(ScenarioStream, ReadsJointsAtTheirTimes) {
  const Scenario scenario = scenario_with_points(
      "time_s,j1_deg,j2_deg,j3_deg,j4_deg,j5_deg,j6_deg\n0,0,0,0,0,0,0\n0.001,1,2,3,4,5,6\n0.005,0,0,0,0,0,90\n");
  ASSERT_EQ(scenario.streams.size(), 1u);
  const StreamSpec& stream = scenario.streams[0];
  EXPECT_EQ(stream.kind, StreamSpec::Kind::kJoints);
  ASSERT_EQ(stream.points.size(), 3u);
  EXPECT_EQ(stream.points[2].ticks, 100);
  EXPECT_DOUBLE_EQ(stream.delay_s(), 0.010);
  EXPECT_EQ(scenario.sources.size(), 3u);  // scenario, points, robot

  const auto last = std::get<StreamPoint>(to_command(stream, 2));
  EXPECT_TRUE(last.last);
  EXPECT_FALSE(last.first);
  EXPECT_EQ(last.time, Ticks{100});
  EXPECT_DOUBLE_EQ(last.joints[5].value(), std::numbers::pi / 2);
  EXPECT_EQ(std::get<StreamPoint>(to_command(stream, 0)).delay, Ticks{200});
}

TEST(ScenarioStream, ReadsPosesOfTheToolAndKeys) {
  const Scenario scenario = scenario_with_points(
      "time_s,x_mm,y_mm,z_mm,roll_deg,pitch_deg,yaw_deg\n0,400,0,600,0,90,0\n0.004,401,0,600,0,90,0\n",
      "delay_ms = 20\nprofile = \"scurve\"\n");
  const auto first = std::get<StreamPoint>(to_command(scenario.streams[0], 0));
  EXPECT_EQ(first.kind, StreamPoint::Kind::kTool);
  EXPECT_EQ(first.delay, Ticks{400});
  EXPECT_EQ(first.profile, ProfileKind::kSCurve);
  EXPECT_EQ(first.position_mm, Eigen::Vector3d(400, 0, 600));
  EXPECT_NEAR(first.rotation(0, 2), 1.0, 1e-15);
}

TEST(ScenarioStream, ReportsMistakesOfItsFileWithLineAndColumn) {
  const std::string header = "time_s,j1_deg,j2_deg,j3_deg,j4_deg,j5_deg,j6_deg\n";
  EXPECT_THAT(
      error_of_points(header + "0,0,0,0,0,0,0\n0.0005,0,0,0,0,0,0\n"),
      HasSubstr("points.csv:3:1: time_s: expected at least 0.001 (s) more than in the row before, found 5e-04"));
  EXPECT_THAT(error_of_points(header + "0.1,0,0,0,0,0,0\n0.2,0,0,0,0,0,0\n"),
              HasSubstr("points.csv:2:1: time_s: expected 0 in the first row, found 0.1"));
  EXPECT_THAT(error_of_points(header + "0,0,0,0,0,0,0\n0.001,0,0,x,0,0,0\n"),
              HasSubstr("points.csv:3:11: j3_deg: expected a number"));
  EXPECT_THAT(error_of_points(header + "0,0,0,0,0,0,0\n"), HasSubstr("expected at least two set-points, found 1"));
  EXPECT_THAT(error_of_points("time_s,j1_rad\n"), HasSubstr("points.csv:1:8: header: expected"));
}

}  // namespace
}  // namespace armature::cosim
