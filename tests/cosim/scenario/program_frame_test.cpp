#include "cosim/scenario/program_frame.hpp"

#include <gtest/gtest.h>

namespace armature::cosim {
namespace {

Scenario with_program(const char* name, const char* text) {
  Scenario scenario;
  scenario.frames = {{.name = "table"}, {.name = "plate"}};
  scenario.program = name;
  scenario.program_files = {{.name = name, .text = text}};
  return scenario;
}

TEST(ProgramFrame, OfGcodeIsThatOfItsSettings) {
  Scenario scenario = with_program("part.NGC", "G1 X1\n");
  EXPECT_EQ(program_frame(scenario), "base");
  scenario.gcode.frame_name = "plate";
  EXPECT_EQ(program_frame(scenario), "plate");
}

TEST(ProgramFrame, OfAJobIsThatOfItsFirstPositions) {
  const auto frame = [](const char* text) { return program_frame(with_program("part.jbi", text)); };
  EXPECT_EQ(frame("/JOB\n///USER 2\n///POSTYPE USER\n///USER 1\n"), "plate");
  EXPECT_EQ(frame("/JOB\n///USER 1\n///POSTYPE BASE\n"), "base");
  EXPECT_EQ(frame("/JOB\n///USER 3\n///POSTYPE USER\n"), "base");  // no such frame
  EXPECT_EQ(frame("/JOB\n///POSTYPE PULSE\n"), std::nullopt);
  EXPECT_EQ(frame("/JOB\n"), "base");
}

TEST(ProgramFrame, IsNoneWithoutAProgram) {
  EXPECT_EQ(program_frame(Scenario{}), std::nullopt);
}

}  // namespace
}  // namespace armature::cosim
