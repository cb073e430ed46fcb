// The files of a program: what the loader of scenarios reads and says about them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "cosim/scenario/command_names.hpp"
#include "cosim/scenario/files/scenario_loader.hpp"
#include "tests/cosim/support/temp_folder.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

struct ProgramFiles : testing::Test {
  // Problems of a scenario with this program, without the folder; sorted as they come.
  std::vector<std::string> load(const std::string& program, const std::string& more = "") {
    folder.write("scenario.toml",
                 "description = \"d\"\nrobot = \"abb_irb120\"\nduration_s = 1\nprogram = \"" + program + "\"\n" + more);
    LoadOptions options;
    options.search_path = fs::path{ARMATURE_SOURCE_DIR} / "scenarios";
    try {
      scenario = load_scenario(folder.path() / "scenario.toml", options);
      return {};
    } catch (const InputError& error) {
      std::vector<std::string> texts;
      const std::string prefix = folder.path().string() + "/";
      for (const Problem& problem : error.problems()) {
        const std::string text = problem.text();
        texts.push_back(text.starts_with(prefix) ? text.substr(prefix.size()) : text);
      }
      return texts;
    }
  }
  [[nodiscard]] std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const ProgramFile& file : scenario.program_files) names.push_back(file.name);
    return names;
  }
  static std::string job(const std::string& name, const std::string& instructions) {
    return "/JOB\n//NAME " + name + "\n//POS\n///NPOS 0,0,0,0,0,0\n//INST\nNOP\n" + instructions + "END\n";
  }

  test::TempFolder folder;
  Scenario scenario;
};

// Many controllers write names in upper case.
TEST_F(ProgramFiles, UpperAndLowerCaseOfNamesAreTheSame) {
  for (const std::string name : {"PART.JBI", "Part.Jbi"}) {
    folder.write(name, job("MAIN", "CALL JOB:SUB\n"));
    folder.write("sub.JBI", job("SUB", ""));
    EXPECT_THAT(load(name), IsEmpty());
    EXPECT_THAT(files(), ElementsAre(name, "sub.JBI"));
  }
  for (const std::string name : {"PART.NGC", "PART.NC", "part.gcode"}) {
    folder.write(name, "M98 P100\nO<probe> CALL\nM2\n");
    folder.write("100.Ngc", "O100\nM99\n");
    folder.write("PROBE.NC", "o<probe> sub\no<probe> endsub\n");
    EXPECT_THAT(load(name), IsEmpty());
    EXPECT_THAT(files(), ElementsAre(name, "100.Ngc", "PROBE.NC"));
    folder.write("100.NC", "G41\n");  // .ngc goes before it
    EXPECT_THAT(load(name), IsEmpty());
  }
  EXPECT_THAT(load("part.ngc.bak"),
              ElementsAre(testing::HasSubstr("expected a file that ends in .ngc, .nc, .gcode or .jbi")));
}

TEST_F(ProgramFiles, AllErrorsOfAGcodeProgramAreReportedWithTheirLines) {
  folder.write("part.ngc", "G21 F600\nG1 X10 Q5\nG41 D1\r\nG1 X20 A5\rM67 E0 Q1\nG2 X30\nM62 P20\nM2\n");
  EXPECT_THAT(load("part.ngc"), ElementsAre("part.ngc:2: Q: no code of the line uses this word",
                                            "part.ngc:3:1: G41: the code is not supported: cutter compensation left",
                                            "part.ngc:4: A, B and C need the orientation 'normal'",
                                            "part.ngc:5: the analog output is not defined",
                                            "part.ngc:6: G2: the arc has neither a radius nor a centre",
                                            "part.ngc:7: the tool has the outputs 0 to 15"));
}

TEST_F(ProgramFiles, EachErrorOfALineIsReported) {
  folder.write("part.ngc", "G21 F600\nG1 X20 A5 T3 M6 M67 E0 Q1\nT5 M6\nT3 M6 G2 X30\nM2\n");
  EXPECT_THAT(load("part.ngc"),
              ElementsAre("part.ngc:2: T3: the tool is not in the tool table; set tools = [3] in [gcode]",
                          "part.ngc:2: the analog output is not defined",
                          "part.ngc:2: A, B and C need the orientation 'normal'",
                          "part.ngc:3: T5: the tool is not in the tool table; set tools = [3, 5] in [gcode]",
                          "part.ngc:4: G2: the arc has neither a radius nor a centre"));
}

