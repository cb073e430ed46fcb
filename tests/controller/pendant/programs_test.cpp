#include "controller/pendant/parts/programs.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <string_view>

#include "tests/controller/pendant/parts_bench.hpp"

namespace armature::pendant {
namespace {

class ProgramsTest : public testing::Test {
 protected:
  // Sends a G-code program of at most a frame. Its text is not read before it runs, so it takes no time to load.
  Answer send_gcode(std::string_view text) {
    EXPECT_EQ(programs.begin(Content::kGcode, static_cast<std::int32_t>(text.size())).status, Status::kOk);
    BulkFrame frame{};
    Crc32 crc;
    for (std::size_t i = 0; i < text.size(); ++i) {
      frame.text[i] = static_cast<std::uint8_t>(text[i]);
      crc.add(frame.text[i]);
    }
    static_cast<void>(programs.push(frame));
    return programs.commit(crc.check(), bench.parts.line, bench.bus);
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

TEST_F(ProgramsTest, ATransferWithAnErrorLeavesTheProgramOfTheHostAlone) {
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
