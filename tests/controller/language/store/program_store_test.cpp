// The programs of the controller: that of the start, and those that are sent later.
#include "controller/language/store/program_store.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "tests/controller/language/gcode/gcode_rig.hpp"
#include "tests/controller/language/job/job_text.hpp"

namespace armature {
namespace {

using test::job_of;
using Loaded = ProgramStore::Loaded;

struct StoreTest : testing::Test {
  StoreTest() {
    cell.setup.cell.base_T_user[1] = Transform{.position_mm = {0.0, 0.0, 10.0}};
    store = std::make_unique<ProgramStore>(cell.setup.cell, job::MachineSettings{}, cell.setup.settings);
  }

  // The program of the start.
  Loaded load(ProgramLanguage language, const std::vector<std::string>& all) {
    files = {.language = language, .count = static_cast<std::uint32_t>(all.size())};
    for (std::size_t i = 0; i < all.size(); ++i) {
      names += "ab"[i];
      texts += all[i];
      files.name_ends[i] = static_cast<std::uint32_t>(names.size());
      files.text_ends[i] = static_cast<std::uint32_t>(texts.size());
    }
    return store->load_first(files, names, texts);
  }
  Loaded send(const std::string& text, bool further = false) { return store->load_sent_job(text, further); }

  // Executes the program to its end.
  void run() {
    ASSERT_NE(store->program(), nullptr);
    port.sent.clear();
    port.notes.clear();
    store->program()->start();
    Program::Progress progress{};
    do {
      progress = store->program()->step(port);
    } while (progress == Program::Progress::kWorking);
    EXPECT_EQ(progress, Program::Progress::kEnded) << (port.notes.empty() ? "" : port.notes.back().text.view());
  }
  [[nodiscard]] std::vector<std::string> messages() const {
    std::vector<std::string> all;
    for (const ProgramNote& note : port.notes_of(ProgramNote::Kind::kMessage)) all.emplace_back(note.text.view());
    return all;
  }

