// Robot files with plant = "dynamic".
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "cosim/scenario/files/robot_loader.hpp"
#include "tests/cosim/support/temp_folder.hpp"

namespace armature::cosim {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

const std::string kArmOfBodies = R"(
[kinematics]
family = "five_r"
a1_mm = 10
a2_mm = 100
a3_mm = 95
a4_mm = 30
d5_mm = 100
sign = [1, 1, 1, 1, 1]
offset_deg = [0, 0, 0, 0, 0]
[defaults]
gear_ratio = 50
pulses_per_rev = 10_000
encoder_lines = 2500
min_deg = -90
max_deg = 90
max_speed_deg_s = 100
max_accel_deg_s2 = 500
)";
const std::string kMotorAndGear = "[defaults.dynamics]\nrotor_inertia_kg_m2 = 1e-4\nstiffness_nm_rad = 20_000\n";
const std::string kMovedAxes =
    "[[axis]]\n[[axis]]\n[axis.dynamics]\nbacklash_deg = 0.02\n[[axis]]\n[[axis]]\n[[axis]]\n";
const std::string kAxesAlone = "[[axis]]\n[[axis]]\n[[axis]]\n[[axis]]\n[[axis]]\n";
const std::string kTestBody = "mass_kg = 2\ncentre_mm = [1, 2, 3]\ninertia_kg_m2 = [0.03, 0.02, 0.04, 0.001, 0, 0]\n";

std::string bodies_of_links(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += "[[link]]\n" + kTestBody;
  return text;
}

// The problems of a file with this plant and these parts.
std::vector<std::string> problems_with_plant(const std::string& plant, const std::string& parts,
                                             RobotSpec* robot = nullptr) {
  const test::TempFolder folder;
  std::vector<Problem> problems;
  const RobotSpec read =
      load_robot(folder.write("r.toml", "name = \"r\"\nplant = \"" + plant + "\"\n" + parts), problems);
  if (robot != nullptr) *robot = read;
  std::vector<std::string> texts;
  for (const Problem& problem : problems) texts.push_back(problem.key + ": " + problem.message);
  return texts;
}

