#include "controller/language/job/loader/header_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/controller/language/job/job_text.hpp"

namespace armature::job {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::string with_positions(const std::string& lines) {
  return "/JOB\n//NAME A\n//POS\n" + lines + "//INST\nNOP\nEND\n";
}

TEST(JobHeader, KeepsWithEachPositionWhatTheLinesAboveItSay) {
  test::Jobs jobs;
  ASSERT_TRUE(
      jobs.load(with_positions("///NPOS 3,0,0,1,0,0\n///TOOL 3\n///POSTYPE PULSE\n///PULSE\n"
                               "C00000=1,-2,3,-4,5,-6\n///USER 2\n///POSTYPE USER\n///RECTAN\n"
                               "///RCONF 1,0,1,0,0,1,0,0\nC00001=1.500,0,0,0,0,90.0000\n///TOOL 4\n"
                               "C00002=2.5,0,0,0,0,0\n///POSTYPE ROBOT\nP00007=3,0,0,0,0,0\n")));
  const auto positions = jobs.memory->positions_of(jobs.memory->jobs[0]);
  ASSERT_EQ(positions.size(), 4U);
  EXPECT_EQ(positions[0].frame, Frame::kPulse);
  EXPECT_EQ(positions[0].value, (std::array<double, 6>{1, -2, 3, -4, 5, -6}));
  EXPECT_EQ(positions[0].rconf, 0);
  EXPECT_EQ(positions[1].frame, Frame::kUser);
  EXPECT_EQ(positions[1].user, 2);
  EXPECT_EQ(positions[1].tool, 3);
  EXPECT_EQ(positions[1].rconf, Position::kHasRconf | 0b100101);
  EXPECT_EQ(positions[1].value[5], 90.0);
  EXPECT_EQ(positions[2].tool, 4);
  EXPECT_EQ(positions[3].frame, Frame::kRobot);
  EXPECT_EQ(positions[3].letter, PositionLetter::kP);
  EXPECT_EQ(positions[3].number, 7);
}

TEST(JobHeader, ReadsRectanglesOfOldFilesInTheBase) {
  test::Jobs jobs;
  ASSERT_TRUE(jobs.load(with_positions("///NPOS 1,0,0,0\n///RECTAN\nC000=1,2,3,4,5,6\n")));
  EXPECT_EQ(jobs.memory->positions[0].frame, Frame::kBase);
}

TEST(JobHeader, ReadsTheNumbersOfLocalVariables) {
  test::Jobs jobs;
  ASSERT_TRUE(jobs.load("/JOB\n//NAME A\n//POS\n//INST\n///LVARS 1,2,3,4,5,6,7,8\nNOP\nEND\n"));
  EXPECT_THAT(jobs.memory->jobs[0].locals, ElementsAre(1, 2, 3, 4, 5, 6, 7, 8));
}

TEST(JobHeader, ComparesThePositionsWithTheirStatedNumber) {
  EXPECT_THAT(test::errors_of(with_positions("///NPOS 2,0,0,1,0,0\nC00000=0,0,0,0,0,0\n")),
              ElementsAre("a.jbi:4:1: NPOS states 2 positions C, the file has 1",
                          "a.jbi:4:1: NPOS states 1 positions P, the file has 0"));
  EXPECT_THAT(test::errors_of(with_positions("C00000=0,0,0,0,0,0\n")),
              ElementsAre("a.jbi:7:1: the job has positions, and no ///NPOS"));
}

TEST(JobHeader, ReportsEachBadPositionWithItsColumn) {
  EXPECT_THAT(
      test::errors_of(with_positions("///NPOS 0,0,0,0,0,0\nC00000=0,0,0\nC1=0,0,0,x,0,0\nD2=0\nC=0\nC3 0\n"
                                     "C4=0,0,0,0,0,0,0\nC5=0,0,0,0,0,1E2\nC6=0,0,0,0,0,0 1\nC99999=0,0,0,0,0,0\n"
                                     "P256=0,0,0,0,0,0\n")),
      ElementsAre("a.jbi:5:13: a position of the arm has 6 values", "a.jbi:6:10: expected a number",
                  "a.jbi:7:1: expected a position: C, BC, EC, P, BP or EX and a number",
                  "a.jbi:8:2: expected the number of the position", "a.jbi:9:3: expected '='",
                  "a.jbi:10:16: a position has at most 6 values", "a.jbi:11:14: expected a number",
                  "a.jbi:12:16: expected a comma or the end of the line", "a.jbi:13:2: expected a number up to 65534",
                  "a.jbi:14:2: expected a number up to 255"));
}

TEST(JobHeader, RefusesASecondPositionOfOneName) {
  EXPECT_THAT(test::errors_of(with_positions("///NPOS 1,0,0,0,0,0\nC00001=0,0,0,0,0,0\nC001=0,0,0,0,0,0\n")),
              ElementsAre("a.jbi:6:1: the same position as in line 5"));
}

TEST(JobHeader, ReportsWhatIsMissing) {
  EXPECT_THAT(test::errors_of(""), ElementsAre("a.jbi:0:1: expected /JOB"));
  EXPECT_THAT(test::errors_of("/JOB\n"),
              ElementsAre("a.jbi:1:1: the job has no //NAME", "a.jbi:1:1: the job has no //INST"));
  EXPECT_THAT(test::errors_of("NOP\nEND\n"),
              ElementsAre("a.jbi:1:1: expected /JOB", "a.jbi:2:1: expected a line that begins with a slash",
                          "a.jbi:2:1: the job has no //NAME", "a.jbi:2:1: the job has no //INST"));
}

TEST(JobHeader, ReportsWrongNumbersAndNames) {
  EXPECT_THAT(
      test::errors_of(with_positions("///NPOS a\n///TOOL 64\n///USER\n///POSTYPE CUBE\n///RCONF 0,2\n///RCONF 0;1\n"
                                     "//POS\n///NPOS 0,0,0,0,0,0,0\n")),
      ElementsAre("a.jbi:4:9: expected a whole number", "a.jbi:5:9: expected a number from 0 to 63",
                  "a.jbi:6:8: expected a whole number",
                  "a.jbi:7:12: expected PULSE, ANGLE, ROBOT, BASE, USER, TOOL or MTOOL",
                  "a.jbi:8:10: the first six fields of RCONF are 0 or 1", "a.jbi:9:11: expected a comma",
                  "a.jbi:10:1: //POS is not expected here", "a.jbi:11:21: too many numbers"));
}

TEST(JobHeader, WarnsOfWhatHasNoEffect) {
  test::Jobs jobs;
  EXPECT_TRUE(jobs.load(with_positions("///RCONF 0,0,0,0,0,0,0,1\n///SECRET 5\n")));
  EXPECT_THAT(jobs.said.warnings, ElementsAre("a.jbi:4:10: fields 7 to 24 of RCONF have no effect",
                                              "a.jbi:5:1: unknown line 'SECRET' is kept and has no effect"));
}

TEST(JobHeader, AcceptsComments) {
  EXPECT_THAT(test::errors_of("/JOB\n'old\n//NAME A\n//POS\n'none\n//INST\nNOP\nEND\n"), IsEmpty());
}

}  // namespace
}  // namespace armature::job
