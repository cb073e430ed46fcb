#include "controller/language/job/execute/calculations.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "tests/controller/language/job/machine_rig.hpp"

namespace armature::job {
namespace {

using test::alarm_of;
using test::executed;

TEST(Calculations, CalculatesWithVariables) {
  auto rig = executed(
      "SET B000 7\nSET I000 -5\nSET D000 100000\nSET R000 2.5\nADD I000 3\nSUB D000 I000\nMUL R000 R000\n"
      "DIV D000 4\nINC B000\nDEC I000\nSET B001 12\nAND B001 10\nSET B002 12\nOR B002 3\nSET B003 6\n"
      "XOR B003 3\nNOT B004 B000\nSQRT R001 2\nSIN R002 30\nCOS R003 60\nATAN R004 1\n");
  EXPECT_EQ(rig.b(0), 8);
  EXPECT_EQ(rig.i(0), -3);
  EXPECT_EQ(rig.d(0), 25'000);  // 100002 / 4 without decimals
  EXPECT_EQ(rig.r(0), 6.25);
  EXPECT_EQ(rig.b(1), 8);
  EXPECT_EQ(rig.b(2), 15);
  EXPECT_EQ(rig.b(3), 5);
  EXPECT_EQ(rig.b(4), 247);
  EXPECT_EQ(rig.r(1), std::sqrt(2.0));
  EXPECT_NEAR(rig.r(2), 0.5, 1e-15);
  EXPECT_NEAR(rig.r(3), 0.5, 1e-15);
  EXPECT_NEAR(rig.r(4), 45.0, 1e-13);
}

TEST(Calculations, TakesTheSineOfAnyNumberOfTurns) {
  auto rig = executed("SET R000 360000000\nADD R000 30\nSIN R001 R000\nADD R000 30\nCOS R002 R000\n");
  EXPECT_NEAR(rig.r(1), 0.5, 1e-15);
  EXPECT_NEAR(rig.r(2), 0.5, 1e-15);
}

TEST(Calculations, CutsDecimalsOffTowardsZero) {
  auto rig = executed("SET I000 2.9\nSET I001 -2.9\nSET R000 -2.9\n");
  EXPECT_EQ(rig.i(0), 2);
  EXPECT_EQ(rig.i(1), -2);
  EXPECT_EQ(rig.r(0), -2.9);
}

TEST(Calculations, RaisesAnAlarmInsteadOfAWrongValue) {
  EXPECT_EQ(alarm_of("SET B000 256\n"), "SET: a value out of the range of its variable");
  EXPECT_EQ(alarm_of("SET B000 -1\n"), "SET: a value out of the range of its variable");
  EXPECT_EQ(alarm_of("SET I000 32767\nINC I000\n"), "INC: a value out of the range of its variable");
  EXPECT_EQ(alarm_of("SET D000 2147483647\nADD D000 1\n"), "ADD: a value out of the range of its variable");
  EXPECT_EQ(alarm_of("SET R000 1E38\nMUL R000 R000\n"), "MUL: a value out of the range of its variable");
  EXPECT_EQ(alarm_of("DIV D000 B000\n"), "DIV: division by 0, or the root of a negative value");
  EXPECT_EQ(alarm_of("SET D000 EXPRESS 1 / B000\n"), "SET: division by 0, or the root of a negative value");
  EXPECT_EQ(alarm_of("SQRT R000 -1\n"), "SQRT: division by 0, or the root of a negative value");
  EXPECT_EQ(alarm_of("SET I000 -1\nSET D[I000] 1\n"), "SET: no variable or element of this number");
  EXPECT_EQ(alarm_of("SET R000 0.5\nSET D[R000] 1\n"), "SET: no variable or element of this number");
  EXPECT_EQ(alarm_of("SET LB000 1\n"), "SET: no variable or element of this number");
  EXPECT_EQ(alarm_of("SET S000 \"text\"\n"), "SET: not supported");
  EXPECT_EQ(alarm_of("SET D000 P000\n"), "SET: operands of kinds that do not go together");
  EXPECT_EQ(alarm_of("ARCON ASF#(1)\n"), "ARCON: not supported");
}

TEST(Calculations, KeepsTheOldValueAfterAnAlarm) {
  test::MachineRig rig{test::job_of("SET B000 200\nADD B000 100\n")};
  EXPECT_EQ(rig.run(), Program::Progress::kAlarm);
  EXPECT_EQ(rig.b(0), 200);
  EXPECT_EQ(rig.machine->alarm(), Alarm::kRange);
  EXPECT_EQ(rig.machine->line(), 8U);
}

TEST(Calculations, CalculatesWithPositions) {
  auto rig = executed(
      "SETE P001 (2) 5000\nSET P002 P001\nSETE P002 (6) 20000\nADD P001 P002\nSUB P002 P001\nSET P003 P001\n"
      "MUL P003 3\nDIV P001 4\nSETE P004 (0) 1000\nGETE D000 P004 (3)\nGETE D001 P004 (4)\nCLEAR P004\n");
  EXPECT_EQ(rig.p(1).value, (std::array{0.0, 2.5, 0.0, 0.0, 0.0, 0.5}));
  EXPECT_EQ(rig.p(2).value, (std::array{0.0, -5.0, 0.0, 0.0, 0.0, 0.0}));
  EXPECT_EQ(rig.p(3).value, (std::array{0.0, 30.0, 0.0, 0.0, 0.0, 6.0}));
  EXPECT_EQ(rig.d(0), 1'000);
  EXPECT_EQ(rig.d(1), 1'000);
  EXPECT_FALSE(rig.p(4).set);
  EXPECT_EQ(alarm_of("ADD P001 P001\n"), "ADD: a position variable that is not set");
  const std::string set = "SETE P001 (1) 1\n";
  EXPECT_EQ(alarm_of(set + "ADD P001 1\n"), "ADD: operands of kinds that do not go together");
  EXPECT_EQ(alarm_of(set + "MUL P001 P001\n"), "MUL: operands of kinds that do not go together");
  EXPECT_EQ(alarm_of(set + "GETS P002 $PX000\nADD P001 P002\n"), "ADD: operands of kinds that do not go together");
  EXPECT_EQ(alarm_of(set + "DIV P001 0\n"), "DIV: division by 0, or the root of a negative value");
  EXPECT_EQ(alarm_of(set + "SETE P001 (7) 1\n"), "SETE: no variable or element of this number");
}

}  // namespace
}  // namespace armature::job
