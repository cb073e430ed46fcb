#include "controller/language/job/state/expression.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/controller/language/job/step_rig.hpp"
#include "tests/controller/support/random.hpp"

namespace armature::job {
namespace {

using test::alarm_of;
using test::executed;

TEST(Expression, EvaluatesExpressionsByPrecedence) {
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

TEST(Expression, EvaluatesRandomExpressions) {
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

TEST(Expression, BindsAndBeforeOr) {
  const auto holds = [](const std::string& condition) {
    return executed("SET B001 1\nIFTHENEXP " + condition + "\nSET B009 1\nENDIF\n").b(9) == 1;
  };
  EXPECT_TRUE(holds("B001=1 OREXP B000=1 ANDEXP B000=2"));
  EXPECT_TRUE(holds("B000=1 ANDEXP B000=2 OREXP B001=1"));
  EXPECT_FALSE(holds("B000=1 OREXP B001=1 ANDEXP B000=2"));
  EXPECT_TRUE(holds("B000=1 ANDEXP B001=0 OREXP B000=0 ANDEXP B001=1"));
  EXPECT_FALSE(holds("B000=1 ANDEXP B001=1"));
  EXPECT_TRUE(holds("B000<>1"));
  EXPECT_TRUE(holds("B001>=1"));
  EXPECT_FALSE(holds("B001>1"));
  EXPECT_FALSE(holds("B001<1"));
  EXPECT_TRUE(holds("B001<=1"));
}

TEST(Expression, LimitsTheDepthOfParentheses) {
  const auto nested = [](std::size_t depth) {
    return "SET D000 EXPRESS " + std::string(depth, '(') + "7" + std::string(depth, ')') + "\n";
  };
  EXPECT_EQ(executed(nested(32)).d(0), 7);
  EXPECT_EQ(alarm_of(nested(33)), "SET: a value out of the range of its variable");
}

TEST(Expression, ReadsAGuardWithoutMovingBehindIt) {
  for (const bool level : {false, true}) {
    test::ReaderRig rig{"JUMP *L IF IN#(2)=ON\n*L"};
    rig.port.inputs[2] = level;
    bool holds = !level;
    EXPECT_TRUE(read_guard(rig.operands, holds));
    EXPECT_EQ(holds, level);
    EXPECT_TRUE(rig.operands.is(OperandKind::kLabel));
  }
  bool holds = false;
  EXPECT_TRUE(read_guard(test::ReaderRig{"PAUSE"}.operands, holds));
  EXPECT_TRUE(holds);
}

}  // namespace
}  // namespace armature::job
