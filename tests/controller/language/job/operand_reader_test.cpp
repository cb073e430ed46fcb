#include "controller/language/job/state/operand_reader.hpp"

#include <gtest/gtest.h>

#include "tests/controller/language/job/step_rig.hpp"

namespace armature::job {
namespace {

using test::executed;
using test::ReaderRig;
using test::StepRig;
using Progress = Program::Progress;

TEST(OperandReader, ReadsConstantsVariablesAndLevels) {
  EXPECT_EQ(ReaderRig{"ADD R000 12.5"}.value(), 12.5);
  EXPECT_EQ(ReaderRig{"ADD R000 -3"}.value(), -3.0);
  EXPECT_EQ(ReaderRig{"DOUT OT#(7) ON"}.value(), 1.0);
  EXPECT_EQ(ReaderRig{"DOUT OT#(7) OFF"}.value(), 0.0);
  ReaderRig variable{"ADD R000 D[B001]"};
  variable.set(VariableType::kB, 1, 3);
  variable.set(VariableType::kD, 3, -70'000);
  EXPECT_EQ(variable.value(), -70'000.0);
  ReaderRig returned{"GETS R000 $RV"};
  returned.variables.set_returned(42.5);
  EXPECT_EQ(returned.value(), 42.5);
}

TEST(OperandReader, ReadsAGroupOfPinsAsANumber) {
  ReaderRig inputs{"DIN B000 IG#(2)"};
  inputs.port.inputs[9] = inputs.port.inputs[16] = true;
  EXPECT_EQ(inputs.value(), 0b1000'0001);
  ReaderRig outputs{"DIN B000 OGH#(2)"};
  outputs.port.outputs[5] = outputs.port.outputs[7] = true;
  EXPECT_EQ(outputs.value(), 0b0101);
  ReaderRig beyond{"DIN B000 OG#(3)"};
  beyond.levels.set(18, true);
  EXPECT_EQ(beyond.value(), 0b0010);
}

TEST(OperandReader, WaitsForTheArmBeforeItReadsAPin) {
  ReaderRig rig{"DIN B000 OT#(16)"};
  rig.port.arrived = false;
  rig.operands.skip();
  double value = 0.0;
  EXPECT_FALSE(rig.operands.number(value));
  EXPECT_EQ(rig.step.progress(), Progress::kWaiting);
  ReaderRig beyond{"DIN B000 OT#(17)"};
  beyond.port.arrived = false;
  EXPECT_EQ(beyond.value(), 0.0);
}

TEST(OperandReader, ScalesATagOnlyWhenItIsAVariable) {
  double value = 0.0;
  ReaderRig constant{"TIMER T=0.50"};
  EXPECT_TRUE(constant.operands.tag(0.01, value));
  EXPECT_EQ(value, 0.5);
  ReaderRig variable{"TIMER T=I004"};
  variable.set(VariableType::kI, 4, 250);
  EXPECT_TRUE(variable.operands.tag(0.01, value));
  EXPECT_EQ(value, 2.5);
  EXPECT_TRUE(variable.operands.at_end());
}

TEST(OperandReader, ReadsPositionsOfTheJobAndVariablesThatAreSet) {
  PositionValue value;
  ReaderRig constant{"MOVJ C2 VJ=5.00"};
  ASSERT_TRUE(constant.operands.position(value));
  EXPECT_EQ(value.value, (std::array{1'000.0, 1'000.0, 0.0, 0.0, 0.0, 0.0}));
  EXPECT_TRUE(constant.operands.is(OperandKind::kTag));
  ReaderRig unset{"MOVJ P003"};
  EXPECT_FALSE(unset.operands.position(value));
  EXPECT_EQ(unset.step.alarm(), Alarm::kNotSet);
  ReaderRig set{"MOVJ P003"};
  *set.variables.position({VariableType::kP, false, 3.0}) = {.value = {1, 2, 3, 4, 5, 6}, .set = true};
  ASSERT_TRUE(set.operands.position(value));
  EXPECT_EQ(value.value[5], 6.0);
}

TEST(OperandReader, FindsAWordBehindOtherOperands) {
  ReaderRig rig{"MOVJ C1 VJ=5.00 UNTIL IN#(3)=ON"};
  OperandReader until = rig.operands;
  ASSERT_TRUE(until.find(Word::kUntil));
  EXPECT_TRUE(until.take(Word::kUntil));
  EXPECT_EQ(until.io_here(), IoType::kInput);
  EXPECT_FALSE(rig.operands.find(Word::kToolFrame));
  EXPECT_TRUE(rig.operands.at_end());
}

TEST(OperandReader, StartsAtTheFirstOperandOfAnotherRecord) {
  ReaderRig rig{"ADD D000 1\nADD D000 2"};
  EXPECT_EQ(rig.value(), 1.0);
  OperandReader other = rig.operands.of(rig.step.record(2));
  other.skip();
  double value = 0.0;
  EXPECT_TRUE(other.number(value));
  EXPECT_EQ(value, 2.0);
}

TEST(OperandReader, UsesVariablesAsIndices) {
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

}  // namespace
}  // namespace armature::job