  test::Cell cell;
  test::KeepingPort port{cell};
  ProgramFiles files;
  std::string names, texts;
  std::unique_ptr<ProgramStore> store;
};

TEST_F(StoreTest, KeepsSentJobsUntilAnotherProgramComes) {
  EXPECT_EQ(store->program(), nullptr);
  EXPECT_EQ(send(job_of("NOP\n", "A")), Loaded::kYes);
  EXPECT_NE(store->program(), nullptr);
  EXPECT_EQ(store->last_job(), 0u);
  EXPECT_EQ(send(job_of("CALL JOB:A\n", "B"), true), Loaded::kYes);
  EXPECT_EQ(store->last_job(), 1u);
  EXPECT_TRUE(store->select(0));
  EXPECT_FALSE(store->select(2));
  EXPECT_EQ(send(job_of("NOP\n", "C")), Loaded::kYes);
  EXPECT_FALSE(store->select(1));
}

TEST_F(StoreTest, HasNoProgramAfterAnError) {
  EXPECT_EQ(send(job_of("NOP\n", "A")), Loaded::kYes);
  EXPECT_EQ(send(job_of("NOP\nJUMP *L\nCALL JOB:X\n", "B"), true), Loaded::kError);
  EXPECT_EQ(store->error_line(), 8u);
  EXPECT_EQ(store->program(), nullptr);
  EXPECT_EQ(send(job_of("NOP\nCALL JOB:A\n", "B")), Loaded::kError);
  EXPECT_EQ(store->error_line(), 8u);
  EXPECT_EQ(send(job_of("NOP\n", "A")), Loaded::kYes);
  EXPECT_EQ(send(job_of("NOP\n", "A"), true), Loaded::kError);  // the same name
  EXPECT_EQ(store->error_line(), 2u);
}

TEST_F(StoreTest, RefusesWhatDoesNotFit) {
  std::string lines;
  for (std::size_t i = 0; i < job::kMaxRecords; ++i) lines += "NOP\n";
  EXPECT_EQ(send(job_of(lines)), Loaded::kFull);
  EXPECT_EQ(store->error_line(), 5 + job::kMaxRecords + 1);  // the header has 5 lines, and one NOP comes before
}

TEST_F(StoreTest, SentGcodeGoesWhenItsTextIsOverwritten) {
  store->load_sent_gcode("G0 X0\nM2\n");
  EXPECT_TRUE(store->has_sent_gcode());
  EXPECT_FALSE(store->select(0));
  EXPECT_TRUE(store->drop_sent_gcode());
  EXPECT_EQ(store->program(), nullptr);
  EXPECT_FALSE(store->drop_sent_gcode());
}

TEST_F(StoreTest, TheProgramOfTheStartBeginsWithItsFirstFile) {
  ASSERT_EQ(load(ProgramLanguage::kJob, {job_of("MSG \"A\"\nCALL JOB:B\n", "A"), job_of("MSG \"B\"\n", "B")}),
            Loaded::kYes);
  EXPECT_FALSE(store->select(1));  // it was not sent
  run();
  EXPECT_EQ(messages(), (std::vector<std::string>{"A", "B"}));
}

TEST_F(StoreTest, TheProgramOfTheStartHasSubroutinesInFurtherFiles) {
  ASSERT_EQ(load(ProgramLanguage::kGcode, {"o<b> call\nM2\n", "o<b> sub\n(MSG,B)\no<b> endsub\n"}), Loaded::kYes);
  EXPECT_FALSE(store->has_sent_gcode());
  EXPECT_FALSE(store->drop_sent_gcode());
  run();
  EXPECT_EQ(messages(), std::vector<std::string>{"B"});
}

TEST_F(StoreTest, SaysWhereTheProgramOfTheStartIsWrong) {
  EXPECT_EQ(load(ProgramLanguage::kJob, {job_of("CALL JOB:B\n", "A"), job_of("JUMP *L\n", "B")}), Loaded::kError);
  EXPECT_EQ(store->error().substr(0, 5), "b:7:6") << store->error();
}

TEST_F(StoreTest, JobsOfTheStartAreGoneOnceAJobIsSent) {
  ASSERT_EQ(load(ProgramLanguage::kJob, {job_of("SET I001 7\n", "A")}), Loaded::kYes);
  EXPECT_EQ(send(job_of("CALL JOB:A\n", "B"), true), Loaded::kError);
  EXPECT_EQ(store->program(), nullptr);
  EXPECT_EQ(send(job_of("NOP\n", "A"), true), Loaded::kYes);
  EXPECT_EQ(store->last_job(), 0u);
}

// A subroutine can read a parameter that the program before has stored: 5161 is the home position of G28.
TEST_F(StoreTest, ParametersOfTheStartDoNotPassToASentProgramButFromOneSentProgramToTheNext) {
  const std::string sets = "#5161=3\nM2\n", shows = "(DEBUG,#5161)\nM2\n";
  ASSERT_EQ(load(ProgramLanguage::kGcode, {sets}), Loaded::kYes);
  run();
  store->load_sent_gcode(shows);
  run();
  const std::vector<std::string> of_start = messages();
  store->load_sent_gcode(sets);
  run();
  store->load_sent_gcode(shows);
  run();
  ASSERT_EQ(of_start.size(), 1u);
  EXPECT_EQ(of_start.front()[0], '0');
  EXPECT_EQ(messages().front()[0], '3');
}

TEST_F(StoreTest, OnlySentProgramsUseTheFrameOfTheOperator) {
  const auto frame_of_move = [this] {
    store->set_sent_gcode_frame(FrameId{2});
    run();
    return port.all<CartesianMove>().front().target.frame;
  };
  const std::string moves = "G21 F100\nG91 G1 Z1\nM2\n";
  ASSERT_EQ(load(ProgramLanguage::kGcode, {moves}), Loaded::kYes);
  EXPECT_EQ(frame_of_move(), FrameId{1});
  store->load_sent_gcode(moves);
  EXPECT_EQ(frame_of_move(), FrameId{2});
  store->set_sent_gcode_frame(std::nullopt);
  run();
  EXPECT_EQ(port.all<CartesianMove>().front().target.frame, FrameId{1});
}

}  // namespace
}  // namespace armature
