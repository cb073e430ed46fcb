// The programs that a pendant sends, as the controller keeps them.
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "controller/pendant/parts/program_store.hpp"
#include "tests/controller/language/job/job_text.hpp"
#include "tests/controller/support/path_rig.hpp"

namespace armature::pendant {
namespace {

using armature::test::job_of;

struct StoreTest : testing::Test {
  // Sends a text and commits it.
  Answer send(Content content, const std::string& text) {
    const Answer begun = store->begin(content, static_cast<std::int32_t>(text.size()));
    if (begun.status != Status::kOk) return begun;
    Crc32 crc;
    for (std::size_t at = 0; at < text.size(); at += BulkFrame::kCharacters) {
      BulkFrame frame{.sequence = static_cast<std::uint8_t>(at / BulkFrame::kCharacters % kSequences)};
      for (std::size_t i = 0; i < BulkFrame::kCharacters && at + i < text.size(); ++i) {
        frame.text[i] = static_cast<std::uint8_t>(text[at + i]);
        crc.add(frame.text[i]);
      }
      static_cast<void>(store->push(frame));
    }
    return store->commit(crc.check());
  }
  static void expect(const Answer& answer, Status status, std::int32_t payload) {
    EXPECT_EQ(answer.status, status);
    EXPECT_EQ(answer.payload, payload);
  }

  RobotModel robot = armature::test::irb120();
  Arm arm{robot};
  std::unique_ptr<ProgramStore> store = std::make_unique<ProgramStore>(RobotCell{.robot = robot, .arm = arm},
                                                                       job::MachineSettings{}, gcode::MotionSettings{});
};

TEST_F(StoreTest, KeepsJobsUntilAnotherProgramComes) {
  EXPECT_EQ(store->program(), nullptr);
  expect(send(Content::kJob, job_of("NOP\n", "A")), Status::kOk, 0);
  EXPECT_NE(store->program(), nullptr);
  EXPECT_EQ(store->lines_read(), 9);
  expect(send(Content::kFurtherJob, job_of("CALL JOB:A\n", "B")), Status::kOk, 1);
  expect(store->select(0), Status::kOk, 0);
  expect(store->select(2), Status::kRange, 0);
  expect(send(Content::kJob, job_of("NOP\n", "C")), Status::kOk, 0);
  expect(store->select(1), Status::kRange, 0);
}

TEST_F(StoreTest, HasNoProgramAfterAnError) {
  expect(send(Content::kJob, job_of("NOP\n", "A")), Status::kOk, 0);
  expect(send(Content::kFurtherJob, job_of("NOP\nJUMP *L\nCALL JOB:X\n", "B")), Status::kParseError, 8);
  EXPECT_EQ(store->program(), nullptr);
  expect(send(Content::kJob, job_of("NOP\nCALL JOB:A\n", "B")), Status::kParseError, 8);
  expect(send(Content::kJob, job_of("NOP\n", "A")), Status::kOk, 0);
  expect(send(Content::kFurtherJob, job_of("NOP\n", "A")), Status::kParseError, 2);  // the same name
}

TEST_F(StoreTest, KeepsTheProgramWhenTheTransferIsDamaged) {
  expect(send(Content::kJob, job_of("NOP\n", "A")), Status::kOk, 0);
  Program* before = store->program();
  EXPECT_EQ(store->begin(Content::kJob, 10).status, Status::kOk);
  expect(store->commit(0), Status::kCheckFail, 0);
  EXPECT_EQ(store->program(), before);
  expect(store->commit(0), Status::kCheckFail, 0);  // no transfer
}

TEST_F(StoreTest, RefusesWhatDoesNotFit) {
  constexpr auto kMax = static_cast<std::int32_t>(ProgramStore::kMaxCharacters);
  expect(store->begin(Content::kGcode, kMax + 1), Status::kStoreFull, kMax);
  EXPECT_EQ(store->begin(Content::kGcode, kMax).status, Status::kOk);
  std::string lines;
  for (std::size_t i = 0; i < job::kMaxRecords; ++i) lines += "NOP\n";
  // The header has 5 lines, and one NOP comes before.
  expect(send(Content::kJob, job_of(lines)), Status::kStoreFull, 5 + static_cast<std::int32_t>(job::kMaxRecords) + 1);
}

TEST_F(StoreTest, AGcodeProgramGoesWithTheNextTransfer) {
  expect(send(Content::kGcode, "G0 X0\nM2\n"), Status::kOk, 0);
  EXPECT_NE(store->program(), nullptr);
  expect(store->select(0), Status::kRange, 0);
  EXPECT_EQ(store->begin(Content::kJob, 10).status, Status::kOk);
  EXPECT_EQ(store->program(), nullptr);
}

}  // namespace
}  // namespace armature::pendant
