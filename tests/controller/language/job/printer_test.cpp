#include "controller/language/job/loader/printer.hpp"

#include <gtest/gtest.h>

#include "tests/controller/language/job/job_text.hpp"

namespace armature::job {
namespace {

// What controllers and generators write differs in blanks, digits and indentation.
const std::string kVaried =
    "/JOB\n//NAME VARIED-1_A\n///FOLDERNAME Weld  cell\n//POS\n///NPOS 2,1,1,1,0,0\n///USER 1\n///TOOL 3\n"
    "///POSTYPE PULSE\n///PULSE\nC00000=1,-2,0,  4,5,-0  \nBC00000=123\nEC00000=1.5,-2.50\n///POSTYPE USER\n///RECTAN\n"
    "///RCONF 1,0,0,0,0,0,0,0\nC0001=-863.111,0.000,-0.000,178.93,.5,+7\nP00127=1,2,3,4,5,6\n//INST\n"
    "///DATE 2026/01/31 08:00\n///COMM  two blanks\n///ATTR SC,RW,RJ\n////FRAME USER 1\n///GROUP1 RB1,BS1\n"
    "///LVARS 1,1,1,1,0,2,0,0\nNOP\n\n'A comment, 100 %\n' \n'\n*LOOP-1\nMOVJ C00000 VJ=50.00\nMOVJ P127  VJ=5.0 PL=1 "
    "\n"
    "MOVL C0001  V=33.3 PL=0  //corner\nMOVL C0001 V=1.0 +MOVJ EC00000 VJ=5.00\nSET LI000 EXPRESS ( D000 -D001 ) / "
    "-I009\n"
    "SET R000 1.000000E-02\nIFTHENEXP I000<=0 ANDEXP B000<>1\n\t SET B001 1\n\t IFTHENEXP B[LB000]=1\n\t \t JUMP "
    "*LOOP-1\n"
    "\t ENDIF\nENDIF\nFOR LI000 START= 120 TO 123 STEP= 2\nNEXT LI000\nGETS PX001 $PX000\nGETS D000 $RV\n"
    "CALL JOB:OTHER ARGF5 ARGF-3 ARGFLB000 IF OT#(LI000)=ON\nJUMP LABEL: B099\nWAIT IN#(1)=ON  T=2.00\nTIMER T=0.050\n"
    "COMM MOVJ C00000 VJ=1.00\nMSG \"hello\nARCON  ASF#(1)\nSETUALM 8000 \"no part\" 0 SMODE=1\nCNVRT PX1 PX002 "
    "UF#(LB000) TL#(0)\n"
    "SETE P001 (3) D[LI000]\n  DOUT OT#(3) OFF   \nEND\n";

TEST(JobPrinter, WritesTheTextThatWasLoaded) {
  test::Jobs jobs;
  ASSERT_TRUE(jobs.load(kVaried)) << jobs.said.errors.front();
  EXPECT_EQ(jobs.printed(), test::with_controller_ends(kVaried));
}

TEST(JobPrinter, WritesTheSameForEachKindOfLineEnd) {
  for (const std::string end : {"\r\n", "\r", "\n"}) {
    std::string text;
    for (const char character : kVaried) text += character == '\n' ? end : std::string{character};
    test::Jobs jobs;
    ASSERT_TRUE(jobs.load(text));
    EXPECT_EQ(jobs.printed(), test::with_controller_ends(kVaried));
  }
}

TEST(JobPrinter, NamesTheColumnOfEachOperand) {
  test::Jobs jobs;
  ASSERT_TRUE(jobs.load(test::job_of("\t SET  B[LB000] 5\n")));
  const Record& record = jobs.memory->records[1];
  EXPECT_EQ(column_of(*jobs.memory, record, 0), 8U);
  EXPECT_EQ(column_of(*jobs.memory, record, 2), 17U);
}

TEST(JobPrinter, ListsTheEncodedInstructions) {
  test::Jobs jobs;
  ASSERT_TRUE(jobs.load(test::moving_job_of("*L\nMOVL C00001 V=LI000 PL=0 +MOVJ EC1\nJUMP *L IF B000=1\n")));
  test::CollectedText out;
  list_job(*jobs.memory, jobs.memory->jobs[0], out);
  EXPECT_EQ(out.text,
            "record  line  operation   flags  target  partner  operands\n"
            "     0    14  NOP                     -        -\n"
            "     1    15  *                       1        - |*L\n"
            "     2    16  MOVL        u           -        - | C00001 | V=LI000 | PL=0 | +MOVJ EC1\n"
            "     3    17  JUMP                    1        - | *L | IF | B000 |= |1\n"
            "     4    18  END                     -        -\n");
}

}  // namespace
}  // namespace armature::job
