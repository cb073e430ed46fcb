#include "controller/language/job/execute/flow.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/controller/language/job/machine_rig.hpp"

namespace armature::job {
namespace {

using test::alarm_of;
using test::executed;
using test::job_of;
using test::MachineRig;
using testing::ElementsAre;
using Progress = Program::Progress;

TEST(Flow, TakesTheFirstBranchThatHolds) {
  const std::string blocks =
      "IFTHENEXP B000=1\nSET B001 10\nELSEIFEXP B000=2\nSET B001 20\nELSEIFEXP B000<4\nSET B001 30\nELSE\nSET B001 40\n"
      "ENDIF\nINC B001\n";
  for (const auto& [value, expected] : {std::pair{1, 11}, {2, 21}, {3, 31}, {0, 31}, {4, 41}}) {
    EXPECT_EQ(executed("SET B000 " + std::to_string(value) + "\n" + blocks).b(1), expected) << value;
  }
  EXPECT_EQ(executed("IFTHENEXP B000=1\nSET B001 5\nENDIF\n").b(1), 0);
}

TEST(Flow, RepeatsLoops) {
  auto rig = executed(
      "FOR I000 START= 1 TO 3\nFOR I001 START= 10 TO 6 STEP=-2\nINC D000\nNEXT I001\nNEXT I000\n"
      "WHILEEXP B000<5\nINC B000\nADD D001 B000\nENDWHILE\nFOR I002 START= 5 TO 4\nINC D002\nNEXT I002\n");
  EXPECT_EQ(rig.d(0), 9);
  EXPECT_EQ(rig.i(0), 3);
  EXPECT_EQ(rig.i(1), 6);
  EXPECT_EQ(rig.d(1), 15);
  EXPECT_EQ(rig.d(2), 0);
}

TEST(Flow, EndsALoopAtTheLargestValueOfItsVariable) {
  auto rig = executed("FOR B000 START= 253 TO 255\nINC D000\nNEXT B000\n");
  EXPECT_EQ(rig.d(0), 3);
  EXPECT_EQ(rig.b(0), 255);
}

TEST(Flow, SelectsACase) {
  const std::string block =
      "SWITCH B000\nCASE 1\nSET B001 10\nCASE B002\nSET B001 20\nDEFAULT\nSET B001 30\nENDSWITCH\n";
  EXPECT_EQ(executed("SET B000 1\nSET B002 7\n" + block).b(1), 10);
  EXPECT_EQ(executed("SET B000 7\nSET B002 7\n" + block).b(1), 20);
  EXPECT_EQ(executed("SET B000 9\nSET B002 7\n" + block).b(1), 30);
  EXPECT_EQ(executed("SET B000 9\nSWITCH B000\nCASE 1\nSET B001 1\nENDSWITCH\n").b(1), 0);
}

TEST(Flow, JumpsToLabelsAlsoByAValue) {
  auto rig = executed(
      "SET B000 2\nJUMP LABEL: B000\n*1\nSET B001 1\n*2\nINC B002\nJUMP *2 IF B002<3\nJUMP *E\nSET B003 9\n*E\n");
  EXPECT_EQ(rig.b(1), 0);
  EXPECT_EQ(rig.b(2), 3);
  EXPECT_EQ(rig.b(3), 0);
  EXPECT_EQ(alarm_of("SET B000 5\nJUMP LABEL: B000\n*1\n"), "JUMP: no label of this value");
}

const std::string kSum =
    "/JOB\n//NAME SUM\n//POS\n//INST\n///LVARS 1,0,2,0,0,1,0,0\nNOP\nGETARG LD000 IARG#(1)\nGETARG LD001 IARG#(2)\n"
    "ADD LD000 LD001\nSET LB000 7\nRET LD000\nEND\n";

TEST(Flow, CallsJobsWithArgumentsAndAResult) {
  MachineRig rig{
      {job_of("SET D005 30\nCALL JOB:SUM ARGF12 ARGFD005\nGETS D000 $RV\nCALL JOB:SUM ARGF1 ARGF-3 IF D000=41\n"
              "CALL JOB:SUM ARGF1 ARGF-3 IF D000=42\nGETS D001 $RV\n"),
       kSum}};
  ASSERT_EQ(rig.run(), Progress::kEnded);
  EXPECT_EQ(rig.d(0), 42);
  EXPECT_EQ(rig.d(1), -2);
}

TEST(Flow, GivesEachCallItsOwnLocalVariables) {
  // The factorial of 5, by calls of itself.
  const std::string factorial =
      "/JOB\n//NAME FACT\n//POS\n//INST\n///LVARS 0,0,2,0,0,0,0,0\nNOP\nGETARG LD000 IARG#(1)\n"
      "RET 1 IF LD000<=1\nSET LD001 EXPRESS LD000 - 1\nCALL JOB:FACT ARGFLD001\nGETS LD001 $RV\nMUL LD000 LD001\n"
      "RET LD000\nEND\n";
  MachineRig rig{{job_of("CALL JOB:FACT ARGF5\nGETS D000 $RV\n"), factorial}};
  ASSERT_EQ(rig.run(), Progress::kEnded);
  EXPECT_EQ(rig.d(0), 120);
}

TEST(Flow, GivesPositionsToJobs) {
  const std::string taker =
      "/JOB\n//NAME TAKE\n//POS\n//INST\n///LVARS 0,0,0,0,0,1,0,0\nNOP\nGETARG LP000 IARG#(1)\nADD LP000 LP000\n"
      "SET P009 LP000\nEND\n";
  MachineRig rig{{job_of("SETE P001 (2) 5000\nCALL JOB:TAKE ARGFP001\n"), taker}};
  ASSERT_EQ(rig.run(), Progress::kEnded);
  EXPECT_EQ(rig.p(9).value[1], 10.0);
  EXPECT_EQ(rig.p(1).value[1], 5.0);
}

TEST(Flow, LimitsCallsArgumentsAndLocalVariables) {
  MachineRig endless{{job_of("CALL JOB:TEST\n")}};
  EXPECT_EQ(endless.run(), Progress::kAlarm);
  EXPECT_THAT(endless.port.alarms, ElementsAre("CALL: more than 16 calls within each other"));
  MachineRig missing{{job_of("CALL JOB:SUM ARGF1\n"), kSum}};
  EXPECT_EQ(missing.run(), Progress::kAlarm);
  EXPECT_THAT(missing.port.alarms, ElementsAre("GETARG: no argument of this number"));
  const std::string large =
      "/JOB\n//NAME BIG\n//POS\n//INST\n///LVARS 256,256,256,200,0,0,0,0\nNOP\nCALL JOB:BIG\nEND\n";
  MachineRig full{{job_of("CALL JOB:BIG\n"), large}};
  EXPECT_EQ(full.run(), Progress::kAlarm);
  EXPECT_THAT(full.port.alarms, ElementsAre("CALL: no room for the local variables"));
}

TEST(Flow, ContinuesInAnotherJobWithoutReturning) {
  MachineRig rig{{job_of("JUMP JOB:B\nSET B000 1\n", "A"), job_of("SET B001 2\n", "B")}};
  ASSERT_EQ(rig.run(), Progress::kEnded);
  EXPECT_EQ(rig.b(0), 0);
  EXPECT_EQ(rig.b(1), 2);
}

// The job that was called from is left already, so this alarm is not one of JUMP.
TEST(Flow, RaisesTheAlarmOfAJobWithoutRoomInItsFirstLine) {
  const std::string large = "/JOB\n//NAME BIG\n//POS\n//INST\n///LVARS 0,0,0,0,0,65,0,0\nNOP\nEND\n";
  MachineRig rig{{job_of("JUMP JOB:BIG\n"), large}};
  EXPECT_EQ(rig.run(), Progress::kAlarm);
  EXPECT_THAT(rig.port.alarms, ElementsAre("NOP: no room for the local variables"));
  EXPECT_EQ(rig.machine->job(), 1U);
}

}  // namespace
}  // namespace armature::job
