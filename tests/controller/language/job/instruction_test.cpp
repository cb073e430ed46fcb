#include "controller/language/job/memory/instruction.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace armature::job {
namespace {

TEST(Instruction, EachNameStandsOnce) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < instruction_count(); ++i) {
    EXPECT_TRUE(names.insert(instruction_at(i).name).second) << instruction_at(i).name;
  }
}

TEST(Instruction, IsFoundByItsName) {
  EXPECT_EQ(op_named("MOVJ"), Op::kMovj);
  EXPECT_EQ(op_named("ENDSWITCH"), Op::kEndswitch);
  EXPECT_EQ(op_named("movj"), std::nullopt);
  EXPECT_EQ(op_named(""), std::nullopt);
  EXPECT_EQ(op_named("*"), std::nullopt);
}

TEST(Instruction, KnowsInstructionsThatItDoesNotExecute) {
  const auto arc_on = op_named("ARCON");
  ASSERT_TRUE(arc_on);
  EXPECT_FALSE(is_supported(*arc_on));
  EXPECT_EQ(instruction_of(*arc_on).name, "ARCON");
  EXPECT_TRUE(is_supported(Op::kPulse));
}

TEST(Instruction, HasAPatternOfKnownLettersAndATextForEach) {
  for (std::size_t i = 0; i < instruction_count(); ++i) {
    const Instruction& instruction = instruction_at(i);
    EXPECT_EQ(instruction.pattern.find_first_not_of("mpdnvexiocsgljafukqthwy?"), std::string_view::npos)
        << instruction.name;
    EXPECT_FALSE(instruction.text.empty()) << instruction.name;
    EXPECT_EQ(instruction_of(instruction.op).name, instruction.name);
    // Tags are listed where the pattern reads them.
    EXPECT_EQ(instruction.tags != 0, instruction.pattern.find_first_of("th") != std::string_view::npos)
        << instruction.name;
  }
}

}  // namespace
}  // namespace armature::job
