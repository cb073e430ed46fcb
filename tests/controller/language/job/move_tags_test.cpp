#include "controller/language/job/execute/move_tags.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/controller/language/job/step_rig.hpp"

namespace armature::job {
namespace {

using test::ReaderRig;

// The alarm of a tag whose value is a variable.
Alarm alarm_of_tag(const std::string& instruction, double value) {
  ReaderRig rig{instruction + "R000"};
  rig.set(VariableType::kR, 0, value);
  MoveTags tags;
  const bool read = read_tags(rig.step, rig.operands, tags);
  EXPECT_EQ(read, rig.step.alarm() == Alarm::kNone);
  return rig.step.alarm();
}

TEST(MoveTags, AreReadInAnyOrderBehindTheTarget) {
  ReaderRig rig{"MOVL C1 ACC=50 V=25.5 PL=3 DEC=40"};
  MoveTags tags;
  ASSERT_TRUE(read_tags(rig.step, rig.operands, tags));
  EXPECT_EQ(tags.v, 25.5);
  EXPECT_EQ(tags.pl, 3.0);
  EXPECT_FALSE(tags.vj || tags.vr || tags.cr);
  EXPECT_EQ(tags.accel_share(), 0.4);
  EXPECT_EQ(MoveTags{}.accel_share(), 1.0);
}

TEST(MoveTags, HaveTheUnitsOfVariables) {
  ReaderRig rig{"MOVL C1 V=I000 PL=B000 CR=B001"};
  rig.set(VariableType::kI, 0, 125);
  rig.set(VariableType::kB, 0, 2);
  rig.set(VariableType::kB, 1, 30);
  MoveTags tags;
  ASSERT_TRUE(read_tags(rig.step, rig.operands, tags));
  EXPECT_EQ(tags.v, 12.5);  // 0.1 mm/s
  EXPECT_EQ(tags.pl, 2.0);
  EXPECT_EQ(tags.cr, 30.0);
  ReaderRig joints{"MOVJ C1 VJ=I000"};
  joints.set(VariableType::kI, 0, 2'500);
  ASSERT_TRUE(read_tags(joints.step, joints.operands, tags));
  EXPECT_EQ(tags.vj, 25.0);  // 0.01 %
}

TEST(MoveTags, HaveRanges) {
  struct Range {
    std::string instruction;
    double least, most;  // of a variable
  };
  for (const Range& range :
       {Range{"MOVJ C1 VJ=", 1, 10'000}, Range{"MOVL C1 V=", 1, 300'000}, Range{"MOVL C1 VR=", 1, 10'000},
        Range{"MOVL C1 PL=", 0, 8}, Range{"MOVL C1 CR=", 0, 1'000}, Range{"MOVL C1 ACC=", 1, 100},
        Range{"MOVL C1 DEC=", 1, 100}}) {
    EXPECT_EQ(alarm_of_tag(range.instruction, range.least), Alarm::kNone) << range.instruction;
    EXPECT_EQ(alarm_of_tag(range.instruction, range.most), Alarm::kNone) << range.instruction;
    EXPECT_EQ(alarm_of_tag(range.instruction, range.least - 0.5), Alarm::kRange) << range.instruction;
    EXPECT_EQ(alarm_of_tag(range.instruction, range.most + 0.5), Alarm::kRange) << range.instruction;
  }
  EXPECT_EQ(alarm_of_tag("MOVL C1 VE=", 100), Alarm::kUnsupported);
}

}  // namespace
}  // namespace armature::job
