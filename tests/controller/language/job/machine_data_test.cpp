// Numbers, and what they may not be.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/controller/language/job/machine_rig.hpp"
#include "tests/controller/support/random.hpp"

namespace armature::job {
namespace {

using test::alarm_of;
using test::executed;

TEST(MachineData, CalculatesWithVariables) {
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

TEST(MachineData, TakesTheSineOfAnyNumberOfTurns) {
  auto rig = executed("SET R000 360000000\nADD R000 30\nSIN R001 R000\nADD R000 30\nCOS R002 R000\n");
  EXPECT_NEAR(rig.r(1), 0.5, 1e-15);
  EXPECT_NEAR(rig.r(2), 0.5, 1e-15);
}

TEST(MachineData, CutsDecimalsOffTowardsZero) {
  auto rig = executed("SET I000 2.9\nSET I001 -2.9\nSET R000 -2.9\n");
  EXPECT_EQ(rig.i(0), 2);
  EXPECT_EQ(rig.i(1), -2);
  EXPECT_EQ(rig.r(0), -2.9);
}

TEST(MachineData, EvaluatesExpressionsByPrecedence) {
  auto rig = executed(
      "SET I000 3\nSET D000 EXPRESS 2 + I000 * 4\nSET D001 EXPRESS ( 2 + I000 ) * 4\n"
      "SET D002 EXPRESS 20 - 8 - 4\nSET D003 EXPRESS 100 / 5 / 2\nSET D004 EXPRESS -I000 * ( 1 - 3 )\n"
      "SET D005 EXPRESS 2 * ( 3 + ( 4 - 1 ) * 2 ) - 1\nSET D006 EXPRESS 10 - - ( 2 + 3 )\n"
      "SET D007 EXPRESS - ( 2 + 3 ) * 2 - 1\n");
  EXPECT_EQ(rig.d(0), 14);
  EXPECT_EQ(rig.d(1), 20);
  EXPECT_EQ(rig.d(2), 8);
  EXPECT_EQ(rig.d(3), 10);
  EXPECT_EQ(rig.d(4), 6);
  EXPECT_EQ(rig.d(5), 17);
  EXPECT_EQ(rig.d(6), 15);
  EXPECT_EQ(rig.d(7), -11);
}

// A random calculation as text, with its value by another method: recursive descent while it is written.
struct RandomTerm {
  test::Random& random;
  std::string text{};

  double sum(int depth) {
    double value = product(depth);
    for (std::int64_t more = random.integer(0, 2); more > 0; --more) {
      const bool add = random.integer(0, 1) == 0;
      text += add ? " + " : " - ";
      const double other = product(depth);
      value = add ? value + other : value - other;
    }
    return value;
  }
  double product(int depth) {
    double value = factor(depth);
    for (std::int64_t more = random.integer(0, 2); more > 0; --more) {
      text += " * ";
      value *= factor(depth);
    }
    return value;
  }
  double factor(int depth) {
    if (depth > 0 && random.integer(0, 2) == 0) {
      text += "( ";
      const double value = sum(depth - 1);
      text += " )";
      return value;
    }
    const std::int64_t value = random.integer(0, 9);
    text += std::to_string(value);
    return static_cast<double>(value);
  }
};

TEST(MachineData, EvaluatesRandomExpressions) {
  test::Random random{411};
  int compared = 0;
  for (int draw = 0; draw < 400; ++draw) {
    RandomTerm term{random};
    const double value = term.sum(2);
    if (term.text.size() > 150 || std::fabs(value) > 1e9) continue;
    auto rig = executed("SET D000 EXPRESS " + term.text + "\n");
    EXPECT_EQ(rig.d(0), value) << term.text << ", seed 411, draw " << draw;
    ++compared;
  }
  EXPECT_GT(compared, 200);
}

TEST(MachineData, UsesVariablesAsIndices) {
  auto rig = executed(
      "SET B000 2\nSET D[B000] 5\nSET I[D[B000]] 9\nSET B[0] 3\nCLEAR D002\nSET R001 1\nCLEAR R000 3\n"
      "SET I001 5\nSET I004 5\nCLEAR I002 ALL\n");
  EXPECT_EQ(rig.d(2), 0);
  EXPECT_EQ(rig.i(5), 0);
  EXPECT_EQ(rig.i(1), 5);
  EXPECT_EQ(rig.i(4), 0);
  EXPECT_EQ(rig.b(0), 3);
  EXPECT_EQ(rig.r(1), 0);
}

TEST(MachineData, RaisesAnAlarmInsteadOfAWrongValue) {
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

TEST(MachineData, KeepsTheOldValueAfterAnAlarm) {
  test::MachineRig rig{test::job_of("SET B000 200\nADD B000 100\n")};
  EXPECT_EQ(rig.run(), Interpreter::Progress::kAlarm);
  EXPECT_EQ(rig.b(0), 200);
  EXPECT_EQ(rig.machine->alarm(), Alarm::kRange);
  EXPECT_EQ(rig.machine->line(), 8U);
}

}  // namespace
}  // namespace armature::job
