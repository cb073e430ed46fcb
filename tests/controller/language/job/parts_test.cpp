#include "controller/language/job/execute/parts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/controller/language/job/cartesian_rigs.hpp"

namespace armature::job {
namespace {

using test::alarm_of;
using test::executed;
using test::job_of;
using test::MachineRig;
using testing::ElementsAre;
using Progress = Program::Progress;

TEST(Parts, NotesLinesMessagesAndAlarms) {
  MachineRig rig{job_of("'comment\nMSG \"part 1\"\nSETUALM 8001 \"no part\" 0\nSET B000 1\n")};
  EXPECT_EQ(rig.run(), Progress::kAlarm);
  EXPECT_THAT(rig.port.lines, ElementsAre(6, 8, 9));
  EXPECT_THAT(rig.port.messages, ElementsAre("part 1"));
  EXPECT_THAT(rig.port.alarms, ElementsAre("SETUALM 8001: no part"));
  EXPECT_EQ(rig.b(0), 0);
  EXPECT_EQ(alarm_of("ABORT\n"), "ABORT: ended by ABORT");
}

TEST(Parts, SwitchStatedOutputs) {
  const std::string instructions = "ARCON ASF#(1)\nWVOF\nTOOLON\nARCOF\nCOMARCON\nCOMARCOF\n";
  EXPECT_EQ(test::alarm_of(instructions), "ARCON: not supported");
  MachineRig rig{test::job_of(instructions)};
  rig.setup.settings.device_pin = {5, 6, 7};
  rig.begin();
  ASSERT_EQ(rig.run(), Progress::kEnded);
  std::string switched;
  for (std::size_t i = 0; i < rig.port.sent.size(); ++i) {
    const auto& output = rig.port.sent_as<SetOutput>(i);
    switched += std::to_string(output.pin) + (output.level ? "+" : "-");
  }
  EXPECT_EQ(switched, "5+6-7+5-5+5-");
}

TEST(Parts, LeaveOutAnInstructionWhoseConditionDoesNotHold) {
  MachineRig rig{job_of(
      "JUMP *L IF B000=1\nCALL JOB:TEST IF B000=1\nPAUSE IF B000=1\nPULSE OT#(1) T=1.00 IF B000=1\nRET 5 IF B000=1\n"
      "*L\nINC B001\n")};
  EXPECT_EQ(rig.run(), Progress::kEnded);
  EXPECT_THAT(rig.port.lines, ElementsAre(6, 7, 8, 9, 10, 11, 12, 13, 14));
  EXPECT_TRUE(rig.port.pulses.empty());
  EXPECT_EQ(rig.b(1), 1);
}

TEST(Parts, ReadAConditionBeforeTheInstructionHasAnyEffect) {
  // Line 12 has the value 300, which does not fit, and a condition that does not hold.
  auto rig = executed("SET I000 300\nSET B001 7\nRET I000 IF B001<>7\nGETS I001 $RV\n");
  EXPECT_EQ(rig.i(1), 0);
}

TEST(Parts, KeepUserFramesWhenAProgramStartsAgain) {
  MachineRig rig{job_of("SETE P001 (1) 100000\nSETE P002 (2) 100000\nMFRAME UF#(1) P003 P001 P002\n")};
  EXPECT_EQ(rig.run(), Progress::kAlarm);  // P003 is not set
  MachineRig kept{
      job_of("JUMP *L IF IN#(1)=ON\nSETE P000 (0) 0\nSETE P001 (1) 100000\nSETE P002 (2) 100000\n"
             "MFRAME UF#(1) P000 P001 P002\nABORT\n*L\nSETE P005 (0) 0\nCNVRT P006 P005 UF#(1)\n")};
  EXPECT_EQ(kept.run(), Progress::kAlarm);
  kept.port.inputs[1] = true;
  kept.machine->start();
  EXPECT_EQ(kept.run(), Progress::kEnded) << kept.port.alarms.back();
}

TEST(Parts, StartWithNothingOfTheRunBefore) {
  MachineRig rig{
      {test::cartesian_job_of(
           "JUMP *L IF IN#(1)=ON\nSFTON P001\nSPEED VJ=50.00\nDOUT OT#(17) ON\nCALL JOB:SEVEN\nABORT\n*L\nMOVJ C0\n"
           "DIN B000 OT#(17)\nGETS D000 $RV\n"),
       "/JOB\n//NAME SEVEN\n//POS\n//INST\nNOP\nRET 7\nEND\n"}};
  rig.port.at = test::degrees({0, 10, 20, 0, 60, 0});
  EXPECT_EQ(rig.run(), Progress::kAlarm);
  rig.port.inputs[1] = true;
  rig.machine->start();
  ASSERT_EQ(rig.run(), Progress::kEnded) << rig.port.alarms.back();
  const auto& move = rig.port.sent_as<JointMove>(0);
  EXPECT_EQ(move.speed, 0.1);
  EXPECT_NEAR((rig.arm.forward(move.target) * rig.setup.cell.flange_T_tool).position_mm.y(), 0.0, 1e-9);
  EXPECT_EQ(rig.b(0), 0);
  EXPECT_EQ(rig.d(0), 0);
}

}  // namespace
}  // namespace armature::job
