// Jumps, blocks, calls, and the orders of the operator.
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
using testing::IsEmpty;
using Progress = Interpreter::Progress;

TEST(MachineFlow, TakesTheFirstBranchThatHolds) {
  const std::string blocks =
      "IFTHENEXP B000=1\nSET B001 10\nELSEIFEXP B000=2\nSET B001 20\nELSEIFEXP B000<4\nSET B001 30\nELSE\nSET B001 40\n"
      "ENDIF\nINC B001\n";
  for (const auto& [value, expected] : {std::pair{1, 11}, {2, 21}, {3, 31}, {0, 31}, {4, 41}}) {
    EXPECT_EQ(executed("SET B000 " + std::to_string(value) + "\n" + blocks).b(1), expected) << value;
  }
  EXPECT_EQ(executed("IFTHENEXP B000=1\nSET B001 5\nENDIF\n").b(1), 0);
}

TEST(MachineFlow, BindsAndBeforeOr) {
  const auto holds = [](const std::string& condition) {
    return executed("SET B001 1\nIFTHENEXP " + condition + "\nSET B009 1\nENDIF\n").b(9) == 1;
  };
  EXPECT_TRUE(holds("B001=1 OREXP B000=1 ANDEXP B000=2"));
  EXPECT_TRUE(holds("B000=1 ANDEXP B000=2 OREXP B001=1"));
  EXPECT_FALSE(holds("B000=1 OREXP B001=1 ANDEXP B000=2"));
  EXPECT_TRUE(holds("B000=1 ANDEXP B001=0 OREXP B000=0 ANDEXP B001=1"));
  EXPECT_TRUE(holds("B000<>1"));
  EXPECT_TRUE(holds("B001>=1"));
  EXPECT_FALSE(holds("B001>1"));
  EXPECT_FALSE(holds("B001<1"));
  EXPECT_TRUE(holds("B001<=1"));
}

TEST(MachineFlow, RepeatsLoops) {
  auto rig = executed(
      "FOR I000 START= 1 TO 3\nFOR I001 START= 10 TO 6 STEP=-2\nINC D000\nNEXT I001\nNEXT I000\n"
      "WHILEEXP B000<5\nINC B000\nADD D001 B000\nENDWHILE\nFOR I002 START= 5 TO 4\nINC D002\nNEXT I002\n");
  EXPECT_EQ(rig.d(0), 9);
  EXPECT_EQ(rig.i(0), 3);
  EXPECT_EQ(rig.i(1), 6);
  EXPECT_EQ(rig.d(1), 15);
  EXPECT_EQ(rig.d(2), 0);
}

TEST(MachineFlow, EndsALoopAtTheLargestValueOfItsVariable) {
  auto rig = executed("FOR B000 START= 253 TO 255\nINC D000\nNEXT B000\n");
  EXPECT_EQ(rig.d(0), 3);
  EXPECT_EQ(rig.b(0), 255);
}

TEST(MachineFlow, SelectsACase) {
  const std::string block =
      "SWITCH B000\nCASE 1\nSET B001 10\nCASE B002\nSET B001 20\nDEFAULT\nSET B001 30\nENDSWITCH\n";
  EXPECT_EQ(executed("SET B000 1\nSET B002 7\n" + block).b(1), 10);
  EXPECT_EQ(executed("SET B000 7\nSET B002 7\n" + block).b(1), 20);
  EXPECT_EQ(executed("SET B000 9\nSET B002 7\n" + block).b(1), 30);
  EXPECT_EQ(executed("SET B000 9\nSWITCH B000\nCASE 1\nSET B001 1\nENDSWITCH\n").b(1), 0);
}