TEST(RobotDynamics, ReadsMotorsGearsAndBodies) {
  RobotSpec robot;
  EXPECT_THAT(problems_with_plant("dynamic",
                                  "gravity_m_s2 = [0, 0, 9.8]\n" + kArmOfBodies + kMotorAndGear + kMovedAxes +
                                      bodies_of_links(5) + "[tool]\n" + kTestBody,
                                  &robot),
              IsEmpty());
  EXPECT_EQ(robot.axes[0].dynamics->stiffness_nm_rad, 20'000);
  EXPECT_EQ(robot.axes[0].dynamics->backlash_deg, 0);
  EXPECT_EQ(robot.axes[1].dynamics->backlash_deg, 0.02);
  EXPECT_EQ(robot.axes[1].dynamics->rotor_inertia_kg_m2, 1e-4);
  ASSERT_EQ(robot.links.size(), 5U);
  EXPECT_EQ(robot.links[4].centre_mm[2], 3);
  EXPECT_EQ(robot.links[4].inertia_kg_m2[3], 0.001);
  EXPECT_EQ(robot.tool.mass_kg, 2);
  EXPECT_EQ(robot.payload.mass_kg, 0);
  EXPECT_EQ(robot.gravity_m_s2[2], 9.8);
}

TEST(RobotDynamics, NeedsABodyForEachLinkAndAMotorForEachAxis) {
  EXPECT_THAT(problems_with_plant("dynamic", kArmOfBodies + kMotorAndGear + kMovedAxes + bodies_of_links(4)),
              ElementsAre("link: expected 5 tables [[link]], found 4"));
  EXPECT_THAT(problems_with_plant("dynamic", kArmOfBodies + kAxesAlone + bodies_of_links(5)),
              testing::Contains("axis: axis[4] has no dynamics, which plant = \"dynamic\" needs"));
}

TEST(RobotDynamics, BelongsToItsPlantOnly) {
  EXPECT_THAT(problems_with_plant("servo", kArmOfBodies + kMotorAndGear + kMovedAxes + bodies_of_links(5)),
              UnorderedElementsAre("link: only with plant = \"dynamic\"",
                                   "plant: expected \"dynamic\", because an axis has dynamics"));
  EXPECT_THAT(problems_with_plant("servo", "gravity_m_s2 = [0, 0, 0]\n" + kArmOfBodies + kAxesAlone),
              testing::Contains("gravity_m_s2: only with plant = \"dynamic\""));
}

TEST(RobotDynamics, RefusesWhatTheStepsOfThePlantCannotHold) {
  const std::string rest = kMovedAxes + bodies_of_links(5);
  EXPECT_THAT(problems_with_plant(
                  "dynamic",
                  kArmOfBodies + "[defaults.dynamics]\nrotor_inertia_kg_m2 = 1e-4\nstiffness_nm_rad = 1.1e9\n" + rest),
              ElementsAre(HasSubstr("defaults.dynamics.stiffness_nm_rad: expected a number")));
  EXPECT_THAT(
      problems_with_plant("dynamic", kArmOfBodies +
                                         "[defaults.dynamics]\nrotor_inertia_kg_m2 = 1e-7\nstiffness_nm_rad = 2e6\n" +
                                         "[defaults.drive]\ninertia_kg_m2 = 1e-5\n" + rest),
      ElementsAre(HasSubstr("defaults.dynamics.stiffness_nm_rad: expected at most 1000000 with this rotor")));
  EXPECT_THAT(
      problems_with_plant("dynamic", kArmOfBodies + "[defaults.drive]\ninertia_kg_m2 = 3e-2\nmax_torque_nm = 100\n" +
                                         kMotorAndGear + rest),
      ElementsAre(HasSubstr("defaults.drive.inertia_kg_m2: expected at most 0.01989")));
}

TEST(RobotDynamics, RefusesAnOverloadAlarmThatRatedTorqueTripsOrThatLacksANumber) {
  const auto problems = [](const std::string& keys) {
    return problems_with_plant("dynamic", kArmOfBodies + kMotorAndGear + keys + kMovedAxes + bodies_of_links(5));
  };
  EXPECT_THAT(problems("rated_torque_nm = 1\noverload_200_s = 8\noverload_300_s = 3\n"), IsEmpty());
  EXPECT_THAT(problems("rated_torque_nm = 1\noverload_200_s = 8\noverload_300_s = 3.01\n"),
              ElementsAre(HasSubstr("overload_300_s: expected above 0 and at most 3/8 of overload_200_s = 8")));
  EXPECT_THAT(problems("rated_torque_nm = 1\n"), ElementsAre(HasSubstr("with a rated_torque_nm, found 0")));
  EXPECT_THAT(problems("overload_200_s = 8\noverload_300_s = 3\n"), ElementsAre(HasSubstr("with a rated_torque_nm")));
}

TEST(RobotDynamics, RefusesInertiasThatNoBodyHas) {
  const auto problem = [](const std::string& inertia) {
    const std::string payload = "[payload]\nmass_kg = 1\ncentre_mm = [0, 0, 0]\ninertia_kg_m2 = " + inertia + "\n";
    return problems_with_plant("dynamic", kArmOfBodies + kMotorAndGear + kMovedAxes + bodies_of_links(5) + payload);
  };
  EXPECT_THAT(problem("[0, 1, 1, 0, 0, 0]"), ElementsAre(HasSubstr("expected moments ixx, iyy and izz above 0")));
  EXPECT_THAT(problem("[1, 1, 3, 0, 0, 0]"), ElementsAre(HasSubstr("none is larger than the sum")));
  EXPECT_THAT(problem("[1, 1, 1, 1.1, 0, 0]"), ElementsAre(HasSubstr("no body has this tensor")));
}

}  // namespace
}  // namespace armature::cosim
