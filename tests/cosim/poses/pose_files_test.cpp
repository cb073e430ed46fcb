// Files of joints and poses as users write them, good and bad.
#include "cosim/poses/pose_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "cosim/poses/number_csv.hpp"

namespace armature::cosim {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string kFive = "j1_deg,j2_deg,j3_deg,j4_deg,j5_deg\n";
const std::string kMatrix = "t11,t12,t13,t14,t21,t22,t23,t24,t31,t32,t33,t34";
const std::string kPrevious = ",prev1_deg,prev2_deg,prev3_deg,prev4_deg,prev5_deg,prev6_deg";

template <class Parse>
std::vector<std::string> problems_of(Parse parse) {
  std::vector<std::string> texts;
  try {
    (void)parse();
  } catch (const InputError& error) {
    for (const Problem& problem : error.problems()) texts.push_back(problem.text());
  }
  return texts;
}
std::vector<std::string> joint_problems(const std::string& text) {
  return problems_of([&] { return parse_joints(text, "a.csv", 5); });
}
std::vector<std::string> pose_problems(const std::string& text) {
  return problems_of([&] { return parse_poses(text, "p.csv", 6); });
}

TEST(JointFile, ReadsRowsAsManyAsThereAre) {
  EXPECT_TRUE(parse_joints(kFive, "a.csv", 5).empty());
  EXPECT_THAT(parse_joints(kFive + "1,-2.5,3e1,0.25,-0\n10,20,30,40,50\n", "a.csv", 5),
              ElementsAre(PerAxis<double>{1, -2.5, 30, 0.25, 0, 0}, PerAxis<double>{10, 20, 30, 40, 50, 0}));
}

TEST(JointFile, TakesWhatSpreadsheetsWrite) {
  const std::string text =
      "\xEF\xBB\xBFj1_deg, j2_deg,j3_deg,j4_deg,j5_deg\r\n +1,2 ,\t3,+.5,5\r\n6,7,8,9,10\r\n\r\n \r\n";
  EXPECT_THAT(parse_joints(text, "a.csv", 5),
              ElementsAre(PerAxis<double>{1, 2, 3, 0.5, 5, 0}, PerAxis<double>{6, 7, 8, 9, 10, 0}));
  EXPECT_EQ(parse_joints(kFive + "1,2,3,4,5", "a.csv", 5).size(), 1u) << "no end of the last line";
}

TEST(JointFile, NamesEveryValueThatIsNoNumber) {
  EXPECT_THAT(joint_problems(kFive + "1,2,nan,4,5\n1,x,3,,inf\n1,2,3,4,5\n0x10,1.2.3,- 4,--5,+-6\n"),
              ElementsAre("a.csv:2:5: j3_deg: expected a number (deg), found \"nan\"",
                          "a.csv:3:3: j2_deg: expected a number (deg), found \"x\"",
                          "a.csv:3:7: j4_deg: expected a number (deg), found nothing",
                          "a.csv:3:8: j5_deg: expected a number (deg), found \"inf\"",
                          "a.csv:5:1: j1_deg: expected a number (deg), found \"0x10\"",
                          "a.csv:5:6: j2_deg: expected a number (deg), found \"1.2.3\"",
                          "a.csv:5:12: j3_deg: expected a number (deg), found \"- 4\"",
                          "a.csv:5:16: j4_deg: expected a number (deg), found \"--5\"",
                          "a.csv:5:20: j5_deg: expected a number (deg), found \"+-6\""));
}

TEST(JointFile, RefusesWhatNoJointTurns) {
  EXPECT_THAT(joint_problems(kFive + "0,-36000,36000,36000.5,1e999\n"),
              ElementsAre("a.csv:2:16: j4_deg: expected a number from -36000 to 36000 (deg), found \"36000.5\"",
                          "a.csv:2:24: j5_deg: expected a number (deg), found \"1e999\""));
}

TEST(JointFile, NamesRowsOfAnotherLength) {
  EXPECT_THAT(joint_problems(kFive + "1,2,3,4\n\n1,2,3,4,5,6\n# comment\n1,2,3,4,5\n"),
              ElementsAre("a.csv:2:8: expected 5 values as in the header, found 4",
                          "a.csv:3:1: expected 5 values as in the header, found an empty line",
                          "a.csv:4:11: expected 5 values as in the header, found 6",
                          "a.csv:5:10: expected 5 values as in the header, found 1"));
}

TEST(JointFile, CountsColumnsInCharacters) {
  EXPECT_THAT(joint_problems(kFive + "\xC3\xA4\xC3\xB6,2,3,4,x\n"),
              ElementsAre("a.csv:2:1: j1_deg: expected a number (deg), found \"\xC3\xA4\xC3\xB6\"",
                          "a.csv:2:10: j5_deg: expected a number (deg), found \"x\""));
}

TEST(JointFile, SaysWhereTheHeaderDiffers) {
  EXPECT_THAT(joint_problems("j1_deg,j2_deg,j3_dge,j4_deg,j5_deg\nx\n"),
              ElementsAre("a.csv:1:15: header: expected \"j3_deg\", found \"j3_dge\"; the header is "
                          "j1_deg,j2_deg,j3_deg,j4_deg,j5_deg"));
  EXPECT_THAT(joint_problems("j1_deg,j2_deg,j3_deg,j4_deg,j5_deg,j6_deg\n1,2,3,4,5,6\n"),
              ElementsAre(HasSubstr("a.csv:1:36: header: expected the end of the line, found \"j6_deg\"")));
  EXPECT_THAT(joint_problems("1,2,3,4,5\n"),
              ElementsAre(HasSubstr("a.csv:1:1: header: expected \"j1_deg\", found \"1\"")));
  // Such as a file that a link leads to.
  EXPECT_THAT(joint_problems("root:$6$salt$hash:19700:0:::\n"),
              ElementsAre(HasSubstr("a.csv:1:1: header: expected \"j1_deg\", found another text; the header is ")));
  EXPECT_THAT(joint_problems(" \n\n"),
              ElementsAre("a.csv: is empty, expected the header j1_deg,j2_deg,j3_deg,j4_deg,j5_deg"));
}

TEST(JointFile, ReportsTheFirstProblemsAndCountsTheRest) {
  std::string text = kFive;
  for (std::size_t i = 0; i < CsvProblems::kMaxReported + 7; ++i) text += "1,2,3,4,bad\n";
  const std::vector<std::string> problems = joint_problems(text);
  ASSERT_EQ(problems.size(), CsvProblems::kMaxReported + 1);
  EXPECT_THAT(problems.front(), HasSubstr("a.csv:2:9: j5_deg"));
  EXPECT_EQ(problems.back(), "a.csv: and 7 more problems");
}

TEST(PoseFile, ReadsMatricesRowByRow) {
  const auto rows = parse_poses(kMatrix + "\n0,-1,0,10,1,0,0,20,0,0,1,30\n", "p.csv", 6);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].pose.rotation(0, 1), -1);
  EXPECT_EQ(rows[0].pose.rotation(1, 0), 1);
  EXPECT_EQ(rows[0].pose.position_mm, Eigen::Vector3d(10, 20, 30));
  EXPECT_EQ(rows[0].previous_deg, PerAxis<double>{});
}