TEST(MachineFlow, JumpsToLabelsAlsoByAValue) {
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

TEST(MachineFlow, CallsJobsWithArgumentsAndAResult) {
  MachineRig rig{
      {job_of("SET D005 30\nCALL JOB:SUM ARGF12 ARGFD005\nGETS D000 $RV\nCALL JOB:SUM ARGF1 ARGF-3 IF D000=41\n"
              "CALL JOB:SUM ARGF1 ARGF-3 IF D000=42\nGETS D001 $RV\n"),
       kSum}};
  ASSERT_EQ(rig.run(), Progress::kEnded);
  EXPECT_EQ(rig.d(0), 42);
  EXPECT_EQ(rig.d(1), -2);
}

TEST(MachineFlow, GivesEachCallItsOwnLocalVariables) {
  // The factorial of 5, by calls of itself.
  const std::string factorial =
      "/JOB\n//NAME FACT\n//POS\n//INST\n///LVARS 0,0,2,0,0,0,0,0\nNOP\nGETARG LD000 IARG#(1)\n"
      "RET 1 IF LD000<=1\nSET LD001 EXPRESS LD000 - 1\nCALL JOB:FACT ARGFLD001\nGETS LD001 $RV\nMUL LD000 LD001\n"
      "RET LD000\nEND\n";
  MachineRig rig{{job_of("CALL JOB:FACT ARGF5\nGETS D000 $RV\n"), factorial}};
  ASSERT_EQ(rig.run(), Progress::kEnded);
  EXPECT_EQ(rig.d(0), 120);
}

TEST(MachineFlow, GivesPositionsToJobs) {
  const std::string taker =
      "/JOB\n//NAME TAKE\n//POS\n//INST\n///LVARS 0,0,0,0,0,1,0,0\nNOP\nGETARG LP000 IARG#(1)\nADD LP000 LP000\n"
      "SET P009 LP000\nEND\n";
  MachineRig rig{{job_of("SETE P001 (2) 5000\nCALL JOB:TAKE ARGFP001\n"), taker}};
  ASSERT_EQ(rig.run(), Progress::kEnded);
  EXPECT_EQ(rig.p(9).value[1], 10.0);
  EXPECT_EQ(rig.p(1).value[1], 5.0);
}

TEST(MachineFlow, LimitsCallsArgumentsAndLocalVariables) {
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

TEST(MachineFlow, GoesOnInAnotherJobWithoutReturning) {
  MachineRig rig{{job_of("JUMP JOB:B\nSET B000 1\n", "A"), job_of("SET B001 2\n", "B")}};
  ASSERT_EQ(rig.run(), Progress::kEnded);
  EXPECT_EQ(rig.b(0), 0);
  EXPECT_EQ(rig.b(1), 2);
}

TEST(MachineFlow, NotesLinesMessagesAndAlarms) {
  MachineRig rig{job_of("'comment\nMSG \"part 1\"\nSETUALM 8001 \"no part\" 0\nSET B000 1\n")};
  EXPECT_EQ(rig.run(), Progress::kAlarm);
  EXPECT_THAT(rig.port.lines, ElementsAre(6, 8, 9));
  EXPECT_THAT(rig.port.messages, ElementsAre("part 1"));
  EXPECT_THAT(rig.port.alarms, ElementsAre("SETUALM 8001: no part"));
  EXPECT_EQ(rig.b(0), 0);
  EXPECT_EQ(alarm_of("ABORT\n"), "ABORT: ended by ABORT");
}

TEST(MachineFlow, PausesWhenTheArmStands) {
  MachineRig rig{test::moving_job_of("MOVJ C1\nPAUSE\nSET B000 1\n")};
  rig.port.arrived = false;
  EXPECT_EQ(rig.run(), Progress::kWaiting);
  rig.port.arrived = true;
  EXPECT_EQ(rig.run(), Progress::kPaused);
  EXPECT_EQ(rig.b(0), 0);
  EXPECT_EQ(rig.run(), Progress::kEnded);
  EXPECT_EQ(rig.b(0), 1);
}

TEST(MachineFlow, PausesAtABreakpointEachTime) {
  MachineRig rig{job_of("*L\nINC B000\nJUMP *L IF B000<3\n")};
  EXPECT_TRUE(rig.port.breakpoints.add(Machine::place_of(0, 8)));
  for (int round = 0; round < 3; ++round) {
    EXPECT_EQ(rig.run(), Progress::kPaused);
    EXPECT_EQ(rig.machine->line(), 8U);
    EXPECT_EQ(rig.b(0), round);
  }
  EXPECT_EQ(rig.run(), Progress::kEnded);
}

TEST(MachineFlow, ABreakpointThatIsRemovedBeforeTheArmIsThereDoesNotPause) {
  MachineRig rig{test::moving_job_of("MOVJ C1\nSET B000 1\n")};
  EXPECT_TRUE(rig.port.breakpoints.add(Machine::place_of(0, 16)));
  rig.port.arrived = false;
  EXPECT_EQ(rig.run(), Progress::kWaiting);
  EXPECT_EQ(rig.b(0), 0);
  rig.port.breakpoints.clear();
  EXPECT_EQ(rig.run(), Progress::kEnded);
  EXPECT_EQ(rig.b(0), 1);
}

TEST(MachineFlow, PausesAtABreakpointOfItsJobOnly) {
  MachineRig rig{{job_of("INC B000\n"), job_of("INC B001\n", "OTHER")}};
  EXPECT_TRUE(rig.port.breakpoints.add(Machine::place_of(1, 7)));
  EXPECT_EQ(rig.run(), Progress::kEnded);
  rig.machine->select(1);
  rig.machine->start();
  EXPECT_EQ(rig.run(), Progress::kPaused);
}

TEST(MachineFlow, ABreakpointDoesNotPauseOnceMoreBehindAPauseOrAStep) {
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

TEST(MachineFlow, KnowsItsLines) {
  MachineRig rig{job_of("INC B000\n")};  // NOP, INC and END are in the lines 6 to 8
  EXPECT_FALSE(rig.machine->has_line(Machine::place_of(0, 5)));
  for (const std::uint32_t line : {6U, 7U, 8U}) EXPECT_TRUE(rig.machine->has_line(Machine::place_of(0, line)));
  EXPECT_FALSE(rig.machine->has_line(Machine::place_of(0, 9)));
  EXPECT_FALSE(rig.machine->has_line(Machine::place_of(1, 7)));
}

TEST(MachineFlow, StepsThroughAProgram) {
  MachineRig rig{job_of("INC B000\nINC B000\n")};
  rig.machine->set_single_step(true);
  std::vector<std::uint32_t> lines;
  while (rig.run() == Progress::kPaused) lines.push_back(rig.machine->line());
  EXPECT_THAT(lines, ElementsAre(7, 8, 9));
}

TEST(MachineFlow, StartsAtALine) {
  MachineRig rig{job_of("INC B000\nINC B001\nINC B002\n")};
  rig.machine->select(0, 8);
  rig.machine->start();
  EXPECT_EQ(rig.run(), Progress::kEnded);
  EXPECT_EQ(rig.b(0), 0);
  EXPECT_EQ(rig.b(1), 1);
}

TEST(MachineFlow, BeginsAgainAsNew) {
  MachineRig rig{job_of("INC B000\nADD P001 P001\n")};
  EXPECT_EQ(rig.run(), Progress::kAlarm);
  rig.machine->start();
  EXPECT_EQ(rig.run(), Progress::kAlarm);
  EXPECT_EQ(rig.b(0), 1);
}

}  // namespace
}  // namespace armature::job
