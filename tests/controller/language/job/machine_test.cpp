#include "controller/language/job/execute/machine.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/controller/language/job/machine_rig.hpp"

namespace armature::job {
namespace {

using test::job_of;
using test::MachineRig;
using testing::ElementsAre;
using Progress = Program::Progress;

TEST(Machine, PausesWhenTheArmStands) {
  MachineRig rig{test::moving_job_of("MOVJ C1\nPAUSE\nSET B000 1\n")};
  rig.port.arrived = false;
  EXPECT_EQ(rig.run(), Progress::kWaiting);
  rig.port.arrived = true;
  EXPECT_EQ(rig.run(), Progress::kPaused);
  EXPECT_EQ(rig.b(0), 0);
  EXPECT_EQ(rig.run(), Progress::kEnded);
  EXPECT_EQ(rig.b(0), 1);
}

TEST(Machine, PausesAtABreakpointEachTime) {
  MachineRig rig{job_of("*L\nINC B000\nJUMP *L IF B000<3\n")};
  EXPECT_TRUE(rig.port.breakpoints.add(Machine::place_of(0, 8)));
  for (int round = 0; round < 3; ++round) {
    EXPECT_EQ(rig.run(), Progress::kPaused);
    EXPECT_EQ(rig.machine->line(), 8U);
    EXPECT_EQ(rig.b(0), round);
  }
  EXPECT_EQ(rig.run(), Progress::kEnded);
}

TEST(Machine, ABreakpointThatIsRemovedBeforeTheArmIsThereDoesNotPause) {
  MachineRig rig{test::moving_job_of("MOVJ C1\nSET B000 1\n")};
  EXPECT_TRUE(rig.port.breakpoints.add(Machine::place_of(0, 16)));
  rig.port.arrived = false;
  EXPECT_EQ(rig.run(), Progress::kWaiting);
  EXPECT_EQ(rig.b(0), 0);
  rig.port.breakpoints.clear();
  EXPECT_EQ(rig.run(), Progress::kEnded);
  EXPECT_EQ(rig.b(0), 1);
}

TEST(Machine, PausesAtABreakpointOfItsJobOnly) {
  MachineRig rig{{job_of("INC B000\n"), job_of("INC B001\n", "OTHER")}};
  EXPECT_TRUE(rig.port.breakpoints.add(Machine::place_of(1, 7)));
  EXPECT_EQ(rig.run(), Progress::kEnded);
  rig.machine->select(1);
  rig.machine->start();
  EXPECT_EQ(rig.run(), Progress::kPaused);
}

TEST(Machine, ABreakpointDoesNotPauseOnceMoreBehindAPauseOrAStep) {
  MachineRig rig{job_of("PAUSE\nINC B000\nINC B000\n")};
  for (const std::uint32_t line : {8U, 9U}) EXPECT_TRUE(rig.port.breakpoints.add(Machine::place_of(0, line)));
  EXPECT_EQ(rig.run(), Progress::kPaused);  // PAUSE
  rig.machine->set_single_step(true);
  EXPECT_EQ(rig.run(), Progress::kPaused);
  EXPECT_EQ(rig.b(0), 1);
  rig.machine->set_single_step(false);
  EXPECT_EQ(rig.run(), Progress::kEnded);
  EXPECT_EQ(rig.b(0), 2);
}

TEST(Machine, KnowsItsLines) {
  MachineRig rig{job_of("INC B000\n")};  // NOP, INC and END are in the lines 6 to 8
  EXPECT_FALSE(rig.machine->has_line(Machine::place_of(0, 5)));
  for (const std::uint32_t line : {6U, 7U, 8U}) EXPECT_TRUE(rig.machine->has_line(Machine::place_of(0, line)));
  EXPECT_FALSE(rig.machine->has_line(Machine::place_of(0, 9)));
  EXPECT_FALSE(rig.machine->has_line(Machine::place_of(1, 7)));
}

TEST(Machine, StepsThroughAProgram) {
  MachineRig rig{job_of("INC B000\nINC B000\n")};
  rig.machine->set_single_step(true);
  std::vector<std::uint32_t> lines;
  while (rig.run() == Progress::kPaused) lines.push_back(rig.machine->line());
  EXPECT_THAT(lines, ElementsAre(7, 8, 9));
}

TEST(Machine, StartsAtALine) {
  MachineRig rig{job_of("INC B000\nINC B001\nINC B002\n")};
  rig.machine->select(0, 8);
  rig.machine->start();
  EXPECT_EQ(rig.run(), Progress::kEnded);
  EXPECT_EQ(rig.b(0), 0);
  EXPECT_EQ(rig.b(1), 1);
}

TEST(Machine, StartsAgainAsNew) {
  MachineRig rig{job_of("INC B000\nADD P001 P001\n")};
  EXPECT_EQ(rig.run(), Progress::kAlarm);
  rig.machine->start();
  EXPECT_EQ(rig.run(), Progress::kAlarm);
  EXPECT_EQ(rig.b(0), 1);
}

}  // namespace
}  // namespace armature::job