TEST_F(ProgramFiles, WhatTheCellDefinesIsNoError) {
  folder.write("part.ngc", "G21 F600\nT3 M6\nG1 X20 A5\nM67 E2 Q1\nG0 X1\nM2\n");
  EXPECT_THAT(load("part.ngc"),
              ElementsAre("part.ngc:2: T3: the tool is not in the tool table; set tools = [3] in [gcode]",
                          "part.ngc:3: A, B and C need the orientation 'normal'",
                          "part.ngc:4: the analog output is not defined"));
  EXPECT_THAT(load("part.ngc",
                   "[gcode]\ntools = [3]\norientation = \"normal\"\n[[gcode.analog]]\nnumber = 2\nfirst_pin = 1\n"
                   "bits = 4\n"),
              IsEmpty());
  EXPECT_THAT(files(), ElementsAre("part.ngc"));
  EXPECT_EQ(scenario.sources.at(1).file, (folder.path() / "part.ngc").string());
}

TEST_F(ProgramFiles, TheCheckEndsWhereAProgramReadsAnInputAndInAnEndlessLoop) {
  folder.write("wait.ngc", "G21\nM66 P0 L0\nG41\nM2\n");
  EXPECT_THAT(load("wait.ngc"), IsEmpty());
  folder.write("loop.ngc", "G21\no1 while [1]\n#1=[#1+1]\no1 endwhile\nG41\nM2\n");
  EXPECT_THAT(load("loop.ngc"), IsEmpty());
}

TEST_F(ProgramFiles, AtMostTwentyErrorsOfAGcodeProgramAreReported) {
  std::string text = "G21\n";
  for (int i = 0; i < 30; ++i) text += "G41\n";
  folder.write("part.ngc", text + "M2\n");
  EXPECT_EQ(load("part.ngc").size(), 20U);
}

TEST_F(ProgramFiles, JobsThatAreCalledAreReadFromFilesOfTheirNames) {
  folder.write("main.jbi", job("MAIN", "CALL JOB:ONE\nCALL JOB:TWO\n"));
  folder.write("ONE.JBI", job("ONE", "CALL JOB:TWO\n"));
  folder.write("TWO.jbi", job("TWO", "CALL JOB:MAIN\nCALL JOB:ONE\n"));
  EXPECT_THAT(load("main.jbi"), IsEmpty());
  EXPECT_THAT(files(), ElementsAre("main.jbi", "ONE.JBI", "TWO.jbi"));
  EXPECT_EQ(scenario.sources.size(), 5U);  // with the scenario and the robot
}

TEST_F(ProgramFiles, AllErrorsOfAllJobsAreReported) {
  folder.write("jobs/MAIN.jbi", job("MAIN", "CALL JOB:SUB\nCALL JOB:GONE\n"));
  EXPECT_THAT(load("jobs/MAIN.jbi"), ElementsAre("jobs/MAIN.jbi:7:6: no job named SUB is loaded",
                                                 "jobs/MAIN.jbi:8:6: no job named GONE is loaded"));
  folder.write("jobs/SUB.jbi", job("SUB", "TIMER\nDOUT OT#(1)\n"));
  EXPECT_THAT(load("jobs/MAIN.jbi"),
              ElementsAre("jobs/SUB.jbi:7:6: expected T= and seconds", "jobs/SUB.jbi:8:12: expected a value"));
  folder.write("jobs/SUB.jbi", job("OTHER", ""));
  EXPECT_EQ(load("jobs/MAIN.jbi").size(), 2U);  // the file has another job
}

