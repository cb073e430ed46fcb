#include "controller/pendant/parts/programs.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "tests/controller/language/job/job_text.hpp"
#include "tests/controller/pendant/parts_bench.hpp"

namespace armature::pendant {
namespace {

using armature::test::job_of;

class ProgramsTest : public testing::Test {
 protected:
  Answer send(Content content, std::string_view text) {
    const Answer begun = programs.begin(content, static_cast<std::int32_t>(text.size()));
    if (begun.status != Status::kOk) return begun;
    Crc32 crc;
    for (std::size_t at = 0; at < text.size(); at += BulkFrame::kCharacters) {
      BulkFrame frame{.sequence = static_cast<std::uint8_t>(at / BulkFrame::kCharacters % kSequences)};
      for (std::size_t i = 0; i < BulkFrame::kCharacters && at + i < text.size(); ++i) {
        frame.text[i] = static_cast<std::uint8_t>(text[at + i]);
        crc.add(frame.text[i]);
      }
      static_cast<void>(programs.push(frame));
    }
    return programs.commit(crc.check(), bench.parts.line, bench.bus);
  }
  // The text is not read before it runs, so it takes no time to load.
  Answer send_gcode(std::string_view text) { return send(Content::kGcode, text); }
  // The line is polled while a job is loaded; there is no interrupt.
  Answer send_job(Content content, const std::string& text) {
    constexpr std::uint32_t kNoInterrupt = 1;
    EXPECT_CALL(bench.bus, charge(Work::kProgramStep, testing::_)).Times(testing::AtLeast(1));
    EXPECT_CALL(bench.bus, read32(testing::_)).WillRepeatedly(testing::Return(kNoInterrupt));
    EXPECT_CALL(bench.bus, write32(testing::_, testing::_)).Times(testing::AnyNumber());
    if (!bench.parts.line.started()) bench.parts.line.start(bench.bus);
    return send(content, text);
  }
  static void expect(const Answer& answer, Status status, std::int32_t payload) {
    EXPECT_EQ(answer.status, status);
    EXPECT_EQ(answer.payload, payload);
  }
  void expect_breakpoint(BreakpointAction action, ProgramPlace line, Status status, std::int32_t payload) {
    const Answer answer = programs.set_breakpoint(action, line);
    EXPECT_EQ(answer.status, status);
    EXPECT_EQ(answer.payload, payload);
  }
  using ClientState = ProgramClient::State;

  test::PartsBench bench;
  Programs& programs = bench.parts.programs;
  const Coordinates& selected = bench.parts.manual.coordinates();
};

TEST_F(ProgramsTest, ALoadedTextIsTheProgramUntilTheNextTransferOverwritesIt) {
  EXPECT_EQ(programs.may_run(selected), Status::kCheckFail);
  EXPECT_EQ(send_gcode("M2\n").status, Status::kOk);
  EXPECT_EQ(bench.program.state(), ClientState::kReady);
  EXPECT_EQ(programs.may_run(selected), Status::kOk);
  EXPECT_EQ(programs.begin(Content::kGcode, 3).status, Status::kOk);
  EXPECT_EQ(bench.program.state(), ClientState::kIdle);
}

TEST_F(ProgramsTest, AnswersWithTheNumberOfAJobOrTheLineOfItsError) {
  expect(send_job(Content::kJob, job_of("NOP\n", "A")), Status::kOk, 0);
  expect(send_job(Content::kFurtherJob, job_of("CALL JOB:A\n", "B")), Status::kOk, 1);
  expect(programs.select(0), Status::kOk, 0);
  expect(programs.select(2), Status::kRange, 0);
  expect(send_job(Content::kFurtherJob, job_of("NOP\nJUMP *L\nCALL JOB:X\n", "C")), Status::kParseError, 8);
  EXPECT_EQ(bench.program.state(), ClientState::kIdle);
}

TEST_F(ProgramsTest, KeepsTheProgramWhenTheTransferIsDamaged) {
  expect(send_job(Content::kJob, job_of("NOP\n", "A")), Status::kOk, 0);
  EXPECT_EQ(programs.begin(Content::kJob, 10).status, Status::kOk);
  expect(programs.commit(0, bench.parts.line, bench.bus), Status::kCheckFail, 0);
  EXPECT_EQ(bench.program.state(), ClientState::kReady);
  expect(programs.commit(0, bench.parts.line, bench.bus), Status::kCheckFail, 0);  // no transfer
}

TEST_F(ProgramsTest, RefusesATextThatDoesNotFit) {
  constexpr auto kMax = static_cast<std::int32_t>(Programs::kMaxCharacters);
  expect(programs.begin(Content::kGcode, kMax + 1), Status::kStoreFull, kMax);
  EXPECT_EQ(programs.begin(Content::kGcode, kMax).status, Status::kOk);
}

TEST_F(ProgramsTest, ATransferWithAnErrorLeavesTheProgramOfTheStartAlone) {
  bench.program.set(bench.waiting, std::nullopt);
  EXPECT_EQ(programs.begin(Content::kGcode, 3).status, Status::kOk);
  EXPECT_EQ(programs.commit(0, bench.parts.line, bench.bus).status, Status::kCheckFail);
  EXPECT_EQ(bench.program.state(), ClientState::kReady);
}

TEST_F(ProgramsTest, GcodeInAnUndefinedUserFrameDoesNotRun) {
  EXPECT_EQ(send_gcode("M2\n").status, Status::kOk);
  bench.parts.manual.select(System::kUser);
  bench.parts.manual.select_user(2);
  EXPECT_EQ(programs.may_run(selected), Status::kRange);
}

TEST_F(ProgramsTest, RunsTellsOnlyOfAProgramThatThePendantHasRun) {
  bench.program.set(bench.waiting, std::nullopt);
  EXPECT_TRUE(bench.program.run());
  EXPECT_FALSE(programs.runs());
  bench.program.clear();
  bench.program.set(bench.waiting, std::nullopt);
  EXPECT_EQ(programs.run(RunMode::kOnce, 0, std::nullopt).status, Status::kOk);
  EXPECT_TRUE(programs.runs());
  EXPECT_EQ(programs.hold().status, Status::kOk);
  EXPECT_FALSE(programs.runs());
}

TEST_F(ProgramsTest, ARunFromALineThatTheLanguageCannotStartAtIsRefused) {
  bench.program.set(bench.waiting, std::nullopt);
  EXPECT_EQ(programs.run(RunMode::kOnce, 3, std::nullopt).status, Status::kRange);
  EXPECT_FALSE(programs.runs());
}

TEST_F(ProgramsTest, BreakpointsAreCountedAndNeedALineOfTheProgram) {
  using enum BreakpointAction;
  expect_breakpoint(kSet, 7, Status::kCheckFail, 0);
  bench.program.set(bench.waiting, std::nullopt);
  expect_breakpoint(kSet, 8, Status::kRange, 0);
  expect_breakpoint(kSet, 7, Status::kOk, 1);
  expect_breakpoint(kSet, 7, Status::kOk, 1);
  expect_breakpoint(kRemove, 7, Status::kOk, 0);
  expect_breakpoint(kSet, 7, Status::kOk, 1);
  expect_breakpoint(kRemoveAll, 0, Status::kOk, 0);
}

}  // namespace
}  // namespace armature::pendant
