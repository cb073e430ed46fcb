#include "controller/language/job/loader/block_linker.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/controller/language/job/job_text.hpp"

namespace armature::job {
namespace {

using testing::ElementsAre;

// target and partner of each record, "-" for none.
std::vector<std::string> links_of(const std::string& text) {
  test::Jobs jobs;
  EXPECT_TRUE(jobs.load(text));
  std::vector<std::string> links;
  const auto place = [](std::uint16_t at) { return at == kNowhere ? std::string{"-"} : std::to_string(at); };
  for (const Record& record : jobs.memory->records_of(jobs.memory->jobs[0])) {
    links.push_back(place(record.target) + "/" + place(record.partner));
  }
  return links;
}

TEST(BlockLinker, ConnectsTheBranchesOfACondition) {
  EXPECT_THAT(links_of(test::job_of("IFTHENEXP B000=1\nINC B001\nELSEIFEXP B000=2\nINC B002\nELSE\nINC B003\nENDIF\n")),
              ElementsAre("-/-", "3/7", "-/-", "5/7", "-/-", "7/7", "-/-", "-/-", "-/-"));
}

TEST(BlockLinker, ConnectsLoopsWithinEachOther) {
  EXPECT_THAT(links_of(test::job_of("FOR I000 START= 1 TO 3\nWHILEEXP B000=0\nINC B000\nENDWHILE\nNEXT I000\n")),
              ElementsAre("-/-", "5/-", "4/-", "-/-", "-/2", "-/1", "-/-"));
}

TEST(BlockLinker, ConnectsTheCasesOfASwitch) {
  EXPECT_THAT(links_of(test::job_of("SWITCH B000\nCASE 1\nNOP\nCASE 2\nDEFAULT\nENDSWITCH\n")),
              ElementsAre("-/-", "2/6", "4/6", "-/-", "5/6", "6/6", "-/-", "-/-"));
}

TEST(BlockLinker, FindsLabelsBeforeAndBehind) {
  EXPECT_THAT(links_of(test::job_of("JUMP *END\n*TOP\nJUMP *TOP\n*END\n")),
              ElementsAre("-/-", "4/-", "2/-", "2/-", "4/-", "-/-"));
}

TEST(BlockLinker, ReportsBlocksThatDoNotMatch) {
  EXPECT_THAT(test::errors_of(test::job_of(
                  "ENDIF\nIFTHENEXP B000=1\nENDWHILE\nELSE\nELSE\nENDIF\n\t WHILEEXP B000=1\nNEXT I000\n")),
              ElementsAre("a.jbi:7:1: ENDIF does not end IFTHENEXP", "a.jbi:9:1: ENDWHILE does not end WHILEEXP",
                          "a.jbi:11:1: ELSE behind ELSE or DEFAULT", "a.jbi:14:1: NEXT does not end FOR",
                          "a.jbi:13:3: WHILEEXP has no end"));
  EXPECT_THAT(test::errors_of(test::job_of("FOR I000 START= 1 TO 3\nNEXT I001\nCASE 1\n")),
              ElementsAre("a.jbi:8:1: NEXT has another variable than FOR in line 7",
                          "a.jbi:9:1: CASE is not inside of SWITCH"));
}

TEST(BlockLinker, ReportsTooManyBlocksWithinEachOther) {
  std::string text;
  for (int i = 0; i < 33; ++i) text += "IFTHENEXP B000=1\n";
  for (int i = 0; i < 33; ++i) text += "ENDIF\n";
  const auto errors = test::errors_of(test::job_of(text));
  ASSERT_FALSE(errors.empty());
  EXPECT_EQ(errors[0], "a.jbi:39:1: more than 32 blocks within each other");
}

TEST(BlockLinker, ReportsASecondLabel) {
  EXPECT_THAT(test::errors_of(test::job_of("*A\n*B\n*A\n")),
              ElementsAre("a.jbi:9:1: the label *A stands in line 7 already"));
}

TEST(BlockLinker, WantsNopFirstAndEndLast) {
  EXPECT_THAT(test::errors_of("/JOB\n//NAME A\n//POS\n//INST\nINC B000\nEND\nNOP\n"),
              ElementsAre("a.jbi:5:1: the first instruction must be NOP", "a.jbi:7:1: an instruction behind END"));
  EXPECT_THAT(test::errors_of("/JOB\n//NAME A\n//POS\n//INST\nNOP\n"),
              ElementsAre("a.jbi:5:1: the last instruction must be END"));
}

TEST(BlockLinker, ConnectsThePointsOfArcs) {
  test::Jobs jobs;
  ASSERT_TRUE(
      jobs.load(test::moving_job_of("MOVC C0\n'a comment\nMOVC C1\nDOUT OT#(1) ON\nMOVC C2 FPT\nMOVC C3\nMOVC C4\n"
                                    "MOVL C0\n")));
  const auto records = jobs.memory->records_of(jobs.memory->jobs[0]);
  EXPECT_EQ(records[1].flags, Record::kArcFirst);
  EXPECT_EQ(records[1].target, 3);
  EXPECT_EQ(records[3].flags, 0);
  EXPECT_EQ(records[3].partner, 1);
  EXPECT_EQ(records[5].flags, Record::kArcEnds);
  EXPECT_EQ(records[6].partner, 5);
  EXPECT_EQ(records[7].flags, Record::kArcEnds);
  EXPECT_EQ(records[7].target, kNowhere);
  EXPECT_EQ(records[8].partner, kNowhere);
}

TEST(BlockLinker, ReportsArcsWithTooFewPoints) {
  const std::string arc = "an arc needs three successive MOVC";
  EXPECT_THAT(test::errors_of(test::moving_job_of("MOVC C0\n")), ElementsAre("a.jbi:15:1: " + arc));
  EXPECT_THAT(test::errors_of(test::moving_job_of("MOVC C0\nMOVC C1\nMOVL C2\n")), ElementsAre("a.jbi:15:1: " + arc));
  EXPECT_THAT(test::errors_of(test::moving_job_of("MOVC C0\nMOVC C1\n*L\nMOVC C2\n")),
              ElementsAre("a.jbi:15:1: " + arc, "a.jbi:18:1: " + arc));
  EXPECT_THAT(test::errors_of(test::moving_job_of("MOVC C0\nMOVC C1\nMOVC C2 FPT\nMOVC C3\n")),
              ElementsAre("a.jbi:17:1: " + arc));
  EXPECT_THAT(test::errors_of(test::moving_job_of("MOVS C0\nMOVS C1\n")),
              ElementsAre("a.jbi:15:1: a curve needs three successive MOVS"));
}

}  // namespace
}  // namespace armature::job
