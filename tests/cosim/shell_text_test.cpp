#include "cosim/text/shell_text.hpp"

#include <gtest/gtest.h>

namespace armature::cosim {
namespace {

TEST(ShellWord, QuotesOnlyWhatAShellWouldNotTakeAsItIs) {
  EXPECT_EQ(shell_word("scenarios/fig9_joint_move"), "scenarios/fig9_joint_move");
  EXPECT_EQ(shell_word(""), "''");
  EXPECT_EQ(shell_word("my arm/x"), "'my arm/x'");
  EXPECT_EQ(shell_word("it's"), "'it'\\''s'");
  EXPECT_EQ(shell_word("$HOME;*"), "'$HOME;*'");
}

}  // namespace
}  // namespace armature::cosim
