#include "controller/language/job/loader/operand_grammar.hpp"

#include <gtest/gtest.h>

#include "tests/controller/language/job/job_text.hpp"

namespace armature::job {
namespace {

// What the loader says about one instruction, without file and line.
std::string said_about(const std::string& line) {
  test::Jobs jobs;
  (void)jobs.load(test::moving_job_of(line + "\n*L\n"));
  const std::string place = "a.jbi:15:";
  if (jobs.said.errors.empty()) return "";
  const std::string& first = jobs.said.errors.front();
  return first.substr(0, place.size()) == place ? first.substr(place.size()) : first;
}

TEST(OperandGrammar, AcceptsTheFormsOfTheLanguage) {
  for (const char* line : {"MOVJ C00001 VJ=25.00 PL=3 ACC=50 DEC=20",
                           "MOVJ P001",
                           "MOVJ LP000 VJ=I000",
                           "MOVJ P[B000] VJ=0.78",
                           "MOVL C0001 V=33.3  //corner",
                           "MOVL P[LB[001]] V=LI000 PL=0",
                           "MOVL C2 VR=30.0 CR=5.5",
                           "IMOV P000 V=10.0 RF",
                           "IMOV P000 VJ=5.00 UF#(3)",
                           "REFP 1 C00001",
                           "SPEED VJ=50.00 V=300.0",
                           "SFTON P010 UF#(B000)",
                           "SFTON P010",
                           "SFTOF",
                           "MFRAME UF#(2) P001 P002 P003",
                           "CNVRT PX001 PX002 UF#(1) TL#(0)",
                           "GETS PX000 $PX001",
                           "GETS LB000 $B003",
                           "GETS D000 $RV",
                           "SETE P001 (3) -5000",
                           "SETE P[LI000] (LI001) LD[LI002]",
                           "GETE D000 P001 (0)",
                           "SET B000 B001",
                           "SET I000 EXPRESS ( D000 - D001 ) / -I009",
                           "SET D000 EXPRESS 2 * ( D001 + 3 ) - D002",
                           "SET LD000 -5",
                           "SET R000 1.000000E-02",
                           "SET S000 \"text\"",
                           "ADD P001 P002",
                           "MUL P005 D000",
                           "INC I000",
                           "CLEAR B000 10",
                           "CLEAR D000 ALL",
                           "NOT B000 B001",
                           "JUMP *L",
                           "JUMP *L IF IN#(3)=ON",
                           "JUMP LABEL: B000 IF B001<B002",
                           "JUMP *L IFEXPRESS B000=1 ANDEXP B001<>2 OREXP I000>=-5",
                           "RET",
                           "RET IF LI000<>LI001",
                           "RET D000 IF B000=1",
                           "PAUSE IF B000=1",
                           "MSG \"anything = at all",
                           "MSG",
                           "SETUALM 8000 \"part\" 0 SMODE=1",
                           "SETUALM 8000 \"part\"",
                           "TIMER T=0.50",
                           "TIMER T=I005",
                           "WAIT IN#(LI000)=OFF T=2.00",
                           "WAIT T=5.00",
                           "WAIT B032=1",
                           "WAIT FOREXPRESS IN#(1)=ON ANDEXP IN#(2)=ON",
                           "DOUT OT#(1) ON",
                           "DOUT OG#(2) B000",
                           "DOUT OT#(LI000) OFF",
                           "DIN B000 IGH#(3)",
                           "DIN B000 OT#(1)",
                           "PULSE OT#(1)",
                           "PULSE OT#(1) T=0.10",
                           "PULSE OT#(1) IF B000=1",
                           "GETARG LB000 IARG#(1)",
                           "ABORT",
                           "CWAIT",
                           "COMM MOVJ anything",
                           "'comment",
                           "' ",
                           "'",
                           "ARCON ASF#(3)",
                           "MOVL C00001 V=10.0 +MOVJ EC00001",
                           "MOVJ EC00001 VJ=5.00",
                           "MOVJ C00001 BC00001 VJ=5.00",
                           "MOVL P001 V=5.0 SRCH RIN#(1)=ON DIS=5.0",
                           "MOVJ C00001 T0001 VJ=5.00",
                           "MOVL C00001 V=1.0 UNTIL IN#(1)=ON",
                           "MOVJ C00001 UNTIL IN#(B000)=OFF  //comment",
                           "IMOV P001 V=5.0 UNTIL IN#(1)=ON"}) {
    EXPECT_EQ(said_about(line), "") << line;
  }
}

TEST(OperandGrammar, SaysWhatItExpectedAndWhere) {
  EXPECT_EQ(said_about("MOVJ"), "5: expected a position: C000, P000 or LP000");
  EXPECT_EQ(said_about("MOVJ B000"), "6: expected a position: C000, P000 or LP000");
  EXPECT_EQ(said_about("MOVJ C00001 V=5.0"), "13: MOVJ has no V=");
  EXPECT_EQ(said_about("MOVJ C00001 VJ=5.00 VJ=6.00"), "21: expected each tag once");
  EXPECT_EQ(said_about("MOVJ C00001 VJ=0.001"), "13: VJ= must be from 0.01 to 100");
  EXPECT_EQ(said_about("MOVJ C00001 VJ=101"), "13: VJ= must be from 0.01 to 100");
  EXPECT_EQ(said_about("MOVL C00001 PL=9"), "13: PL= must be a whole number from 0 to 8");
  EXPECT_EQ(said_about("MOVL C00001 PL=1.5"), "13: PL= must be a whole number from 0 to 8");
  EXPECT_EQ(said_about("MOVL C00001 V=P000"), "15: expected a number, or a variable B, I, D or R");
  EXPECT_EQ(said_about("MOVL C00001 UNTIL OT#(1)=ON"), "19: expected IN# and a number");
  EXPECT_EQ(said_about("MOVL C00001 UNTIL IN#(1)<>ON"), "25: expected '='");
  EXPECT_EQ(said_about("MOVL C00001 UNTIL IN#(1)=1"), "26: expected ON or OFF");
  EXPECT_EQ(said_about("MOVL C00001 UNTIL IN#(1)=ON V=5.0"), "29: expected the end of the line");
  EXPECT_EQ(said_about("MOVL C00001 FAST"), "13: unknown word 'FAST'");
  EXPECT_EQ(said_about("MOVL C00001 V=5.0 ON"), "19: expected the end of the line");
  EXPECT_EQ(said_about("MOVL C00009"), "6: the job has no position C9");
  EXPECT_EQ(said_about("MOVLC00001"), "1: unknown instruction 'MOVLC00001'");
  EXPECT_EQ(said_about("movl C00001"), "1: unknown instruction 'movl'");
  EXPECT_EQ(said_about("SET 5 5"), "5: expected a variable");
  EXPECT_EQ(said_about("SET B000"), "9: expected a value");
  EXPECT_EQ(said_about("SET B256 1"), "5: expected a variable number below 256");
  EXPECT_EQ(said_about("SET B000 EXPRESS ( 1 + 2"), "25: expected ')' or a calculation");
  EXPECT_EQ(said_about("SET B000 EXPRESS 1 +"), "21: expected a value");
  EXPECT_EQ(said_about("SET B000 1 2"), "12: expected the end of the line");
  EXPECT_EQ(said_about("SET B[1,2] 0"), "8: expected ']'");
  EXPECT_EQ(said_about("SET Q000 0"), "5: unknown variable 'Q'");
  EXPECT_EQ(said_about("SET B123456 0"), "5: a number of more than 5 digits");
  EXPECT_EQ(said_about("SET D000 1234567890123456"),
            "10: not a number of at most 15 digits, with digits behind its point");
  EXPECT_EQ(said_about("SETE P000 3 5"), "11: expected the number of an element: (0) to (6)");
  EXPECT_EQ(said_about("JUMP L"), "6: unknown word 'L'");
  EXPECT_EQ(said_about("JUMP *NONE"), "6: no label *NONE in this job");
  EXPECT_EQ(said_about("JUMP *L IF B000"), "16: expected one of = <> < <= > >=");
  EXPECT_EQ(said_about("TIMER"), "6: expected T= and seconds");
  EXPECT_EQ(said_about("TIMER T=0"), "7: T= must be from 0.01 to 655.35");
  EXPECT_EQ(said_about("WAIT"), "5: expected a condition, or T= and seconds");
  EXPECT_EQ(said_about("DOUT IN#(1) ON"), "6: expected OT#, OG# or OGH#");
  EXPECT_EQ(said_about("DOUT OT#(0) ON"), "6: expected a number from 1");
  EXPECT_EQ(said_about("DOUT OT#(1"), "11: expected ')'");
  EXPECT_EQ(said_about("DOUT OT#1 ON"), "9: expected '(' and a number");
  EXPECT_EQ(said_about("DOUT XY#(1) ON"), "6: unknown 'XY#'");
  EXPECT_EQ(said_about("CALL *L"), "6: expected JOB: and a name");
  EXPECT_EQ(said_about("CALL JOB:"), "10: expected a name");
  EXPECT_EQ(said_about("SETUALM 1 \"open"), "11: the text has no closing quotation mark");
  EXPECT_EQ(said_about("SET B000\t1"), "9: a tab between operands; expected blanks");
  EXPECT_EQ(said_about("SET B000 \xC3\xA9"), "10: a character that is not ASCII");
  EXPECT_EQ(said_about("SET B000 ;"), "10: unexpected ';'");
  EXPECT_EQ(said_about("FOR I000 1 TO 3"), "10: expected START= and the first value");
  EXPECT_EQ(said_about("*L2 5"), "1: expected *NAME alone");
  EXPECT_EQ(said_about("*L2 JUMP"), "5: unknown word 'JUMP'");
}

TEST(OperandGrammar, LimitsTheOperandsOfALine) {
  std::string line = "SET D000 EXPRESS 1";
  for (int i = 0; i < 60; ++i) line += " + 1";
  EXPECT_EQ(said_about(line), "214: more than 100 operands in one line");
  std::string nested = "SET B[B[B[B[B[0]]]]] 1";
  EXPECT_EQ(said_about(nested), "13: too many indices within each other");
}

}  // namespace
}  // namespace armature::job