TEST(PoseFile, ReadsPreviousJointsWhereTheHeaderNamesThemAll) {
  const auto rows = parse_poses(kMatrix + kPrevious + "\n1,0,0,1,0,1,0,2,0,0,1,3,1,2,3,4,5,6\n", "p.csv", 6);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].previous_deg, (PerAxis<double>{1, 2, 3, 4, 5, 6}));
  EXPECT_THAT(pose_problems(kMatrix + ",prev1_deg,prev2_deg\n"),
              ElementsAre(HasSubstr("p.csv:1:68: header: expected \"prev3_deg\", found the end of the line; the header "
                                    "is " +
                                    kMatrix + " or " + kMatrix + kPrevious)));
}

TEST(PoseFile, RefusesWhatIsNoRotation) {
  EXPECT_THAT(
      pose_problems(kMatrix + "\n"
                              "1,0,0,1,0,1,0,2,0,0,1,3\n"
                              "1,0,0,1,0,1,0,2,0,0,-1,3\n"
                              "  0,0,0,1,0,0,0,2,0,0,0,3\n"
                              "1,0.001,0,1,0,1,0,2,0,0,1,3\n"
                              "1e300,0,0,1,0,1e300,0,2,0,0,1,3\n"),
      ElementsAre("p.csv:3:1: expected a rotation in t11 .. t33, but it is a reflection: determinant -1, expected +1",
                  "p.csv:4:3: expected a rotation in t11 .. t33, but its columns are not orthonormal: off by 1, "
                  "allowed is 1e-06",
                  "p.csv:5:1: expected a rotation in t11 .. t33, but its columns are not orthonormal: off by "
                  "0.001, allowed is 1e-06",
                  HasSubstr("p.csv:6:1: t11: expected a number from"),
                  HasSubstr("p.csv:6:15: t22: expected a number from")));
}