TEST_F(ProgramFiles, ARobotWithoutKinematicsHasNoProgram) {
  folder.write("part.ngc", "M2\n");
  const std::string robot = std::string{ARMATURE_SOURCE_DIR} + "/tests/cosim/test_robots/joints_only.toml";
  folder.write("scenario.toml",
               "description = \"d\"\nrobot = \"" + robot + "\"\nduration_s = 1\nprogram = \"part.ngc\"\n");
  EXPECT_THAT([&] { static_cast<void>(load_scenario(folder.path() / "scenario.toml")); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("program: needs [kinematics]")));
}

TEST_F(ProgramFiles, CommandsHaveTheNamesOfTheirSources) {
  const CommandNames none;
  EXPECT_FALSE(none.has_program());
  EXPECT_EQ(none.of(3), "move[3]");
  EXPECT_EQ(none.of(kFirstStreamTag + 1), "stream[1]");
  EXPECT_EQ(none.of(Tag{Source::kPendant, 0x0040'0002}), "pendant[2]");
  EXPECT_EQ(none.of(Tag{Source::kProgram, 12}), "line 12");
  EXPECT_EQ(none.of(Tag{Source::kProgram, 0x1'000C}), "line 12 of job 2");

  folder.write("part.ngc", "M2\n");
  ASSERT_THAT(load("part.ngc"), IsEmpty());
  EXPECT_EQ(CommandNames{scenario}.of(Tag{Source::kProgram, 70'000}), "line 70000 of part.ngc");

  folder.write("MAIN.jbi", job("MAIN", "CALL JOB:SUB\n"));
  folder.write("SUB.jbi", job("SUB", ""));
  ASSERT_THAT(load("MAIN.jbi"), IsEmpty());
  EXPECT_EQ(CommandNames{scenario}.of(Tag{Source::kProgram, 7}), "line 7 of MAIN.jbi");
  EXPECT_EQ(CommandNames{scenario}.of(Tag{Source::kProgram, 0x1'0006}), "line 6 of SUB.jbi");
  EXPECT_EQ(CommandNames{scenario}.of(3), "move[3]");
}

TEST(CommandNames, OfAProgramThatThePendantSendsAreThoseOfItsFiles) {
  Scenario scenario;
  auto& steps = scenario.pendant.emplace().steps;
  const auto send = [&steps](const std::string& file, bool adds_job, const std::string& reply = "ok") {
    PendantStepSpec& step = steps.emplace_back();
    step.act = PendantAct::kDownload;
    step.file = file;
    step.adds_job = adds_job;
    step.reply = reply;
  };
  EXPECT_FALSE(CommandNames{scenario}.has_program());
  send("wrong.jbi", false, "parse_error");  // the controller does not have it
  EXPECT_FALSE(CommandNames{scenario}.has_program());
  send("SUB.jbi", false);
  steps.emplace_back().act = PendantAct::kEstop;
  send("MAIN.jbi", true);
  EXPECT_EQ(CommandNames{scenario}.of(Tag{Source::kProgram, 0x1'0006}), "line 6 of MAIN.jbi");
  EXPECT_TRUE(CommandNames{scenario}.has_program());
  send("part.ngc", false);  // which one is executed is not known
  EXPECT_EQ(CommandNames{scenario}.of(Tag{Source::kProgram, 0x1'0006}), "line 6 of job 2");
  EXPECT_TRUE(CommandNames{scenario}.has_program());
}

TEST_F(ProgramFiles, CommandsOfTwoProgramsHaveNoFiles) {
  folder.write("part.ngc", "M2\n");
  ASSERT_THAT(load("part.ngc"), IsEmpty());
  PendantStepSpec& step = scenario.pendant.emplace().steps.emplace_back();
  step.act = PendantAct::kDownload;
  step.file = "row.jbi";
  EXPECT_EQ(CommandNames{scenario}.of(Tag{Source::kProgram, 0x1'0006}), "line 6 of job 2");
}

TEST(MoveIndex, IsThatOfAMoveOfTheScenarioOnly) {
  EXPECT_EQ(move_index(3), 3U);
  EXPECT_FALSE(move_index(kFirstStreamTag));
  EXPECT_FALSE(move_index(Tag{Source::kProgram, 3}));
  EXPECT_FALSE(move_index(Tag{Source::kPendant, 3}));
}

}  // namespace
}  // namespace armature::cosim
