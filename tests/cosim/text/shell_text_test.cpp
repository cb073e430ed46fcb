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

TEST(ShellWord, EscapesWhatATerminalObeys) {
  EXPECT_EQ(shell_word("evil\x1B[31m\n"), "$'evil\\x1B[31m\\x0A'");
  EXPECT_EQ(shell_word("it's\t\\"), "$'it\\'s\\x09\\\\'");
  EXPECT_EQ(shell_word("Grüße"), "'Grüße'");
}

}  // namespace
}  // namespace armature::cosim