TEST(PoseFile, TheToleranceOfARotationIsAMillionth) {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  rotation(0, 1) = 0.99e-6;
  EXPECT_FALSE(rotation_problem(rotation));
  rotation(0, 1) = 1.01e-6;
  EXPECT_TRUE(rotation_problem(rotation));
  rotation(0, 1) = std::nan("");
  EXPECT_TRUE(rotation_problem(rotation));
}

TEST(PoseFile, WhatIsWrittenReadsBackAsTheSameBits) {
  const double third = 1.0 / 3.0;
  const Transform pose{
      Eigen::Matrix3d{{third, 2 * third, -2 * third}, {-2 * third, 2 * third, third}, {2 * third, third, 2 * third}},
      {1e-300, -0.1, 123456.789012345678}};
  const auto rows = parse_poses(poses_text(std::vector{pose}), "p.csv", 6);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].pose.rotation, pose.rotation);
  EXPECT_EQ(rows[0].pose.position_mm, pose.position_mm);
}

TEST(SolutionsFile, HasOneRowABranch) {
  IkSolutions found;
  found.count = 2;
  found.selected = 1;
  found.status = IkStatus::kOk;
  found.branches[0] = {.joints = {}, .shoulder = 1, .elbow = -1, .flip = 1, .singular = 6, .within_limits = false};
  found.branches[1] = {.joints = {Radians{std::numbers::pi}, Radians{-0.0}}, .shoulder = -1, .elbow = 1, .flip = -1};
  found.branches[1].within_limits = true;
  SolutionsText text{6};
  text.add(found);
  text.add(found);
  EXPECT_EQ(
      text.text(),
      "pose,branch,shoulder,elbow,flip,singular,within_limits,selected,j1_deg,j2_deg,j3_deg,j4_deg,j5_deg,j6_deg\n"
      "0,0,1,-1,1,6,0,0,0,0,0,0,0,0\n"
      "0,1,-1,1,-1,0,1,1,180,0,0,0,0,0\n"
      "1,0,1,-1,1,6,0,0,0,0,0,0,0,0\n"
      "1,1,-1,1,-1,0,1,1,180,0,0,0,0,0\n");
}

TEST(SolutionsFile, SaysWhyThereIsNone) {
  IkSolutions far;
  far.status = IkStatus::kUnreachable;
  far.margin_mm = 12.3456784;
  IkSolutions turned;
  turned.status = IkStatus::kOrientation;
  turned.residual_rad = 1.23 * std::numbers::pi / 180;
  IkSolutions hardly = far;
  hardly.margin_mm = 2.5e-7;
  SolutionsText text{5};
  text.add(far);
  text.add(turned);
  text.add(hardly);
  EXPECT_EQ(text.text(),
            "pose,branch,shoulder,elbow,flip,singular,within_limits,selected,j1_deg,j2_deg,j3_deg,j4_deg,j5_deg\n"
            "0,none,unreachable by 12.345678 mm,,,,,,,,,,\n"
            "1,none,orientation off by 1.230000 deg,,,,,,,,,,\n"
            "2,none,unreachable by 2.5e-07 mm,,,,,,,,,,\n");
}

TEST(Numbers, AreDecimalAndFinite) {
  EXPECT_EQ(parse_number("+1.5e-3"), 0.0015);
  EXPECT_EQ(parse_number("-.5"), -0.5);
  EXPECT_EQ(parse_number("5."), 5.0);
  for (const char* bad :
       {"", "+", "-", "++1", "+-1", "1e", "1,5", "nan", "-inf", "infinity", "1e400", "0x1p3", "1 2"}) {
    EXPECT_FALSE(parse_number(bad)) << bad;
  }
}

}  // namespace
}  // namespace armature::cosim
