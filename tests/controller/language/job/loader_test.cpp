#include "controller/language/job/loader/loader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "tests/controller/language/job/job_text.hpp"
#include "tests/controller/support/draws.hpp"
#include "tests/controller/support/random.hpp"

namespace armature::job {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(JobLoader, ReportsAllErrorsOfAFileInTheirOrder) {
  test::Jobs jobs;
  EXPECT_FALSE(
      jobs.load("/JOB\n//NAME A\n//POS\n///NPOS 1,0,0,0,0,0\nC0=1,2\n//INST\nNOP\nMOVX C0\nMOVJ C0 PL=9\nEND\n"));
  EXPECT_THAT(jobs.said.errors,
              ElementsAre("a.jbi:5:7: a position of the arm has 6 values", "a.jbi:8:1: unknown instruction 'MOVX'",
                          "a.jbi:9:9: PL= must be a whole number from 0 to 8",
                          "a.jbi:4:1: NPOS states 1 positions C, the file has 0"));
}

TEST(JobLoader, LeavesTheMemoryAsItWasAfterAnError) {
  test::Jobs jobs;
  ASSERT_TRUE(jobs.load(test::moving_job_of("MOVJ C0 VJ=5.00\n", "GOOD")));
  const std::string before = jobs.printed();
  const ProgramMemory& memory = *jobs.memory;
  const std::array marks{memory.job_count,      memory.record_count, memory.operand_count,
                         memory.position_count, memory.header_count, memory.text_size};
  EXPECT_FALSE(jobs.load(test::moving_job_of("MOVJ C0 VJ=5.00\nMOVJ C99\n", "BAD"), "b.jbi"));
  EXPECT_EQ(marks, (std::array{memory.job_count, memory.record_count, memory.operand_count, memory.position_count,
                               memory.header_count, memory.text_size}));
  EXPECT_EQ(jobs.printed(), before);
}

TEST(JobLoader, ResolvesCallsBetweenFilesInAnyOrder) {
  test::Jobs jobs;
  ASSERT_TRUE(jobs.load(test::job_of("CALL JOB:SUB-1\n", "MAIN"), "main.jbi"));
  ASSERT_TRUE(jobs.load(test::job_of("JUMP JOB:MAIN\n", "SUB-1"), "sub.jbi"));
  EXPECT_TRUE(jobs.loader->link());
  EXPECT_EQ(jobs.memory->operands_of(jobs.memory->records[1])[0].number, 1.0);
}

TEST(JobLoader, ReportsCallsOfJobsThatAreNotLoaded) {
  test::Jobs jobs;
  ASSERT_TRUE(jobs.load(test::job_of("CALL JOB:A IF B000=1\n\t JUMP JOB:B\n")));
  EXPECT_FALSE(jobs.loader->link());
  EXPECT_THAT(jobs.said.errors,
              ElementsAre("a.jbi:7:6: no job named A is loaded", "a.jbi:8:8: no job named B is loaded"));
}

TEST(JobLoader, RefusesASecondJobOfOneName) {
  test::Jobs jobs;
  ASSERT_TRUE(jobs.load(test::job_of("")));
  EXPECT_FALSE(jobs.load(test::job_of(""), "b.jbi"));
  EXPECT_THAT(jobs.said.errors, ElementsAre("b.jbi:2:8: a job named TEST is loaded already"));
}

TEST(JobLoader, WarnsOfPositionVariablesThatDiffer) {
  const auto with_p1 = [](const std::string& name, const std::string& x) {
    return "/JOB\n//NAME " + name + "\n//POS\n///NPOS 0,0,0,1,0,0\nP001=" + x + ",0,0,0,0,0\n//INST\nNOP\nEND\n";
  };
  test::Jobs jobs;
  ASSERT_TRUE(jobs.load(with_p1("A", "1"), "a.jbi"));
  ASSERT_TRUE(jobs.load(with_p1("B", "1"), "b.jbi"));
  EXPECT_TRUE(jobs.loader->link());
  EXPECT_THAT(jobs.said.warnings, IsEmpty());
  ASSERT_TRUE(jobs.load(with_p1("C", "2"), "c.jbi"));
  EXPECT_TRUE(jobs.loader->link());
  EXPECT_THAT(jobs.said.warnings, ElementsAre("c.jbi:5:1: another job gives P1 other values; these apply"));
}

std::string repeated(const std::string& line, std::size_t times) {
  std::string text;
  for (std::size_t i = 0; i < times; ++i) text += line;
  return text;
}

TEST(JobLoader, ReportsWhatDoesNotFit) {
  const auto first_error = [](const std::string& text) {
    test::Jobs jobs;
    EXPECT_FALSE(jobs.load(text));
    return jobs.said.errors.empty() ? "" : jobs.said.errors.front();
  };
  EXPECT_EQ(first_error(test::job_of(repeated("NOP\n", kMaxRecords))),
            "a.jbi:8198:1: the program memory has room for 8192 instructions");
  EXPECT_EQ(first_error(test::job_of(repeated("SET D000 EXPRESS 1 + 2 + 3 + 4\n", 2'000))),
            "a.jbi:1827:1: the program memory has room for 16384 operands");
  EXPECT_EQ(first_error(test::job_of(repeated("'" + std::string(900, 'x') + "\n", 100))),
            "a.jbi:79:2: the program memory has no room for more text");
  EXPECT_EQ(first_error(test::job_of("'" + std::string(kMaxLineLength, 'x') + "\n")),
            "a.jbi:7:1025: a line has at most 1024 characters");
  std::string positions = "/JOB\n//NAME A\n//POS\n///NPOS 3073,0,0,0,0,0\n";
  for (std::size_t i = 0; i <= kMaxPositions; ++i) positions += "C" + std::to_string(i) + "=0,0,0,0,0,0\n";
  EXPECT_EQ(first_error(positions + "//INST\nNOP\nEND\n"),
            "a.jbi:3077:1: the program memory has room for 3072 positions");

  test::Jobs jobs;
  for (std::size_t i = 0; i < kMaxJobs; ++i) ASSERT_TRUE(jobs.load(test::job_of("", "J" + std::to_string(i))));
  EXPECT_FALSE(jobs.load(test::job_of("", "ONE-MORE")));
  EXPECT_THAT(jobs.said.errors, ElementsAre("a.jbi:0:1: the program memory has room for 32 jobs"));
}

// Pieces from which random lines are made: most are nearly right.
constexpr std::array<const char*, 44> kPieces{"MOVJ",
                                              "MOVL",
                                              "MOVC",
                                              " C00001",
                                              " P[B000]",
                                              " V=5.0",
                                              " PL=",
                                              "SET",
                                              " B000",
                                              " EXPRESS",
                                              " (",
                                              " )",
                                              " +",
                                              " -",
                                              " *",
                                              "*L",
                                              "JUMP",
                                              " *L",
                                              " IF",
                                              "=",
                                              "<>",
                                              " IN#(1)",
                                              " OT#(",
                                              "CALL",
                                              " JOB:A",
                                              " ARGF",
                                              "FOR",
                                              " START=",
                                              " TO",
                                              " STEP=",
                                              "NEXT",
                                              " I000",
                                              "ENDIF",
                                              "ELSE",
                                              " 5",
                                              " -.5E+1",
                                              "\"",
                                              " \"a\"",
                                              "\t ",
                                              "'",
                                              "//NAME",
                                              "///RCONF 1,",
                                              "C1=1,2,3,4,5,6",
                                              "\xFF"};

std::string random_text(test::Random& random) {
  std::string text = random.integer(0, 3) == 0 ? "" : "/JOB\n//NAME A\n//POS\n///NPOS 0,0,0,0,0,0\n//INST\nNOP\n";
  for (std::int64_t lines = random.integer(0, 30); lines > 0; --lines) {
    for (std::int64_t pieces = random.integer(0, 8); pieces > 0; --pieces) {
      if (random.integer(0, 19) == 0) {
        text += static_cast<char>(random.integer(0, 255));
      } else {
        text += kPieces[static_cast<std::size_t>(random.integer(0, std::ssize(kPieces) - 1))];
      }
    }
    text += random.integer(0, 9) == 0 ? "\r" : "\n";
  }
  return text + (random.integer(0, 1) == 0 ? "END\n" : "");
}

TEST(JobLoader, NeverCrashesAndPrintsWhatItAccepts) {
  test::Random random{2607};
  test::Jobs jobs;
  int accepted = 0;
  for (int draw = 0; draw < test::draws(20'000); ++draw) {
    const std::string text = random_text(random);
    jobs.memory->clear();
    jobs.said = {};
    if (!jobs.load(text)) {
      EXPECT_FALSE(jobs.said.errors.empty()) << "seed 2607, draw " << draw;
      continue;
    }
    ++accepted;
    std::string ends;
    for (std::size_t i = 0; i < text.size(); ++i) ends += text[i] == '\r' ? '\n' : text[i];
    EXPECT_EQ(jobs.printed(), test::with_controller_ends(ends)) << "seed 2607, draw " << draw;
  }
  EXPECT_GT(accepted, test::draws(20'000) / 1'000);
}

}  // namespace
}  // namespace armature::job
